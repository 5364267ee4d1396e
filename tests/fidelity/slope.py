#!/usr/bin/env python3
"""How steep the relief of a canvas is: the root mean square of its slope (docs/fidelity.md).

    slope.py COMMAND LOG K...

Renders the log's state at each scale K. Of the surface, ground and wet paint, in the middle quarter of the
canvas, it tells the slope between neighbouring cells, down the canvas: across strokes that run to the side.
Dumps live in a temporary folder (TMPDIR). Needs NumPy and h5py.
"""
import subprocess
import sys
import tempfile

import h5py
import numpy


def rms_slope(path):
    with h5py.File(path) as dump:
        height, width = dump["fluid/depth"].shape
        middle = slice(height // 4, 3 * height // 4), slice(width // 4, 3 * width // 4)
        surface = dump["canvas/base"][middle].astype(numpy.float64) + dump["fluid/depth"][middle]
        cell_m = dump["/"].attrs["canvas_height_m"] / height
    return float(numpy.sqrt(numpy.mean((numpy.diff(surface, axis=0) / cell_m) ** 2)))


def main(arguments):
    if len(arguments) < 3:
        sys.exit(__doc__)
    command, log, *scales = arguments
    for scale in scales:
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/state.h5"
            subprocess.run([command, "render", log, "--scale", scale, "--quiet", "-o", path], check=True)
            print(f"k = {scale}: {rms_slope(path):.3f}")


main(sys.argv[1:])
