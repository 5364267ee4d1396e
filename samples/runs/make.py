#!/usr/bin/env python3
"""Writes runs.jsonl, after Figure 4 of the publication: the canvas is raised; thin paint runs in
drips out of its strokes, thick paint stands."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from recording import output_path, turn_tablet  # noqa: E402
from studio import easel  # noqa: E402

PALETTE = {"sepia": ("#5a3420", 0.5), "blue": ("#23427c", 0.5), "red": ("#a8281e", 0.5)}


def main():
    p = easel("runs", "Runs under gravity", PALETTE, seed=14)
    p.brush("flat", size=0.026, medium=0.7, pigment=0.17)  # thin: much medium, little pigment
    for n, colour in enumerate(("sepia", "blue", "red")):
        p.color(colour)
        y = 0.035 + 0.085 * n
        for back in (0.0, 0.004):
            p.stroke([(0.03, y + back), (0.14, y - 0.008 + back), (0.25, y + 0.004 + back)],
                     speed=0.3, pressure=0.95, taper=False)
        for k in range(2):  # more of it here and there: there it breaks out
            x = 0.04 + 0.2 * (k + p.random.random()) / 2
            p.stroke([(x, y), (x + 0.006, y + 0.001), (x + 0.012, y + 0.002)], speed=0.2)
    p.brush("bristle", size=0.032, medium=0.6, pigment=1)  # thick
    for n, colour in enumerate(("sepia", "blue", "red")):
        p.color(colour)
        y = 0.04 + 0.06 * n
        p.stroke([(0.3, y), (0.38, y - 0.012), (0.47, y + 0.006)], speed=0.3, pressure=0.95)
    p.recording.event("mark", name="painted")
    p.recording.wait(0.3)
    turn_tablet(p.recording, [(0, 0), (1.0, 75), (9.0, 75)])
    p.recording.event("mark", name="end")
    p.recording.write(output_path(HERE / "runs.jsonl"))


if __name__ == "__main__":
    main()
