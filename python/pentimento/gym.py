"""An environment in the shape of Gymnasium's: an agent paints strokes, and is told how near the picture comes to a target.

Gymnasium is not needed. `action_space` and `observation_space` have its members `shape`, `low`, `high`, `dtype`, `sample()`.
"""

from typing import Any, Iterator, Optional

import numpy as np
import numpy.typing as npt

from .canvas import Canvas
from .spline import bezier

Array = npt.NDArray[Any]
USUAL_SPACING = 0.025  # of the brush's stamps, in its diameters, as in a log


class Box:
    """Arrays between two bounds."""

    def __init__(self, low: Array, high: Array, seed: Optional[int] = None) -> None:
        self.low, self.high = np.asarray(low), np.asarray(high)
        self.shape, self.dtype = self.low.shape, self.low.dtype
        self._random = np.random.default_rng(seed)

    def seed(self, seed: Optional[int] = None) -> None:
        """Begins the random numbers of sample() anew."""
        self._random = np.random.default_rng(seed)

    def sample(self) -> Array:
        """A random array, evenly."""
        if self.dtype == np.uint8:
            return self._random.integers(0, 256, self.shape, dtype=np.uint8)
        return self._random.uniform(self.low, self.high).astype(self.dtype)

    def contains(self, value: Array) -> bool:
        """Whether it has the shape and lies between the bounds."""
        value = np.asarray(value)
        return value.shape == self.shape and bool((value >= self.low).all() and (value <= self.high).all())


class PaintEnv:
    """Paints strokes on a canvas of `side` x `side` cells of a metre.

    An action is a quadratic Bezier curve (x0, y0, x1, y1, x2, y2 in metres), the brush's diameter in metres at both ends
    (the smaller is reached by pressing less), the amount of each pigment of the palette (the largest is taken), the
    load of the brush 0..1, and the pressure at both ends 0..1. An observation is the picture. The reward is how much nearer
    it came to the target, as the mean square difference of sRGB in 0..1; without a target it is 0. `spacing` is how far the
    brush's stamps are apart, in its diameters: wider ones are fewer and quicker, and paint coarser.
    """

    metadata = {"render_modes": ["rgb_array"]}
    render_mode = "rgb_array"
    spec = None

    def __init__(self, side: int = 128, palette: tuple[str, ...] = ("French Ultramarine", "Titanium White", "Cadmium Red"),
                 target: Optional[Array] = None, strokes: int = 100, brush: str = "flat", threads: int = 1,
                 spacing: float = USUAL_SPACING) -> None:
        self.side, self.palette, self.strokes, self.brush = side, tuple(palette), strokes, brush
        self.spacing = spacing
        self.target = None if target is None else np.asarray(target, np.float64) / 255
        if self.target is not None and self.target.shape != (side, side, 3):
            raise ValueError(f"the target is {self.target.shape}, not {(side, side, 3)}")
        self._fresh = Canvas(1, 1, grid=(side, side), palette=self.palette, threads=threads)
        pigments = len(self.palette)
        low = np.array([0] * 6 + [0.01] * 2 + [0] * pigments + [0.2] + [0] * 2, np.float32)
        high = np.array([1] * 6 + [0.2] * 2 + [1] * pigments + [1] + [1] * 2, np.float32)
        self.action_space = Box(low, high)
        self.observation_space = Box(np.zeros((side, side, 3), np.uint8), np.full((side, side, 3), 255, np.uint8))
        self.canvas = self._fresh.fork()
        self._done = 0
        self._distance = 0.0

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None) -> tuple[Array, dict[str, Any]]:
        """A fresh canvas. `seed` is that of action_space.sample()."""
        if seed is not None:
            self.action_space.seed(seed)
        self.canvas = self._fresh.fork()
        self._done = 0
        picture = self.canvas.picture()
        self._distance = self._distance_of(picture)
        return picture, self._info()

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Paints a stroke. (observation, reward, terminated, truncated, info)."""
        paint(self.canvas, action, self.palette, self.brush, self.spacing)
        self._done += 1
        picture = self.canvas.picture()
        before, self._distance = self._distance, self._distance_of(picture)
        return picture, before - self._distance, False, self._done >= self.strokes, self._info()

    def render(self) -> Array:
        """The picture."""
        return self.canvas.picture()

    def close(self) -> None:
        """Nothing is left open."""

    def _distance_of(self, picture: Array) -> float:
        return 0.0 if self.target is None else float(((picture / 255.0 - self.target) ** 2).mean())

    def _info(self) -> dict[str, Any]:
        return {"strokes": self._done, "distance": self._distance, "time_s": self.canvas.time_s}


def paint(canvas: Canvas, action: Array, palette: tuple[str, ...], brush: str = "flat",
          spacing: float = USUAL_SPACING) -> None:
    """Paints an action of PaintEnv."""
    action = np.asarray(action, np.float64)
    if action.shape != (11 + len(palette),) or not np.isfinite(action).all():
        raise ValueError(f"an action is {11 + len(palette)} finite numbers")
    curve, (size0_m, size1_m) = action[:6].reshape(3, 2), action[6:8]
    amounts, load, pressures = action[8:8 + len(palette)], action[-3], action[-2:]
    largest = max(size0_m, size1_m)
    canvas.brush(brush, size_m=float(largest), load=float(np.clip(load, 0, 1)), spacing=spacing)
    canvas.color(palette[int(np.argmax(amounts))])
    # The narrower end is pressed less.
    ends = np.clip(pressures * np.array([size0_m, size1_m]) / largest, 0, 1)
    middle = float(ends.mean())
    canvas.paint(bezier([(*curve[0], ends[0]), (*curve[1], middle), (*curve[2], ends[1])], 16), speed_m_s=2)


def pairs(count: int, seed: int = 0, strokes_each: int = 8,
          **env: Any) -> Iterator[tuple[Array, Array, Array]]:
    """Yields `count` triples (action, picture before, picture after), for what learns to paint. Every
    `strokes_each` strokes a fresh canvas begins. The same seed gives the same triples."""
    world = PaintEnv(**env)
    before, _ = world.reset(seed=seed)
    for i in range(count):
        if i > 0 and i % strokes_each == 0:
            before, _ = world.reset()
        action = world.action_space.sample()
        after = world.step(action)[0]
        yield action, before, after
        before = after
