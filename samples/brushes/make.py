#!/usr/bin/env python3
"""Writes brushes.jsonl: what every built-in brush does. One row per brush: light, middling and full
pressure, a swell; a nearly dry brush; a slow and a fast stroke; over wet paint of another colour."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Painter, Recording, output_path  # noqa: E402

BRUSHES = [("round", "prussian"), ("flat", "vermilion"), ("filbert", "sap"),
           ("bristle", "umber"), ("fan", "prussian"), ("rigger", "vermilion"),
           ("knife", "ochre"), ("rag", "umber")]
PALETTE = {"prussian": "#1d3f77", "vermilion": "#c8341e", "sap": "#3f6b34", "umber": "#7a4426",
           "ochre": "#cf9a2c", "white": "#f4f0e4"}
LENGTH = 0.115


def wave(x, y, length=LENGTH):
    return [(x + length * k / 6, y + 0.008 * math.sin(2 * math.pi * k / 6)) for k in range(7)]


def mark(p, x, y, pressure, speed=0.35, length=LENGTH):
    """A wavy stroke whose pressure is a function of the way along it."""
    path = wave(x, y, length)
    recording = p.recording
    count = max(4, int(length / speed * 120))
    for n in range(count):
        u = n / (count - 1)
        k = min(int(u * 6), 5)
        f = u * 6 - k
        px = path[k][0] + f * (path[k + 1][0] - path[k][0])
        py = path[k][1] + f * (path[k + 1][1] - path[k][1])
        phase = "down" if n == 0 else "up" if n == count - 1 else "move"
        recording.touch(phase, px, py, recording.time + n / 120, 0, pressure(u))
    recording.wait(count / 120 + 0.05)


def main():
    recording = Recording(
        1.0, 0.75, (1280, 960), model={"scheme": "conservative"},
        paper={"texture": "linen", "relief": 0.0004, "scale": 0.09,
               "reflectance": [0.82, 0.79, 0.72]},
        palette=[{"name": n, "color": c, "opacity": 0.85} for n, c in PALETTE.items()],
        title="Brushes", recorded_by="samples/brushes/make.py")
    p = Painter(recording)
    for row, (brush, colour) in enumerate(BRUSHES):
        y = 0.05 + 0.092 * row
        p.brush("flat", size=0.05, medium=0.6, pigment=0.9)
        p.color("white")
        wet = (0.855,) if brush != "rag" else (0.04, 0.175, 0.31, 0.445, 0.58, 0.715, 0.855)
        for x in wet:  # wet paint to work in
            p.color("white" if x == 0.855 else colour)
            for dy in (-0.012, 0.014):
                p.stroke([(x - 0.005, y + dy), (x + LENGTH + 0.005, y + dy)], speed=0.4,
                         taper=False, tilt=(0, 0), tremor=0)
        p.brush(brush, size=0.044, medium=0.5, pigment=0.9)
        p.color(colour)
        for column, pressure in enumerate((0.15, 0.5, 1.0)):
            mark(p, 0.04 + 0.135 * column, y, lambda u, f=pressure: f)
        mark(p, 0.445, y, lambda u: u)
        recording.slider(load=0.3)
        mark(p, 0.58, y, lambda u: 0.7)
        recording.slider(load=1)
        mark(p, 0.715, y, lambda u: 0.8, speed=2.2)
        mark(p, 0.855, y, lambda u: 0.8)
    recording.event("mark", name="end")
    recording.write(output_path(HERE / "brushes.jsonl"))


if __name__ == "__main__":
    main()
