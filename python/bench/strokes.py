"""Strokes a second of a core on a canvas of 128 x 128 cells: state only, and with a picture after each, with the usual distance
of the brush's stamps and with stamps a cell apart.

  PYTHONPATH=build/python python3 python/bench/strokes.py [STROKES]

Seconds are those of the processor, so that others who use the core count little; the best of three rounds.
"""

import random
import sys
import time

import pentimento


def strokes(count, seed=1):
    """Curves across a part of the canvas, as other stroke renderers are asked for."""
    numbers = random.Random(seed)
    for _ in range(count):
        points = [(numbers.uniform(0.05, 0.95), numbers.uniform(0.05, 0.95)) for _ in range(3)]
        yield pentimento.bezier(points, 16)


USUAL_SPACING, CELL_APART = 0.025, 0.125  # of the brush's diameter
ROUNDS = 3


def rate(count, picture, spacing):
    canvas = pentimento.Canvas(1, 1, grid=(128, 128), palette=["French Ultramarine", "Titanium White", "Yellow Ochre"])
    canvas.brush("flat", size_m=0.06, spacing=spacing)
    canvas.picture()  # opens the shader
    began = time.process_time()
    for i, stroke in enumerate(strokes(count)):
        canvas.color(["French Ultramarine", "Titanium White", "Yellow Ochre"][i % 3])
        canvas.paint(stroke, speed_m_s=5)
        if picture:
            canvas.picture()
    return count / (time.process_time() - began)


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    for spacing in (USUAL_SPACING, CELL_APART):
        best = [max(rate(count, picture, spacing) for _ in range(ROUNDS)) for picture in (False, True)]
        print(f"stamps {spacing:g} diameters apart: {best[0]:.0f} strokes a second, with a picture after each {best[1]:.0f}",
              flush=True)


main()
