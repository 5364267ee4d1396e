#!/usr/bin/env python3
"""Writes blue-tit.jsonl.gz from the Tilt Brush sketch "Blue Tit": 471 strokes in 28 colours.

The sketch was painted in the air; its points come projected on the plane that fits them best
(u right, v down, w depth). The mirror twins of a stroke were painted at the same time, so they are
a second finger here. Real timing is kept, but pauses longer than 0.1 s are shortened to that.
The depth, which a canvas does not have, stays in the log as `x-depth` events: one list per stroke.
"""

import csv
import gzip
import itertools
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Recording, output_path, rounded  # noqa: E402

SOURCE = HERE.parent / "data/tilt-brush/Blue_Tit.csv.gz"
WIDTH, HEIGHT = 0.75, 1.0
MARGIN = 0.03
LONGEST_PAUSE = 0.1
BRUSH = 0.8  # of the sketch's size: a brush is wider than the ribbon it stands for


def read_strokes():
    """The strokes in the order of time; each a list of rows with numbers."""
    with gzip.open(SOURCE, "rt", newline="") as source:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(source)]
    groups = itertools.groupby(rows, key=lambda row: row["stroke"])
    return sorted((list(group) for _, group in groups), key=lambda s: (s[0]["t_s"], s[0]["mirror"]))


def hex_color(row):
    return "#" + "".join(f"{round(255 * row[band]):02x}" for band in "rgb")


def shorten_pauses(strokes):
    """When each stroke begins, with the time in which no pen is down cut to LONGEST_PAUSE."""
    begins, busy_until, cut = [], strokes[0][0]["t_s"], strokes[0][0]["t_s"] - 0.1
    for stroke in strokes:
        begin = stroke[0]["t_s"]
        cut += max(0.0, begin - busy_until - LONGEST_PAUSE)
        begins.append(begin - cut)
        busy_until = max(busy_until, stroke[-1]["t_s"])
    return begins


def main():
    strokes = read_strokes()
    us = [row["u"] for stroke in strokes for row in stroke]
    vs = [row["v"] for stroke in strokes for row in stroke]
    scale = min((WIDTH - 2 * MARGIN) / (max(us) - min(us)),
                (HEIGHT - 2 * MARGIN) / (max(vs) - min(vs)))
    left = (WIDTH - scale * (max(us) + min(us))) / 2
    top = (HEIGHT - scale * (max(vs) + min(vs))) / 2

    recording = Recording(
        WIDTH, HEIGHT, (768, 1024), model={"scheme": "conservative"},
        paper={"texture": "linen", "relief": 0.0004, "scale": 0.12,
               "reflectance": [0.8, 0.78, 0.72]},
        title="Blue Tit",
        author="Tilt Brush sample sketches, Google", recorded_by="samples/blue-tit/make.py",
        brushes=[{"name": "ink", "shape": "round", "size_pressure": 0.6, "flow_pressure": 0.6}])
    recording.event("brush", name="ink")
    recording.slider(medium=0.4, pigment=0.9, pickup=0.15, layer_mixing=0.15)
    color, size = None, None
    for stroke, begin in zip(strokes, shorten_pauses(strokes)):
        first, finger = stroke[0], int(stroke[0]["mirror"])
        if hex_color(first) != color:
            color = hex_color(first)
            recording.event("color", begin, value=color)
        if first["size"] != size:
            size = first["size"]
            recording.event("slider", begin, name="size", value=rounded(BRUSH * scale * size))
        recording.samples([(begin + row["t_s"] - first["t_s"], left + scale * row["u"],
                            top + scale * row["v"], row["pressure"], None) for row in stroke],
                          finger)
        end = begin + stroke[-1]["t_s"] - first["t_s"]
        recording.event("x-depth", end, id=finger,
                        w=[rounded(scale * row["w"], 4) for row in stroke])
    recording.write(output_path(HERE / "blue-tit.jsonl.gz"))


if __name__ == "__main__":
    main()
