#!/usr/bin/env python3
"""Adds up what the fuzzer did, run by run, and writes it as a table.

  record.py RECORD PAGE [--check]

RECORD: a JSON file that `fuzz.py --record` adds to: for each target the inputs tried, the processor time that
took, the most edges of the code that a run reached, and how many runs ended with a find. PAGE: a page of the
docs; the lines between its two comments `fuzz-record` are written anew. With --check nothing is written:
ends with 1 if the page says something else than the record.
"""

import argparse
import fcntl
import json
import pathlib
import sys

BEGIN, END = "<!-- fuzz-record -->\n", "<!-- /fuzz-record -->\n"


def add(path, target, inputs, cpu_s, edges, finds):
    """Adds one run to the record; runs that end at one time wait for one another."""
    with open(path, "a+", encoding="utf-8") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        file.seek(0)
        record = json.loads(file.read() or "{}")
        before = record.get(target, {"inputs": 0, "processor_s": 0, "edges": 0, "finds": 0})
        record[target] = {"inputs": before["inputs"] + inputs, "processor_s": round(before["processor_s"] + cpu_s),
                          "edges": max(before["edges"], edges), "finds": before["finds"] + finds}
        file.truncate(0)
        file.write(json.dumps(dict(sorted(record.items())), indent=2) + "\n")


def spaced(number):
    return f"{number:,.0f}".replace(",", " ")


def table(record):
    lines = ["| target | processor time, h | inputs | inputs a second | edges | runs that ended with a find |",
             "|---|---|---|---|---|---|"]
    for target, run in record.items():
        seconds = run["processor_s"]
        speed = run["inputs"] / max(seconds, 1)
        lines.append(f"| `{target}` | {seconds / 3600:.2f} | {spaced(run['inputs'])} "
                     f"| {spaced(speed) if speed >= 100 else f'{speed:.1f}'} | {spaced(run['edges'])} "
                     f"| {run['finds']} |")
    hours = sum(run["processor_s"] for run in record.values()) / 3600
    return "\n".join(lines) + f"\n\nTogether {hours:.1f} hours of processor time.\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("record", type=pathlib.Path)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    before = options.page.read_text(encoding="utf-8")
    if BEGIN not in before or END not in before:
        sys.exit(f"record.py: {options.page} lacks the comments {BEGIN.strip()} and {END.strip()}")
    head, _, rest = before.partition(BEGIN)
    tail = rest.partition(END)[2]
    after = head + BEGIN + "\n" + table(json.loads(options.record.read_text(encoding="utf-8"))) + "\n" + END + tail
    if options.check:
        sys.exit(0 if after == before else f"record.py: {options.page} is not what {options.record} says")
    options.page.write_text(after, encoding="utf-8")


if __name__ == "__main__":
    main()
