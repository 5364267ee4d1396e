#!/usr/bin/env python3
"""Writes thin-paint.jsonl: hills in the haze, in washes of much medium and little pigment."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import dry, easel, rows  # noqa: E402

PALETTE = {"sky": ("#5b8fb8", 0.3), "rose": ("#d08a78", 0.3), "far": ("#6f8fa8", 0.35),
           "hill": ("#4d6f7c", 0.4), "near": ("#3d5a48", 0.45), "bank": ("#4a4a2a", 0.5),
           "ink": ("#22302e", 0.6)}


def ridge(x, base, height, seed):
    return base - height * (0.55 * math.sin(9 * x + seed) + 0.3 * math.sin(23 * x + 2.3 * seed)
                            + 0.15 * math.sin(51 * x + seed))


def hill(p, colour, base, height, seed, depth):
    """A wash under a ridge: strokes side by side, each along the ridge and lower."""
    p.color(colour)
    for n in range(int(depth / 0.02) + 1):
        y = 0.02 * n
        points = [(x / 10, ridge(x / 10, base, height * math.exp(-8 * y), seed) + y)
                  for x in range(-1, 7)]
        p.stroke(points if n % 2 == 0 else points[::-1], speed=0.5, pressure=0.9, taper=False)


def main():
    p = easel("thin-paint", "Thin paint", PALETTE, seed=3, ground=(0.9, 0.88, 0.82), relief=0.0002)
    p.brush("flat", size=0.05, medium=0.3, pigment=0.1, pickup=0.3)
    rows(p, -0.05, 0.55, 0.02, 0.16, 0.034, ["sky", "sky", "sky", "rose", "rose"], speed=0.5)
    p.recording.wait(1)
    dry(p)
    for n, (colour, base, height, pigment) in enumerate(
            (("far", 0.165, 0.016, 0.1), ("hill", 0.195, 0.026, 0.14), ("near", 0.24, 0.03, 0.2),
             ("bank", 0.31, 0.02, 0.26))):
        p.brush("flat", size=0.03, medium=0.3, pigment=pigment, pickup=0.3)
        hill(p, colour, base, height, 1.9 * n, 0.05 + 0.025 * n)
        p.recording.wait(1)
        dry(p)
    p.brush("rigger", size=0.012, medium=0.25, pigment=0.6)
    p.color("ink")
    for n in range(16):  # reeds
        x = 0.03 + 0.006 * n + p.vary(0.008)
        p.stroke([(x, 0.36), (x + p.vary(0.01), 0.3), (x + 0.02 + p.vary(0.02), 0.2 + 0.06 * p.random.random())],
                 speed=0.4, pressure=0.6)
    p.brush("round", size=0.014, medium=0.25, pigment=0.5)
    for x, y in ((0.33, 0.06), (0.36, 0.075), (0.4, 0.055)):  # birds
        p.stroke([(x - 0.012, y - 0.004), (x - 0.005, y - 0.006), (x, y)], speed=0.2, pressure=0.4)
        p.stroke([(x, y), (x + 0.006, y - 0.007), (x + 0.013, y - 0.004)], speed=0.2, pressure=0.4)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "thin-paint.jsonl"))


if __name__ == "__main__":
    main()
