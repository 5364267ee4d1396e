"""A sunset in glazes: thin transparent layers, each dried before the next.

  sunset.py LOG
"""

import math
import sys

import pentimento

PALETTE = ["Titanium White", "Hansa Yellow", "Brilliant Orange", "Quinacridone Rose", "French Ultramarine", "Burnt Umber"]


def veil(session, color, top, bottom, pigment, rows):
    """A glaze over a part of the sky: side by side strokes of thin paint, and then it dries."""
    session.color(color)
    session.slider("pigment", pigment)
    for i in range(rows):
        y = top + (bottom - top) * (i + 0.5) / rows
        points = [(-0.05 + 1.1 * k / 8, y + 0.006 * math.sin(3 * k + 5 * i), 0.75) for k in range(9)]
        session.spline(points if i % 2 else points[::-1], speed_m_s=2)
    session.wait(1)
    session.dry()


def main():
    with pentimento.Session(sys.argv[1], 1, 0.75, grid=(640, 480), palette=PALETTE, title="Sunset in glazes") as session:
        session.brush("flat", size_m=0.09, medium=0.6)
        veil(session, "Titanium White", 0, 0.75, 0.8, 12)
        veil(session, "Hansa Yellow", 0.22, 0.75, 0.10, 9)
        veil(session, "Brilliant Orange", 0.30, 0.52, 0.07, 5)
        veil(session, "Quinacridone Rose", 0.10, 0.42, 0.06, 6)
        veil(session, "French Ultramarine", -0.02, 0.26, 0.10, 5)
        veil(session, "French Ultramarine", -0.02, 0.14, 0.10, 3)
        veil(session, "Quinacridone Rose", 0.36, 0.50, 0.05, 3)
        # The sun, and its light on the sea, are thick.
        session.brush("round", size_m=0.05, medium=0.7)
        session.slider("pigment", 0.7)
        session.color("Titanium White")
        session.spline([(0.62 + 0.022 * math.cos(a), 0.40 + 0.022 * math.sin(a)) for a in range(8)], 0.2)
        session.brush("flat", size_m=0.018)
        for i in range(14):
            y = 0.53 + 0.012 * i
            half = 0.02 + 0.010 * i
            session.color("Titanium White" if i % 3 else "Hansa Yellow")
            session.spline([(0.62 - half * (0.6 + 0.4 * math.sin(7 * i)), y), (0.62 + half, y + 0.002)], 0.5, 0.6)
        # Hills against the light.
        session.brush("filbert", size_m=0.05)
        session.color("Burnt Umber")
        for x0, x1, y in ((-0.05, 0.45, 0.50), (-0.05, 0.30, 0.475), (0.80, 1.05, 0.495)):
            session.spline([(x0, y + 0.02), ((x0 + x1) / 2, y - 0.012), (x1, y + 0.02)], 0.6)
        session.wait(0.5)


main()
