#!/usr/bin/env python3
"""Writes tips.jsonl: a chart of the built-in tips. One row per tip; in it four pressures, a swell
from nothing to full, a turn of the pen (twist) and a lean of it (tilt)."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Recording, output_path  # noqa: E402

TIPS = [("round", "#27388f"), ("flat", "#c8281e"), ("filbert", "#2f6b3c"), ("bristle", "#8a4b2a"),
        ("knife", "#d99a1c")]
SAMPLES = 18
SECONDS = 0.3


def mark(recording, x, y, pressure, twist=lambda u: 0.0, tilt=(0.0, 0.0)):
    """A short wavy stroke; pressure and twist are functions of the way along it, 0 to 1."""
    for n in range(SAMPLES):
        u = n / (SAMPLES - 1)
        phase = "down" if n == 0 else "up" if n == SAMPLES - 1 else "move"
        recording.touch(phase, x + 0.062 * u, y + 0.006 * math.sin(2 * math.pi * u),
                        recording.time + SECONDS * u, 0, pressure(u), tilt, twist(u))
    recording.wait(SECONDS + 0.02)


def main():
    recording = Recording(
        0.6, 0.4, (768, 512), model={"scheme": "conservative"},
        paper={"texture": "linen", "relief": 0.0003, "scale": 0.08,
               "reflectance": [0.8, 0.78, 0.72]},
        palette=[{"name": n, "color": c} for n, c in TIPS],
        title="Tips and pressures", recorded_by="samples/tips/make.py")
    recording.slider(size=0.026, medium=0.5, pigment=0.9)
    for row, (tip, _) in enumerate(TIPS):
        recording.event("brush", name=tip)
        recording.event("color", pigment=tip)
        y = 0.05 + 0.075 * row
        for column, pressure in enumerate((0.25, 0.5, 0.75, 1.0)):
            mark(recording, 0.025 + 0.08 * column, y, lambda u, p=pressure: p)
        mark(recording, 0.345, y, lambda u: u)
        mark(recording, 0.425, y, lambda u: 0.8, twist=lambda u: 180 * u)
        mark(recording, 0.505, y, lambda u: 0.8, tilt=(50.0, 20.0))
    recording.event("mark", name="end")
    recording.write(output_path(HERE / "tips.jsonl"))


if __name__ == "__main__":
    main()
