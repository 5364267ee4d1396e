#!/usr/bin/env python3
"""Writes tints.jsonl: every pigment of the library in spectral optics, pure on the left and in more
and more titanium white to the right. White and colour are laid one after the other into one layer,
where they mix."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Recording, output_path  # noqa: E402

GOLDEN = ["bone black", "hansa yellow opaque", "diarylide yellow", "cadmium orange", "pyrrole orange",
          "cadmium red light", "pyrrole red", "quinacridone red", "quinacridone magenta",
          "dioxazine purple", "ultramarine blue", "cobalt blue", "cerulean blue chromium",
          "phthalo blue red shade", "phthalo blue green shade", "phthalo green blue shade",
          "phthalo green yellow shade", "bismuth vanadate yellow", "titanium white"]
CURTIS = ["quinacridone rose", "indian red", "cadmium yellow", "hooker's green", "cerulean blue",
          "burnt umber", "cadmium red", "brilliant orange", "hansa yellow", "phthalo green",
          "french ultramarine", "interference lilac"]
OILS = ["titanium white", "zinc white", "ivory black", "yellow ochre", "raw sienna", "burnt sienna",
        "raw umber", "alizarin crimson", "vermilion", "naples yellow", "lemon yellow", "viridian",
        "chromium oxide green", "cobalt blue", "prussian blue", "ultramarine blue", "cobalt violet"]
SHARES = (1.0, 0.5, 0.25, 0.1, 0.03, 0.01)
WHITE = "golden titanium white"
ROWS, COLUMN, ROW, PATCH = 16, 0.156, 0.0125, 0.024
SECONDS = 0.2  # two steps of this log
PASSES = 2


def pull(recording, x, y):
    recording.touch("down", x + 0.004, y, pressure=1.0)
    recording.touch("up", x + PATCH - 0.005, y, recording.time + SECONDS / 2, pressure=1.0)
    recording.wait(SECONDS)


def main():
    names = ["golden " + n for n in GOLDEN] + CURTIS + OILS
    recording = Recording(
        0.48, 0.21, (720, 315), optics="spectral", steps_per_second=10,
        model={"layers": 1, "brush_push": 0, "max_medium": 0.002},
        paper={"texture": "smooth", "relief": 0, "scale": 0.1, "reflectance": [0.9, 0.9, 0.9]},
        palette=[{"name": n} for n in names], title="Tints",
        recorded_by="samples/tints/make.py")
    recording.event("brush", name="flat")
    recording.slider(size=0.009, medium=0.02, pickup=0.0)
    places = [(0.012 + COLUMN * (i // ROWS), 0.0115 + ROW * (i % ROWS)) for i in range(len(names))]
    # Share by share, so that a brush is dipped twice for a whole column of the chart.
    recording.event("color", pigment=WHITE)
    for step, share in enumerate(SHARES[1:], 1):
        recording.slider(pigment=1 - share)
        for x, y in places:
            for _ in range(PASSES):
                pull(recording, x + PATCH * step, y)
    for name, (x, y) in zip(names, places):
        recording.event("color", pigment=name)
        for step, share in enumerate(SHARES):
            recording.slider(pigment=share)
            for _ in range(PASSES):
                pull(recording, x + PATCH * step, y)
    recording.event("mark", name="end")
    recording.write(output_path(HERE / "tints.jsonl"))


if __name__ == "__main__":
    main()
