"""Thin paint on an upright canvas that is swung from side to side: the runs bend.

  drips.py LOG
"""

import math
import sys

import pentimento

PALETTE = ["Phthalo Green", "Quinacridone Rose", "French Ultramarine", "Hansa Yellow"]


def main():
    with pentimento.Session(sys.argv[1], 1, 0.75, grid=(640, 480), palette=PALETTE, title="Swinging drips") as session:
        session.brush("round", size_m=0.07, medium=1, pigment=0.2, stiffness=0.0)
        for i in range(9):
            session.color(PALETTE[i % 4])
            x = 0.1 + 0.1 * i
            for _ in range(6):
                session.spline([(x - 0.03, 0.10 + 0.01 * (i % 3)), (x + 0.03, 0.10 + 0.01 * (i % 3))], 0.3, 0.9)
        # It is lifted, and swings: twice from side to side in ten seconds.
        for i in range(200):
            lean = 0.9 * math.sin(2 * math.pi * i / 100)
            upright = min(1.0, i / 20)
            session.gravity(9.81 * math.sin(lean) * upright, 9.81 * math.cos(lean) * upright, 9.81 * (1 - upright) + 0.6)
            session.wait(0.05)
        session.mark("hung")


main()
