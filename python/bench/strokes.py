"""Strokes a second of the engine on a canvas of 128 x 128 cells: state only, and with a picture after each.

  PYTHONPATH=build/python python3 python/bench/strokes.py [STROKES]
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


def rate(count, picture):
    canvas = pentimento.Canvas(1, 1, grid=(128, 128), palette=["French Ultramarine", "Titanium White", "Yellow Ochre"])
    canvas.brush("flat", size_m=0.06)
    canvas.picture()  # opens the shader
    began = time.perf_counter()
    for i, stroke in enumerate(strokes(count)):
        canvas.color(["French Ultramarine", "Titanium White", "Yellow Ochre"][i % 3])
        canvas.paint(stroke, speed_m_s=5)
        if picture:
            canvas.picture()
    return count / (time.perf_counter() - began)


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    print(f"state only: {rate(count, False):.0f} strokes a second, with a picture: {rate(count, True):.0f}")


main()
