#!/usr/bin/env python3
"""The same state by SSE2, AVX2 and AVX-512: each set that the processor has gives the frozen hashes of
a few logs (`instruction_sets` in cases.json, a part of what states.json has).

usage: instruction_sets.py REPOSITORY BUILD

BUILD/golden_states_SET is golden_states with kernels of that set at most (lowered_processor.cpp). The
C library, too, is told to do without what the set lacks, so that no result hangs on its functions. Two
threads each: `golden` has 1 and 7.
"""

import json
import os
import pathlib
import subprocess
import sys

import golden

HERE = pathlib.Path(__file__).resolve().parent
THREADS = 2
# What the C library must not use, by its own names (glibc.cpu.hwcaps).
LACKS_AVX512 = ("AVX512F", "AVX512VL", "AVX512BW", "AVX512CD", "AVX512DQ")
LACKS_AVX2 = (*LACKS_AVX512, "AVX", "AVX2", "FMA", "BMI1", "BMI2", "LZCNT", "MOVBE", "SSE4_1", "SSE4_2")
LACKS = {"sse2": LACKS_AVX2, "avx2": LACKS_AVX512, "avx512": ()}
SETS = tuple(LACKS)  # ascending


def environment(name):
    """The environment of a program that has the set `name` at most."""
    without = ",".join(f"-{feature}" for feature in LACKS[name])
    return {**os.environ, "GLIBC_TUNABLES": f"glibc.cpu.hwcaps={without}"} if without else dict(os.environ)


def output_of(program, name, arguments=(), text=""):
    run = subprocess.run([program, *arguments], input=text, capture_output=True, text=True, check=False,
                         env=environment(name))
    if run.returncode != 0:
        raise SystemExit(f"{program.name}: {run.stderr.strip()}")
    return run.stdout.split()


def line_of(root, row):
    log, *rest = row
    return "\t".join(str(field) for field in (root / log, *rest, THREADS))


def problems_of(name, rows, found, frozen):
    """A line for each state that is not the frozen one."""
    return [f"{name}: {golden.key(row)}: {frozen[golden.key(row)][:12]} is {state[:12]}"
            for row, state in zip(rows, found) if frozen[golden.key(row)] != state]


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    root, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    frozen = json.loads((HERE / "states.json").read_text())
    rows = [tuple(row) for row in json.loads((HERE / "cases.json").read_text())["instruction_sets"]]
    problems, done = [], []
    for name in SETS:
        program = build / f"golden_states_{name}"
        (chosen,) = output_of(program, name, ["--instruction-set"])
        if chosen != name:
            # A lesser processor runs what it has, under that name in this list. More than the name says is a
            # fault of lowered_processor.cpp.
            if SETS.index(chosen) > SETS.index(name):
                problems.append(f"{name}: {program.name} runs {chosen}")
            else:
                print(f"{name}: this processor has {chosen} at most")
            continue
        found = output_of(program, name, text="\n".join(line_of(root, row) for row in rows) + "\n")
        problems += problems_of(name, rows, found, frozen)
        done.append(name)
    for line in problems:
        print(line)
    print(f"{len(rows)} states by {', '.join(done)}: {len(problems)} problems")
    return 1 if problems or not done else 0


if __name__ == "__main__":
    sys.exit(main())
