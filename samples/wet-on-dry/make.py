#!/usr/bin/env python3
"""Writes wet-on-dry.jsonl: a bough of blossom over a dried ground; nothing below is disturbed."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import dip, dry, easel, rows  # noqa: E402

PALETTE = {"turquoise": "#3f8f92", "sea": "#2b6a7c", "mist": "#8fbab4", "bark": "#4b3527",
           "lichen": "#7c8262", "white": "#f7f2ea", "blush": "#e7b3b4", "pollen": "#dba52c",
           "leaf": "#5d7a35"}


def blossom(p, x, y, size):
    p.brush("filbert", size=0.62 * size, medium=0.9, pigment=1, pickup=0.1, refill=0.02)
    turn = p.random.random()
    for n in range(5):
        a = 2 * math.pi * (n + turn) / 5
        dip(p, *(("white", "blush") if n % 2 else ("blush", "white")))
        p.stroke([(x + 0.25 * size * math.cos(a), y + 0.25 * size * math.sin(a)),
                  (x + 0.7 * size * math.cos(a), y + 0.7 * size * math.sin(a))], speed=0.15,
                 pressure=0.9)
    p.brush("round", size=0.2 * size, medium=0.8, pigment=1)
    p.color("pollen")
    for n in range(4):
        a = 2 * math.pi * n / 4 + turn
        px, py = x + 0.14 * size * math.cos(a), y + 0.14 * size * math.sin(a)
        p.stroke([(px, py), (px + 0.001, py + 0.001)], speed=0.1, taper=False)


def main():
    p = easel("wet-on-dry", "Wet on dry", PALETTE, seed=21)
    p.brush("bristle", size=0.05, medium=0.5, pigment=0.9)
    rows(p, -0.05, 0.55, 0.01, 0.37, 0.033, ["turquoise", "mist", "turquoise", "sea"], speed=0.5)
    dry(p)
    boughs = [([(-0.01, 0.3), (0.1, 0.25), (0.2, 0.22), (0.33, 0.14), (0.48, 0.11)], 0.022),
              ([(0.12, 0.243), (0.17, 0.16), (0.19, 0.07)], 0.013),
              ([(0.23, 0.2), (0.32, 0.22), (0.42, 0.27)], 0.012),
              ([(0.34, 0.138), (0.38, 0.09), (0.4, 0.04)], 0.01)]
    for points, size in boughs:
        p.brush("flat", size=size, medium=0.7, pigment=1)
        dip(p, "lichen", "bark", "bark")
        p.stroke(points, speed=0.2, pressure=0.9)
    p.brush("filbert", size=0.016, medium=0.7, pigment=1, refill=0.02)
    for x, y, a in ((0.16, 0.11, -2.4), (0.2, 0.09, -0.6), (0.36, 0.24, 0.9), (0.44, 0.105, -1.2),
                    (0.28, 0.21, 1.4), (0.08, 0.27, -1.9), (0.4, 0.05, -0.2)):
        dip(p, "leaf", "mist")
        p.stroke([(x, y), (x + 0.02 * math.cos(a + 0.3), y + 0.02 * math.sin(a + 0.3)),
                  (x + 0.045 * math.cos(a), y + 0.045 * math.sin(a))], speed=0.15, pressure=0.7)
    for x, y, size in ((0.19, 0.055, 0.024), (0.145, 0.19, 0.028), (0.24, 0.17, 0.032),
                       (0.31, 0.17, 0.026), (0.335, 0.105, 0.03), (0.41, 0.14, 0.025),
                       (0.43, 0.28, 0.028), (0.365, 0.255, 0.022), (0.46, 0.085, 0.024),
                       (0.055, 0.245, 0.026), (0.395, 0.065, 0.022)):
        blossom(p, x, y, size)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "wet-on-dry.jsonl"))


if __name__ == "__main__":
    main()
