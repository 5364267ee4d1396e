#!/usr/bin/env python3
"""Writes pigments.jsonl: measured acrylics in spectral optics. Above, pairs of colours stroked into
each other while wet; below, a dry underpainting crossed by glazes, thicker from left to right."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Recording, output_path  # noqa: E402

PAIRS = [("hansa yellow opaque", "phthalo blue green shade"),
         ("bismuth vanadate yellow", "cobalt blue"),
         ("pyrrole red", "titanium white"),
         ("quinacridone magenta", "cerulean blue chromium"),
         ("cadmium orange", "ultramarine blue")]
GLAZES = ["quinacridone magenta", "diarylide yellow", "phthalo green yellow shade",
          "phthalo blue red shade"]
GREYS = [0.9, 0.55, 0.25]
SAMPLES = 24


def pull(recording, x0, y0, x1, y1, seconds=0.5, sway=0.0, pressure=lambda u: 0.85):
    """A stroke from one point to another that sways `sway` metres to either side."""
    dx, dy = x1 - x0, y1 - y0
    length = math.hypot(dx, dy)
    for n in range(SAMPLES):
        u = n / (SAMPLES - 1)
        phase = "down" if n == 0 else "up" if n == SAMPLES - 1 else "move"
        s = sway * math.sin(4 * math.pi * u)
        recording.touch(phase, x0 + u * dx - s * dy / length, y0 + u * dy + s * dx / length,
                        recording.time + seconds * u, 0, pressure(u))
    recording.wait(seconds + 0.03)


def wet_on_wet(recording, x, first, second):
    """Two colours side by side, then a brush that drags one through the other and back."""
    recording.event("brush", name="flat")
    recording.slider(size=0.03, medium=0.5, pigment=0.9, pickup=0.2)
    recording.event("color", pigment="golden " + first)
    for i in range(2):
        pull(recording, x, 0.03 + 0.024 * i, x + 0.095, 0.03 + 0.024 * i)
    recording.event("color", pigment="golden " + second)
    for i in range(2):
        pull(recording, x, 0.142 + 0.024 * i, x + 0.095, 0.142 + 0.024 * i)
    # The mixing brush: first loaded with one, then with the other, picking up as it goes.
    recording.slider(size=0.02, pigment=0.6, pickup=0.9, refill=0.0, layer_mixing=1.0)
    recording.event("brush", name="bristle")
    for i, colour in enumerate((first, second, first, second)):
        recording.event("color", pigment="golden " + colour)
        y0, y1 = (0.03, 0.165) if i % 2 == 0 else (0.165, 0.03)
        pull(recording, x + 0.012 + 0.023 * i, y0, x + 0.016 + 0.023 * i, y1, 0.9, 0.006)
    for i in range(3):
        y = 0.08 + 0.018 * i
        pull(recording, x, y, x + 0.095, y, 0.7, 0.004)


def underpainting(recording):
    recording.event("brush", name="flat")
    recording.slider(size=0.034, medium=0.4, pigment=1.0, pickup=0.1, refill=1.0, layer_mixing=0.0)
    for row in range(len(GREYS)):
        recording.event("color", pigment=f"grey {row}")
        for _ in range(2):
            pull(recording, 0.02, 0.235 + 0.05 * row, 0.58, 0.235 + 0.05 * row, 1.0)
    recording.event("dry")


def glazes(recording):
    recording.event("brush", name="round")
    for column, name in enumerate(GLAZES):
        recording.event("color", pigment="golden " + name)
        for step, pigment in enumerate((0.01, 0.03, 0.1)):
            recording.slider(size=0.032, medium=0.15, pigment=pigment, pickup=0.0)
            x = 0.045 + 0.14 * column + 0.04 * step
            pull(recording, x, 0.215, x, 0.36, 0.6)


def main():
    palette = [{"name": f"grey {row}", "color": [r, r, r], "opacity": 0.9}
               for row, r in enumerate(GREYS)]
    names = list(dict.fromkeys([n for pair in PAIRS for n in pair] + GLAZES))
    palette += [{"name": "golden " + n} for n in names]
    recording = Recording(
        0.6, 0.38, (720, 456), optics="spectral", model={"scheme": "conservative"},
        paper={"texture": "linen", "relief": 0.0003, "scale": 0.08, "reflectance": [0.9, 0.9, 0.88]},
        palette=palette, title="Measured pigments", recorded_by="samples/pigments/make.py")
    for i, (first, second) in enumerate(PAIRS):
        wet_on_wet(recording, 0.02 + 0.117 * i, first, second)
    underpainting(recording)
    glazes(recording)
    recording.event("mark", name="end")
    recording.write(output_path(HERE / "pigments.jsonl"))


if __name__ == "__main__":
    main()
