#!/usr/bin/env python3
"""Writes non-square.jsonl: cells twice as high as wide, thick and thin paint, two colours in one
brush, a knife, the tablet tilted along both axes, drying, and strokes over what is dry.

usage: make_non_square.py FILE
"""

import json
import math
import sys


def emit(lines, **fields):
    lines.append(json.dumps(fields, separators=(",", ":")))


def stroke(lines, t, start, end, pressure):
    steps = 18
    for i in range(steps + 1):
        along = i / steps
        phase = "down" if i == 0 else "up" if i == steps else "move"
        bow = 0.02 * math.sin(math.pi * along)
        emit(lines, t=round(t + i / 60, 4), type="touch", phase=phase,
             x=round(start[0] + along * (end[0] - start[0]) + bow, 5),
             y=round(start[1] + along * (end[1] - start[1]) - bow, 5),
             pressure=pressure, tilt_x=20, tilt_y=-30)


def sliders(lines, t, **values):
    for name, value in values.items():
        emit(lines, t=t, type="slider", name=name, value=value)


def main():
    lines = []
    emit(lines, type="header", format="pentimento-log", version=1,
         canvas={"width": 0.3, "height": 0.24}, grid={"width": 240, "height": 96},
         palette=[{"name": "blue", "color": "#23427c", "opacity": 0.5},
                  {"name": "ochre", "color": "#c79a3c"}, {"name": "white", "color": "#f4f2ea"}])
    emit(lines, t=0, type="brush", name="flat")
    sliders(lines, 0, size=0.03, medium=0.8, pigment=0.15)
    emit(lines, t=0, type="color", pigment="blue")
    stroke(lines, 0, (0.04, 0.05), (0.26, 0.06), 0.9)
    stroke(lines, 0.4, (0.05, 0.05), (0.06, 0.2), 0.9)
    emit(lines, t=0.8, type="brush", name="bristle")
    sliders(lines, 0.8, size=0.04, medium=0.5, pigment=1)
    emit(lines, t=0.8, type="color", pigment="ochre")
    emit(lines, t=0.8, type="color", pigment="white", across=[0, 0.4])
    stroke(lines, 0.8, (0.1, 0.2), (0.25, 0.09), 0.7)
    emit(lines, t=1.2, type="gravity", x=4, y=-6, z=5)
    emit(lines, t=1.9, type="gravity", x=-7, y=2, z=5)
    emit(lines, t=2.4, type="gravity", x=0, y=0, z=9.81)
    emit(lines, t=2.5, type="brush", name="knife")
    stroke(lines, 2.5, (0.05, 0.15), (0.22, 0.15), 0.8)
    emit(lines, t=2.9, type="dry")
    emit(lines, t=2.9, type="brush", name="round")
    sliders(lines, 2.9, size=0.02, medium=0.6, pigment=0.6)
    emit(lines, t=2.9, type="color", pigment="blue")
    stroke(lines, 3, (0.08, 0.06), (0.2, 0.19), 0.6)
    emit(lines, t=3.4, type="gravity", x=3, y=8, z=4)
    emit(lines, t=4, type="mark", name="end")
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
