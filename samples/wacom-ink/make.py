#!/usr/bin/env python3
"""Writes wacom-ink.jsonl from a Wacom ink session: handwriting with pressure and a leaning pen.

The pen's lean comes as altitude (pi/2 = upright) and azimuth (from +x, towards +y). The log wants
it as two angles in the planes of the axes, as W3C Pointer Events define them:
tilt_x = atan(cos(azimuth) / tan(altitude)), tilt_y = atan(sin(azimuth) / tan(altitude)).
Pauses longer than 0.3 s are shortened to that: what the pen does is kept, what it waits is not.
"""

import csv
import itertools
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Recording, output_path  # noqa: E402

SOURCE = HERE.parent / "data/wacom-uim/digital-ink-processable.csv"
WIDTH, HEIGHT = 1.0, 0.5
LONGEST_PAUSE = 0.3
COLORS = {("74", "74", "74"): "payne's grey", ("33", "33", "33"): "ivory black",
          ("0", "150", "255"): "cerulean"}
PALETTE = [{"name": "payne's grey", "color": "#3a4150"},
           {"name": "ivory black", "color": "#1d1a18"}, {"name": "cerulean", "color": "#0e86d4"}]


def tilt(altitude, azimuth):
    """The pen's lean as (tilt_x, tilt_y) in degrees."""
    lean = 1 / math.tan(max(altitude, 0.02))
    return (math.degrees(math.atan(math.cos(azimuth) * lean)),
            math.degrees(math.atan(math.sin(azimuth) * lean)))


def read_strokes():
    with open(SOURCE, newline="") as source:
        rows = list(csv.DictReader(source))
    return [list(group) for _, group in itertools.groupby(rows, key=lambda row: row["stroke"])]


def main():
    strokes = read_strokes()
    xs = [float(row["x_px"]) for stroke in strokes for row in stroke]
    ys = [float(row["y_px"]) for stroke in strokes for row in stroke]
    scale = 0.92 * WIDTH / (max(xs) - min(xs))
    left = (WIDTH - scale * (max(xs) - min(xs))) / 2 - scale * min(xs)
    top = (HEIGHT - scale * (max(ys) - min(ys))) / 2 - scale * min(ys)

    recording = Recording(WIDTH, HEIGHT, (1024, 512), palette=PALETTE,
                          model={"scheme": "conservative"},
                          paper={"texture": "linen", "relief": 0.0002, "scale": 0.09,
                                 "reflectance": [0.8, 0.78, 0.72]},
                          title="Digital ink", recorded_by="WILL3, by samples/wacom-ink/make.py")
    recording.event("brush", name="round")
    recording.slider(size=0.0075, medium=0.3, pigment=0.9)
    color, time, previous_end = None, 0.2, None
    for stroke in strokes:
        begin = float(stroke[0]["t_s"])
        if previous_end is not None:
            time += min(max(begin - previous_end, 0.01), LONGEST_PAUSE)
        wanted = COLORS[tuple(stroke[0][band] for band in "rgb")]
        if wanted != color:
            color = wanted
            recording.event("color", time, pigment=color)
        recording.samples([(time + float(row["t_s"]) - begin,
                            left + scale * float(row["x_px"]), top + scale * float(row["y_px"]),
                            float(row["pressure"]),
                            tilt(float(row["altitude_rad"]), float(row["azimuth_rad"])))
                           for row in stroke])
        previous_end = float(stroke[-1]["t_s"])
        time += previous_end - begin
    recording.write(output_path(HERE / "wacom-ink.jsonl"))


if __name__ == "__main__":
    main()
