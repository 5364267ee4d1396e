"""Strokes that follow a flow: a log of 220 strokes of a flat brush, wet in wet.

  flow_field.py LOG
"""

import math
import random
import sys

import pentimento

PALETTE = ["French Ultramarine", "Cerulean Blue", "Titanium White", "Yellow Ochre", "Cadmium Red"]
WIDTH_M, HEIGHT_M = 1.0, 0.75


def direction(x, y):
    """The angle of the flow: three slow waves, turned by one vortex."""
    vortex = math.atan2(y - 0.33, x - 0.62)
    near = math.exp(-((x - 0.62) ** 2 + (y - 0.33) ** 2) / 0.05)
    waves = 0.6 * math.sin(5 * x + 1) + 0.5 * math.cos(7 * y + 2 * x)
    return (1 - near) * waves + near * (vortex + math.pi / 2)


def line(x, y, steps=26, step_m=0.012):
    points = []
    for i in range(steps):
        pressure = 0.35 + 0.55 * math.sin(math.pi * (i + 1) / (steps + 1))
        points.append((x, y, pressure))
        angle = direction(x, y)
        x += step_m * math.cos(angle)
        y += step_m * math.sin(angle)
    return points


def main():
    chance = random.Random(5)
    with pentimento.Session(sys.argv[1], WIDTH_M, HEIGHT_M, grid=(640, 480), palette=PALETTE, title="Flow") as session:
        session.brush("flat", size_m=0.05, medium=0.5)
        for i in range(220):
            x, y = chance.uniform(-0.1, 1.0), chance.uniform(-0.02, 0.77)
            near = math.hypot(x - 0.62, y - 0.33)
            # Warm in the vortex, cold far from it, white now and then.
            color = chance.choices(PALETTE, weights=(1 + 3 * near, 2, 0.8, max(0.05, 1.6 - 4 * near), max(0.02, 0.9 - 4 * near)))[0]
            session.color(color)
            session.slider("size", 0.05 if i < 120 else 0.028)
            session.spline(line(x, y), speed_m_s=1.2)
            session.wait(0.05)


main()
