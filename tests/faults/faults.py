#!/usr/bin/env python3
"""What the command does when the machine fails it.

A library (tests/faults/fault_shim.cpp) makes the k-th call of a kind fail, once or from then on, for
k = 1, 2, ... until a run completes without a fault; or kills the process before the k-th call that
changes a file. For `files` the process may have so few files open, one more each time until a run completes.
For `held` a write never ends, and the process is told to stop, and told again. After every run

- the process ended by itself, with exit code 0, 4 or 5 (a kill: by that; told twice: with 75);
- it said why in one line;
- each output holds its old bytes or the complete new ones, and the new ones if the code is 0;
- no temporary file is left (a kill leaves some; the next run completes beside them).

Memory that is refused to libraries before the command begins ends it by a signal, and so does most that
is refused to Mesa, and some to OpenSSL: by hand only.

usage: faults.py COMMAND SHIM [--kinds write,sync,rename,thread,memory,files,held,kill] [--long] [--table]

Without --long every kind tries a few k, the first and the last among them. --table prints a line for
each kind, as docs/reliability.md has it.
"""

import argparse
import collections
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time

HEADER = ('{"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.3,"height":0.2},'
          '"grid":{"width":48,"height":32}}\n')
STROKE = ('{"t":0,"type":"touch","phase":"down","x":0.05,"y":0.05}\n'
          '{"t":0.2,"type":"touch","phase":"up","x":0.25,"y":0.15}\n')
JOBS = {
    "render": (["render", "a.jsonl", "-o", "a.png", "-o", "a.exr", "-o", "a.h5", "--quiet", "--threads", "3"],
               ["a.png", "a.exr", "a.h5"]),
    "convert": (["convert", "a.jsonl", "-o", "b.jsonl.gz", "--quiet"], ["b.jsonl.gz"]),
}
KINDS = ("write", "sync", "rename", "thread", "memory", "files", "held", "kill")
ENDS = frozenset({0, 4, 5})
INTERRUPTED = 75
SAME_WISH_S = 0.6  # a signal that comes within half a second of the first is no second wish
OLD = b"old"
SLOWEST_S = 120  # a run that takes longer hangs
FEWEST_FILES = 4  # with three, which are open at the start, no shared library is found
MOST_FILES = 64  # a job that needs more at a time leaks them


def limit_files(files):
    resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))


