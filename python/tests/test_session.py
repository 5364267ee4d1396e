"""Logs that are written by the package, as the command sees them."""

import gzip
import io
import json
import os
import pathlib
import subprocess

import pytest

import pentimento

COMMAND = os.environ["PENTIMENTO_COMMAND"]


def run(*words):
    return subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True)


def everything(session):
    """Every kind of event that needs no file."""
    session.brush("flat", size_m=0.04, medium=0.7)
    session.slider("nu_max", 0.02)
    session.color("French Ultramarine")
    session.color([0.5, 0.1, 0.0], across=(0.0, 0.5))
    session.gravity(0, 9.81, 0)
    with session.stroke(speed_m_s=0.4) as stroke:
        stroke.to(0.1, 0.1, 0.3, tilt_x=10, tilt_y=-5, twist=90)
        stroke.to(0.3, 0.12)
        stroke.to(0.3, 0.2, 1, dt_s=0.5)
    session.color("#e0c020")
    session.spline([(0.1, 0.2), (0.2, 0.25, 0.5), (0.3, 0.2)])
    session.bezier([(0.1, 0.1), (0.2, 0.4), (0.3, 0.1)])
    with session.stroke() as one, session.stroke() as other:  # two fingers
        one.to(0.1, 0.1).to(0.2, 0.1)
        other.to(0.1, 0.2).to(0.2, 0.2)
    session.undo()
    session.redo()
    session.wait(0.5)
    session.light(direction=[0, 1, 1], intensity=0.8)
    session.environment(sh=[[0.5, 0.5, 0.5]] + [[0, 0, 0]] * 8)
    session.dry()
    session.mark("dry")
    session.note("mood", calm=True)
    session.clear()
    session.brush("fine")


def options():
    return {"grid": (80, 60), "palette": ["French Ultramarine", {"name": "mine", "color": "#804020"}],
            "brushes": [{"name": "fine", "shape": "round", "spacing": 0.05}], "model": {"nu_min": 1e-5},
            "title": "all events"}


@pytest.mark.parametrize("name", ["all.jsonl", "all.jsonl.gz"])
def test_every_event_is_valid(tmp_path, name):
    with pentimento.Session(tmp_path / name, 0.4, 0.3, **options()) as session:
        everything(session)
    told = run("validate", tmp_path / name)
    assert told.returncode == 0, told.stderr
    read = gzip.open(tmp_path / name, "rt") if name.endswith(".gz") else open(tmp_path / name)
    kinds = {json.loads(line)["type"] for line in read}
    assert kinds == {"header", "brush", "slider", "color", "gravity", "touch", "undo", "redo", "light", "environment",
                     "dry", "mark", "x-mood", "clear"}


def test_a_stroke_paints_where_it_says(tmp_path):
    log = tmp_path / "a.jsonl"
    with pentimento.Session(log, 0.4, 0.3, grid=(80, 60)) as session:
        session.spline([(0.1, 0.15), (0.3, 0.15)])
    assert run("render", log, "-o", tmp_path / "a.h5").returncode == 0
    state = pentimento.read_state(tmp_path / "a.h5")
    rows, columns = (state.depth_m > 1e-4).nonzero()
    # Half the brush of 0.03 m, and a cell of 0.005 m.
    assert abs(state.x_m[columns].min() - 0.1) < 0.02 and abs(state.x_m[columns].max() - 0.3) < 0.02
    assert abs(state.y_m[rows].mean() - 0.15) < 0.005
    assert state.units["/fluid/depth"] == "m"
    assert state.channels and state.pigment.shape[2:] == state.depth_m.shape
    assert state.attributes["canvas_width_m"] == pytest.approx(0.4)
    assert (state.height_m >= state.base_m).all()


def test_each_event_is_written_when_it_happens():
    file = io.StringIO()
    session = pentimento.Session(file, 0.4, 0.3)
    assert json.loads(file.getvalue())["type"] == "header"
    session.mark("here")
    assert file.getvalue().count("\n") == 2
    session.close()
    assert not file.closed, "the file is the caller's"


@pytest.mark.parametrize("wrong, says", [
    (lambda s: s.brush("flt"), "there is no brush 'flt' (did you mean 'flat'"),
    (lambda s: s.slider("sise", 1), "there is no slider 'sise'"),
    (lambda s: s.color("Mars Black"), "there is no pigment of the palette 'Mars Black'"),
    (lambda s: s.spline([(0, 0, 1.7), (1, 1)]), "pressure 1.7 is outside 0..1"),
    (lambda s: s.spline([(0, float("nan"))]), "y_m nan is outside -1000..1000"),
    (lambda s: s.wait(-1), "seconds -1 is outside"),
    (lambda s: s.slider("size", float("inf")), "size is not finite"),
])
def test_what_a_log_may_not_say_is_refused_before_it_is_written(wrong, says):
    file = io.StringIO()
    session = pentimento.Session(file, 0.4, 0.3)
    before = file.getvalue()
    with pytest.raises(ValueError, match="^" + __import__("re").escape(says)):
        wrong(session)
    assert file.getvalue() == before


def test_near_misses_of_pigments_are_named():
    with pytest.raises(ValueError, match="French Ultramarine"):
        pentimento.Session(io.StringIO(), palette=["Ultramarine"])


def test_curves_pass_where_they_must():
    curve = pentimento.bezier([(0, 0, 0.2), (1, 2, 0.4), (2, 0, 0.6)], 4)
    assert curve[0] == (0, 0, 0.2) and curve[-1] == pytest.approx((2, 0, 0.6))
    assert curve[2] == pytest.approx((1, 1, 0.4)), "the middle of a parabola"
    through = pentimento.smooth([(0, 0), (1, 1), (2, 0)], 4)
    assert through[4][:2] == pytest.approx((1, 1)) and len(through) == 9


def test_layers_are_read_in_their_units(tmp_path):
    pytest.importorskip("cv2")
    log = tmp_path / "a.jsonl"
    with pentimento.Session(log, 0.4, 0.3, grid=(80, 60)) as session:
        session.spline([(0.1, 0.15), (0.3, 0.15)])
    done = run("render", log, "-o", tmp_path / "a.png", "-o", tmp_path / "a.h5", "--aov", "depth,normal")
    assert done.returncode == 0, done.stderr
    layers = pentimento.read_aovs(tmp_path / "a.depth.png", tmp_path / "a.normal.png")
    state = pentimento.read_state(tmp_path / "a.h5")
    depth = layers["depth"]
    # A code of the layer is a 65535th of the deepest.
    assert depth.unit == "m" and abs(depth.values - state.depth_m).max() <= state.depth_m.max() / 65535
    assert layers["normal"].values.shape == (60, 80, 3)
    assert layers["normal"].values[..., 2].max() > 0.9
