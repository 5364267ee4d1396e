#!/usr/bin/env python3
"""Do the tests bite? Plants one small fault after the other in a copy of the tree, builds, runs tests
until one fails. A fault that no test notices has survived: a test is missing there, or the record of
the fault says under "survives" why no test can or should notice it.

The faults are records in tests/mutation/faults; records.py says what is in them.

All is kept in build-mutation: the copy (tree), its build, and results.json, where --resume goes on.
Ends with 1 if a record is stale or refused by the compiler, if an unexplained fault survived, or if
less than nine of ten were caught.
"""

import argparse
import collections
import concurrent.futures
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

from records import load_records, planted, problems

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORK = ROOT / "build-mutation"
TREE, BUILD, RESULTS = WORK / "tree", WORK / "tree/build", WORK / "results.json"
MUST_BE_CAUGHT = 0.9
SLOW_S = 1.0  # tests that take longer wait until the quick ones of their rank have passed
PATIENCE = 5, 60  # a run that takes this many times its usual time, and so many seconds, hangs
FOLDERS = ["core", "formats", "replay", "cli"]  # each sees those before it
NOT_ASKED = {"mutation_list", "mutation_runner"}  # they look at the records themselves

Test = collections.namedtuple("Test", "program name file seconds command")  # program "": not GoogleTest


def say(text):
    print(text, file=sys.stderr, flush=True)


# ---- the copy

def tree_files():
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
    return [name for name in listed.split("\0") if name and (ROOT / name).is_file()]


def copy_tree():
    """Writes what differs only, so that little is built anew; answers with a digest of it all."""
    names, whole = set(tree_files()), hashlib.sha256()
    for name in sorted(names):
        wanted, copy = (ROOT / name).read_bytes(), TREE / name
        # The records and the runner decide no test's outcome: writing new ones keeps the results.
        if not name.startswith("tests/mutation/"):
            whole.update(name.encode() + wanted)
        if not copy.is_file() or copy.read_bytes() != wanted:
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(wanted)
            shutil.copymode(ROOT / name, copy)
    for folder in {name.split("/")[0] for name in names if "/" in name}:
        for copy in (TREE / folder).rglob("*"):
            if copy.is_file() and str(copy.relative_to(TREE)) not in names:
                copy.unlink()
    return whole.hexdigest()


def configure():
    """As the release preset does, but with one object for each file outside the tests, of which a fault changes one.

    The objects come out of the compiler's cache where there is one."""
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "-G", "Ninja", "-S", str(TREE), "-B", str(BUILD), "-DCMAKE_BUILD_TYPE=Release",
                    "-DPENTIMENTO_TESTS=ON", "-DPENTIMENTO_BENCH=OFF", "-DPENTIMENTO_TOGETHER=tests", *launcher],
                   check=True, stdout=sys.stderr)


