#!/usr/bin/env python3
"""Writes first-painting.jsonl: a river landscape, painted stroke by stroke.

Wet on wet in the sky and the water, thin rain that runs when the tablet is raised, a dry, glazes
over it, then impasto with every built-in tip.
"""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import Painter, Recording, output_path, turn_tablet  # noqa: E402

PALETTE = {
    "titanium white": "#f6f3ea", "ultramarine": "#27388f", "high blue": "#4a72b4",
    "sky blue": "#7fb2d6", "haze": "#b4bfc9", "rose grey": "#d9b7a8", "warm light": "#f3d9a4",
    "cloud shade": "#8f9bb3", "violet hill": "#6d6a9c", "far slope": "#8d86b0",
    "umber": "#4a3122", "sap green": "#4d6b2c", "meadow": "#8fa33b", "cadmium yellow": "#f2b61c",
    "cadmium red": "#c8281e", "deep green": "#22402c", "rain": "#5a6a86",
    "glaze orange": "#e08a2e", "glaze violet": "#3d2f63",
}
OPACITY = {"glaze orange": 0.12, "glaze violet": 0.15, "rain": 0.3, "sky blue": 0.8,
           "titanium white": 0.85, "cadmium yellow": 0.8}


def hill_line(x, base, height, phase):
    """The height of a ridge over x, metres from the top."""
    return base - height * (0.6 * math.sin(3.1 * x + phase) + 0.3 * math.sin(8.3 * x + 2 * phase)
                            + 0.1 * math.sin(19 * x))


def river_middle(y):
    """The middle of the river at height y: narrow and far at 0.42, wide and near at 0.75."""
    near = (y - 0.42) / 0.33
    return 0.58 + 0.13 * math.sin(4.6 * near + 0.6) * (0.35 + 0.65 * near) - 0.16 * near


def river_half_width(y):
    near = max(0.0, (y - 0.42) / 0.33)
    return 0.012 + 0.115 * near * near


def paint_sky(p):
    p.brush("flat", size=0.066, medium=0.42, pigment=0.8)
    rows = ["ultramarine", "high blue", "high blue", "sky blue", "sky blue", "haze", "rose grey",
            "warm light", "warm light"]
    for n, color in enumerate(rows):
        y = 0.02 + 0.042 * n
        p.color(color)
        ends = [(-0.03, 0.36), (0.3, 0.7), (0.64, 1.03)]
        for x0, x1 in (ends if n % 2 == 0 else [(b, a) for a, b in reversed(ends)]):
            p.stroke([(x0, y + p.vary(0.012)), ((x0 + x1) / 2, y + p.vary(0.018)),
                      (x1, y + p.vary(0.012))], speed=0.66)
    p.brush("round", size=0.026, medium=0.8, pigment=1.0)
    p.color("cadmium yellow")  # the sun, wound from the middle outwards
    p.stroke([(0.3 + 0.0021 * k * math.cos(k), 0.296 + 0.0021 * k * math.sin(k))
              for k in range(11)], speed=0.25, taper=False)


def paint_clouds(p):
    clouds = [(0.15, 0.115, 0.15), (0.33, 0.085, 0.11), (0.7, 0.13, 0.13), (0.86, 0.1, 0.17),
              (0.52, 0.185, 0.1)]
    for cx, cy, width in clouds:
        p.brush("bristle", size=0.026, medium=0.5, pigment=0.7)
        p.color("cloud shade")  # the underside first, the lit heads over it while it is wet
        for n in range(3):
            y = cy + 0.008 + 0.011 * n
            p.stroke([(cx - (0.6 - 0.12 * n) * width + p.vary(0.015), y + 0.004),
                      (cx + p.vary(0.02), y + p.vary(0.006)),
                      (cx + (0.62 - 0.15 * n) * width + p.vary(0.015), y - 0.002)], speed=0.5,
                     pressure=0.6, pause=0.05)
        p.brush("filbert", medium=0.6, pigment=0.95)
        heads = 8
        for n in range(heads):
            p.color("warm light" if n in (3, 6) else "titanium white")
            u = n / (heads - 1) - 0.5
            size = 0.45 + 0.55 * math.cos(2.6 * u) + p.vary(0.2)
            p.recording.slider(size=0.03 + 0.012 * size)
            x, y = cx + u * width + p.vary(0.01), cy - 0.016 * size + p.vary(0.008)
            r = 0.017 * size
            p.stroke([(x - r, y + 0.6 * r), (x - 0.6 * r, y - 0.7 * r), (x + 0.4 * r, y - 0.9 * r),
                      (x + 1.3 * r, y + 0.2 * r)], speed=0.3, pressure=0.75, pause=0.04)


