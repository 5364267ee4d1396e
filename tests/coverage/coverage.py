"""Which lines and branches of the readers, of publishing and of resuming the tests reach.

usage: coverage.py BUILD SOURCES [--files]

BUILD is a build of the preset `coverage`; `./bootstrap coverage` makes it and calls this. Runs the tests
of formats and replay with LLVM's counters, and prints a table of folders. Exit code 1 if a folder is
below its aim, 2 if a test failed. With --files the table has every file below an aim.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys

LINES, BRANCHES = 90, 80  # aims, percent
PROGRAMS = ("formats_tests", "replay_tests")
# What is reported together: a name, and the folders of sources that belong to it.
GROUPS = (
    ("logs", ("formats/log",)),
    ("recordings", ("formats/import",)),
    ("pictures, videos", ("formats/image", "formats/png", "formats/exr", "formats/video", "formats/color")),
    ("dumps", ("formats/hdf5",)),
    ("publishing", ("formats/io",)),
    ("checkpoints", ("formats/checkpoint",)),
    ("resume", ("replay/checkpoint",)),
)


def run_tests(build, raw):
    """Each process writes its counters into a file of its own."""
    failed = []
    for program in PROGRAMS:
        environment = dict(os.environ, LLVM_PROFILE_FILE=str(raw / f"{program}-%p%c.profraw"))
        done = subprocess.run([build / program, "--gtest_brief=1"], env=environment, check=False)
        if done.returncode != 0:
            failed.append(program)
    return failed


def export(build, raw):
    """The counters of all processes, by file: {path: {"lines": ..., "branches": ...}}."""
    merged = raw / "merged.profdata"
    files = [f for f in raw.glob("*.profraw") if f.stat().st_size > 0]
    listing = raw / "files.txt"
    listing.write_text("".join(f"{f}\n" for f in files))
    subprocess.run(["llvm-profdata", "merge", "--sparse", "--failure-mode=all", "-f", listing, "-o", merged],
                   check=True)
    objects = [word for program in PROGRAMS for word in ("-object", str(build / program))][1:]
    text = subprocess.run(["llvm-cov", "export", "--summary-only", f"--instr-profile={merged}", *objects],
                          check=True, capture_output=True, text=True).stdout
    return {f["filename"]: f["summary"] for f in json.loads(text)["data"][0]["files"]}


def percent(summaries, kind):
    count = sum(s[kind]["count"] for s in summaries)
    covered = sum(s[kind]["covered"] for s in summaries)
    return 100.0 if count == 0 else 100 * covered / count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("sources", type=pathlib.Path)
    parser.add_argument("--files", action="store_true", help="also each file below an aim")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    raw = build / "coverage"
    raw.mkdir(exist_ok=True)
    for old in raw.glob("*.prof*"):
        old.unlink()
    failed = run_tests(build, raw)
    files = {os.path.relpath(path, arguments.sources.resolve()): summary
             for path, summary in export(build, raw).items()}
    below = False
    print(f"{'':18} {'lines':>8} {'branches':>9}")
    for name, folders in GROUPS:
        here = {path: s for path, s in files.items() if path.startswith(tuple(f"{f}/" for f in folders))}
        lines, branches = percent(here.values(), "lines"), percent(here.values(), "branches")
        print(f"{name:18} {lines:6.1f} % {branches:7.1f} %")
        below |= not here or lines < LINES or branches < BRANCHES
        for path, summary in sorted(here.items()) if arguments.files else ():
            lines, branches = percent([summary], "lines"), percent([summary], "branches")
            if lines < LINES or branches < BRANCHES:
                print(f"    {lines:5.1f} {branches:5.1f}  {path}")
    if failed:
        print(f"coverage: failed: {', '.join(failed)}", file=sys.stderr)
        return 2
    return 1 if below else 0


if __name__ == "__main__":
    sys.exit(main())
