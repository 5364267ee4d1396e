"""Renders many logs by the command, here or on the workers of Dask."""

import json
import os
import subprocess
import tempfile
from dataclasses import dataclass
from typing import Any, Iterable, Optional, Sequence, Union

INTERRUPTED = 75


@dataclass
class Rendered:
    """What became of a log."""

    log: str
    exit_code: int  #: of `pentimento render`; -N: signal N ended it
    report: dict[str, Any]  #: the closing report; empty without one
    message: str  #: what it said

    @property
    def state_sha256(self) -> Optional[str]:
        """Of the state, if it was rendered."""
        return self.report.get("state_sha256")


def render(log: Union[str, "os.PathLike[str]"], options: Sequence[str] = (), command: str = "pentimento",
           timeout_s: float = 600) -> Rendered:
    """Renders one log in a process of its own. Without an `-o` among the options only the report is kept."""
    words = [str(word) for word in options]
    with tempfile.TemporaryDirectory() as scratch:
        if not any(word in ("-o", "--output") or word.startswith(("-o", "--output=")) for word in words):
            words += ["-o", os.path.join(scratch, "state.h5")]
        try:
            done = subprocess.run([command, "render", os.fspath(log), "--json", "--quiet", *words], capture_output=True,
                                  text=True, timeout=timeout_s)
        except subprocess.TimeoutExpired:
            return Rendered(os.fspath(log), -9, {}, f"took longer than {timeout_s:g} s")
    report = json.loads(done.stdout) if done.returncode == 0 else {}
    return Rendered(os.fspath(log), done.returncode, report, done.stderr.strip())


def batch(logs: Iterable[Union[str, "os.PathLike[str]"]], client: Any = None, options: Sequence[str] = (),
          command: str = "pentimento", timeout_s: float = 600) -> list[Rendered]:
    """Renders logs, in their order. `client`: a `dask.distributed.Client`, whose workers do it, each log a future. One that is
    lost with its worker is done again by another. Without a client the logs are rendered here, one after the other.
    """
    names = [os.fspath(log) for log in logs]
    if client is None:
        return [render(name, options, command, timeout_s) for name in names]
    futures = [client.submit(render, name, list(options), command, timeout_s, pure=False, retries=3) for name in names]
    rows: list[Rendered] = client.gather(futures)
    return rows
