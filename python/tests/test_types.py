"""The types of the package, as a type checker sees them."""

import pathlib
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent.parent
USER = """
import numpy as np
import pentimento
from pentimento import gym

canvas = pentimento.Canvas(1, 0.75, palette=["Titanium White"])
deepest: np.float32 = canvas.paint([(0.1, 0.1), (0.2, 0.1, 0.5)]).state.depth_m.max()
row: pentimento.Rendered = pentimento.batch(["a.jsonl"])[0]
for action, before, after in gym.pairs(2):
    print(action.shape)
canvas.paint(0.1)  # wrong
"""


def check(*words):
    pytest.importorskip("mypy")
    return subprocess.run([sys.executable, "-m", "mypy", "--config-file", HERE / "pyproject.toml", *words],
                          capture_output=True, text=True, cwd=HERE)


def test_the_package_is_typed_throughout(tmp_path):
    told = check("--cache-dir", tmp_path, "pentimento")
    assert told.returncode == 0, told.stdout + told.stderr


def test_a_users_mistake_is_seen(tmp_path):
    (tmp_path / "user.py").write_text(USER)
    told = check("--cache-dir", tmp_path / "cache", tmp_path / "user.py").stdout
    mistakes = [line for line in told.splitlines() if "error:" in line]
    assert len(mistakes) == 1 and f"user.py:{USER[:USER.index('# wrong')].count(chr(10)) + 1}:" in mistakes[0], told