def paint_hills(p):
    for base, height, phase, color, light in [(0.375, 0.05, 0.4, "violet hill", "far slope"),
                                              (0.43, 0.04, 2.2, "deep green", "sap green")]:
        p.brush("flat", size=0.05, medium=0.4, pigment=0.85)
        p.color(color)
        for row in range(3):
            for x0, x1 in [(-0.02, 0.28), (0.24, 0.54), (0.5, 0.8), (0.76, 1.02)]:
                xs = [x0 + (x1 - x0) * k / 4 for k in range(5)]
                p.stroke([(x, hill_line(x, base, height, phase) + 0.024 + 0.035 * row)
                          for x in xs], speed=0.55)
        p.brush("bristle", size=0.024, medium=0.3, pigment=0.6)
        p.color(light)
        for n in range(12):  # light on the slopes, falling with them
            x = 0.01 + 0.085 * n + p.vary(0.03)
            top = hill_line(x, base, height, phase) + 0.012
            p.stroke([(x, top), (x + 0.02, top + 0.008), (x + 0.045, top + 0.026),
                      (x + 0.055, top + 0.045 + p.vary(0.01))], speed=0.3, pressure=0.45)


def paint_ground(p):
    """A lean first coat under the meadow, so that no canvas shows between its strokes."""
    p.brush("flat", size=0.1, medium=0.25, pigment=0.6)
    for n, y in enumerate((0.475, 0.55, 0.625, 0.69, 0.745)):
        p.color("sap green" if n < 2 else "deep green")
        p.stroke([(-0.03, y), (0.5, y + 0.01), (1.03, y)] if n % 2 == 0
                 else [(1.03, y), (0.5, y - 0.01), (-0.03, y)], speed=0.9, taper=False)


def paint_meadow(p):
    """Short strokes that lie as the ground does, lighter towards the sun and darker in front."""
    p.brush("bristle", size=0.05, medium=0.42, pigment=0.85)
    for row in range(8):
        y = 0.462 + 0.039 * row
        for side in (-1, 1):
            edge = river_middle(y) + side * (river_half_width(y) + 0.014)
            end = -0.03 if side < 0 else 1.03
            pieces = max(1, round(abs(end - edge) / 0.17))
            for k in range(pieces):
                a = edge + (end - edge) * k / pieces
                b = edge + (end - edge) * (k + 1.2) / pieces
                lift = 0.012 * math.sin(7 * a + row)
                shade = 0.25 + 0.5 * a + 0.07 * row + p.vary(0.35)
                p.color("meadow" if shade < 0.6 else "sap green" if shade < 1.0 else "deep green")
                p.stroke([(a, y + lift), ((a + b) / 2, y - 0.008 + lift), (b, y + p.vary(0.01))],
                         speed=0.6, pressure=0.75, pause=0.04)


def paint_river(p):
    """Along the stream in two blues and white, then across it: the colours marble."""
    lanes = [(-0.8, "high blue"), (0.0, "sky blue"), (0.55, "sky blue"), (-0.4, "sky blue"),
             (0.25, "high blue"), (0.85, "ultramarine"), (-0.15, "titanium white"),
             (0.65, "warm light")]
    for ys, size, speed in [([0.425, 0.45, 0.48, 0.51, 0.54], 0.017, 0.35),
                            ([0.53, 0.56, 0.59, 0.62, 0.65], 0.03, 0.42),
                            ([0.63, 0.66, 0.69, 0.72, 0.765], 0.05, 0.5)]:
        p.brush("flat", size=size, medium=0.5, pigment=0.8)
        for lane, color in lanes:
            p.color(color)
            light = color in ("titanium white", "warm light")
            p.recording.slider(size=0.5 * size if light else size)
            p.stroke([(river_middle(y) + lane * river_half_width(y), y) for y in ys], speed=speed,
                     pressure=0.75, pause=0.05)
    p.brush("round", size=0.016, medium=0.55, pigment=0.7)
    for n in range(10):
        p.color(["titanium white", "ultramarine", "warm light"][n % 3])
        y = 0.51 + 0.024 * n
        x, w = river_middle(y), 0.7 * river_half_width(y)
        p.stroke([(x - w, y), (x - 0.4 * w, y + 0.008), (x + 0.1 * w, y - 0.006),
                  (x + w, y + 0.004)],
                 speed=0.26, pressure=0.6)


