#!/usr/bin/env python3
"""Writes a log of four straight strokes, one brush each, nearly along the rows: for sharpness.py.

    straight_strokes.py OUT.jsonl [CELL_MM]

The strokes are 30 mm wide on a canvas of 400 x 300 mm, whose cells are CELL_MM wide (1.25 unless said).
"""
import json
import sys


def events():
    t = 0
    for number, brush in enumerate(("round", "flat", "filbert", "bristle")):
        yield {"t": t, "type": "brush", "name": brush}
        yield {"t": t, "type": "slider", "name": "size", "value": 0.03}
        x, y = 0.04, 0.045 + 0.065 * number
        yield {"t": t, "type": "touch", "phase": "down", "x": x, "y": y, "pressure": 0.8}
        for _ in range(40):
            t, x, y = round(t + 0.03, 4), round(x + 0.008, 5), round(y + 0.0004, 5)
            yield {"t": t, "type": "touch", "phase": "move", "x": x, "y": y, "pressure": 0.8}
        yield {"t": t, "type": "touch", "phase": "up", "x": x, "y": y}
        t = round(t + 0.3, 4)


def main(out, cell_mm="1.25"):
    cell_mm = float(cell_mm)
    header = {"type": "header", "format": "pentimento-log", "version": 1, "canvas": {"width": 0.4, "height": 0.3},
              "grid": {"width": round(400 / cell_mm), "height": round(300 / cell_mm)},
              "palette": [{"name": "blue", "color": "#203a8a", "opacity": 0.9}]}
    with open(out, "w", encoding="utf-8") as log:
        for line in (header, *events()):
            log.write(json.dumps(line) + "\n")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
