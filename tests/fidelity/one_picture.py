#!/usr/bin/env python3
"""The tablet's picture beside the poster's, reduced: docs/fidelity.md.

    one_picture.py COMMAND OUT.jpg [--scale 8] LOG:X,Y,SIZE...

For each log a row: the picture at the grid's size, the poster reduced to that size in linear light, and
of the poster SIZE x SIZE cells of the log's grid from cell (X, Y) on. Needs NumPy and Pillow.
"""
import pathlib
import sys

import numpy
import sheet
from PIL import Image


def render(command, log, folder, scale):
    path = f"{folder}/{scale}.png"
    picture = sheet.render(command, log, path, "--scale", str(scale))
    pathlib.Path(path).unlink()
    return picture


def linear(code):
    code = code.astype(numpy.float32) / 255
    return numpy.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)


def reduced(picture, scale):
    """Mean light of scale x scale pixels, row of blocks by row of blocks."""
    code = numpy.asarray(picture)
    height, width = code.shape[0] // scale, code.shape[1] // scale
    rows = []
    for y in range(height):
        band = linear(code[y * scale:(y + 1) * scale])
        rows.append(band.reshape(scale, width, scale, 3).mean(axis=(0, 2)))
    light = numpy.stack(rows)
    code = numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    return Image.fromarray((255 * code + 0.5).astype(numpy.uint8))


def row(command, spec, scale, folder):
    log, *at = sheet.cells_of(spec)
    x, y, size = (v * scale for v in at)
    tablet = render(command, log, folder, 1)
    poster = render(command, log, folder, scale)
    crop = poster.crop((x, y, x + size, y + size)).resize((tablet.height, tablet.height), Image.LANCZOS)
    return tablet, reduced(poster, scale), crop


if __name__ == "__main__":
    sheet.make(sys.argv[1:], __doc__, row, quality=88)
