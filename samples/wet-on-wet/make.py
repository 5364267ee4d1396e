#!/usr/bin/env python3
"""Writes wet-on-wet.jsonl: an evening over water, all of it painted into wet paint."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import easel, rows  # noqa: E402

PALETTE = {"night": "#22305c", "violet": "#5c4a86", "rose": "#c9707a", "peach": "#eda56c",
           "lemon": "#f6dc86", "white": "#f7f2e4", "umber": "#2c2420"}


def main():
    p = easel("wet-on-wet", "Wet on wet", PALETTE, seed=8)
    p.brush("flat", size=0.05, medium=0.6, pigment=0.9, pickup=0.5)
    rows(p, -0.05, 0.55, 0.01, 0.2, 0.028,
         ["night", "violet", "violet", "rose", "peach", "lemon", "lemon"], speed=0.45)
    rows(p, -0.05, 0.55, 0.225, 0.37, 0.026, ["lemon", "peach", "rose", "violet", "night"], speed=0.45)
    p.brush("fan", size=0.06, medium=0, pigment=0, pickup=0.75, refill=0)  # clean: it only blends
    for n in range(12):
        y = 0.02 + 0.03 * n
        p.stroke([(-0.01, y), (0.15, y + 0.012 * (-1) ** n), (0.33, y - 0.01 * (-1) ** n), (0.51, y)],
                 speed=0.5, pressure=0.8)
    p.brush("filbert", size=0.024, medium=0.8, pigment=1, pickup=0.4, refill=0.03)
    p.color("white")
    for n in range(4):  # the sun, and its light on the water
        a = 0.008 * n
        p.stroke([(0.32 - a, 0.183), (0.332, 0.178 + 0.002 * n), (0.345 + a, 0.184)], speed=0.2)
    for n in range(13):
        half = 0.006 + 0.03 * p.random.random() * (0.4 + n / 13)
        y = 0.228 + 0.0105 * n
        p.brush("filbert", size=0.008 + 0.0006 * n, medium=0.7, pigment=1, pickup=0.4, refill=0.03)
        x = 0.333 + p.vary(0.014)
        p.stroke([(x - half, y), (x + p.vary(0.01), y + 0.002), (x + half, y)], speed=0.3, pressure=0.6)
    p.brush("bristle", size=0.03, medium=0.7, pigment=0.95, pickup=0.5, refill=0.03)
    for x, y, long, colour in ((0.05, 0.07, 0.16, "rose"), (0.22, 0.045, 0.2, "peach"),
                               (0.1, 0.12, 0.2, "violet"), (0.35, 0.1, 0.14, "rose"),
                               (0.3, 0.14, 0.16, "violet")):
        p.color(colour)
        p.stroke([(x, y), (x + 0.4 * long, y - 0.012), (x + long, y + 0.004)], speed=0.35, pressure=0.7)
    p.brush("filbert", size=0.02, medium=0.6, pigment=1, pickup=0.4)
    p.color("umber")
    p.stroke([(-0.01, 0.212), (0.06, 0.207), (0.12, 0.211), (0.17, 0.214)], speed=0.3)  # the shore
    for n in range(20):  # trees and their reflection
        x = 0.17 * p.random.random() ** 0.8
        tall = 0.012 + 0.026 * p.random.random() * (1 - x / 0.2)
        p.brush("round", size=0.01 + 0.008 * p.random.random(), medium=0.5, pigment=1, pickup=0.3)
        p.stroke([(x, 0.212), (x + p.vary(0.003), 0.205 - tall)], speed=0.2, pressure=0.8)
        p.stroke([(x, 0.219), (x + p.vary(0.003), 0.224 + 0.8 * tall)], speed=0.2, pressure=0.4)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "wet-on-wet.jsonl"))


if __name__ == "__main__":
    main()
