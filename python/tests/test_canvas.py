"""The engine in process, against the command."""

import json
import os
import random
import subprocess
import sys

import numpy as np
import pytest

import pentimento

COMMAND = os.environ["PENTIMENTO_COMMAND"]
PALETTE = ["Prussian Blue", "Titanium White"]


def canvas(**more):
    return pentimento.Canvas(0.4, 0.3, grid=(80, 60), palette=PALETTE, **more)


def paint(on):
    """The same calls on a canvas and, by way of `spline`, in a log."""
    on.brush("flat", size_m=0.05, medium=0.8)
    on.color("Prussian Blue")
    stroke = getattr(on, "paint", None) or on.spline
    stroke([(0.05, 0.1), (0.2, 0.12), (0.35, 0.1)])
    on.gravity(0, 9.81, 2)
    on.wait(0.5)
    on.color("Titanium White")
    stroke([(0.2, 0.05, 0.5), (0.2, 0.25, 1)], speed_m_s=0.4)
    on.wait(0.4)
    on.dry()
    stroke([(0.1, 0.2), (0.3, 0.2)])


def test_the_hash_is_the_commands_for_the_same_strokes(tmp_path):
    log = tmp_path / "a.jsonl"
    with pentimento.Session(log, 0.4, 0.3, grid=(80, 60), palette=PALETTE) as session:
        paint(session)
        end_s = session.time_s
    told = subprocess.run([COMMAND, "render", log, "-o", tmp_path / "a.png", "--json", "--quiet"], check=True,
                          capture_output=True, text=True)
    report = json.loads(told.stdout)
    painted = canvas()
    paint(painted)
    assert painted.time_s == pytest.approx(end_s, abs=1e-5)
    assert painted.step().steps == report["steps"]
    assert painted.state_sha256 == report["state_sha256"]


def test_fast_strokes_of_many_points_end_in_the_commands_hash_too(tmp_path):
    """The times of their points are no whole microseconds: they must be rounded alike."""
    colours = ["#80a040", "#ffffff", "#201008"]
    log = tmp_path / "a.jsonl"
    numbers = random.Random(1)
    painted = pentimento.Canvas(1, 0.7, grid=(120, 84), palette=colours)
    palette = [{"name": name, "color": name} for name in colours]
    with pentimento.Session(log, 1, 0.7, grid=(120, 84), palette=palette) as session:
        for on in (painted, session):
            on.brush("flat", size_m=0.05, medium=0.45, pickup=0.15)
        for i in range(12):
            points = [(numbers.uniform(-0.1, 1.1), numbers.uniform(0, 0.7)) for _ in range(5)]
            for on in (painted, session):
                on.color(colours[i % 3])
            painted.paint(points, speed_m_s=1.7)
            session.spline(points, speed_m_s=1.7)
    told = subprocess.run([COMMAND, "render", log, "-o", tmp_path / "a.png", "--json", "--quiet"], check=True,
                          capture_output=True, text=True)
    assert painted.step().state_sha256 == json.loads(told.stdout)["state_sha256"]


def test_what_lies_under_the_paint_is_shown_as_it_dries():
    canvas = pentimento.Canvas(0.4, 0.3, grid=(80, 60), palette=PALETTE)
    state = canvas.state
    bare, paper = state.reflectance[0].copy(), state.paper_m.copy()
    canvas.color(PALETTE[0]).paint([(0.05, 0.1), (0.35, 0.1)]).wait(0.2)
    assert (state.reflectance[0] == bare).all() and (state.base_m == paper).all()
    canvas.dry()
    assert (state.reflectance[0] != bare).any() and (state.reflectance[0] == bare).any()
    assert (state.base_m > paper).any() and (state.paper_m == paper).all()