def paint_rain(p):
    """Thin paint under the right clouds; the tablet is raised and it runs down as rain."""
    r = p.recording
    p.brush("round", size=0.026, medium=1.0, pigment=0.1)
    p.color("rain")
    for n in range(13):
        x = 0.6 + 0.03 * n + p.vary(0.008)
        y = 0.165 + p.vary(0.014)
        p.recording.slider(size=0.016 + 0.014 * p.random.random())
        for back in (0.0, 0.008):  # twice over: a film thick enough to run
            p.stroke([(x, y + back), (x + 0.006, y + 0.01 + back), (x + 0.014, y + 0.004 + back)],
                     speed=0.15, pressure=0.9, pause=0.02)
    r.event("mark", name="before the tilt")
    turn_tablet(r, [(0.0, 0), (0.9, 60), (7.2, 60), (8.0, 0)])
    r.event("mark", name="after the tilt")
    r.wait(0.6)


def glaze(p):
    p.brush("round", size=0.11, medium=0.5, pigment=0.16)
    p.color("glaze orange")
    for y, x0, x1 in [(0.3, 0.02, 0.52), (0.36, 0.5, 0.04), (0.5, 0.02, 0.34), (0.57, 0.3, 0.03)]:
        p.stroke([(x0, y), ((x0 + x1) / 2, y - 0.012), (x1, y + 0.006)], speed=0.55, pressure=0.9)
    p.recording.slider(size=0.08)
    p.color("glaze violet")
    for y, x0, x1 in [(0.69, 0.98, 0.66), (0.73, 0.64, 0.99), (0.725, 0.04, 0.3)]:
        p.stroke([(x0, y), ((x0 + x1) / 2, y + 0.008), (x1, y)], speed=0.55, pressure=0.9)


def paint_tree(p):
    p.brush("knife", size=0.024, medium=0.5, pigment=1.0)
    p.color("umber")
    for dx, size in [(0.006, 0.026), (-0.008, 0.018), (0.0, 0.02)]:
        p.recording.slider(size=size)
        p.stroke([(0.83 + 1.6 * dx, 0.67), (0.828 + dx, 0.57), (0.838 + 0.5 * dx, 0.46),
                  (0.845 + 0.2 * dx, 0.36)], speed=0.3, pressure=0.8)
    p.brush("round", size=0.011)
    for x0, y0, x1, y1 in [(0.832, 0.5, 0.75, 0.4), (0.84, 0.46, 0.91, 0.37),
                           (0.842, 0.42, 0.8, 0.33), (0.845, 0.4, 0.885, 0.31),
                           (0.835, 0.53, 0.925, 0.45)]:
        p.stroke([(x0, y0), ((x0 + x1) / 2 + 0.006, (y0 + y1) / 2 - 0.014), (x1, y1)], speed=0.3,
                 pressure=0.7)
    p.brush("bristle", medium=0.62, pigment=1.0)
    leaves = [("deep green", 60, 0.0, 0.036, 1.0), ("sap green", 44, 0.01, 0.026, 0.95),
              ("meadow", 30, 0.022, 0.021, 0.8), ("cadmium yellow", 14, 0.03, 0.015, 0.7)]
    for color, count, towards_light, size, spread in leaves:
        p.color(color)
        for n in range(count):
            p.recording.slider(size=size * (1 + p.vary(0.2)))
            angle, reach = 2.39996 * n + p.vary(0.5), spread * math.sqrt((n + 0.5) / count)
            x = 0.835 + 0.125 * reach * math.cos(angle) - 1.2 * towards_light + p.vary(0.008)
            y = 0.355 + 0.1 * reach * math.sin(angle) - towards_light + p.vary(0.008)
            out = angle + 0.5 + p.vary(0.9)
            p.stroke([(x, y), (x + 0.012 * math.cos(out), y + 0.01 * math.sin(out)),
                      (x + 0.022 * math.cos(out), y + 0.02 * math.sin(out) + 0.005)], speed=0.28,
                     pressure=0.75, tilt=(35, -25), pause=0.02)


