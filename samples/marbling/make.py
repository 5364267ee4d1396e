#!/usr/bin/env python3
"""Writes marbling.jsonl: stripes of wet paint, drawn through with a clean point and a fan."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import easel  # noqa: E402

PALETTE = {"indigo": "#202a5c", "teal": "#1f7a80", "cream": "#f4ecd4", "ochre": "#cf962e",
           "red": "#a82c22"}


def main():
    p = easel("marbling", "Marbling", PALETTE, seed=17, relief=0.0002,
              model={"brush_push": 0.66})
    p.brush("flat", size=0.026, medium=0.9, pigment=0.85)
    order = ["indigo", "cream", "teal", "cream", "ochre", "red", "cream"]
    for n in range(24):  # stripes
        p.color(order[n % len(order)])
        y = 0.003 + 0.0162 * n
        p.stroke([(-0.04, y), (0.25, y), (0.54, y)], speed=0.5, pressure=0.9, taper=False, tremor=0.0002)
    p.recording.event("mark", name="stripes")
    clean = {"medium": 0, "pigment": 0, "pickup": 0.04, "refill": 0, "layer_mixing": 0}
    p.brush("rigger", size=0.05, **clean)
    for n in range(17):  # combed up and down
        x = 0.012 + 0.03 * n
        ends = [(x, -0.03), (x + 0.002, 0.1), (x - 0.002, 0.25), (x, 0.405)]
        p.stroke(ends if n % 2 else ends[::-1], speed=0.35, pressure=0.8, taper=False)
    p.brush("rigger", size=0.07, **clean)
    for x, y, size in ((0.14, 0.12, 0.085), (0.35, 0.25, 0.095), (0.39, 0.08, 0.055),
                       (0.11, 0.3, 0.055)):
        points = [(x + size * (1 - k / 34) * math.cos(0.42 * k),
                   y + size * (1 - k / 34) * math.sin(0.42 * k)) for k in range(32)]
        p.stroke(points, speed=0.4, pressure=0.9, taper=False)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "marbling.jsonl"))


if __name__ == "__main__":
    main()