def build(target, jobs):
    """The compiler's words if it refuses, else nothing."""
    made = subprocess.run(["cmake", "--build", str(BUILD), "-j", str(jobs), "--target", target],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    return made.stdout if made.returncode else ""


# ---- the tests

def commands():
    """The tests of ctest that are no GoogleTest: (name, command)."""
    told = subprocess.run(["ctest", "--test-dir", str(BUILD), "--show-only=json-v1"], check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    for test in json.loads(told)["tests"]:
        command = test.get("command", [])
        if command and test["name"] not in NOT_ASKED and not any("--gtest_" in word for word in command):
            yield test["name"], command


def source_of_tests(program):
    """Test's name -> its file in the tree; ccache makes names relative to the build."""
    told = WORK / "tests.json"
    subprocess.run([program, "--gtest_list_tests", f"--gtest_output=json:{told}"], check=True,
                   stdout=subprocess.DEVNULL)
    return {f"{suite['name']}.{test['name']}": os.path.relpath(BUILD / test["file"], TREE)
            for suite in json.loads(told.read_text())["testsuites"] for test in suite["testsuite"]}


def seconds_of_tests(program, shard, shards):
    """Test's name -> how long it takes without a fault."""
    told = WORK / f"times-{shard}.json"
    command = [program, f"--gtest_output=json:{told}", "--gtest_brief=1"]
    if subprocess.run(command, cwd=BUILD, env=surroundings(shard, shards), stdout=sys.stderr).returncode:
        sys.exit(f"mutate: {program} fails without a fault")
    return {f"{suite['name']}.{test['name']}": float(test["time"].rstrip("s"))
            for suite in json.loads(told.read_text())["testsuites"] for test in suite["testsuite"]}


def measure_tests(jobs):
    """Runs every test once without a fault."""
    tests = []
    for program in sorted(str(path) for path in BUILD.glob("*_tests")):
        say(f"without a fault: {pathlib.Path(program).name}")
        files = source_of_tests(program)
        for seconds in together(lambda n: seconds_of_tests(program, n, jobs), jobs):
            tests += [Test(program, name, files[name], time_s, []) for name, time_s in seconds.items()]
    for name, command in commands():
        say(f"without a fault: {name}")
        began = time.monotonic()
        if subprocess.run(command, cwd=BUILD, env=surroundings(), stdout=sys.stderr).returncode:
            sys.exit(f"mutate: {name} fails without a fault")
        tests.append(Test("", name, "", time.monotonic() - began, command))
    return tests


def together(body, count):
    """body(0), body(1), ... at the same time."""
    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        return list(pool.map(body, range(count)))


def surroundings(shard=0, shards=1):
    """The distribution's Python comes first: that is the one which has the tests' packages."""
    return {**os.environ, "PATH": "/usr/bin:" + os.environ.get("PATH", ""),
            "GTEST_TOTAL_SHARDS": str(shards), "GTEST_SHARD_INDEX": str(shard)}


def rank(test, source, killer=None):
    """How soon a test is asked about a fault in the source: what most likely notices comes first."""
    folder, program = source.rsplit("/", 1)[0], source.split("/")[0] + "_tests"
    if test.name == killer:
        return 0
    if test.file == f"tests/{os.path.splitext(source)[0]}_test.cpp":
        return 1
    if os.path.dirname(test.file) == f"tests/{folder}":
        return 2
    if test.name.startswith("golden"):  # minutes, and it sees the states and a few pictures only
        return 3 if folder.startswith("core") else 6
    return 4 if test.program.endswith("/" + program) else 5


def can_notice(test, source):
    """Tests of a folder below the fault's do not run its code: the folders' arrows lead downwards."""
    below = FOLDERS[:FOLDERS.index(source.split("/")[0])]
    return not any(test.program.endswith(f"/{folder}_tests") for folder in below)


def rounds(tests, source, killer=None):
    """The tests in the order of asking: lists that one program can run in one go."""
    groups = collections.defaultdict(list)
    for test in (test for test in tests if can_notice(test, source)):
        key = (rank(test, source, killer), test.seconds > SLOW_S, test.program or "~" + test.name)
        groups[key].append(test)
    return [groups[key] for key in sorted(groups)]


def who_fails(group, shard, shards):
    """Name of the test that fails or hangs, or nothing."""
    first, names = group[0], ":".join(test.name for test in group)
    command = [first.program, f"--gtest_filter={names}", "--gtest_fail_fast"] if first.program else first.command
    running = subprocess.Popen(command, cwd=BUILD, env=surroundings(shard, shards), stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True)
    try:
        told, _ = running.communicate(timeout=PATIENCE[0] * sum(test.seconds for test in group) + PATIENCE[1])
        hung = ""
    except subprocess.TimeoutExpired:
        os.killpg(running.pid, signal.SIGKILL)
        told, hung = running.communicate()[0], " (hangs)"
    if running.returncode == 0:
        return ""
    failed = re.search(r"^\[  FAILED  \] ([^\s,]+)", told, re.M)  # else it crashed in the last one begun
    begun = re.findall(r"^\[ RUN      \] (\S+)", told, re.M)
    return (failed[1] if failed else begun[-1] if begun else first.name) + hung


def first_to_fail(group, jobs):
    shards = min(jobs, len(group)) if group[0].program else 1
    return next(filter(None, together(lambda n: who_fails(group, n, shards), shards)), "")


# ---- the run

def judge(record, tests, killer, jobs):
    """Plants the fault, asks the tests, takes it out again."""
    began, path = time.monotonic(), TREE / record["file"]
    sound, verdict = path.read_text(), {"verdict": "survived", "by": ""}
    path.write_text(sound.replace(record["find"], record["replace"]))
    try:
        for group in rounds(tests, record["file"], killer):
            target = os.path.basename(group[0].program) or "all"
            if refused := build(target, jobs):
                verdict = {"verdict": "invalid", "by": refused[-2000:]}
                break
            if name := first_to_fail(group, jobs):
                verdict = {"verdict": "caught", "by": name}
                break
    finally:
        path.write_text(sound)
    return {**verdict, "seconds": round(time.monotonic() - began, 1), "record": planted(record)}


def settled(old, record, same_tree):
    """An earlier verdict that still counts. More tests may catch what survived before."""
    return old and old["record"] == planted(record) and (old["verdict"] == "caught" or same_tree)


def run(records, args):
    WORK.mkdir(exist_ok=True)
    kept = json.loads(RESULTS.read_text()) if RESULTS.exists() else {"tree": "", "tests": [], "faults": {}}
    tree = copy_tree()
    configure()
    if refused := build("all", args.jobs):
        sys.exit(f"mutate: the tree does not build without a fault\n{refused[-4000:]}")
    same = kept["tree"] == tree
    if not (args.resume and same and kept["tests"]):
        kept["tests"] = measure_tests(args.jobs)
    kept["tree"], tests = tree, [Test(*test) for test in kept["tests"]]
    for number, record in enumerate(sorted(records, key=lambda record: (record["file"], record["id"])), 1):
        old = kept["faults"].get(record["id"])
        if not (args.resume and settled(old, record, same)):
            found = judge(record, tests, old and old["by"], args.jobs)
            kept["faults"][record["id"]] = found
            by = "" if found["verdict"] == "survived" else f" by {found['by'].splitlines()[-1]}"
            say(f"[{number}/{len(records)}] {record['id']}: {found['verdict']}{by}, {found['seconds']:.0f} s")
        RESULTS.write_text(json.dumps(kept, indent=1))
    return kept["faults"]


def report(records, found):
    """The table on standard output; whether the tests bite well enough."""
    caught, total, good = collections.Counter(), collections.Counter(), True
    for record in records:
        verdict = found[record["id"]]["verdict"]
        folder = "/".join(record["file"].split("/")[:-1][:2])
        total[folder] += 1
        caught[folder] += verdict == "caught"
        if verdict == "invalid":
            good = False
            print(f"refused by the compiler: {record['id']}\n{found[record['id']]['by']}")
        elif verdict == "survived":
            good = good and "survives" in record
            print(f"survived: {record['id']} ({record['file']}): {record.get('survives', record['breaks'])}")
        elif "survives" in record:
            print(f"caught by now: {record['id']}: its \"survives\" can go")
    for folder in sorted(total):
        print(f"{folder:24} {caught[folder]:4} of {total[folder]:4}")
    print(f"{'all':24} {caught.total():4} of {total.total():4}")
    return good and caught.total() >= MUST_BE_CAUGHT * total.total()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only look whether every record fits the sources")
    parser.add_argument("--list", action="store_true", help="only list the faults")
    parser.add_argument("--only", metavar="GLOB", default="*", help="faults whose id or file matches")
    parser.add_argument("--resume", action="store_true",
                        help="keep earlier verdicts; ask again about survivors if the tree has changed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs at a time (%(default)s)")
    args = parser.parse_args()
    records = load_records(ROOT / "tests/mutation/faults")
    if wrong := problems(records, ROOT):
        sys.exit("\n".join(["mutate: records that do not fit the sources:", *wrong]))
    records = [record for record in records
               if any(fnmatch.fnmatch(record[key], args.only) for key in ("id", "file"))]
    if args.list:
        print("\n".join(f"{record['id']:40} {record['file']}: {record['breaks']}" for record in records))
    elif args.check:
        say(f"{len(records)} faults, each fits the sources")
    elif not records:
        sys.exit(f"mutate: no fault matches '{args.only}'")
    else:
        sys.exit(0 if report(records, run(records, args)) else 1)


if __name__ == "__main__":
    main()
