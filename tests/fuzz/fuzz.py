"""Runs the fuzzer on each of its targets, beginning with the kept inputs.

  fuzz.py FUZZER CORPUS FINDS [--seconds S] [--runs N] [--only TARGET] [--record FILE] [--patience N]

FUZZER: the program pentimento_fuzz. CORPUS: the kept inputs, a folder for each target. FINDS: where inputs
go that do harm, and new ones that reach more of the code. For each target a line says how many inputs were
tried, the processor time that took, and how many edges of the code they reached. Ends with 1 if any did
harm. S seconds are processor time: on a busy machine they take longer. FILE: where record.py adds the runs up.
N: an input may take N times as long as on a quiet machine before it counts as one that hangs.

An input that ends HDF5 itself is no harm if a user's file is safe from it: if reading it in a child says in
one line what is wrong, or if nothing has been read yet. The line counts them.
"""

import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys

import record

LIMITS = ["-rss_limit_mb=1024", "-malloc_limit_mb=512", "-print_final_stats=1"]
# An input that takes longer than this hangs, seconds.
LONGEST_S = {"replay": 60}  # the first use of each brush draws its tip, which takes seconds
LONGEST_OF_OTHERS_S = 10
INTERRUPTED = 72  # libFuzzer's exit code when somebody ends it by SIGINT or SIGTERM
# Read by a library that does not withstand every file, and therefore by users' runs in a child first.
BY_CHILD = ("dump", "dump-edits")
MORE = {
    "dump": ["-max_len=65536", "-detect_leaks=0"],  # the library loses memory when it gives up on a file
    "dump-edits": ["-max_len=256", "-detect_leaks=0"],
    # To weigh inputs by how rare what they reach is takes the fuzzer a third of its time here: each replay
    # reaches nearly all there is.
    "replay": ["-max_len=512", "-entropic=0"],
}
FRAME = re.compile(r"^ +#\d+ ", re.MULTILINE)


class Tally:
    """What the runs on one target did."""

    def __init__(self):
        self.inputs = self.edges = self.library = self.editing = 0
        self.cpu_s = 0.0

    def add(self, output, cpu_s):
        counts = re.findall(r"stat::number_of_executed_units: (\d+)", output) or re.findall(r"^#(\d+)", output, re.M)
        self.inputs += int(counts[-1]) if counts else 0
        self.edges = max([self.edges, *map(int, re.findall(r" cov: (\d+)", output))])
        self.cpu_s += cpu_s

    def text(self):
        library = f", {self.library} ended HDF5 and a child held them" if self.library else ""
        library += f", {self.editing} ended HDF5 while a dump was changed" if self.editing else ""
        speed = self.inputs / max(self.cpu_s, 1e-9)
        return (f"{self.inputs} inputs, {self.cpu_s / 60:.1f} min of processor time, {speed:.0f}/s, "
                f"{self.edges} edges{library}")


def cpu_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def call(fuzzer, target, arguments):
    return subprocess.run([fuzzer, *arguments], env={**os.environ, "PENTIMENTO_FUZZ": target}, capture_output=True,
                          text=True, errors="replace")


def is_in_library(output):
    """Whether the innermost frame that is the library's or ours is the library's."""
    for line in output.splitlines():
        if FRAME.match(line):
            if "libhdf5" in line:
                return True
            if "pentimento::" in line:
                return False
    return False


def ended_by_editing(output):
    """Whether HDF5 ended while the fuzzer changed a dump by it: no reader has come to that."""
    return is_in_library(output) and "DumpEditor::" in output


def held_by_child(fuzzer, target, done):
    written = re.search(r"Test unit written to (\S+)", done.stderr)
    return (target in BY_CHILD and written and is_in_library(done.stderr)
            and call(fuzzer, target + "-child", [written[1]]).returncode == 0)


def run(fuzzer, target, corpus, finds, options):
    """Whether the target did no harm."""
    new = finds / target
    new.mkdir(parents=True, exist_ok=True)
    tally = Tally()
    longest_s = options.patience * LONGEST_S.get(target, LONGEST_OF_OTHERS_S)
    seed = options.seed
    harm = None
    # What ends the library ends the fuzzer too, which begins again with another seed.
    while harm is None and (left := options.seconds - tally.cpu_s) > 0:
        arguments = [*LIMITS, f"-timeout={longest_s}", *MORE.get(target, ["-max_len=65536"]),
                     f"-max_total_time={int(left) + 1}", f"-seed={seed}",
                     f"-artifact_prefix={finds / target}-", str(new), str(corpus / target)]
        if options.runs:
            arguments.insert(0, f"-runs={options.runs}")
        before = cpu_s()
        done = call(fuzzer, target, arguments)
        # While an input hangs nothing is tried: that time does not count.
        hung_s = longest_s if "libFuzzer: timeout" in done.stderr else 0
        tally.add(done.stderr, max(0, cpu_s() - before - hung_s))
        seed += 1
        if done.returncode == 0:
            if options.runs:
                break
        elif done.returncode == INTERRUPTED:
            break
        elif ended_by_editing(done.stderr):
            tally.editing += 1
        elif held_by_child(fuzzer, target, done):
            tally.library += 1
        else:
            harm = done.stderr
    if options.record:
        record.add(options.record, target, tally.inputs, tally.cpu_s, tally.edges, int(harm is not None))
    print(f"{target}: {'no harm' if harm is None else 'HARM'}; {tally.text()}", flush=True)
    if harm is not None:
        print(harm[-4000:], flush=True)
    return harm is None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fuzzer")
    parser.add_argument("corpus", type=pathlib.Path)
    parser.add_argument("finds", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=600, help="of processor time, for each target")
    parser.add_argument("--runs", type=int, help="inputs for each target, at most")
    parser.add_argument("--only", default="all", help="one target, or `all`")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--record", type=pathlib.Path, help="a JSON file that the runs are added to")
    parser.add_argument("--patience", type=int, default=1)
    options = parser.parse_args()
    targets = call(options.fuzzer, "list", []).stdout.split()
    if options.only != "all":
        if options.only not in targets:
            sys.exit(f"fuzz.py: no target '{options.only}'; there are {' '.join(targets)}")
        targets = [options.only]
    good = [run(options.fuzzer, target, options.corpus, options.finds, options) for target in targets]
    sys.exit(0 if targets and all(good) else 1)


main()
