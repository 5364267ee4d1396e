#!/usr/bin/env python3
"""Posters beside enlargements: the crops of docs/fidelity.md.

    crops.py COMMAND OUT.png [--scale 8] LOG:X,Y,SIZE...

For each log a row: SIZE x SIZE cells of its own grid from cell (X, Y) on; left the picture at the
grid's size, enlarged with a Lanczos filter, right the poster. Needs Pillow.
"""
import pathlib
import sys

import sheet
from PIL import Image


def pair(command, spec, scale, folder):
    log, x, y, size = sheet.cells_of(spec)
    tablet = sheet.render(command, log, f"{folder}/tablet.png").crop((x, y, x + size, y + size))
    enlarged = tablet.resize((size * scale, size * scale), Image.LANCZOS)
    poster = sheet.render(command, log, f"{folder}/poster.png", "--scale", str(scale),
                          "--crop", f"{x * scale},{y * scale},{size * scale},{size * scale}")
    for picture in ("tablet.png", "poster.png"):
        pathlib.Path(folder, picture).unlink()
    return enlarged, poster


if __name__ == "__main__":
    sheet.make(sys.argv[1:], __doc__, pair)
