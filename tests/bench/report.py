#!/usr/bin/env python3
"""Measures the phases of the simulation and writes docs/bench/phases.md.

usage: report.py measure PROGRAM [--before PROGRAM] [--rounds N]   runs the benchmarks, keeps what they gave in
                                                                   docs/bench/measured.json, writes the page
       report.py page                                              writes the page from that file
       report.py check                                             fails if the page is not what the file gives

--before: an older program with the same benchmarks. Both run in turns, round by round.
"""

import argparse
import json
import pathlib
import platform
import sys

import page
import results

HERE = pathlib.Path(__file__).resolve().parent
PHASES = HERE / "phases.json"
DOCS = HERE.parent.parent / "docs" / "bench"
MEASURED, PAGE = DOCS / "measured.json", DOCS / "phases.md"
ROUNDS = 5
GROWTH_ROUNDS = 2  # of the tables of growth, which take most of the time


def names_of(document):
    """The benchmarks of all phases and of the probe."""
    references = [p[key] for p in document["phases"] for key in ("time", "against") if key in p]
    return {results.benchmark_of(reference) for reference in references + page.PROBES}


def digits(number, count=4):
    return float(f"{number:.{count}g}")


def kept(samples):
    """The least and the middle time of each reference."""
    return {reference: {"best": digits(min(times)), "median": digits(sorted(times)[len(times) // 2])}
            for reference, times in sorted(samples.items())}


def measure(program, before, rounds):
    names = names_of(json.loads(PHASES.read_text()))
    growth = set(page.growth_names())
    programs = {"now": program, **({"before": before} if before else {})}
    samples = {which: {} for which in programs}
    counters = {}
    load_before, processors = results.load()
    for k in range(rounds):
        print(f"round {k + 1} of {rounds}", file=sys.stderr)
        for which, path in programs.items():
            wanted = names | growth if k < GROWTH_ROUNDS else names
            results.add_document(results.run_once(path, wanted), samples[which], counters if which == "now" else {})
    model, instruction_set = results.processor(counters)
    return {"machine": {"processor": model, "instruction_set": instruction_set, "processors": processors,
                        "system": f"{platform.system()} {platform.machine()}",
                        "load_before": round(load_before, 1), "load_after": round(results.load()[0], 1)},
            "rounds": rounds,
            "counters": {reference: value if isinstance(value, str) else digits(value)
                         for reference, value in sorted(counters.items())},
            **{which: kept(times) for which, times in samples.items()}}


def text_of_page():
    return page.text(json.loads(PHASES.read_text())["phases"], json.loads(MEASURED.read_text()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    measuring = commands.add_parser("measure")
    measuring.add_argument("program")
    measuring.add_argument("--before")
    measuring.add_argument("--rounds", type=int, default=ROUNDS)
    commands.add_parser("page")
    commands.add_parser("check")
    options = parser.parse_args()
    if options.command == "measure":
        found = measure(options.program, options.before, options.rounds)
        MEASURED.write_text(json.dumps(found, indent=1) + "\n")
    if options.command == "check":
        if PAGE.read_text() == text_of_page():
            return 0
        print(f"{PAGE} is not what {MEASURED.name} gives: python3 tests/bench/report.py page")
        return 1
    PAGE.write_text(text_of_page())
    return 0


if __name__ == "__main__":
    sys.exit(main())
