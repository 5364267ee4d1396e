"""Painting in process: the same simulation as the command's, without a log."""

import json
from typing import Any, Iterable, Mapping, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _engine
from .session import Color, header
from .spline import Point, full


class State:
    """What is on the canvas now. The arrays are views: they show what the canvas holds at any time, cannot be written
    to, and keep the canvas alive. Rows run from the top down. `clear`, in a log, is the only thing that makes new ones.
    """

    def __init__(self, planes: Mapping[str, Any], channels: list[str], width_m: float, height_m: float) -> None:
        self.depth_m: npt.NDArray[np.float32] = planes["depth_m"]
        self.velocity_x_m_s: npt.NDArray[np.float32] = planes["velocity_x_m_s"]
        self.velocity_y_down_m_s: npt.NDArray[np.float32] = planes["velocity_y_down_m_s"]
        self.base_m: npt.NDArray[np.float32] = planes["base_m"]
        self.paper_m: npt.NDArray[np.float32] = planes["paper_m"]
        self.stroke: npt.NDArray[np.uint32] = planes["stroke"]
        self.reflectance: list[npt.NDArray[np.float32]] = planes["reflectance"]
        #: pigment[layer][channel], bottom layer first; `channels` has the names of the channels.
        self.pigment: list[list[npt.NDArray[np.float32]]] = planes["pigment"]
        self.channels = channels
        rows, columns = self.depth_m.shape
        #: Centres of the cells, from the left and from the top.
        self.x_m = (np.arange(columns) + 0.5) * (width_m / columns)
        self.y_m = (np.arange(rows) + 0.5) * (height_m / rows)


class Canvas:
    """A canvas to paint on. One thread at a time. A log with the same strokes ends in the same state, bit for bit.

    `palette` has all pigments that will be used: names of the library, colours "#rrggbb", or objects with a `name` as
    a log's header has them. `threads` 0: as many as the machine has.
    """

    def __init__(self, width_m: float = 1, height_m: float = 0.75, *, grid: Optional[tuple[int, int]] = None,
                 palette: Iterable[Union[str, Mapping[str, Any]]] = ("Ivory Black",), threads: int = 1,
                 **more: Any) -> None:
        paints = [{"name": paint, "color": paint} if isinstance(paint, str) and paint.startswith("#") else paint
                  for paint in palette]
        self._header = header(width_m, height_m, grid=grid, palette=paints, **more)
        self._engine = _engine.Easel(json.dumps(self._header), threads)
        self._brush = "round"

    def brush(self, name: Optional[str] = None, **sliders: float) -> "Canvas":
        """Takes up a brush, and sets sliders: medium, pigment, size_m, pickup, refill, stiffness, layer_mixing, load."""
        if "size_m" in sliders:
            sliders["size"] = sliders.pop("size_m")
        self._engine.brush(name or self._brush, sliders)
        self._brush = name or self._brush
        return self

    def color(self, pigment: Color) -> "Canvas":
        """Loads the brush with a pigment of the palette."""
        self._engine.color(str(pigment))
        return self

    def paint(self, stroke: Iterable[Point], speed_m_s: float = 0.5, pressure: float = 0.8) -> "Canvas":
        """Draws a smooth curve through the points (x_m, y_m) or (x_m, y_m, pressure)."""
        self._engine.stroke([full(point, pressure) for point in stroke], speed_m_s)
        return self

    def wait(self, seconds: float) -> "Canvas":
        """Time passes, and wet paint moves."""
        self._engine.wait(seconds)
        return self

    def step(self, steps: int = 1) -> "Canvas":
        """So many steps of the simulation pass."""
        self._engine.step(steps)
        return self

    def dry(self) -> "Canvas":
        """All paint dries."""
        self._engine.dry()
        return self

    def gravity(self, x: float, y: float, z: float) -> "Canvas":
        """What an accelerometer reads, m/s^2: (0, 0, 9.81) lies face up, (0, 9.81, 0) stands upright."""
        self._engine.gravity(x, y, z)
        return self

    def fork(self) -> "Canvas":
        """Another canvas with the same wet paint and the same brush. It goes on bit for bit as this one would."""
        twin = object.__new__(Canvas)
        twin._header = self._header
        twin._engine = self._engine.fork()
        twin._brush = self._brush
        return twin

    @property
    def state(self) -> State:
        """What is on the canvas, without a copy."""
        size = self._header["canvas"]
        return State(self._engine.planes(), self._engine.channels, size["width"], size["height"])

    @property
    def state_sha256(self) -> str:
        """The hash that the command reports for this state."""
        return self._engine.state_sha256()

    @property
    def steps(self) -> int:
        """Steps of the simulation so far."""
        return self._engine.steps

    @property
    def time_s(self) -> float:
        """Simulated time."""
        return self._engine.time_s

    def picture(self, width: Optional[int] = None) -> npt.NDArray[np.uint8]:
        """The picture, sRGB, as (rows, columns, 3). `width` in pixels; without it a pixel for each cell."""
        return self._engine.picture(width or 0)

    def save(self, file: str, width: Optional[int] = None) -> None:
        """Writes the picture as a PNG of 8 bits, whole or not at all."""
        self._engine.save(str(file), width or 0)
