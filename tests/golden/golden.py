#!/usr/bin/env python3
"""Frozen results: the hashes of many logs' states, and a few small pictures.

usage: golden.py check REPOSITORY BUILD     fails where a result is not the frozen one
       golden.py renew REPOSITORY BUILD     freezes what is found now, and says what changed

`cases.json` says what is replayed. `states.json` has a hash for each log, fluid, moment and
detail; threads do not count: each state is computed by 1 thread and by 7. `pictures/` has the
pictures, which may differ a little, since Mesa compiles shaders for the machine at hand.
"""

import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
THREADS = (1, 7)
# Two levels of 8 bits: one for another machine's shader compiler, one for rounding.
LARGEST_DIFFERENCE = "0.0079"


def state_rows(cases):
    """(log, fluid, moment, detail), the dearest first so that two processes end together."""
    rows = []
    for case in cases["states"]:
        for detail in cases["details"]:
            rows.append((case["log"], "conservative", case["at"], detail))
        rows.append((case["log"], "paper", case.get("paper_at", cases["paper_at"]), 1))
    for case in cases["paper_finer"]:
        rows.append((case["log"], "paper", case["at"], case["detail"]))
    return sorted(rows, key=lambda row: (-row[3], row))


def key(row):
    log, fluid, at, detail = row
    return f"{log} {fluid} at {at} detail {detail}"


def hashes_of(root, build, row):
    """The state's hash for each number of threads."""
    log, *rest = row
    lines = ["\t".join(str(field) for field in (root / log, *rest, threads)) for threads in THREADS]
    run = subprocess.run([build / "golden_states"], input="\n".join(lines) + "\n",
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise SystemExit(f"{key(row)}: {run.stderr.strip()}")
    return run.stdout.split()


def found_states(root, build, cases):
    rows = state_rows(cases)
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        found = dict(zip(map(key, rows), pool.map(lambda row: hashes_of(root, build, row), rows)))
    problems = [f"{name}: {' and '.join(hashes)} by {' and '.join(map(str, THREADS))} threads"
                for name, hashes in found.items() if len(set(hashes)) > 1]
    return {name: hashes[0] for name, hashes in sorted(found.items())}, problems


def changed_states(frozen, found):
    lines = [f"{name}: {frozen[name][:12]} is now {found[name][:12]}"
             for name in frozen if name in found and frozen[name] != found[name]]
    lines += [f"{name}: no longer a case" for name in frozen if name not in found]
    lines += [f"{name}: not frozen yet" for name in found if name not in frozen]
    return lines


def render(root, build, case, file):
    run = subprocess.run([build / "pentimento", "render", root / case["log"], "--at", case["at"], "--crop",
                          case["crop"], "-o", file, "--quiet", *case.get("options", [])],
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise SystemExit(f"{case['name']}: {run.stderr.strip()}")


def changed_pictures(root, build, cases, folder):
    """Renders all into the folder; a line for each that is not the frozen one."""
    lines = []
    for case in cases["pictures"]:
        frozen = HERE / "pictures" / f"{case['name']}.png"
        file = folder / frozen.name
        render(root, build, case, file)
        if not frozen.exists():
            lines.append(f"{frozen.name}: not frozen yet")
            continue
        run = subprocess.run([build / "pentimento", "compare", frozen, file, "--max", LARGEST_DIFFERENCE],
                             capture_output=True, text=True, check=False)
        if run.returncode != 0:
            lines.append(f"{frozen.name}: {(run.stdout + run.stderr).strip()}")
    return lines


def pictures_without_case(cases):
    names = {f"{case['name']}.png" for case in cases["pictures"]}
    return sorted(file for file in (HERE / "pictures").glob("*") if file.name not in names)


def main():
    if len(sys.argv) != 4 or sys.argv[1] not in ("check", "renew"):
        raise SystemExit(__doc__)
    command, root, build = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    cases = json.loads((HERE / "cases.json").read_text())
    file = HERE / "states.json"
    frozen = json.loads(file.read_text()) if file.exists() else {}
    found, problems = found_states(root, build, cases)
    changes = changed_states(frozen, found)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        pictures = changed_pictures(root, build, cases, folder)
        left_over = pictures_without_case(cases)
        if command == "renew" and not problems:
            file.write_text(json.dumps(found, indent=1) + "\n")
            (HERE / "pictures").mkdir(exist_ok=True)
            for line in pictures:
                name = line.split(":")[0]
                (HERE / "pictures" / name).write_bytes((folder / name).read_bytes())
            for picture in left_over:
                picture.unlink()
    pictures += [f"{picture.name}: no longer a case" for picture in left_over]
    for line in problems + changes + pictures:
        print(line)
    print(f"{len(found)} states by {THREADS[0]} and {THREADS[1]} threads, {len(cases['pictures'])} pictures: "
          f"{len(changes)} states and {len(pictures)} pictures are others, {len(problems)} depend on threads")
    return 1 if problems or (command == "check" and (changes or pictures)) else 0


if __name__ == "__main__":
    sys.exit(main())