def paint_grass_and_flowers(p):
    p.brush("bristle", size=0.02, medium=0.5, pigment=0.95)
    for n in range(46):
        p.color(["sap green", "deep green", "meadow", "deep green", "sap green"][n % 5])
        x, y = 0.2 + p.vary(0.2), 0.7 + p.vary(0.05)
        bend = p.vary(0.022)
        p.stroke([(x, y + 0.015), (x + 0.3 * bend, y - 0.02), (x + bend, y - 0.05 - p.vary(0.015))],
                 speed=0.34, pressure=0.65, pause=0.02)
    p.brush("round", medium=0.8, pigment=1.0)
    for n in range(44):
        p.color(["cadmium red", "cadmium red", "titanium white", "cadmium yellow"][n % 4])
        near = p.random.random()
        x, y = 0.19 + p.vary(0.18), 0.625 + 0.1 * near
        r = 0.003 + 0.0035 * near
        p.recording.slider(size=0.008 + 0.01 * near)
        p.stroke([(x - r, y), (x, y - r), (x + r, y), (x, y + r), (x - 0.6 * r, y + 0.3 * r)],
                 speed=0.14, pressure=0.9, taper=False, pause=0.02)


def paint_lights(p):
    """Knife lights on water, cloud and ridge: the thickest paint."""
    p.brush("knife", size=0.026, medium=0.9, pigment=1.0)
    p.color("titanium white")
    for n in range(6):
        y = 0.53 + 0.037 * n
        x, w = river_middle(y) + 0.1 * river_half_width(y), 0.35 * river_half_width(y)
        p.stroke([(x - w, y), (x, y + 0.002), (x + w, y)], speed=0.25, pressure=0.6, twist=80)
    p.recording.slider(size=0.02)
    for x, y in [(0.105, 0.09), (0.15, 0.082), (0.31, 0.062), (0.505, 0.16), (0.84, 0.07)]:
        p.stroke([(x, y), (x + 0.012, y - 0.012), (x + 0.034, y - 0.012), (x + 0.048, y - 0.002)],
                 speed=0.25, pressure=0.8)
    p.brush("round", size=0.007, medium=0.7)
    p.color("warm light")
    for x0, x1 in [(0.17, 0.24), (0.26, 0.36), (0.4, 0.46)]:
        xs = [x0 + (x1 - x0) * k / 3 for k in range(4)]
        p.stroke([(x, hill_line(x, 0.375, 0.05, 0.4) + 0.004) for x in xs], speed=0.2, pressure=0.6)


def sign(p):
    p.brush("round", size=0.007, medium=0.5, pigment=1.0)
    p.color("umber")
    x, y = 0.925, 0.725
    p.stroke([(x, y), (x + 0.002, y - 0.02), (x + 0.004, y - 0.035)], speed=0.15)
    p.stroke([(x + 0.004, y - 0.034), (x + 0.022, y - 0.032), (x + 0.02, y - 0.018),
              (x + 0.003, y - 0.015)], speed=0.15)
    p.stroke([(x + 0.03, y - 0.004), (x + 0.045, y - 0.008), (x + 0.06, y - 0.004)], speed=0.15)


def main():
    recording = Recording(
        1.0, 0.75, (1024, 768), paper={"texture": "linen", "relief": 0.0004, "scale": 0.12,
                                   "reflectance": [0.78, 0.74, 0.66]},
        palette=[{"name": n, "color": c, "opacity": OPACITY.get(n, 0.7)}
                 for n, c in PALETTE.items()],
        model={"scheme": "conservative", "friction_viscosity_floor": 0.0004},
        title="River with rain", recorded_by="samples/first-painting/make.py")
    painter = Painter(recording, seed=2016)
    recording.event("gravity", x=0, y=0, z=9.81)
    recording.wait(0.2)
    for part in (paint_sky, paint_clouds, paint_hills, paint_ground, paint_meadow, paint_river):
        part(painter)
        recording.event("mark", name=part.__name__.replace("_", " "))
    recording.event("dry")
    paint_rain(painter)
    recording.event("dry")
    recording.wait(0.2)
    for part in (glaze, paint_tree, paint_grass_and_flowers, paint_lights, sign):
        part(painter)
        recording.event("mark", name=part.__name__.replace("_", " "))
    recording.wait(0.5)
    recording.event("mark", name="end")
    recording.write(output_path(HERE / "first-painting.jsonl"))


if __name__ == "__main__":
    main()
