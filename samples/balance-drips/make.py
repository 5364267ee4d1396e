#!/usr/bin/env python3
"""Writes balance-drips.jsonl: bands of thin paint, and a real recording of a device being raised.

The device lies flat while the bands are painted. Then the accelerometer of a balance test takes
over: the device is snatched up and then carried upright, in a pocket.
CoreMotion gives gravity and the user's acceleration in units of g with the opposite sign of the
log's: lying face up reads (0, 0, -1) there and (0, 0, 9.81) here. In the pocket the device stood
on its head; the axes are given half a turn about z, so that paint runs to the picture's bottom.
"""

import csv
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Painter, Recording, output_path, rounded  # noqa: E402

SOURCE = HERE.parent / "data/gravity/iphone_balance.csv"
STANDARD_GRAVITY = 9.80665
EVERY = 3  # the recording's 100 Hz are more than the 45 steps per second can use
SECONDS = 12.0
PALETTE = [("indigo", "#2c3577", 0.5), ("turquoise", "#1f8a8c", 0.5), ("magenta", "#a8326f", 0.5),
           ("ochre", "#c98f2b", 0.55)]


def read_accelerations():
    """Rows of (time_s, x, y, z), specific force in m/s^2 as the log wants it."""
    with open(SOURCE, newline="") as source:
        for n, row in enumerate(csv.DictReader(source)):
            if n % EVERY == 0 and float(row["t_s"]) <= SECONDS:
                x, y, z = (float(row[f"grav_{axis}_g"]) + float(row[f"useracc_{axis}_g"])
                           for axis in "xyz")
                yield (float(row["t_s"]), STANDARD_GRAVITY * x, STANDARD_GRAVITY * y,
                       -STANDARD_GRAVITY * z)


def main():
    recording = Recording(
        0.75, 1.0, (768, 1024),
        palette=[{"name": n, "color": c, "opacity": o} for n, c, o in PALETTE],
        paper={"texture": "linen", "relief": 0.0004, "scale": 0.12,
               "reflectance": [0.8, 0.78, 0.72]},
        model={"scheme": "conservative"},
        title="Picked up", recorded_by="samples/balance-drips/make.py")
    painter = Painter(recording, seed=7)
    accelerations = list(read_accelerations())
    recording.event("gravity", **dict(zip("xyz", (rounded(a, 3) for a in accelerations[0][1:]))))
    recording.wait(0.2)
    painter.brush("round", size=0.04, medium=0.75, pigment=0.15)
    for n in range(15):
        painter.color(PALETTE[n % 4][0])
        row, column = divmod(n, 5)
        x, y = 0.07 + 0.125 * column + 0.03 * row, 0.08 + 0.12 * row + 0.02 * (column % 2)
        for back in (0.0, 0.01):  # there and back: a film that is thick enough to run
            painter.stroke([(x, y + back), (x + 0.05, y - 0.012 + back), (x + 0.1, y + back)],
                           speed=0.3, pressure=0.85)
    painter.brush("bristle", size=0.03, medium=0.5, pigment=1.0)
    for n in range(3):  # thick paint stays where it is
        painter.color(PALETTE[(n + 2) % 4][0])
        y = 0.5 + 0.13 * n
        painter.stroke([(0.08 + 0.02 * math.sin(n), y), (0.35, y + 0.02), (0.67, y - 0.01)],
                       speed=0.5)
    recording.event("mark", name="painted")
    recording.wait(0.3)
    start = recording.time
    for time, *force in accelerations:
        recording.event("gravity", start + time, **dict(zip("xyz", (rounded(a, 3) for a in force))))
    recording.event("mark", start + SECONDS, name="end")
    recording.write(output_path(HERE / "balance-drips.jsonl"))


if __name__ == "__main__":
    main()
