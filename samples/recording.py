"""Writes action logs (docs/action-log.md). Standard library only, so that samples can be made
anywhere; the same calls always give the same bytes.

Lengths are metres on the canvas, x right, y down from the top left; times are seconds.
"""

import gzip
import json
import math
import pathlib
import random
import sys


def rounded(value, digits=5):
    """A float with few digits: 1e-5 m is a hundredth of a cell of the usual grid."""
    value = round(value, digits)
    return int(value) if value == int(value) else value


def output_path(default):
    """Where a make.py writes its log: its first argument, or beside itself."""
    return pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default


class Recording:
    """A session being recorded: events in the order of time, then written as JSON Lines."""

    def __init__(self, width, height, grid, **header):
        self.header = {"type": "header", "format": "pentimento-log", "version": 1,
                       "canvas": {"width": width, "height": height},
                       "grid": {"width": grid[0], "height": grid[1]}, **header}
        self.time = 0.0
        self._events = []

    def event(self, type_, time=None, **fields):
        """Adds an event at `time`, or at the recording's own clock."""
        at = self.time if time is None else time
        self._events.append({"t": rounded(at, 4), "type": type_, **fields})

    def touch(self, phase, x, y, time=None, id=0, pressure=None, tilt=None, twist=None):
        fields = {"phase": phase}
        if id:
            fields["id"] = id
        fields.update(x=rounded(x), y=rounded(y))
        if pressure is not None:
            fields["pressure"] = rounded(min(max(pressure, 0.0), 1.0), 3)
        if tilt is not None:
            fields.update(tilt_x=rounded(tilt[0], 1), tilt_y=rounded(tilt[1], 1))
        if twist is not None:
            fields["twist"] = rounded(twist, 1)
        self.event("touch", time, **fields)

    def samples(self, rows, id=0):
        """One recorded stroke: rows of (time, x, y, pressure, tilt); tilt may be None."""
        if len(rows) == 1:
            rows = [rows[0], rows[0]]
        for n, (time, x, y, pressure, tilt) in enumerate(rows):
            phase = "down" if n == 0 else "up" if n == len(rows) - 1 else "move"
            self.touch(phase, x, y, time, id, pressure, tilt)

    def slider(self, **values):
        for name, value in values.items():
            self.event("slider", name=name, value=rounded(value))

    def wait(self, seconds):
        self.time += seconds

    def lines(self):
        events = sorted(self._events, key=lambda e: e["t"])  # stable: keeps the order within a time
        for entry in [self.header, *events]:
            yield json.dumps(entry, separators=(",", ":")) + "\n"

    def write(self, path):
        """Plain, or gzip without a time stamp when the name ends in .gz."""
        text = "".join(self.lines()).encode()
        if str(path).endswith(".gz"):
            text = gzip.compress(text, 9, mtime=0)
        with open(path, "wb") as out:
            out.write(text)


def resample(points, count):
    """`count` points evenly along a smooth curve (Catmull-Rom) through `points`."""
    dense = []
    ends = [points[0], *points, points[-1]]
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        for k in range(16):
            u = k / 16
            dense.append(tuple(
                0.5 * (2 * q + (r - p) * u + (2 * p - 5 * q + 4 * r - s) * u * u
                       + (3 * q - p - 3 * r + s) * u * u * u)
                for p, q, r, s in zip(a, b, c, d)))
    dense.append(tuple(points[-1]))
    along = [0.0]
    for p, q in zip(dense, dense[1:]):
        along.append(along[-1] + math.dist(p, q))
    result, k = [], 0
    for n in range(count):
        target = along[-1] * n / (count - 1)
        while k < len(along) - 2 and along[k + 1] < target:
            k += 1
        step = along[k + 1] - along[k]
        u = (target - along[k]) / step if step > 0 else 0.0
        result.append(tuple(p + u * (q - p) for p, q in zip(dense[k], dense[k + 1])))
    return result


class Painter:
    """A hand that paints on a recording: smooth strokes with pressure, tilt and a slight tremor."""

    def __init__(self, recording, seed=1, rate=60):
        self.recording = recording
        self.random = random.Random(seed)
        self.rate = rate  # samples per second

    def vary(self, spread):
        return (2 * self.random.random() - 1) * spread

    def color(self, name_or_value):
        key = "value" if name_or_value.startswith("#") else "pigment"
        self.recording.event("color", **{key: name_or_value})

    def brush(self, name, **sliders):
        self.recording.event("brush", name=name)
        self.recording.slider(**sliders)

    def stroke(self, points, speed=0.6, pressure=0.8, tilt=(25, -15), twist=None, taper=True,
               tremor=0.0006, pause=0.08, id=0):
        """One stroke through `points` at `speed` (m/s), then a `pause`. The pressure rises at the
        start and falls at the end (`taper`)."""
        length = sum(math.dist(p, q) for p, q in zip(points, points[1:]))
        count = max(4, int(length / speed * self.rate) + 2)
        path = resample(points, count)
        start = self.recording.time
        for n, (x, y) in enumerate(path):
            share = n / (count - 1)
            force = pressure * (min(1.0, 0.35 + 3.2 * share, 0.25 + 4 * (1 - share))
                                if taper else 1.0)
            phase = "down" if n == 0 else "up" if n == count - 1 else "move"
            lean = (tilt[0] + 4 * math.sin(5 * share), tilt[1] + 3 * math.cos(4 * share))
            self.recording.touch(phase, x + self.vary(tremor), y + self.vary(tremor),
                                 start + n / self.rate, id, force + self.vary(0.02), lean, twist)
        self.recording.time = start + (count - 1) / self.rate + pause


def turn_tablet(recording, path, rate=30):
    """Gravity events from (time, pitch) pairs: `pitch` is how far the tablet is raised from lying
    flat (0) to upright (90 degrees). Lying face up reads (0, 0, 9.81), upright (0, 9.81, 0)."""
    start = recording.time
    for (t0, a0), (t1, a1) in zip(path, path[1:]):
        steps = max(1, round((t1 - t0) * rate))
        for k in range(steps if t1 < path[-1][0] else steps + 1):
            u = k / steps
            angle = math.radians(a0 + (a1 - a0) * u * u * (3 - 2 * u))
            recording.event("gravity", start + t0 + (t1 - t0) * u, x=0,
                            y=rounded(9.81 * math.sin(angle), 3),
                            z=rounded(9.81 * math.cos(angle), 3))
    recording.time = start + path[-1][0]
