#!/usr/bin/env python3
"""Writes loaded-brush.jsonl: brushes that hold two or three colours side by side."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Painter, Recording, output_path  # noqa: E402

PALETTE = {"white": "#f6f1e3", "crimson": "#a3182d", "gold": "#e0a526", "deep green": "#1f4a35",
           "spring": "#9cb83f", "night": "#1c2a58", "umber": "#4b2d1c"}


def dip(recording, *colours):
    """Each colour on its share of the brush's width, the first at the left of a stroke."""
    for n, colour in enumerate(colours):
        side = {} if n == 0 else {"across": [n / len(colours), 1]}
        recording.event("color", pigment=colour, **side)


def petal(p, x, y, angle, length):
    """A stroke outwards that turns the brush: its left side stays outside."""
    across = 0.34 * length
    points = []
    for k in range(7):
        u = k / 6
        side = across * math.sin(math.pi * u)
        points.append((x + length * u * math.cos(angle) - side * math.sin(angle),
                       y + length * u * math.sin(angle) + side * math.cos(angle)))
    p.stroke(points, speed=0.3, pressure=0.9, tilt=(0, 0))


def flower(p, x, y, size, colours):
    p.brush("filbert", size=0.42 * size, medium=0.7, pigment=0.95, pickup=0.15, refill=0.02)
    dip(p.recording, *colours)
    for n in range(9):
        petal(p, x, y, 2 * math.pi * (n / 9) + 0.3, size)
    p.brush("round", size=0.16 * size, medium=0.6, pigment=1)
    p.color("gold")
    for n in range(7):
        a = 2.4 * n
        r = 0.17 * size * math.sqrt(n / 7)
        px, py = x + r * math.cos(a), y + r * math.sin(a)
        p.stroke([(px, py), (px + 0.004, py + 0.003)], speed=0.2, taper=False)


def leaf(p, points):
    p.brush("flat", size=0.05, medium=0.6, pigment=0.95, pickup=0.15, refill=0.02)
    dip(p.recording, "spring", "deep green")
    p.stroke(points, speed=0.35, pressure=0.9, tilt=(0, 0))


def main():
    recording = Recording(
        1.0, 0.75, (1024, 768), model={"scheme": "conservative"},
        paper={"texture": "linen", "relief": 0.0004, "scale": 0.1,
               "reflectance": [0.3, 0.27, 0.22]},
        palette=[{"name": n, "color": c, "opacity": 0.9} for n, c in PALETTE.items()],
        title="Loaded brushes", recorded_by="samples/loaded-brush/make.py")
    p = Painter(recording, seed=5)
    leaves = [[(0.3, 0.5), (0.36, 0.62), (0.5, 0.7)], [(0.3, 0.5), (0.2, 0.58), (0.08, 0.6)],
              [(0.72, 0.4), (0.82, 0.52), (0.93, 0.54)], [(0.68, 0.42), (0.62, 0.56), (0.66, 0.68)],
              [(0.26, 0.2), (0.14, 0.14), (0.05, 0.17)], [(0.74, 0.2), (0.86, 0.12), (0.95, 0.17)]]
    for points in leaves:
        leaf(p, points)
    flower(p, 0.3, 0.34, 0.15, ("white", "crimson"))
    flower(p, 0.71, 0.28, 0.12, ("gold", "white", "night"))
    p.brush("bristle", size=0.075, medium=0.6, pigment=0.95, pickup=0.1, refill=0.02)
    dip(recording, "white", "gold", "crimson", "night")
    p.stroke([(0.36, 0.1), (0.44, 0.05), (0.52, 0.1), (0.6, 0.06), (0.66, 0.06)], speed=0.4,
             tilt=(0, 0))
    recording.event("mark", name="end")
    recording.write(output_path(HERE / "loaded-brush.jsonl"))


if __name__ == "__main__":
    main()
