#!/usr/bin/env python3
"""Does `verify` name the step and the fields in which a change of the code shows first?

Changes one number of the code after the other in a copy of the tree, builds the command, and lets `verify` look for the
place where its replay leaves that of the sound command. The truth is found without `verify`: both commands dump their
states after the step that it names and after the one before, and h5py compares the dumps. The verdict must be the same
on 1, 2 and 7 threads.

The copy and its build are those of mutate.py. Takes some minutes. Ends with 1 if a verdict is wrong.
"""

import collections
import gzip
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import h5py

import mutate

Change = collections.namedtuple("Change", "file find replace log about")
CHANGES = [
    Change("core/brush/transfer.cpp", "kSlowing_per_s = 120;", "kSlowing_per_s = 121;", "tips/tips.jsonl",
           "how deep a fast brush lays its film"),
    Change("core/brush/stroke_path.cpp", "kHeadingFrac = 0.25;", "kHeadingFrac = 0.26;", "own-brushes/own-brushes.jsonl",
           "how far a tip goes until it has turned"),
    Change("core/brush/stamp_shares.cpp", "kScraped = 0.97f;", "kScraped = 0.975f;", "knife/knife.jsonl",
           "what a blade leaves"),
    Change("core/fluid/conservative/conservative_scheme.cpp", "kLeastFilm_m = 5e-5f;", "kLeastFilm_m = 6e-5f;",
           "balance-drips/balance-drips.jsonl", "which films have a surface"),
    Change("core/optics/spectral/measured_paints.h", "kMeasuredScale = 12;", "kMeasuredScale = 12.1;",
           "pigments/pigments.jsonl", "the measured pigments, which dry paint keeps"),
]
THREADS = (1, 2, 7)
COMMAND = mutate.BUILD / "pentimento"


def run(command, *arguments, good=(0,)):
    told = subprocess.run([str(command), *map(str, arguments)], stdout=subprocess.PIPE, text=True)
    if told.returncode not in good:
        sys.exit(f"parted: {arguments[0]} ended with {told.returncode}")
    return told.stdout


def fields_after(command, log, step, names, folder):
    """{field: its values} after so many steps."""
    state = folder / f"{command.name}-{step}.h5"
    run(command, "render", log, "-o", state, "--at", f"step:{step}", "--quiet")
    with h5py.File(state) as dump:
        return {name: dump[name][...].tobytes() for name in names}


def differing(sound, log, step, names, folder):
    """Names of the fields that differ between the commands after so many steps, bit for bit."""
    one, other = (fields_after(command, log, step, names, folder) for command in (sound, COMMAND))
    return [name for name in names if one[name] != other[name]]


def wrong_with(change, sound, folder):
    """What is wrong with verify's verdict on a planted change; nothing if it is right."""
    log = mutate.ROOT / "samples" / change.log
    hashes = folder / "hashes.gz"
    run(sound, "render", log, "--hashes", hashes, "--quiet")
    verdicts = [json.loads(run(COMMAND, "verify", log, hashes, "--threads", threads, "--json", good=(0, 1)))
                for threads in THREADS]
    if any(verdict != verdicts[0] for verdict in verdicts):
        return "the verdict depends on the number of threads"
    if verdicts[0]["equal"]:
        return "verify saw nothing"
    found = verdicts[0]["difference"]
    step = found["step"]
    print(f"{change.file}: {change.replace} ({change.about})\n  step {step}, line {found['line']} ({found['event']}), "
          f"{', '.join(found['fields'])}, {len(found['tiles'])} tiles", flush=True)
    with gzip.open(hashes, "rt") as file:
        names = json.loads(file.readline())["fields"]
    if earlier := step > 1 and differing(sound, log, step - 1, names, folder):
        return f"the dumps differ one step earlier, in {', '.join(earlier)}"
    if found["fields"] != (truth := differing(sound, log, step, names, folder)):
        return f"the dumps differ in {', '.join(truth)}"
    return ""


def main():
    mutate.WORK.mkdir(exist_ok=True)
    mutate.copy_tree()
    mutate.configure()
    jobs = os.cpu_count()
    wrong = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        sound = folder / "sound"
        if refused := mutate.build("pentimento", jobs):
            sys.exit(f"parted: the tree does not build without a change\n{refused[-4000:]}")
        sound.write_bytes(COMMAND.read_bytes())
        sound.chmod(0o755)
        for change in CHANGES:
            path = mutate.TREE / change.file
            text = path.read_text()
            if text.count(change.find) != 1:
                sys.exit(f"parted: {change.file} does not have {change.find} once")
            path.write_text(text.replace(change.find, change.replace))
            try:
                problem = mutate.build("pentimento", jobs)[-2000:] or wrong_with(change, sound, folder)
            finally:
                path.write_text(text)
            if problem:
                wrong += 1
                print(f"{change.file}: {change.replace}: {problem}", flush=True)
    print(f"{len(CHANGES) - wrong} of {len(CHANGES)} verdicts are right")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
