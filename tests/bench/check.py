#!/usr/bin/env python3
"""Is a phase of the simulation slower than it was? Compares the time of each phase of phases.json with
that of its plain twin, or of the probe of what the machine gives, in the same run.

usage: check.py PROGRAM [--store] [--rounds N] [--only GLOB]

The ratios to be held are those of ratios.json, by instruction set. A phase whose ratio is more than 15 %
above them is measured again, three times; if it stays behind, it is named and the exit code is 1. So is a
phase without a ratio, and a ratio without its phase. --store writes the ratios found in place of those of
this instruction set.

Times are processor times of an iteration. All benchmarks run in turns, round by round, each round in a new
process, and the least time of each counts: other work on the machine makes a time longer, never shorter.
"""

import argparse
import fnmatch
import json
import pathlib
import sys

import results

HERE = pathlib.Path(__file__).resolve().parent
TOLERANCE = 1.15   # a phase may take so many times what it took
# Of the first measurement. With nine other processes on two processors, the least of three runs was within 6 % of
# that of five for nine phases of ten, and 29 % off for one: where a process has its memory counts, too.
ROUNDS = 5
STORE_ROUNDS = 9   # what is stored is compared with for long
RETRIES = 3        # of what seems slower


def phases_of(document, pattern="*"):
    """{phase: (reference, reference of what it is compared with)}."""
    return {p["phase"]: (p["time"], p["against"]) for p in document["phases"]
            if "against" in p and fnmatch.fnmatch(p["phase"], pattern)}


def least(samples, reference):
    return min(samples[reference]) if reference in samples else None


def ratios_of(phases, samples):
    """{phase: ratio}, without the phases that were not measured."""
    ratios = {}
    for phase, (time, against) in phases.items():
        ours, theirs = least(samples, time), least(samples, against)
        if ours is not None and theirs:
            ratios[phase] = ours / theirs
    return ratios


def behind(found, stored):
    """The phases that take more than they may."""
    return [phase for phase in found if phase in stored and found[phase] > TOLERANCE * stored[phase]]


def problems_of(phases, found, stored):
    """One line for each phase that fails."""
    lines = []
    for phase in sorted(set(phases) | set(stored)):
        if phase not in phases:
            lines.append(f"{phase}: has a stored ratio but is no phase of phases.json")
        elif phase not in found:
            lines.append(f"{phase}: was not measured: {' or '.join(phases[phase])} is missing")
        elif phase not in stored:
            lines.append(f"{phase}: has no stored ratio; ./bootstrap bench --store")
        elif phase in behind(found, stored):
            slower = 100 * (found[phase] / stored[phase] - 1)
            lines.append(f"{phase}: {slower:.0f} % behind: {found[phase]:.3g} times {phases[phase][1]}, "
                         f"stored {stored[phase]:.3g}")
    return lines


def probe_counters(program):
    counters = {}
    results.add_document(results.run_once(program, {results.SET_PROBE}), {}, counters)
    return counters


def measure(program, phases, rounds, samples):
    """Runs the benchmarks of the phases, all once in each round."""
    names = {results.benchmark_of(reference) for pair in phases.values() for reference in pair}
    for _ in range(rounds):
        results.add_document(results.run_once(program, names), samples, {})


def measured(program, phases, stored, rounds):
    """{phase: ratio}; what seems slower is measured again."""
    samples = {}
    measure(program, phases, rounds, samples)
    for _ in range(RETRIES):
        slow = behind(ratios_of(phases, samples), stored)
        if not slow:
            break
        print(f"again: {', '.join(slow)}", file=sys.stderr)
        measure(program, {phase: phases[phase] for phase in slow}, rounds, samples)
    return ratios_of(phases, samples)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--store", action="store_true", help="write the ratios found")
    parser.add_argument("--rounds", type=int, help="how often all is run")
    parser.add_argument("--only", default="*", help="phases of this name, * for anything")
    options = parser.parse_args()
    phases = phases_of(json.loads((HERE / "phases.json").read_text()), options.only)
    file = HERE / "ratios.json"
    kept = json.loads(file.read_text()) if file.exists() else {}
    model, instruction_set = results.processor(probe_counters(options.program))
    ours = kept.get(instruction_set, {"processor": model, "ratios": {}})
    stored = {phase: ratio for phase, ratio in ours["ratios"].items() if fnmatch.fnmatch(phase, options.only)}
    if options.store:
        found = measured(options.program, phases, {}, options.rounds or STORE_ROUNDS)
        ours = {"processor": model, "ratios": {**(ours["ratios"] if options.only != "*" else {}),
                                               **{phase: float(f"{r:.3g}") for phase, r in found.items()}}}
        kept[instruction_set] = ours
        file.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n")
        stored = found
    else:
        if ours["processor"] != model:
            print(f"note: the ratios were stored on another processor, {ours['processor']}; this is {model}")
        found = measured(options.program, phases, stored, options.rounds or ROUNDS)
    busy, processors = results.load()
    if busy > processors:
        print(f"note: {busy:.0f} processes want {processors} processors; ratios may be a fifth off")
    problems = problems_of(phases, found, stored)
    for line in problems:
        print(line)
    print(f"{len(found)} phases by {instruction_set}: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
