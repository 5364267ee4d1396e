#!/usr/bin/env python3
"""Writes knife.jsonl: mountains laid with a painting knife, and lines scraped through them."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path  # noqa: E402
from studio import dip, easel, rows  # noqa: E402

PALETTE = {"sky": "#7fa6c0", "high": "#4d7ba3", "snow": "#f4f2ec", "shade": "#7d93b4",
           "rock": "#4a4650", "rust": "#8a5a3c", "pine": "#27402f", "moss": "#6f7f3a",
           "lake": "#2f6076", "sun": "#ecd9a8"}


def facet(p, colours, x, y, dx, dy, size, pressure=0.85):
    p.brush("knife", size=size, medium=0.75, pigment=1, pickup=0.25, refill=0.03)
    dip(p, *colours)
    p.stroke([(x, y), (x + dx / 2, y + dy / 2), (x + dx, y + dy)], speed=0.3, pressure=pressure,
             tilt=(0, 0), taper=False)


def mountain(p, x, y, wide, high):
    """Rows of facets from the foot up to the peak, the lit ones at the left; each row over the one
    below, as slabs of snow lie."""
    for row in range(7, -1, -1):
        down = row / 7
        half = 0.5 * wide * down
        for n in range(row + 2):
            across = -1 + 2 * (n + 0.5) / (row + 2)
            px = x + half * across + p.vary(0.006)
            py = y + high * (down - 0.06) + p.vary(0.006)
            lit = across < 0.15 + p.vary(0.25)
            snow = p.random.random() > 0.75 * down - 0.1
            colours = ((("snow", "sun"), ("rust", "snow")) if lit else
                       (("shade", "snow"), ("rock", "shade")))[0 if snow else 1]
            slide = (-0.05 if lit else 0.05) * (0.5 + 0.6 * down)
            facet(p, colours, px, py, slide, 0.2 * high + p.vary(0.008), 0.032 + p.vary(0.008))


def main():
    p = easel("knife", "Painting knife", PALETTE, seed=9)
    p.brush("flat", size=0.05, medium=0.5, pigment=0.9)
    rows(p, -0.05, 0.55, 0.01, 0.24, 0.033, ["high", "sky", "sky", "sun"], speed=0.45)
    rows(p, -0.05, 0.55, 0.27, 0.37, 0.03, ["lake"], speed=0.45)
    p.recording.event("dry")
    mountain(p, 0.33, 0.09, 0.2, 0.15)
    mountain(p, 0.14, 0.05, 0.26, 0.19)
    for n in range(22):  # the far shore
        x = 0.023 * n + p.vary(0.008)
        facet(p, ("pine", "moss") if n % 3 else ("pine", "rust"), x, 0.268 + p.vary(0.005), 0.004,
              -0.018 - 0.014 * p.random.random(), 0.022)
    for n in range(16):  # the lake, flat
        y = 0.288 + 0.0055 * n
        x = 0.4 * p.random.random()
        facet(p, ("lake", "shade") if n % 3 else ("snow", "lake"), x, y, 0.12 + p.vary(0.04), 0.001, 0.02,
              0.7)
    p.brush("knife", size=0.016, medium=0, pigment=0, pickup=0.6, refill=0)  # scraping, clean
    for n in range(14):  # birches, out of the wet paint
        x = 0.36 + 0.01 * n + p.vary(0.004)
        p.stroke([(x, 0.36), (x + p.vary(0.004), 0.29), (x + p.vary(0.008), 0.23)], speed=0.3,
                 pressure=1, tilt=(0, 0), twist=90, taper=False)
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "knife.jsonl"))


if __name__ == "__main__":
    main()
