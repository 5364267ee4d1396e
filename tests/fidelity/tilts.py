#!/usr/bin/env python3
"""What two washes do in a minute, from a canvas that leans to one that is a ceiling (docs/numerics.md).

    tilts.py COMMAND

Two strokes of a flat brush 40 mm wide, one below the other, of thin paint. Then the canvas is held at each
tilt for a minute, 9.81 m/s^2 in all. Prints the deepest cell, how many cells are deeper than three times the mean
of their four neighbours, and what was painted less what is there, as a share. Dumps live in a temporary folder
(TMPDIR). Needs NumPy and h5py.
"""
import json
import subprocess
import sys
import tempfile

import h5py
import numpy

GRAVITY_M_S2 = 9.81
TILTS_Z_M_S2 = (2.5, 0.6, 0, -0.6, -9.81)
STANDS_OUT_M = 0.002  # shallower cells are the edges of films


def events(gravity_z_m_s2):
    yield {"t": 0, "type": "brush", "name": "flat"}
    for name, value in (("size", 0.04), ("medium", 0.8), ("pigment", 0.15)):
        yield {"t": 0, "type": "slider", "name": name, "value": value}
    t = 0
    for y in (0.06, 0.13):
        yield {"t": t, "type": "touch", "phase": "down", "x": 0.05, "y": y, "pressure": 0.95}
        for i in range(1, 61):
            t = round(t + 1 / 60, 4)
            yield {"t": t, "type": "touch", "phase": "move", "x": round(0.05 + 0.005 * i, 4), "y": y, "pressure": 0.95}
        yield {"t": t, "type": "touch", "phase": "up", "x": 0.35, "y": y}
        t = round(t + 0.2, 4)
    down = (GRAVITY_M_S2**2 - gravity_z_m_s2**2) ** 0.5
    yield {"t": t, "type": "gravity", "x": 0, "y": round(down, 4), "z": gravity_z_m_s2}
    yield {"t": t + 60, "type": "mark", "name": "end"}


def write_log(path, gravity_z_m_s2):
    header = {"type": "header", "format": "pentimento-log", "version": 1, "canvas": {"width": 0.4, "height": 0.3},
              "grid": {"width": 400, "height": 300}, "model": {"scheme": "conservative"},
              "palette": [{"name": "blue", "color": "#203a8a", "opacity": 0.9}]}
    with open(path, "w", encoding="utf-8") as log:
        for line in (header, *events(gravity_z_m_s2)):
            log.write(json.dumps(line) + "\n")


def judged(path):
    """The deepest cell, m; cells that stand out; how many are wet."""
    with h5py.File(path) as dump:
        depth = dump["fluid/depth"][:].astype(numpy.float64)
    walled = numpy.pad(depth, 1, mode="edge")  # the canvas's edges are walls
    mean = (walled[1:-1, :-2] + walled[1:-1, 2:] + walled[:-2, 1:-1] + walled[2:, 1:-1]) / 4
    return depth.max(), int(((depth > STANDS_OUT_M) & (depth > 3 * mean)).sum()), int((depth > 0).sum())


def main(arguments):
    if len(arguments) != 1:
        sys.exit(__doc__)
    print("| gravity z, m/s^2 | deepest, mm | cells that stand out | wet cells | paint lost, share |")
    print("|---|---|---|---|---|")
    for z in TILTS_Z_M_S2:
        with tempfile.TemporaryDirectory() as folder:
            write_log(f"{folder}/log.jsonl", z)
            command = [arguments[0], "render", f"{folder}/log.jsonl", "--quiet", "--json", "-o", f"{folder}/state.h5"]
            report = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
            deepest_m, standing_out, wet = judged(f"{folder}/state.h5")
            lost = report["paint"]["medium"]["relative_difference"]
            print(f"| {z} | {1e3 * deepest_m:.1f} | {standing_out} | {wet} | {lost:.1e} |", flush=True)


main(sys.argv[1:])
