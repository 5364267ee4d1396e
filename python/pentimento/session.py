"""Writes an action log, event by event."""

import contextlib
import gzip
import io
import json
import math
import os
import sys
from typing import Any, Iterable, Iterator, Mapping, Optional, Sequence, TextIO, Union

from . import names
from .spline import FullPoint, Point, bezier, full

Color = Union[str, Sequence[float]]
Pigment = Union[str, Mapping[str, Any]]
SLIDERS = ("medium", "pigment", "size", "pickup", "refill", "stiffness", "layer_mixing", "spacing", "load")


def _within(name: str, value: float, low: float, high: float) -> float:
    value = float(value)
    if not low <= value <= high:
        raise ValueError(f"{name} {value:g} is outside {low:g}..{high:g}")
    return value


def _microseconds(seconds: float) -> int:
    """What a log counts time in."""
    return math.floor(seconds * 1e6 + 0.5)


def header(width_m: float, height_m: float, *, grid: Optional[tuple[int, int]] = None,
           palette: Iterable[Pigment] = (), brushes: Iterable[Mapping[str, Any]] = (),
           **more: Any) -> dict[str, Any]:
    """The header of a log. `palette`: names of the library, or objects with a `name` as the log's format has
    them. `more`: other members of the header, `model={"nu_max": 0.02}`."""
    canvas = {"width": _within("width_m", width_m, 0.001, 100), "height": _within("height_m", height_m, 0.001, 100)}
    made: dict[str, Any] = {"type": "header", "format": "pentimento-log", "version": 1, "canvas": canvas}
    if grid is not None:
        made["grid"] = {"width": int(grid[0]), "height": int(grid[1])}
    paints = [dict(paint) if isinstance(paint, Mapping) else {"name": paint} for paint in palette]
    for paint in paints:
        if set(paint) == {"name"}:
            names.check("pigment", paint["name"], names.pigments())
    if paints:
        made["palette"] = paints
    own = [dict(brush) for brush in brushes]
    if own:
        made["brushes"] = own
    made.update(more)
    return made


class Stroke:
    """A stroke while it is drawn; made by Session.stroke()."""

    def __init__(self, session: "Session", speed_m_s: float, touch: int) -> None:
        self._session = session
        self._speed_m_s = speed_m_s
        self._touch = touch
        self._last: Optional[tuple[float, float, dict[str, Any]]] = None
        # The hand has gone so far since then without a change of its speed, and was there at `_at_us`.
        self._way_m = 0.0
        self._since_us = self._at_us = session._time_us

    def to(self, x_m: float, y_m: float, pressure: Optional[float] = None, *, tilt_x: Optional[float] = None,
           tilt_y: Optional[float] = None, twist: Optional[float] = None, dt_s: Optional[float] = None) -> "Stroke":
        """Goes on to a place. It takes the time that the stroke's speed says, or `dt_s`. Angles are in degrees."""
        sample: dict[str, Any] = {"x": _within("x_m", x_m, -1000, 1000), "y": _within("y_m", y_m, -1000, 1000)}
        for name, value, low, high in (("pressure", pressure, 0, 1), ("tilt_x", tilt_x, -90, 90),
                                       ("tilt_y", tilt_y, -90, 90), ("twist", twist, -360, 360)):
            if value is not None:
                sample[name] = _within(name, value, low, high)
        if self._last is None:
            self._session._event("touch", phase="down", id=self._touch, **sample)
        else:
            self._go(x_m - self._last[0], y_m - self._last[1], dt_s)
            self._session._event("touch", phase="move", id=self._touch, **sample)
        self._last = (x_m, y_m, sample)
        self._at_us = self._session._time_us
        return self

    def _go(self, x_m: float, y_m: float, dt_s: Optional[float]) -> None:
        """Time passes. It is rounded for the whole way, as Canvas does it, not for each part."""
        if dt_s is not None:
            self._session.wait(dt_s)
        if dt_s is not None or self._at_us != self._session._time_us:
            self._way_m, self._since_us = 0.0, self._session._time_us
        if dt_s is None:
            self._way_m += math.sqrt(x_m * x_m + y_m * y_m)
            self._session._time_us = self._since_us + _microseconds(self._way_m / self._speed_m_s)

    def _end(self) -> None:
        if self._last is not None:
            self._session._event("touch", phase="up", id=self._touch, **self._last[2])


