#!/usr/bin/env python3
"""How much faster than it was painted a session is replayed, before and after a change.

    sessions.py PAGE BEFORE AFTER LOG[:SECONDS]... [--repeats N]

BEFORE and AFTER are two builds of the command. Each log, or its first SECONDS, is rendered by both in turn,
N times (3). What a run takes to its first step (`--at 0`) is taken off its time, so that start-up does not
count. Writes a table of medians to PAGE. Both must come to the same state, or the table says so.
"""
import argparse
import json
import os
import pathlib
import platform
import statistics
import subprocess
import tempfile
import time


def render(command, log, at, folder):
    """(elapsed seconds, closing report)"""
    words = [command, "render", log, "-o", f"{folder}/a.png", "--quiet", "--json"]
    began = time.perf_counter()
    done = subprocess.run(words + ([] if at is None else ["--at", at]), capture_output=True, check=True)
    return time.perf_counter() - began, json.loads(done.stdout)


def session(commands, log, at, repeats, folder):
    """Medians of seconds for each command, the seconds painted, and whether the states are one."""
    took, states, painted = ([[], []]), set(), 0.0
    for _ in range(repeats):
        for which, command in enumerate(commands):
            start_up, _ = render(command, log, "0", folder)
            elapsed, report = render(command, log, at, folder)
            took[which].append(elapsed - start_up)
            painted = report["simulated_s"]
            states.add(report["state_sha256"])
    return [statistics.median(t) for t in took], painted, len(states) == 1


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def version(command):
    return subprocess.run([command, "--version"], capture_output=True, check=True, text=True).stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("log", nargs="+")
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    commands = (options.before, options.after)
    lines = ["# Sessions: replayed, and painted", "",
             "Written by `tests/bench/sessions.py`. Painted time over elapsed, start-up left out, median of "
             f"{options.repeats} runs of each build in turn. {processor()}, {len(os.sched_getaffinity(0))} "
             "processors.", "",
             f"Before: {version(options.before)}. After: {version(options.after)}.", "",
             "| session | seconds painted | before | after | after / before | state |", "|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for entry in options.log:
            log, _, at = entry.partition(":")
            (before, after), painted, same = session(commands, log, at or None, options.repeats, folder)
            name = pathlib.Path(log).name.split(".")[0]
            lines.append(f"| {name} | {painted:.0f} | {painted / before:.1f} | {painted / after:.1f} "
                         f"| {before / after:.2f} | {'the same' if same else 'another'} |")
            print(lines[-1], flush=True)
    options.out.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
