#!/usr/bin/env python3
"""Kills a run at random times until it has come through, and compares with a run that nobody disturbed.

  kills.py COMMAND REPOSITORY [--kills N] [--signal KILL|TERM|BOTH] [--seed S] [--only CASE]

Each case is a job with --checkpoint. Its process is ended by the signal after a random time, during reading,
painting, saving, resuming or shading, and started again with the same command. When it comes to its end, the
outputs must have the bytes, and the report the hashes and the account, of the run without interruptions. Then
the job begins anew, until there were N kills in each case. Ends with 1 if anything differed.
"""

import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

MEASURED = ("wall_s", "phases", "peak_memory_bytes", "checkpoint")
INTERRUPTED = 75


def cases(samples):
    """name: (options, steps between slots)."""
    tips, wet = str(samples / "tips/tips.jsonl"), str(samples / "wet-on-wet/wet-on-wet.jsonl")
    return {
        "plain": ([tips, "--at", "1.5", "-o", "a.png"], 3),
        "detail": ([tips, "--at", "1.2", "--detail", "2", "-o", "a.png", "-o", "a.h5"], 2),
        "stops": ([wet, "--at", "0.5", "--at", "0.8", "--at", "1.1", "-o", "a-%.png"], 5),
        "film": ([str(samples / "dry-brush/dry-brush.jsonl"), "-o", "a.avi", "-o", "f-%03d.png", "--frames", "12",
                  "--width", "96"], 10),
        "scratch": ([tips, "--at", "1", "--detail", "3", "--scratch", ".", "-o", "a.png"], 4),
    }


def comparable(report):
    return {name: value for name, value in json.loads(report).items() if name not in MEASURED}


def outputs(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir()) if path.is_file()
            and not path.name.startswith(".")}


class Case:
    def __init__(self, command, options, steps, folder):
        self.command = [command, "render", *options, "--json", "--quiet"]
        self.saved = [*self.command, "--checkpoint", "ck", "--checkpoint-every", f"step:{steps}"]
        self.folder = folder
        begin = time.monotonic()
        done = subprocess.run(self.command, cwd=folder, capture_output=True, check=True)
        self.seconds = time.monotonic() - begin
        self.report, self.files = comparable(done.stdout), outputs(folder)

    def empty(self):
        for path in self.folder.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()

    def attempt(self, signals, chance, most_s):
        """(its exit status, its report) of one run, which a signal may end before `most_s`."""
        run = subprocess.Popen(self.saved, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        try:
            out, err = run.communicate(timeout=chance.uniform(0.01, most_s))
        except subprocess.TimeoutExpired:
            run.send_signal(chance.choice(signals))
            out, err = run.communicate()
        return run.returncode, out, err.decode(errors="replace")

    def survive(self, signals, chance):
        """(how many kills it took, what is wrong)."""
        self.empty()
        kills = 0
        while True:
            # Each run may take longer than the one before: else a busy machine kills all of them while they begin.
            status, out, err = self.attempt(signals, chance, self.seconds * 1.25**kills)
            if status in (-signal.SIGKILL, -signal.SIGTERM, INTERRUPTED):
                kills += 1
            elif status != 0:
                return kills, f"exit {status}: {err}"
            else:
                break
        report = comparable(out)
        if report != self.report:
            return kills, "another report: " + "; ".join(
                f"{name} {report.get(name)}, not {self.report.get(name)}" for name in sorted({*report, *self.report})
                if report.get(name) != self.report.get(name))
        if outputs(self.folder) != self.files:
            return kills, "other files"
        if (self.folder / "ck").exists():
            return kills, "slots are left"
        return kills, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("repository", type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=200, help="in each case (200)")
    parser.add_argument("--signal", choices=("KILL", "TERM", "BOTH"), default="KILL")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="one case")
    options = parser.parse_args()
    signals = {"KILL": [signal.SIGKILL], "TERM": [signal.SIGTERM], "BOTH": [signal.SIGKILL, signal.SIGTERM]}
    wrong = 0
    for name, (job, steps) in cases(options.repository.absolute() / "samples").items():
        if options.only not in (None, name):
            continue
        with tempfile.TemporaryDirectory() as folder:
            case = Case(options.command, job, steps, pathlib.Path(folder))
            chance, kills, runs = random.Random(f"{options.seed} {name}"), 0, 0
            while kills < options.kills:
                more, problem = case.survive(signals[options.signal], chance)
                kills, runs = kills + more, runs + 1
                if problem:
                    wrong += 1
                    print(f"{name}: after {more} kills: {problem}", flush=True)
            print(f"{name}: {kills} kills, {runs} jobs came through", flush=True)
    sys.exit(1 if wrong else 0)


main()
