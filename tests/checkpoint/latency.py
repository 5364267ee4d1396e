"""How long a job goes on after SIGTERM, without and with --checkpoint, at several sizes.

usage: latency.py PROGRAM SOURCES [--signals 5] [--factors 1,8,16] [--log samples/blue-tit/blue-tit.jsonl.gz] [--whole S]

For each factor the log is rendered at that many times its grid, and a SIGTERM is sent at moments spread
over the first seconds of the painting. Measured is from the signal until the process has ended. The exit
code must be 75, no temporary file may be left, and with --checkpoint a slot must be there. Prints a table.

With --whole S a job paints the first S seconds and writes a picture and a dump. It runs once undisturbed; then the
signals are spread over all of it: painting, hash, shading, encoding, and the dump that is read back.
"""

import argparse
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

INTERRUPTED = 75
FIRST_S, SPREAD_S = 1.0, 4.0  # painting has begun, and moves on from signal to signal
MOST_OF_A_JOB = 0.95  # what is left are names that are changed


def painting_has_begun(process):
    """Waits for the progress of the simulation, which comes as JSON lines."""
    for line in process.stderr:
        if b'"simulate"' in line:
            return True
    return False


def words_of(program, log, factor, folder, whole_s):
    words = [program, "render", log, "-o", folder / "a.png", "--scale", str(factor), "--progress", "ndjson"]
    return words if whole_s is None else [*words, "--at", str(whole_s), "-o", folder / "a.h5"]


def undisturbed_s(words):
    """How long a job takes from when painting begins."""
    process = subprocess.Popen(words, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
    painting_has_begun(process)
    begun = time.monotonic()
    process.stderr.read()
    if process.wait() != 0:
        raise SystemExit(f"latency: the job that nobody disturbed ended with {process.returncode}")
    return time.monotonic() - begun


def measure(words, checkpoint, wait_s, folder):
    if checkpoint:
        words = [*words, "--checkpoint", folder / "ck"]
    process = subprocess.Popen(words, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
    if not painting_has_begun(process):
        raise SystemExit(f"latency: the job ended before it painted, exit code {process.wait()}")
    time.sleep(wait_s)
    sent = time.monotonic()
    process.send_signal(signal.SIGTERM)
    process.stderr.read()
    code = process.wait()
    taken_s = time.monotonic() - sent
    if code != INTERRUPTED:
        raise SystemExit(f"latency: exit code {code}, not {INTERRUPTED}: a faster machine needs an earlier signal")
    left = [name for name in os.listdir(folder) if name.startswith(".pentimento-")]
    left += [name for name in ("a.png", "a.h5") if (folder / name).exists()]
    if left:
        raise SystemExit(f"latency: left behind: {left}")
    if checkpoint and not any(name.endswith(".slot") for name in os.listdir(folder / "ck")):
        raise SystemExit("latency: nothing was saved")
    return taken_s


def row(program, log, factor, checkpoint, arguments):
    """Sends all signals to jobs of one kind."""
    first_s, spread_s = FIRST_S, SPREAD_S
    taken_s = []
    for i in range(-1 if arguments.whole is not None else 0, arguments.signals):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="pentimento-latency-"))
        try:
            words = words_of(program, log, factor, folder, arguments.whole)
            if i < 0:
                first_s, spread_s = 0, MOST_OF_A_JOB * undisturbed_s(words)
                continue
            wait_s = first_s + spread_s * (i + (arguments.whole is not None)) / arguments.signals
            taken_s.append(measure(words, checkpoint, wait_s, folder))
        finally:
            shutil.rmtree(folder)
    taken_s.sort()
    return (f"{factor:5} {'yes' if checkpoint else 'no':>10} {taken_s[len(taken_s) // 2]:10.2f} "
            f"{taken_s[-1]:10.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("sources", type=pathlib.Path)
    parser.add_argument("--signals", type=int, default=5, help="for each row")
    parser.add_argument("--factors", default="1,8,16", help="times the log's grid")
    parser.add_argument("--log", default="samples/blue-tit/blue-tit.jsonl.gz")
    parser.add_argument("--whole", type=float, metavar="S", help="signals over a whole job of so many seconds")
    arguments = parser.parse_args()
    program, log = arguments.program.resolve(), (arguments.sources / arguments.log).resolve()
    print(f"{'times':>5} {'checkpoint':>10} {'median, s':>10} {'longest, s':>10}")
    for factor in (int(f) for f in arguments.factors.split(",")):
        for checkpoint in (False, True):
            print(row(program, log, factor, checkpoint, arguments), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
