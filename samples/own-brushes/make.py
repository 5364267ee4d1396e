#!/usr/bin/env python3
"""Writes own-brushes.jsonl and the picture of a tip that it names: brushes that a log defines itself.
One row per brush: light, middling and full pressure, a swell, a fast stroke, over wet paint."""

import math
import pathlib
import struct
import sys
import zlib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Painter, Recording, output_path  # noqa: E402

PALETTE = {"prussian": "#1d3f77", "vermilion": "#c8341e", "sap": "#3f6b34", "umber": "#7a4426",
           "white": "#f4f0e4"}
BRUSHES = [
    {"name": "old hog", "shape": "filbert",
     "bristles": {"count": 60, "thickness": 0.05, "length_spread": 0.9, "clumping": 0.9},
     "stiffness": 0.9, "capacity": 30,
     "pressure": {"splay": [[0, 0], [0.3, 0.6], [1, 1]], "flow": [[0, 0.2], [0.5, 1]]}},
    {"name": "soft mop", "shape": "round",
     "bristles": {"count": 400, "length_spread": 0.1, "clumping": 0},
     "stiffness": 0, "grip": 0.2, "size_pressure": 0.1},
    {"name": "three tufts", "texture": "tufts.png",
     "bristles": {"count": 150, "thickness": 0.03, "length_spread": 0.5}},
    {"name": "stamp", "texture": "tufts.png", "spacing": 0.9}]
COLOURS = ["umber", "prussian", "vermilion", "sap"]
LENGTH = 0.115


def tufts(side=96):
    """Rows of grey, white where the tip touches: three soft discs, the middle one largest."""
    discs = [(0.2, 0.5, 0.13), (0.5, 0.5, 0.2), (0.82, 0.5, 0.1)]
    rows = []
    for j in range(side):
        row = bytearray([0])
        for i in range(side):
            x, y = (i + 0.5) / side, (j + 0.5) / side
            depth = max(r - math.hypot(x - cx, y - cy) for cx, cy, r in discs)
            row.append(round(255 * min(1, max(0, depth / 0.04))))
        rows.append(bytes(row))
    return rows


def write_png(path, rows):
    def chunk(name, data):
        return (struct.pack(">I", len(data)) + name + data +
                struct.pack(">I", zlib.crc32(name + data)))
    side = len(rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b""))


def mark(p, x, y, pressure, speed=0.35):
    """A wavy stroke whose pressure is a function of the way along it."""
    recording = p.recording
    count = max(4, int(LENGTH / speed * 120))
    for n in range(count):
        u = n / (count - 1)
        phase = "down" if n == 0 else "up" if n == count - 1 else "move"
        recording.touch(phase, x + LENGTH * u, y + 0.008 * math.sin(2 * math.pi * u),
                        recording.time + n / 120, 0, pressure(u))
    recording.wait(count / 120 + 0.05)


def main():
    recording = Recording(
        0.86, 0.4, (1032, 480), model={"scheme": "conservative"},
        paper={"texture": "linen", "relief": 0.0004, "scale": 0.09,
               "reflectance": [0.82, 0.79, 0.72]},
        palette=[{"name": n, "color": c, "opacity": 0.85} for n, c in PALETTE.items()],
        brushes=BRUSHES, title="Brushes of a log's own", recorded_by="samples/own-brushes/make.py")
    p = Painter(recording)
    for row, (brush, colour) in enumerate(zip(BRUSHES, COLOURS)):
        y = 0.05 + 0.1 * row
        p.brush("flat", size=0.05, medium=0.6, pigment=0.9)
        p.color("white")
        for dy in (-0.012, 0.014):
            p.stroke([(0.715, y + dy), (0.725 + LENGTH, y + dy)], speed=0.4, taper=False,
                     tilt=(0, 0), tremor=0)
        p.brush(brush["name"], size=0.05, medium=0.5, pigment=0.9)
        p.color(colour)
        for column, pressure in enumerate((0.15, 0.5, 1.0)):
            mark(p, 0.04 + 0.135 * column, y, lambda u, f=pressure: f)
        mark(p, 0.445, y, lambda u: u)
        mark(p, 0.58, y, lambda u: 0.8, speed=2.2)
        mark(p, 0.715, y, lambda u: 0.8)
    recording.event("mark", name="end")
    target = output_path(HERE / "own-brushes.jsonl")
    write_png(pathlib.Path(target).parent / "tufts.png", tufts())
    recording.write(target)


if __name__ == "__main__":
    main()
