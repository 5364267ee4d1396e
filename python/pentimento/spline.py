"""Curves as points along them. A point is (x_m, y_m) or (x_m, y_m, pressure)."""

from typing import Iterable, Sequence

Point = Sequence[float]
FullPoint = tuple[float, float, float]
USUAL_PRESSURE = 0.8


def full(point: Point, pressure: float = USUAL_PRESSURE) -> FullPoint:
    """The point with a pressure."""
    if len(point) not in (2, 3):
        raise ValueError(f"a point is (x_m, y_m) or (x_m, y_m, pressure), not {point!r}")
    return float(point[0]), float(point[1]), float(point[2]) if len(point) == 3 else pressure


def _between(p: FullPoint, q: FullPoint, t: float) -> FullPoint:
    return p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])


def bezier(points: Iterable[Point], count: int = 32) -> list[FullPoint]:
    """`count` + 1 points along the Bezier curve with these control points; pressures go along."""
    control = [full(point) for point in points]
    if len(control) < 2 or count < 1:
        raise ValueError("a Bezier curve has two control points or more, and one part or more")
    curve = []
    for i in range(count + 1):
        t = i / count
        row = control
        while len(row) > 1:  # de Casteljau
            row = [_between(p, q, t) for p, q in zip(row, row[1:])]
        curve.append(row[0])
    return curve


def smooth(points: Iterable[Point], per_part: int = 8) -> list[FullPoint]:
    """A smooth curve through the points (Catmull-Rom), with `per_part` steps between two of them."""
    through = [full(point) for point in points]
    if len(through) < 3:
        return through
    curve = [through[0]]
    for i in range(len(through) - 1):
        a, b, c, d = (through[min(max(k, 0), len(through) - 1)] for k in (i - 1, i, i + 1, i + 2))
        for k in range(1, per_part + 1):
            t = k / per_part
            x, y, pressure = (
                0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t
                       + (3 * q - p - 3 * r + s) * t ** 3) for p, q, r, s in zip(a, b, c, d))
            curve.append((x, y, pressure))
    return [(x, y, min(1.0, max(0.0, pressure))) for x, y, pressure in curve]
