"""Oil paint for scripts: write logs, read states, and paint in process.

    >>> import pentimento
    >>> with pentimento.Session("drawing.jsonl", width_m=1, height_m=0.75) as session:
    ...     session.color("#1f2f8c")
    ...     session.spline([(0.2, 0.3), (0.4, 0.35, 0.8), (0.6, 0.3)])

Places are in metres from the top left corner of the canvas, y down; times are in seconds.
"""

from .batches import Rendered, batch
from .canvas import Canvas, State
from .names import brushes, pigments
from .session import Session, Stroke
from .spline import bezier, smooth
from .states import StateDump, read_aovs, read_state

__all__ = ["Canvas", "Rendered", "Session", "State", "StateDump", "Stroke", "batch", "bezier", "brushes", "pigments",
           "read_aovs", "read_state", "smooth"]