class Place:
    """A folder in which a job runs."""

    def __init__(self, command, shim, job):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        self.command, self.shim = command, shim
        self.words, self.outputs = JOBS[job]
        (self.path / "a.jsonl").write_text(HEADER + STROKE)

    def prepare(self, fault):
        """The environment of a run, and the file that gets the number of calls"""
        # Without shaders kept by runs before: every run makes the same calls.
        environment = dict(os.environ, LC_ALL="C", PENTIMENTO_CACHE="")
        count = self.path / "count"
        if fault:
            environment.update(LD_PRELOAD=self.shim, PENTIMENTO_FAULT=fault, PENTIMENTO_FAULT_COUNT=str(count))
        for name in self.outputs:
            (self.path / name).write_bytes(OLD)
        return environment, count

    def run(self, fault=None, files=None):
        """(exit code, standard error, number of calls); `files`: how many may be open at a time"""
        environment, count = self.prepare(fault)
        try:
            done = subprocess.run([self.command, *self.words], cwd=self.path, env=environment, capture_output=True,
                                  timeout=SLOWEST_S, preexec_fn=files and (lambda: limit_files(files)))
            code, words = done.returncode, done.stderr.decode(errors="replace")
        except subprocess.TimeoutExpired:
            code, words = "hang", ""
        calls = int(count.read_text()) if count.exists() else 0
        count.unlink(missing_ok=True)
        return code, words, calls

    def memory_before_main(self):
        """How often libraries ask for memory before the command begins, and it for next to nothing"""
        words, self.words = self.words, ["--version"]
        calls = self.run("memory:0:once")[2]
        self.words = words
        return calls

    def stop_twice(self, fault):
        """(exit code, standard error) of a run that a fault holds, and that gets two signals"""
        environment, held = self.prepare(fault)
        with subprocess.Popen([self.command, *self.words], cwd=self.path, env=environment, text=True,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
            until = time.monotonic() + SLOWEST_S
            while not held.exists() and process.poll() is None and time.monotonic() < until:
                time.sleep(0.02)
            process.send_signal(signal.SIGTERM)
            time.sleep(SAME_WISH_S)
            process.send_signal(signal.SIGTERM)
            try:
                words = process.communicate(timeout=SLOWEST_S)[1]
            except subprocess.TimeoutExpired:
                process.kill()
                return "hang", ""
        held.unlink(missing_ok=True)
        return process.returncode, words

    def contents(self):
        return {name: (self.path / name).read_bytes() for name in self.outputs}

    def temporaries(self):
        return [path for path in self.path.iterdir() if path.name.endswith((".part", ".lock"))]


def problems(place, reference, code, words, killed, ends):
    found = []
    if killed and code == -9:
        pass
    elif code not in ends:
        found.append(f"ended with {code}: {words.strip()[-200:]}")
    elif code != 0 and words.count("\n") != 1:
        found.append(f"said {words!r}")
    for name, content in place.contents().items():
        if content != reference[name] and (content != OLD or code == 0):
            found.append(f"{name} is neither old nor complete" if code != 0 else f"{name} is not the plain run's")
    left = place.temporaries()
    if left and not killed:
        found.append(f"left {[path.name for path in left]}")
    for path in left:
        path.unlink()
    return found


def chosen(calls, long, kind):
    """The k to try of so many calls."""
    if long and kind != "memory":
        return range(1, calls + 1)
    if long:  # there are a hundred thousand: the first, and then ever larger steps
        return sorted({*range(1, 101), *(int(100 * 1.03 ** i) for i in range(400)), calls} & {*range(1, calls + 1)})
    few = 3 if kind != "memory" else 6
    return sorted({1, calls, *(max(1, calls * i // few) for i in range(1, few))})


def judge(place, reference, done, killed=False, ends=ENDS):
    """(runs, codes, what was wrong) of runs that come as (name, exit code, standard error)"""
    codes, wrong = collections.Counter(), []
    for name, code, words in done:
        codes[code] += 1
        wrong += [f"{name}: {text}" for text in problems(place, reference, code, words, killed, ends)]
    return sum(codes.values()), codes, wrong


def try_kind(place, reference, kind, mode, long):
    """(calls, runs, codes, what was wrong)"""
    call = "publish" if kind == "kill" else kind
    _, _, calls = place.run(f"{call}:0:{mode}")
    first = place.memory_before_main() if kind == "memory" else 0
    done = ((f"{kind} {k} {mode}", *place.run(f"{call}:{k}:{mode}")[:2])
            for k in (first + n for n in chosen(calls - first, long, kind) if calls))
    return calls, *judge(place, reference, done, killed=kind == "kill")


def with_few_files(place):
    """Runs that may have FEWEST_FILES open and more, until one completes"""
    for limit in range(FEWEST_FILES, MOST_FILES + 1):
        code, words, _ = place.run(files=limit)
        yield f"files {limit}", code, words
        if code == 0:
            return


def try_files(place, reference):
    """As try_kind(): the limit that sufficed, and the rest"""
    runs, codes, wrong = judge(place, reference, with_few_files(place))
    if codes[0] == 0:
        wrong.append(f"files {MOST_FILES}: not enough")
    return FEWEST_FILES + runs - 1, runs, codes, wrong


def try_held(place, reference, long):
    """As try_kind(), for writes that never end."""
    _, _, calls = place.run("write:0:once")
    done = ((f"held {k}", *place.stop_twice(f"write:{k}:hold")) for k in chosen(calls, long, "write"))
    return calls, *judge(place, reference, done, ends={INTERRUPTED})


def modes(kind):
    """How a fault of a kind comes."""
    return {"kill": ("kill",), "files": ("limit",), "held": ("hold",)}.get(kind, ("once", "on"))


def try_one(place, reference, kind, mode, long):
    if kind == "files":
        return try_files(place, reference)
    if kind == "held":
        return try_held(place, reference, long)
    return try_kind(place, reference, kind, mode, long)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command")
    parser.add_argument("shim")
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    wrong = []
    for job in JOBS:
        place = Place(os.path.abspath(options.command), os.path.abspath(options.shim), job)
        code, words, _ = place.run()
        reference = place.contents()
        if code != 0 or OLD in reference.values():
            sys.exit(f"{job}: the plain run ended with {code}: {words}")
        for kind in options.kinds.split(","):
            for mode in modes(kind):
                calls, runs, codes, found = try_one(place, reference, kind, mode, options.long)
                wrong += [f"{job}: {text}" for text in found]
                if options.table:
                    ends = ", ".join(f"{n} x {code}" for code, n in sorted(codes.items(), key=str))
                    print(f"| {job} | {kind} | {mode} | {calls} | {runs} | {ends} | {len(found)} |", flush=True)
        code, words, _ = place.run()
        if code != 0 or place.contents() != reference:
            wrong.append(f"{job}: the run after all faults ended with {code}: {words}")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
