"""Paints a photograph stroke by stroke, wet in wet, and looks at the picture after each stroke.

  photograph.py PICTURE LOG [STROKES]

Broad brushes come first and small ones last. A stroke begins where the painting is furthest from the photograph, runs along
lines of equal light (Hertzmann, "Painterly Rendering with Curved Brush Strokes of Multiple Sizes", 1998), and stays only if
the painting came nearer: it is tried on a fork of the canvas. What stays is written to the log, which renders at any size.
"""

import sys

import numpy as np
from PIL import Image

import pentimento

WIDTH_M = 1.0
COLUMNS = 240
PAINTS = 24
#: Diameter of the brush in metres, and its share of the strokes.
BRUSHES = ((0.12, 0.06), (0.06, 0.16), (0.03, 0.33), (0.015, 0.45))
SPEED_M_S = 2.0
TRIES = 3
#: A stroke mixes with the wet paint below. Its own colour lies beyond the one that is wanted by this share of the difference.
BEYOND = 0.4


def paints_of(pixels, count):
    """Colours that stand for those of the photograph (k-means; the first ones as far apart as they can be)."""
    chosen = [pixels.mean(axis=0)]
    for _ in range(count - 1):
        away = np.min([((pixels - c) ** 2).sum(axis=1) for c in chosen], axis=0)
        chosen.append(pixels[np.argmax(away)])
    colours = np.array(chosen)
    for _ in range(12):
        nearest = ((pixels[:, None] - colours) ** 2).sum(axis=2).argmin(axis=1)
        colours = np.array([pixels[nearest == i].mean(axis=0) if (nearest == i).any() else colours[i]
                            for i in range(count)])
    return colours


def blurred(image, radius):
    """A mean over squares of 2 radius + 1 pixels, twice: nearly a Gaussian."""
    for _ in range(2):
        for axis in (0, 1):
            widths = [(radius + 1, radius) if a == axis else (0, 0) for a in range(image.ndim)]
            sums = np.cumsum(np.pad(image, widths, mode="edge"), axis=axis)
            first, last = [slice(None)] * image.ndim, [slice(None)] * image.ndim
            first[axis], last[axis] = slice(0, -2 * radius - 1), slice(2 * radius + 1, None)
            image = (sums[tuple(last)] - sums[tuple(first)]) / (2 * radius + 1)
    return image


class Painter:
    def __init__(self, photograph, log, seed=1):
        rows = round(COLUMNS * photograph.height / photograph.width)
        small = photograph.convert("RGB").resize((COLUMNS, rows), Image.LANCZOS)
        self.target = np.asarray(small, dtype=np.float32) / 255
        self.cell_m = WIDTH_M / COLUMNS
        self.paints = paints_of(self.target.reshape(-1, 3)[::7], PAINTS)
        names = ["#%02x%02x%02x" % tuple(int(round(255 * v)) for v in paint) for paint in self.paints]
        height_m = rows * self.cell_m
        self.canvas = pentimento.Canvas(WIDTH_M, height_m, grid=(COLUMNS, rows), palette=names)
        palette = [{"name": name, "color": name} for name in names]
        self.log = pentimento.Session(log, WIDTH_M, height_m, grid=(COLUMNS, rows), palette=palette,
                                      title="A photograph, stroke by stroke")
        self.names = names
        self.picture = self.canvas.picture() / np.float32(255)
        self.numbers = np.random.default_rng(seed)
        self.kept = self.refused = 0

    def level(self, size_m, strokes):
        """So many strokes with one brush."""
        radius = max(1, round(size_m / self.cell_m / 2))
        goal = blurred(self.target, max(1, radius // 2))
        along = self.along(goal, radius)
        sliders = dict(size_m=size_m, medium=0.45, pickup=0.15)
        self.canvas.brush("flat" if size_m > 0.03 else "round", **sliders)
        self.log.brush("flat" if size_m > 0.03 else "round", **sliders)
        for _ in range(strokes):
            self.stroke(goal, along, radius)

    def stroke(self, goal, along, radius):
        error = ((self.picture - goal) ** 2).sum(axis=2)
        wanted = blurred(error, radius)
        for _ in range(TRIES):
            row, column = self.place(wanted)
            points = self.path(goal, along, row, column, radius)
            colour = goal[row, column] + BEYOND * (goal[row, column] - self.picture[row, column])
            name = self.names[((self.paints - colour) ** 2).sum(axis=1).argmin()]
            trial = self.canvas.fork()
            trial.color(name).paint(points, SPEED_M_S)
            picture = trial.picture() / np.float32(255)
            if ((picture - goal) ** 2).sum() < error.sum():
                self.canvas, self.picture = trial, picture
                self.log.color(name)
                self.log.spline(points, SPEED_M_S)
                self.kept += 1
                return
            self.refused += 1

    def place(self, wanted):
        """The worst of some places, so that strokes do not follow one another in rows."""
        rows = self.numbers.integers(0, wanted.shape[0], 40)
        columns = self.numbers.integers(0, wanted.shape[1], 40)
        worst = wanted[rows, columns].argmax()
        return int(rows[worst]), int(columns[worst])

    @staticmethod
    def along(goal, radius):
        """Where lines of equal light run: across the main direction of the slopes around."""
        slope_y, slope_x = np.gradient(goal.mean(axis=2))
        xx, yy, xy = (blurred(product, radius) for product in (slope_x**2, slope_y**2, slope_x * slope_y))
        angle = np.arctan2(2 * xy, xx - yy) / 2 + np.pi / 2
        return np.stack([np.cos(angle), np.sin(angle)], axis=2)

    def path(self, goal, along, row, column, radius):
        """Along a line of equal light, as long as the photograph has this colour there."""
        points, colour, before = [], goal[row, column], np.zeros(2)
        x, y = column + 0.5, row + 0.5
        while len(points) < 9:
            points.append((x * self.cell_m, y * self.cell_m))
            i = min(max(int(y), 0), goal.shape[0] - 1), min(max(int(x), 0), goal.shape[1] - 1)
            if len(points) > 3 and ((goal[i] - colour) ** 2).sum() > 0.03:
                break
            way = along[i] if along[i] @ before >= 0 else -along[i]
            before = way
            x, y = x + 1.4 * radius * way[0], y + 1.4 * radius * way[1]
        return points


def main():
    painter = Painter(Image.open(sys.argv[1]), sys.argv[2])
    strokes = int(sys.argv[3]) if len(sys.argv) > 3 else 1600
    with painter.log:
        for size_m, share in BRUSHES:
            painter.level(size_m, round(share * strokes))
    off = float(np.sqrt(((painter.picture - painter.target) ** 2).mean()))
    print(f"{painter.kept} strokes kept, {painter.refused} refused; off by {off:.3f} of full scale; "
          f"state {painter.canvas.step().state_sha256}")


main()
