#!/usr/bin/env python3
"""Writes dry-brush.jsonl: a boat on a beach, with a brush that hardly holds paint."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import dry, easel  # noqa: E402

PALETTE = {"sand": "#b58f5a", "light": "#ead9b0", "sea": "#2f6478", "foam": "#f3f0e6",
           "sky": "#7796a4", "hull": "#7c2f22", "dark": "#2b211c", "wood": "#8a6a48"}


def pass_over(p, colour, load, pressure, lines, speed=0.45):
    p.color(colour)
    p.recording.slider(load=load)
    for points in lines:
        p.stroke(points, speed=speed, pressure=pressure)


def line(p, x0, y0, x1, y1, bow=0.0):
    return [(x0, y0), ((x0 + x1) / 2, (y0 + y1) / 2 + bow + p.vary(0.003)), (x1, y1)]


def main():
    p = easel("dry-brush", "Dry brush", PALETTE, seed=26, relief=0.0005)
    p.brush("bristle", size=0.05, medium=0.4, pigment=0.9)
    for n in range(9):
        y = 0.02 + 0.018 * n
        pass_over(p, "sky" if n < 6 else "foam", 0.34 - 0.01 * n, 0.6,
                  [line(p, -0.04 + 0.1 * p.random.random(), y, 0.5 * p.random.random() + 0.2, y)])
    for n in range(5):
        y = 0.165 + 0.012 * n
        pass_over(p, "sea", 0.5, 0.7, [line(p, -0.04, y, 0.54, y)])
    for n in range(9):
        y = 0.235 + 0.017 * n
        pass_over(p, "sand", 0.48, 0.7, [line(p, -0.04, y, 0.54, y - 0.005, 0.004)])
    dry(p)
    p.brush("bristle", size=0.03, medium=0.5, pigment=1)
    for n in range(8):
        y = 0.175 + 0.008 * n
        x = 0.4 * p.random.random()
        pass_over(p, "foam", 0.33, 0.5, [line(p, x, y, x + 0.16, y)])
        pass_over(p, "light", 0.3, 0.5, [line(p, x, y + 0.075 + 0.012 * n, x + 0.2, y + 0.07 + 0.012 * n)])
    p.brush("flat", size=0.022, medium=0.6, pigment=1)
    strakes = [[(0.17 + 0.012 * k, 0.235 + 0.015 * k), (0.28, 0.262 + 0.012 * k),
                (0.41 - 0.012 * k, 0.225 + 0.018 * k)] for k in range(4)]
    for n, points in enumerate(strakes):  # the hull
        pass_over(p, "hull" if n < 3 else "dark", 0.75, 0.8, [points], 0.3)
    dry(p)
    p.brush("fan", size=0.05, medium=0.5, pigment=1)
    for n, points in enumerate(strakes):  # worn paint
        pass_over(p, "wood" if n % 2 else "light", 0.4, 0.4, [points], 0.4)
    p.brush("rigger", size=0.014, medium=0.5, pigment=1)
    pass_over(p, "dark", 1, 0.8, [[(0.28, 0.26), (0.283, 0.16), (0.287, 0.07)],
                                  [(0.165, 0.23), (0.28, 0.252), (0.415, 0.22)]], 0.3)
    pass_over(p, "dark", 0.7, 0.35, [[(0.287, 0.075), (0.34, 0.14), (0.405, 0.22)],
                                     [(0.287, 0.075), (0.23, 0.15), (0.175, 0.23)]], 0.3)
    p.brush("fan", size=0.045, medium=0.5, pigment=1)
    for n in range(18):  # beach grass
        x = 0.02 + 0.007 * n
        pass_over(p, ("wood", "sand", "dark")[n % 3], 0.6, 0.5,
                  [[(x, 0.37), (x + 0.006, 0.34), (x + 0.02 * math.sin(n), 0.31)]], 0.3)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "dry-brush.jsonl"))


if __name__ == "__main__":
    main()
