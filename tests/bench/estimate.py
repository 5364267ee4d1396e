#!/usr/bin/env python3
"""How good --dry-run is: foreseen and found, for the table of docs/bench/poster.md.

    estimate.py COMMAND RESULTS.jsonl [--scale 1,2,4] [--steps N] [--again] LOG...

Renders each log, or its first N steps, at each scale to a PNG (in TMPDIR) and adds a line with what
that took to RESULTS.jsonl; what is there already is not done again. Asks `--dry-run` of each and
prints the table. With --again it renders nothing: after a change to the estimate.

Time found is elapsed time on a machine that has nothing else to do. On a shared one it is worked out
from the processor time, which others change less: divided by the 1.1 processors that quiet runs used
on the log's own grid, 1.3 at twice and 1.6 at four times that.
"""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time


def ask(command, log, scale, steps, *options):
    """One render's report, or the estimate with --dry-run; of the first `steps` steps if it has more."""
    with tempfile.TemporaryDirectory() as folder:
        asked = [command, "render", log, "--scale", str(scale), "--json", "--quiet",
                 "-o", f"{folder}/x.png", *options]
        if steps:
            asked += ["--at", f"step:{steps}"]
        done = subprocess.run(asked, stdout=subprocess.PIPE, check=False, text=True)
        if done.returncode == 2 and steps:  # a shorter log
            return ask(command, log, scale, None, *options)
        done.check_returncode()
        return json.loads(done.stdout)


def measure(command, log, scale, steps):
    begin, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    report = ask(command, log, scale, steps)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"log": pathlib.Path(log).parent.name, "scale": scale, "limit": steps,
            "steps": report["steps"], "elapsed_s": time.monotonic() - begin,
            "processor_s": processor_s, "phases": report["phases"], "fluid": report.get("fluid"),
            "memory": report["peak_memory_bytes"]}


def idle_s(found):
    """What the run would have taken with the machine to itself."""
    parallel = {1: 1.1, 2: 1.3}.get(found["scale"], 1.6)
    return min(found["elapsed_s"], found["processor_s"] / parallel)


def row(found, foreseen):
    seconds = idle_s(found)
    return (f"| {found['log']} | {found['scale']} | {foreseen['time_s']:.1f} | {seconds:.1f} "
            f"| {foreseen['time_s'] / seconds:.2f} "
            f"| {foreseen['memory_bytes'] / found['memory']:.2f} |")


def main():
    arguments = sys.argv[1:]
    again = "--again" in arguments
    arguments = [a for a in arguments if a != "--again"]
    options = {"--scale": "1,2,4", "--steps": "0"}
    for name in options:
        if name in arguments:
            at = arguments.index(name)
            options[name] = arguments[at + 1]
            del arguments[at:at + 2]
    scales = [int(s) for s in options["--scale"].split(",")]
    steps = int(options["--steps"])
    command, results, *logs = arguments
    results = pathlib.Path(results)
    known = [json.loads(line) for line in results.read_text().splitlines()] if results.exists() else []
    done = {(found["log"], found["scale"], found.get("limit", 0)): found for found in known}
    rows = []
    for scale in scales:
        for log in logs:
            key = (pathlib.Path(log).parent.name, scale, steps)
            if key not in done and not again:
                done[key] = measure(command, log, scale, steps)
                with results.open("a") as out:
                    out.write(json.dumps(done[key]) + "\n")
            if key in done:
                rows.append(row(done[key], ask(command, log, scale, steps, "--dry-run")))
    print("| sample | k | foreseen, s | found, s | of it | memory, of it |\n|---|---|---|---|---|---|")
    print("\n".join(rows))


if __name__ == "__main__":
    main()
