#!/usr/bin/env python3
"""How much sharper a poster is than an enlargement of the tablet's painting.

    sharpness.py TABLET.h5 POSTER.h5

Both are state dumps of one log, the second with --scale K. Of all pigment on the canvas it tells

- the 10-90 % rise of the coverage at the edges of strokes, in cells of the tablet's grid: median and
  first quartile over the edges met along rows, of the poster and of the tablet's planes enlarged K times (Lanczos);
- the share of the variance along rows inside strokes that lies beyond the tablet's Nyquist
  frequency: bristles that an enlargement cannot have.
"""
import sys

import h5py
import numpy as np
from PIL import Image


COVERING_AMOUNT = 0.005  # a third of model.pigment_reference hides about as much as a first glaze


def total_pigment(path):
    with h5py.File(path) as dump:
        return dump["layers/pigment"][:].sum(axis=(0, 1)).astype(np.float32)


def enlarged(plane, factor):
    height, width = plane.shape
    size = (width * factor, height * factor)
    return np.asarray(Image.fromarray(plane, mode="F").resize(size, Image.LANCZOS))


def rises(plane, cells_per_guide):
    """Lengths, in guide cells, from 10 to 90 % of the first crest of the coverage behind an edge."""
    coverage = 1 - np.exp(-np.maximum(plane, 0) / COVERING_AMOUNT)
    found = []
    reach = 4 * cells_per_guide
    for row in coverage[:: 2 * cells_per_guide]:
        bare = row < 0.02
        for start in np.flatnonzero(bare[:-1] & ~bare[1:]):
            stretch = row[start : start + reach]
            falling = np.flatnonzero(np.diff(stretch) < 0)
            if len(stretch) < reach or len(falling) == 0:
                continue
            top = stretch[falling[0]]
            if top < 0.3:  # a trace, not an edge
                continue
            rising = stretch[: falling[0] + 1]
            found.append((crossing(rising, 0.9 * top) - crossing(rising, 0.1 * top)) / cells_per_guide)
    return np.array(found)


def crossing(rising, level):
    """Where the samples first reach a level, between them."""
    at = int(np.argmax(rising >= level))
    if at == 0:
        return 0.0
    return at - 1 + (level - rising[at - 1]) / (rising[at] - rising[at - 1])


def fine_share(plane, factor, window_guide=32):
    """Share of the variance beyond half a cycle per guide cell, in windows inside strokes."""
    window = window_guide * factor
    beyond = whole = 0.0
    for row in plane[:: 2 * factor]:
        for begin in range(0, len(row) - window, window // 2):
            part = row[begin : begin + window]
            if part.min() <= 1e-4:
                continue
            power = np.abs(np.fft.rfft((part - part.mean()) * np.hanning(window))) ** 2
            beyond += power[window_guide // 2 + 1 :].sum()
            whole += power[1:].sum()
    return beyond / whole if whole else float("nan")


def main(tablet_path, poster_path):
    tablet, poster = total_pigment(tablet_path), total_pigment(poster_path)
    factor = poster.shape[0] // tablet.shape[0]
    larger = enlarged(tablet, factor)
    for name, plane in (("poster", poster), ("enlarged", larger)):
        edge = rises(plane, factor)
        print(
            f"{name:9} k={factor}: rise median {np.median(edge):.2f}, quartile "
            f"{np.percentile(edge, 25):.2f} guide cells over {len(edge)} edges; "
            f"variance beyond the tablet's Nyquist {fine_share(plane, factor):.4f}"
        )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
