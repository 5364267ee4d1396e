#!/usr/bin/env python3
"""Writes mypaint-30s.jsonl from libmypaint's test recording: thirty seconds of a real pen."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Recording, output_path  # noqa: E402

SOURCE = HERE.parent / "data/mypaint-painting30sec/painting30sec.dat"
WIDTH, HEIGHT = 1.0, 0.75
PALETTE = [("ultramarine", "#27388f"), ("cadmium yellow", "#f2b61c"), ("titanium white", "#f6f3ea"),
           ("cadmium red", "#c8281e"), ("emerald", "#2f8f6b"), ("rose", "#d9578a")]
SCALE = 0.0013  # metres of canvas per pixel of the recording


def read_samples():
    """Rows of (time_s, x_px, y_px, pressure); pressure 0 means that the pen hovers."""
    for line in SOURCE.read_text().splitlines():
        yield tuple(float(value) for value in line.split())


def main():
    recording = Recording(
        WIDTH, HEIGHT, (1024, 768), palette=[{"name": n, "color": c} for n, c in PALETTE],
        model={"scheme": "conservative"},
        paper={"texture": "linen", "relief": 0.0004, "scale": 0.12,
               "reflectance": [0.8, 0.78, 0.72]},
        title="Thirty seconds", recorded_by="MyPaint, converted by samples/mypaint-30s/make.py")
    samples = list(read_samples())
    middle_x = (min(s[1] for s in samples) + max(s[1] for s in samples)) / 2
    middle_y = (min(s[2] for s in samples) + max(s[2] for s in samples)) / 2

    def place(x, y):
        return WIDTH / 2 + SCALE * (x - middle_x), HEIGHT / 2 + SCALE * (y - middle_y)

    recording.event("brush", name="bristle")
    recording.slider(size=0.034, medium=0.6, pigment=1.0)
    strokes, last = 0, None  # `last`: where the pen is while it is down
    for time, x, y, pressure in samples:
        recording.time = time
        if pressure > 0:
            if last is None:
                recording.event("color", pigment=PALETTE[strokes % len(PALETTE)][0])
                strokes += 1
            recording.touch("move" if last else "down", *place(x, y), pressure=pressure)
            last = place(x, y)
        elif last is not None:
            recording.touch("up", *last, pressure=0)
            last = None
    if last is not None:
        recording.touch("up", *last, pressure=0)
    recording.write(output_path(HERE / "mypaint-30s.jsonl"))


if __name__ == "__main__":
    main()
