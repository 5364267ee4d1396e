#!/usr/bin/env python3
"""Writes impasto.jsonl: a wheat field under a turning sky, wet paint laid thick with hog bristle."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import arc, dip, easel, rows  # noqa: E402

PALETTE = {"deep blue": "#1c3468", "blue": "#3a6ca8", "pale blue": "#9cc3d8", "white": "#f5f1e2",
           "sun": "#f2c230", "orange": "#dd7f22", "wheat": "#d9a83a", "ochre": "#a8741f",
           "green": "#3f5f2c", "dark green": "#1e3324"}


def swirl(p, x, y, size, colours):
    for ring in range(4, 0, -1):
        radius = size * ring / 4
        for piece in range(2 + ring):
            dip(p, *colours[(ring + piece) % len(colours)])
            start = 2 * math.pi * piece / (2 + ring) + 0.7 * ring
            p.stroke(arc(x, y, radius, start, 1.7 / (0.6 + 0.2 * ring), flat=0.8), speed=0.25,
                     pressure=0.9)


def main():
    p = easel("impasto", "Impasto", PALETTE, seed=11)
    p.brush("flat", size=0.036, medium=0.55, pigment=0.95)
    rows(p, -0.05, 0.55, 0.012, 0.2, 0.024, ["deep blue", "blue", "blue", "pale blue"], speed=0.4)
    rows(p, -0.05, 0.55, 0.222, 0.37, 0.025, ["green", "ochre", "wheat"], speed=0.4)
    p.recording.event("dry")
    p.brush("bristle", size=0.022, medium=1, pigment=1, pickup=0.2, refill=0.03)
    for n in range(60):  # the wind
        y = 0.012 + 0.19 * p.random.random()
        x = 0.48 * p.random.random()
        dip(p, *p.random.choice([("blue", "pale blue"), ("deep blue", "blue"), ("blue", "white")]))
        p.stroke([(x, y), (x + 0.03, y - 0.006 + p.vary(0.004)), (x + 0.065, y + 0.002)], speed=0.3,
                 pressure=0.85)
    swirl(p, 0.17, 0.085, 0.052, [("deep blue", "pale blue"), ("white", "blue")])
    swirl(p, 0.33, 0.13, 0.035, [("blue", "white"), ("pale blue", "deep blue")])
    swirl(p, 0.42, 0.055, 0.034, [("sun", "orange"), ("white", "sun")])
    p.brush("bristle", size=0.017, medium=1, pigment=1, pickup=0.2, refill=0.03)
    for n in range(210):  # the wheat, from far to near
        near = n / 209
        y = 0.225 + 0.135 * near + p.vary(0.01)
        x = 0.5 * p.random.random()
        dip(p, *p.random.choice([("wheat", "sun"), ("ochre", "wheat"), ("sun", "white"),
                                 ("green", "wheat"), ("orange", "wheat")]))
        long = 0.014 + 0.026 * near
        lean = 0.4 + p.vary(0.3)
        p.stroke([(x, y), (x + 0.5 * lean * long, y - 0.6 * long), (x + lean * long, y - long)],
                 speed=0.25, pressure=0.75 + 0.2 * near)
    p.brush("filbert", size=0.02, medium=0.95, pigment=1, pickup=0.2)
    for n in range(46):  # the cypress
        up = n / 45
        y = 0.29 - 0.25 * up
        wide = 0.026 * (1 - up) ** 0.7 + 0.003
        x = 0.075 + 0.008 * math.sin(7 * up) + p.vary(wide)
        dip(p, *p.random.choice([("dark green", "green"), ("dark green", "deep blue"),
                                 ("green", "ochre")]))
        p.stroke([(x, y + 0.02), (x + 0.006, y), (x - 0.002, y - 0.022)], speed=0.25, pressure=0.8)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "impasto.jsonl"))


if __name__ == "__main__":
    main()
