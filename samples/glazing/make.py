#!/usr/bin/env python3
"""Writes glazing.jsonl: three fruits painted in grey, dried, then coloured by transparent glazes."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import arc, dry, easel, rows  # noqa: E402

GREYS = {f"grey {n}": "#" + 3 * f"{round(40 + 205 * (n / 9) ** 0.8):02x}" for n in range(10)}
GLAZES = {"crimson": ("#9c1022", 0.06), "gold": ("#d08a10", 0.08), "sap": ("#4e6a14", 0.07),
          "violet": ("#2e2048", 0.08), "brown": ("#4a2a12", 0.08)}
FRUITS = [(0.14, 0.235, 0.068, "crimson"), (0.275, 0.22, 0.083, "gold"), (0.4, 0.25, 0.056, "sap")]


def grey(p, light):
    p.color(f"grey {max(0, min(9, round(9 * light)))}")


def fruit(p, x, y, radius):
    """Rings of strokes, each as light as the ball is there; the light is at the upper left."""
    for ring in range(6, -1, -1):
        r = radius * ring / 6.4
        for piece in range(max(1, 3 * ring)):
            a = 2 * math.pi * piece / max(1, 3 * ring)
            px, py = r * math.cos(a) / radius, r * math.sin(a) / radius
            pz = math.sqrt(max(0.0, 1 - px * px - py * py))
            shade = max(0.0, -0.5 * px - 0.62 * py + 0.6 * pz)
            bounce = 0.16 * max(0.0, py)
            grey(p, 0.08 + 0.92 * shade ** 1.2 + bounce)
            p.stroke(arc(x, y, max(r, 0.004), a, 1.8 / max(1, 3 * ring) * math.pi, 5), speed=0.2,
                     pressure=0.8, taper=False)


def glaze(p, x, y, radius):
    """One transparent film over the whole ball: rings, from the rim inwards, without lifting."""
    points = []
    for k in range(60):
        r = radius * (0.96 - 0.92 * k / 59)
        points.append((x + r * math.cos(0.62 * k), y + r * math.sin(0.62 * k)))
    p.stroke(points, speed=0.4, pressure=0.9, taper=False)


def main():
    p = easel("glazing", "Glazing", {**GREYS, **GLAZES}, seed=4, ground=(0.7, 0.67, 0.6))
    p.brush("flat", size=0.04, medium=0.5, pigment=0.95)
    rows(p, -0.05, 0.55, 0.01, 0.2, 0.026, ["grey 5", "grey 6", "grey 6", "grey 7"], speed=0.4)
    rows(p, -0.05, 0.55, 0.225, 0.37, 0.026, ["grey 8", "grey 9"], speed=0.4)
    p.brush("filbert", size=0.024, medium=0.5, pigment=0.95)
    for x, y, radius, _ in FRUITS:  # shadows on the table
        p.color("grey 2")
        for k in range(3):
            p.stroke([(x, y + radius * (0.9 + 0.08 * k)), (x + radius, y + radius * (0.97 + 0.07 * k)),
                      (x + 1.7 * radius, y + radius)], speed=0.3)
    for x, y, radius, _ in FRUITS:
        fruit(p, x, y, radius)
    p.recording.event("mark", name="grey")
    dry(p)
    p.brush("round", size=0.03, medium=0.25, pigment=0.16, pickup=0.1)
    for x, y, radius, colour in FRUITS:
        p.color(colour)
        glaze(p, x, y, radius)
    dry(p)
    p.brush("flat", size=0.045, medium=0.3, pigment=0.2, pickup=0.1)
    rows(p, -0.05, 0.55, 0.012, 0.13, 0.03, ["violet"], speed=0.4)
    rows(p, -0.05, 0.55, 0.315, 0.37, 0.03, ["brown"], speed=0.4)
    dry(p)
    p.brush("round", size=0.034, medium=0.25, pigment=0.3, pickup=0.1)
    for x, y, radius, colour in FRUITS:  # a second glaze of each, in the shadows only
        p.color(colour)
        p.stroke(arc(x, y, 0.76 * radius, -0.3, 2.1), speed=0.25, pressure=0.9)
        p.stroke(arc(x, y, 0.5 * radius, 0, 1.6), speed=0.25, pressure=0.8)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "glazing.jsonl"))


if __name__ == "__main__":
    main()
