"""What the pictures of the gallery share: a canvas of 50 by 37.5 cm on an easel, lying flat, and a
painter in front of it. Lengths in metres, times in seconds."""

import math

from recording import Painter, Recording

WIDTH, HEIGHT = 0.5, 0.375
GRID = (640, 480)


def easel(name, title, palette, seed=1, ground=(0.78, 0.74, 0.66), relief=0.0003, **header):
    """A painter with a primed canvas. `palette`: name to colour, or to (colour, opacity)."""
    pigments = []
    for pigment, colour in palette.items():
        value, opacity = colour if isinstance(colour, tuple) else (colour, 0.85)
        pigments.append({"name": pigment, "color": value, "opacity": opacity})
    model = {"scheme": "conservative", **header.pop("model", {})}
    recording = Recording(
        WIDTH, HEIGHT, GRID, model=model, palette=pigments,
        paper={"texture": "linen", "relief": relief, "scale": 0.06, "reflectance": list(ground)},
        title=title, recorded_by=f"samples/{name}/make.py", **header)
    return Painter(recording, seed=seed)


def dip(p, *colours):
    """Each colour on its share of the brush's width, the first at the left of a stroke."""
    for n, colour in enumerate(colours):
        side = {} if n == 0 else {"across": [n / len(colours), 1]}
        p.recording.event("color", pigment=colour, **side)


def arc(x, y, radius, start, sweep, count=7, flat=1.0):
    """Points along a part of an ellipse."""
    return [(x + radius * math.cos(start + sweep * k / (count - 1)),
             y + flat * radius * math.sin(start + sweep * k / (count - 1))) for k in range(count)]


def rows(p, x0, x1, y0, y1, step, colours, **stroke):
    """Fills a rectangle with strokes to and fro; `colours` change from the top to the bottom."""
    count = max(1, round((y1 - y0) / step))
    for n in range(count + 1):
        y = y0 + (y1 - y0) * n / count
        p.color(colours[min(len(colours) - 1, n * len(colours) // (count + 1))])
        ends = (x0, x1) if n % 2 == 0 else (x1, x0)
        middle = (ends[0] + ends[1]) / 2 + p.vary(0.05)
        p.stroke([(ends[0], y + p.vary(0.003)), (middle, y + p.vary(0.005)),
                  (ends[1], y + p.vary(0.003))], **stroke)


def dry(p):
    p.recording.event("dry")
    p.recording.wait(0.1)
