"""The names that a log may use. They come from the engine, so they are those of this version."""

import difflib
import functools
import json
from typing import Iterable


@functools.lru_cache(maxsize=None)
def _catalogue(kind: str) -> tuple[str, ...]:
    try:
        from . import _engine
    except ImportError:  # logs can be written without the engine; then the replay checks the names
        return ()
    return tuple(row["name"] for row in json.loads(_engine.catalogue(kind))[kind])


def brushes() -> tuple[str, ...]:
    """The built-in brushes."""
    return _catalogue("brushes")


def pigments() -> tuple[str, ...]:
    """The paints of the library."""
    return _catalogue("pigments")


def parameters() -> tuple[str, ...]:
    """The sliders of the brush and the parameters of the model."""
    return _catalogue("parameters")


def _plain(name: str) -> str:
    return name.lower().replace("'", "").replace("-", " ").replace("_", " ")


def check(what: str, name: str, known: Iterable[str]) -> None:
    """Raises ValueError, with what is near, if `known` is not empty and has no such name."""
    known = list(known)
    plain = {_plain(one): one for one in known}
    if not known or _plain(name) in plain:
        return
    near = [plain[one] for one in difflib.get_close_matches(_plain(name), plain, n=3)]
    near = near or [one for one in known if _plain(name) in _plain(one)][:3]
    hint = f" (did you mean {' or '.join(repr(one) for one in near)}?)" if near else ""
    raise ValueError(f"there is no {what} {name!r}{hint}")