def test_the_state_is_a_view_of_what_is_there():
    painted = canvas()
    state = painted.state
    depth = state.depth_m
    assert depth.shape == (60, 80) and not depth.any()
    painted.paint([(0.1, 0.15), (0.3, 0.15)])
    assert depth.max() > 0.0005, "no copy"
    assert depth.base is not None and not depth.flags.writeable
    with pytest.raises(ValueError):
        depth[0, 0] = 1
    rows, columns = (depth > 1e-4).nonzero()
    assert abs(state.y_m[rows].mean() - 0.15) < 0.005
    assert state.channels == PALETTE and len(state.pigment[0]) == 2
    assert (state.stroke == 1).any()
    last = depth.max()
    del painted, state
    assert depth.max() == last, "the view keeps the canvas"


def test_a_fork_goes_on_bit_for_bit_and_alone():
    first = canvas().brush("flat", size_m=0.05).paint([(0.05, 0.1), (0.35, 0.1)]).wait(0.2)
    before = first.state_sha256
    other = first.fork()
    other.color("Titanium White").paint([(0.2, 0.05), (0.2, 0.25)]).wait(0.5)
    assert first.state_sha256 == before
    first.color("Titanium White").paint([(0.2, 0.05), (0.2, 0.25)]).wait(0.5)
    assert first.state_sha256 == other.state_sha256 != before


def test_the_picture_is_that_of_the_file(tmp_path):
    cv2 = pytest.importorskip("cv2")
    painted = canvas().paint([(0.1, 0.15), (0.3, 0.15)])
    picture = painted.picture()
    assert picture.shape == (60, 80, 3) and picture.dtype == np.uint8
    assert picture[30, 40].mean() < picture[5, 5].mean() / 2, "blue on white"
    painted.save(tmp_path / "a.png")
    assert (cv2.imread(str(tmp_path / "a.png"))[..., ::-1] == picture).all()
    assert painted.picture(40).shape == (30, 40, 3)


FORKS = """
import multiprocessing, sys, pentimento

def paint(on):
    return on.paint([(0.1, 0.1), (0.3, 0.2)]).picture().tobytes()

def child(on, queue):
    try:
        queue.put(paint(on))
    except OSError as problem:
        queue.put(str(problem))

canvas = pentimento.Canvas(0.4, 0.3, grid=(80, 60), threads=int(sys.argv[1]))
canvas.picture()
fork = multiprocessing.get_context("fork")
queue = fork.Queue()
process = fork.Process(target=child, args=(canvas, queue))
process.start()
told = queue.get(timeout=60)
process.join()
print("the same" if told == paint(canvas) else told)
"""


@pytest.mark.parametrize("threads, says", [(1, "the same"), (2, "let the canvas have one thread")])
def test_a_forked_process_paints_and_shows_or_says_why_not(threads, says):
    """In an interpreter of its own: Mesa keeps the threads of the first picture."""
    told = subprocess.run([sys.executable, "-c", FORKS, str(threads)], capture_output=True, text=True, timeout=120)
    assert told.returncode == 0, told.stderr
    assert says in told.stdout


@pytest.mark.parametrize("wrong, says", [
    (lambda c: c.brush("flt"), "flt"),
    (lambda c: c.brush(sise=1), 'there is no slider "sise" \\(did you mean "size"'),
    (lambda c: c.brush(size_m=-1), "size -1 is outside"),
    (lambda c: c.color("Mars Black"), "Mars Black"),
    (lambda c: c.paint([(0, 0, 2)]), "a pressure is outside 0..1"),
    (lambda c: c.paint([(0,)]), "a point is"),
    (lambda c: c.paint([(0, 0)], speed_m_s=0), "speed_m_s"),
    (lambda c: c.wait(-1), "seconds"),
    (lambda c: c.step(-1), "steps"),
])
def test_wrong_values_are_refused(wrong, says):
    with pytest.raises(ValueError, match=says):
        wrong(canvas())


def test_a_wrong_header_is_refused():
    with pytest.raises(ValueError, match="outside"):
        pentimento.Canvas(0.4, 0.3, grid=(0, 60))
    with pytest.raises(ValueError, match="did you mean"):
        pentimento.Canvas(palette=["Prusian Blue"])
