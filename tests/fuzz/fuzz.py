"""Runs the fuzzer on each of its targets, beginning with the kept inputs.

  fuzz.py FUZZER CORPUS FINDS [--seconds S] [--runs N] [--only TARGET]

FUZZER: the program pentimento_fuzz. CORPUS: the kept inputs, a folder for each target. FINDS: where inputs
go that do harm, and new ones that reach more of the code. Ends with 1 if any did harm.
"""

import argparse
import os
import pathlib
import subprocess
import sys

LIMITS = ["-rss_limit_mb=1024", "-malloc_limit_mb=512", "-timeout=10", "-max_len=65536", "-print_final_stats=0"]


def run(fuzzer, target, corpus, finds, bounds):
    """Whether the target did no harm."""
    new = finds / target
    new.mkdir(parents=True, exist_ok=True)
    command = [fuzzer, *bounds, *LIMITS, "-seed=1", "-verbosity=0", f"-artifact_prefix={finds / target}-",
               str(new), str(corpus / target)]
    dictionary = corpus.parent / "words" / f"{target}.txt"
    if dictionary.exists():
        command.insert(1, f"-dict={dictionary}")
    done = subprocess.run(command, env={**os.environ, "PENTIMENTO_FUZZ": target}, capture_output=True, text=True,
                          errors="replace")
    print(f"{target}: {'no harm' if done.returncode == 0 else 'HARM'}", flush=True)
    if done.returncode != 0:
        print(done.stderr[-4000:], flush=True)
    return done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fuzzer")
    parser.add_argument("corpus", type=pathlib.Path)
    parser.add_argument("finds", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=600, help="for each target")
    parser.add_argument("--runs", type=int, help="inputs for each target, at most")
    parser.add_argument("--only", help="one target")
    options = parser.parse_args()
    targets = subprocess.run([options.fuzzer], env={**os.environ, "PENTIMENTO_FUZZ": "list"}, capture_output=True,
                             text=True, check=True).stdout.split()
    if options.only:
        targets = [target for target in targets if target == options.only]
    bounds = [f"-max_total_time={options.seconds}"]
    if options.runs:
        bounds.append(f"-runs={options.runs}")
    good = [run(options.fuzzer, target, options.corpus, options.finds, bounds) for target in targets]
    sys.exit(0 if targets and all(good) else 1)


main()
