#!/usr/bin/env python3
"""Writes figure-8.jsonl, after Figure 8 of the publication: blue strokes over wet red, along a
diagonal; then a clean brush goes through both. Marks: covered, stirred."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import easel  # noqa: E402

PALETTE = {"red": ("#c4241c", 0.9), "blue": ("#1f3f9c", 0.9)}


def main():
    p = easel("figure-8", "Blue over wet red", PALETTE, seed=2)
    p.brush("flat", size=0.05, medium=0.6, pigment=0.9, pickup=0, layer_mixing=0)
    p.color("red")
    for n in range(5):  # a patch of red, wet
        y = 0.09 + 0.045 * n
        p.stroke([(0.08, y), (0.25, y), (0.42, y)], speed=0.3, pressure=0.9, taper=False, tremor=0.0003)
    p.recording.wait(0.5)
    p.color("blue")
    for n in range(3):  # along the diagonal, from the left to the right
        shift = 0.075 * n
        p.stroke([(0.06 + shift, 0.09), (0.17 + shift, 0.19), (0.28 + shift, 0.3)], speed=0.3,
                 pressure=0.9, taper=False, tremor=0.0003)
    p.recording.event("mark", name="covered")
    p.recording.wait(0.5)
    p.brush("bristle", size=0.05, medium=0, pigment=0, pickup=0.5, refill=0, layer_mixing=1)
    for n in range(2):  # through it again, with nothing on the brush, three times each
        for back in range(3):
            y = 0.15 + 0.09 * n
            ends = [(0.04, y + 0.004 * back), (0.25, y - 0.01), (0.46, y + 0.004 * back)]
            p.stroke(ends if back % 2 == 0 else ends[::-1], speed=0.3, pressure=1, taper=False)
    p.recording.event("mark", name="stirred")
    p.recording.write(output_path(HERE / "figure-8.jsonl"))


if __name__ == "__main__":
    main()