class Session:
    """A log that is written while the script paints. Each event is written when it happens, so another program can
    read along. `file`: a name in .jsonl or .jsonl.gz, "-" for standard output, or an open text file. Places are in
    metres from the top left corner, y down. What a log may not say raises ValueError, and nothing is written of it.
    """

    def __init__(self, file: Union[str, "os.PathLike[str]", TextIO] = "-", width_m: float = 1,
                 height_m: float = 0.75, **more: Any) -> None:
        self._header = header(width_m, height_m, **more)
        self._own_brushes = [brush["name"] for brush in self._header.get("brushes", [])]
        self._palette = [paint["name"] for paint in self._header.get("palette", [])]
        self._time_us = 0
        self._touches = 0
        self._close = False
        if isinstance(file, io.TextIOBase) or hasattr(file, "write"):
            self._file: Any = file
        elif os.fspath(file) == "-":
            self._file = sys.stdout
        else:
            name = os.fspath(file)
            self._file = gzip.open(name, "wt", encoding="utf-8") if name.endswith(".gz") else open(
                name, "w", encoding="utf-8")
            self._close = True
        self._write(self._header)

    @property
    def time_s(self) -> float:
        """The time of the next event."""
        return self._time_us / 1e6

    def __enter__(self) -> "Session":
        return self

    def __exit__(self, *problem: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the log."""
        self._file.flush()
        if self._close:
            self._file.close()

    # The hand.

    def brush(self, name: str, **sliders: float) -> None:
        """Takes up a brush of the header or a built-in one. `sliders` as in slider(), and `size_m` for `size`."""
        if name not in self._own_brushes:
            names.check("brush", name, list(names.brushes()) + self._own_brushes)
        self._event("brush", name=name)
        for slider, value in sliders.items():
            self.slider("size" if slider == "size_m" else slider, value)

    def slider(self, name: str, value: Union[float, bool, str]) -> None:
        """Sets a slider of the brush, or a parameter of the model that may change while painting."""
        names.check("slider", name, list(names.parameters()))
        if isinstance(value, float) and not math.isfinite(value):
            raise ValueError(f"{name} is not finite")
        self._event("slider", name=name, value=value)

    def color(self, color: Color, across: Optional[tuple[float, float]] = None) -> None:
        """Loads the brush: a pigment of the palette, "#rrggbb", or linear red, green and blue."""
        more = {} if across is None else {"across": [_within("across", side, 0, 1) for side in across]}
        if isinstance(color, str) and not color.startswith("#"):
            names.check("pigment of the palette", color, self._palette or ["Ivory Black"])
            self._event("color", pigment=color, **more)
        else:
            value = color if isinstance(color, str) else [_within("color", part, 0, 1) for part in color]
            self._event("color", value=value, **more)

    @contextlib.contextmanager
    def stroke(self, speed_m_s: float = 0.5) -> Iterator[Stroke]:
        """`with session.stroke() as s: s.to(x_m, y_m, pressure)`. Strokes may lie within each other: several fingers."""
        if not speed_m_s > 0:
            raise ValueError("speed_m_s must be more than 0")
        self._touches += 1
        drawn = Stroke(self, speed_m_s, self._touches - 1)
        try:
            yield drawn
        finally:
            drawn._end()
            self._touches -= 1

    def spline(self, points: Iterable[Point], speed_m_s: float = 0.5, pressure: float = 0.8) -> None:
        """A stroke along the smooth curve through the points. The painter smooths it; the log has the points."""
        path: list[FullPoint] = [full(point, pressure) for point in points]
        with self.stroke(speed_m_s) as drawn:
            for point in path:
                drawn.to(*point)

    def bezier(self, points: Iterable[Point], speed_m_s: float = 0.5, count: int = 32) -> None:
        """A stroke along the Bezier curve with these control points."""
        self.spline(bezier(points, count), speed_m_s)

    # What happens between strokes.

    def wait(self, seconds: float) -> None:
        """Time passes, and wet paint moves."""
        self._time_us += _microseconds(_within("seconds", seconds, 0, 9e9))

    def gravity(self, x: float, y: float, z: float) -> None:
        """What an accelerometer reads, m/s^2: (0, 0, 9.81) lies face up, (0, 9.81, 0) stands upright."""
        self._event("gravity", x=_within("x", x, -1000, 1000), y=_within("y", y, -1000, 1000),
                    z=_within("z", z, -1000, 1000))

    def dry(self) -> None:
        """All paint dries."""
        self._event("dry")

    def clear(self) -> None:
        """A fresh canvas."""
        self._event("clear")

    def undo(self) -> None:
        """Takes the last stroke, drying, clearing or picture back."""
        self._event("undo")

    def redo(self) -> None:
        """Does again what was undone."""
        self._event("redo")

    def load(self, file: str) -> None:
        """A picture becomes the dry layer. Its name is as the log's folder sees it."""
        self._event("load", file=file)

    def light(self, **members: Any) -> None:
        """Sets a lamp: `lamp`, `direction` or `position`, `intensity`, `color`, `follow`."""
        self._event("light", **members)

    def environment(self, **members: Any) -> None:
        """What lights the painting from all around: `file`, or `sh`; `soft`."""
        self._event("environment", **members)

    def camera(self, file: str, **members: Any) -> None:
        """What wet paint reflects: a picture or a video; `start`, `fov`, `mirror`."""
        self._event("camera", file=file, **members)

    def step(self) -> None:
        """Exactly one step of the simulation. A log with such events is stepped by them alone."""
        self._event("step")

    def mark(self, name: str) -> None:
        """Names this moment, for `render --at mark:NAME`."""
        self._event("mark", name=name)

    def note(self, kind: str, **members: Any) -> None:
        """An event of your own, which the replay ignores. Its type is "x-" and `kind`."""
        self._event("x-" + kind, **members)

    def _event(self, kind: str, **members: Any) -> None:
        self._write({"t": self._time_us / 1e6, "type": kind, **members})

    def _write(self, line: Mapping[str, Any]) -> None:
        self._file.write(json.dumps(line, allow_nan=False) + "\n")
        self._file.flush()
