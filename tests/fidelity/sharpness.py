#!/usr/bin/env python3
"""How much sharper a poster is than an enlargement of the tablet's painting.

    sharpness.py TABLET.h5 POSTER.h5

Both are state dumps of one log, the second with --scale K. Of all pigment on the canvas it tells

- the 10-90 % rise of the coverage at the edges of strokes, across them, in cells of the tablet's grid:
  median and first quartile over some thousand places, of the poster and of the tablet's planes
  enlarged K times (Lanczos) at the same places;
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


def coverage(plane):
    return 1 - np.exp(-np.maximum(plane, 0) / COVERING_AMOUNT)


def blurred(plane, sigma=0.7):
    weight = np.exp(-0.5 * (np.arange(-3, 4) / sigma) ** 2)
    for axis in (0, 1):
        plane = sum(w * np.roll(plane, j, axis) for w, j in zip(weight / weight.sum(), range(-3, 4)))
    return plane


def edges(tablet, most=4000, seed=1):
    """Cells (y, x) of the tablet's grid on the edges of strokes, and the direction into the paint."""
    smooth = blurred(coverage(tablet))
    down, right = np.gradient(smooth)
    steep = np.hypot(down, right)
    found = np.argwhere((smooth > 0.4) & (smooth < 0.6) & (steep > 0.25))
    chosen = np.random.default_rng(seed).permutation(found)[:most]
    y, x = chosen.T
    return chosen, np.stack([down[y, x], right[y, x]], axis=1) / steep[y, x][:, None]


def across(plane, factor, cell, direction):
    """Coverage along a line across an edge, from two guide cells outside on; None: off the canvas."""
    place = np.arange(-2.0, 2.5, 1 / (2 * factor))[:, None] * direction + cell + 0.5
    y, x = (place * factor - 0.5).T
    if y.min() < 0 or x.min() < 0 or y.max() >= plane.shape[0] - 1 or x.max() >= plane.shape[1] - 1:
        return None
    i, j = np.floor(y).astype(int), np.floor(x).astype(int)
    v, u = y - i, x - j
    near = (plane[i, j] * (1 - u) + plane[i, j + 1] * u) * (1 - v)
    return near + (plane[i + 1, j] * (1 - u) + plane[i + 1, j + 1] * u) * v


def rise(line, factor):
    """From 10 to 90 % of the first crest, in guide cells; None: no edge between bare and covered."""
    if line is None or line[:4].max() > 0.02:
        return None
    falls = np.flatnonzero((np.diff(line) < -1e-4) & (line[:-1] > 0.3))
    top = line[falls[0]] if len(falls) else line.max()
    if top < 0.5:  # a trace
        return None
    return (crossing(line, 0.9 * top) - last_below(line, 0.1 * top)) / (2 * factor)


def crossing(line, level):
    """Where the samples first reach a level, between them."""
    at = int(np.argmax(line >= level))
    return at - 1 + (level - line[at - 1]) / (line[at] - line[at - 1])


def last_below(line, level):
    """Where they leave another for good before they reach nine times as much."""
    at = int(np.flatnonzero(line[: np.argmax(line >= 9 * level)] < level)[-1])
    return at + (level - line[at]) / (line[at + 1] - line[at])


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
    both = []
    lines = [coverage(poster), coverage(larger)]
    for cell, direction in zip(*edges(tablet)):
        pair = [rise(across(plane, factor, cell, direction), factor) for plane in lines]
        if None not in pair:
            both.append(pair)
    both = np.array(both)
    for name, plane, found in (("poster", poster, both[:, 0]), ("enlarged", larger, both[:, 1])):
        print(
            f"{name:9} k={factor}: rise median {np.median(found):.2f}, quartile "
            f"{np.percentile(found, 25):.2f} guide cells over {len(found)} edges; "
            f"variance beyond the tablet's Nyquist {fine_share(plane, factor):.4f}"
        )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
