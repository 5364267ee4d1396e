#!/usr/bin/env python3
"""Writes scumbling.jsonl: fog and moonlight dragged nearly dry over dark paint that has set."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import arc, dry, easel, rows  # noqa: E402

PALETTE = {"black green": "#18231f", "night": "#1d2a40", "slate": "#39485a", "fog": "#b9c2c0",
           "moon": "#f4efd8", "rust": "#8a4a26"}


def main():
    p = easel("scumbling", "Scumbling", PALETTE, seed=31)
    p.brush("bristle", size=0.045, medium=0.8, pigment=1)
    rows(p, -0.05, 0.55, 0.01, 0.24, 0.03, ["night", "slate", "night"], speed=0.45)
    rows(p, -0.05, 0.55, 0.26, 0.37, 0.028, ["black green", "night"], speed=0.45)
    p.brush("bristle", size=0.03, medium=0.9, pigment=1)
    p.color("black green")
    for n in range(30):  # trees
        x = 0.018 * n + p.vary(0.006)
        top = 0.21 - 0.04 * abs(math.sin(1.7 * n)) - (0.05 if 8 < n < 15 else 0)
        p.stroke([(x, 0.27), (x + p.vary(0.006), (0.27 + top) / 2), (x + p.vary(0.005), top)], speed=0.3)
    dry(p)
    p.brush("bristle", size=0.05, medium=0.35, pigment=0.9, stiffness=0.9)
    p.recording.slider(load=0.32)
    for n in range(16):  # the fog lies between the trees
        y = 0.2 + 0.011 * n + p.vary(0.004)
        p.color("fog" if n % 4 else "slate")
        x = -0.02 + 0.1 * p.random.random()
        p.stroke([(x, y), (x + 0.2, y + p.vary(0.012)), (x + 0.42, y + p.vary(0.006))], speed=0.6,
                 pressure=0.55)
    p.color("moon")
    for ring in range(7):  # the halo, thinner outwards
        p.recording.slider(load=0.4 - 0.035 * ring)
        for piece in range(2 + ring):
            p.stroke(arc(0.35, 0.09, 0.014 + 0.011 * ring, 1.3 * ring + 6.28 * piece / (2 + ring), 1.5),
                     speed=0.3, pressure=0.6 - 0.04 * ring)
    p.recording.slider(load=1)
    p.brush("round", size=0.03, medium=1, pigment=1)
    p.color("moon")
    p.stroke(arc(0.35, 0.09, 0.008, 0, 6.4, 9), speed=0.15, pressure=0.9)
    p.brush("bristle", size=0.03, medium=0.4, pigment=0.9, stiffness=0.9)
    p.recording.slider(load=0.38)
    for n in range(12):  # light on the path, and some warmth
        p.color("moon" if n % 3 else "rust")
        y = 0.29 + 0.007 * n
        x = 0.3 + p.vary(0.03)
        p.stroke([(x, y), (x + 0.05, y + 0.003), (x + 0.1 + 0.004 * n, y)], speed=0.5, pressure=0.5)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "scumbling.jsonl"))


if __name__ == "__main__":
    main()
