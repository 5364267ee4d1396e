#!/usr/bin/env python3
"""A hundred logs, of which five go wrong, each in its own way; in one run, and in three shards of which one is killed. Then
how small a change `batch` sees with its usual tolerances, and whether it ever sees one where there is none.

  hundred.py COMMAND [--short | --pictures]

One log crashes its renderer, one hangs (the process is stopped, so that only SIGKILL ends it), one is corrupt, one is missing,
and one has a slider that is 1 % off. Everything else must be done, and reported once. --short takes fewer logs. With --pictures
each of the hundred is shaded too, which takes some minutes. Ends with 1 at the first thing that is not as it should be.
"""

import argparse
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree
import zlib

LOGS, FEW_LOGS = 100, 24
WRONG = {"log 3": "crash", "log 7": "timeout", "log 12": "exit", "log 17": "exit", "log 22": "state"}
CRASHES, HANGS, CORRUPT, MISSING, CHANGED = WRONG
REPEATS = 20
SHARDS = 3
SLIDERS = {"medium": 0.5, "pigment": 0.6, "size": 0.05, "pickup": 0.5, "refill": 0.4, "stiffness": 0.5, "layer_mixing": 0.5,
           "spacing": 0.1, "load": 0.8}
HEADER = {"type": "header", "format": "pentimento-log", "version": 1, "canvas": {"width": 0.4, "height": 0.3},
          "grid": {"width": 80, "height": 60}, "palette": [{"name": "French Ultramarine"}, {"name": "Titanium White"}]}

# Stands for the command: what a broken renderer does to its process, it does to its own. A name of a log says so.
RENDERER = """#!/bin/sh
case $2 in
  *crashes*) kill -SEGV $$;;
  *hangs*) kill -STOP $$;;
  *"one pixel, changed"*) exec "{python}" "{script}" --one-pixel "{command}" "$@";;
esac
exec "{command}" "$@"
"""


def log(number, strokes=3, **sliders):
    """Strokes that cross each other while they are wet."""
    lines, t = [HEADER], 0.0
    for name, value in {**SLIDERS, **sliders}.items():
        lines.append({"t": 0, "type": "slider", "name": name, "value": value})
    for stroke in range(strokes):
        lines.append({"t": t, "type": "color", "pigment": HEADER["palette"][stroke % 2]["name"]})
        for k in range(4):
            along, across = 0.08 + 0.07 * k, 0.06 + 0.0015 * number + 0.03 * stroke
            x, y = (along, across) if stroke % 2 == 0 else (across + 0.08, along - 0.03)
            lines.append({"t": round(t, 3), "type": "touch", "phase": ("down", "move", "move", "up")[k], "x": round(x, 4),
                          "y": round(y, 4), "pressure": 0.7})
            t += 0.06
    return "".join(json.dumps(line) + "\n" for line in lines)


def png_pixels(data):
    """(chunks before the pixels, rows of bytes, bytes a pixel, chunks after) of a PNG of 8 bits without interlace."""
    at, before, packed, after = 8, [], b"", []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IDAT":
            packed += body
        else:
            (after if packed else before).append((kind, body))
        at += 12 + length
    width, height, depth, colour = struct.unpack(">IIBB", before[0][1][:10])
    assert depth == 8 and colour == 2, "not an RGB of 8 bits"
    raw, rows, above = zlib.decompress(packed), [], bytearray(3 * width)
    for y in range(height):
        kind, row = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
        for i in range(3 * width):
            a, b, c = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
        rows.append(row)
        above = row
    return before, rows, 3, after


def change_one_pixel(file):
    """Another code in one channel of one pixel: two codes off, as one is allowed."""
    before, rows, size, after = png_pixels(file.read_bytes())
    middle = rows[len(rows) // 2]
    at = len(middle) // 2 // size * size
    middle[at] += 2 if middle[at] < 250 else -2
    packed = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    chunks = [*before, (b"IDAT", packed), *after]
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in chunks))


def render_with_one_pixel_off(command, words):
    code = subprocess.run([command, *words]).returncode
    change_one_pixel(pathlib.Path(words[words.index("-o") + 1]))
    sys.exit(code)


class Place:
    """A folder with logs, a manifest for each batch, and the command."""

    def __init__(self, command, folder):
        self.command, self.folder = command, folder
        self.program = folder / "renderer"
        self.program.write_text(RENDERER.format(command=command, python=sys.executable, script=pathlib.Path(__file__).resolve()))
        self.program.chmod(0o755)

    def manifest(self, name, logs, **more):
        """`logs`: {id: text, or None for a log that is missing}. The logs' names are `name` and the ids."""
        lines = []
        for job, text in logs.items():
            file = f"{name} {job}.jsonl"
            if text is not None:
                (self.folder / file).write_text(text)
            lines.append(json.dumps({"id": job, "log": file, **more.get(job, {})}) + "\n")
        path = self.folder / f"{name}.manifest.jsonl"
        path.write_text("".join(lines))
        return path

    def words(self, manifest, run, *more):
        return [self.command, "batch", manifest, "-o", self.folder / run, "-j", "2", "--program", self.program, "--json",
                "--quiet", "--golden", self.folder / "golden", *more]

    def batch(self, manifest, run, *more):
        done = subprocess.run(self.words(manifest, run, *more), capture_output=True, text=True)
        assert done.returncode in (0, 1), (run, done.returncode, done.stdout[-2000:], done.stderr[-2000:])
        summary = json.loads(done.stdout)
        assert done.returncode == (1 if summary["failed"] else 0), (run, done.returncode)
        return summary

    def report(self, *runs, code):
        """{id: kind of the row} of the merged report; the JUnit file has the same."""
        junit = self.folder / "junit.xml"
        done = subprocess.run([self.command, "batch-report", *(self.folder / run for run in runs), "--json", "--junit", junit],
                              capture_output=True, text=True)
        assert done.returncode == code, (done.returncode, done.stderr)
        rows = json.loads(done.stdout)["rows"]
        kinds = {row["id"]: row["kind"] for row in rows}
        assert len(kinds) == len(rows), "an id is there twice"
        cases = [(case.attrib["name"], case[0].attrib["type"] if len(case) else "passed")
                 for case in xml.etree.ElementTree.parse(junit).getroot().iter("testcase")]
        assert sorted(cases) == sorted(kinds.items()), "JUnit's report is another"
        return kinds


def logs_and_wrong_ones(count):
    """({id: log}, the same of which five go wrong)."""
    good = {f"log {i}": log(i) for i in range(count)}
    bad = dict(good)
    bad[CORRUPT] = good[CORRUPT][:300] + "}{" + good[CORRUPT][300:]
    bad[MISSING] = None
    bad[CHANGED] = log(int(CHANGED.split()[1]), medium=SLIDERS["medium"] * 1.01)
    return good, bad


def write_wrong_logs(place, bad, **hang):
    names = {CRASHES: f"{CRASHES}, crashes", HANGS: f"{HANGS}, hangs"}
    manifest = place.manifest("bad", bad)
    lines = []
    for line in manifest.read_text().splitlines():
        job = json.loads(line)
        if job["id"] in names:
            other = f"bad {names[job['id']]}.jsonl"
            (place.folder / job["log"]).rename(place.folder / other)
            job["log"] = other
        if job["id"] == HANGS:
            job.update(hang)
        lines.append(json.dumps(job) + "\n")
    manifest.write_text("".join(lines))
    return manifest


def shards_of_which_one_is_killed(place, manifest, options, expected):
    killed = 2
    for shard in range(1, SHARDS + 1):
        if shard != killed:
            place.batch(manifest, f"shard {shard}", f"--shard={shard}/{SHARDS}", *options)
    rows = place.folder / f"shard {killed}" / "rows"
    words = place.words(manifest, f"shard {killed}", f"--shard={killed}/{SHARDS}", *options)
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 60
    while not rows.exists() or len(list(rows.glob("*.json"))) < 3:
        assert time.monotonic() < end and process.poll() is None, "the shard was never caught in the middle"
        time.sleep(0.005)
    process.kill()
    process.wait()
    done_before = len(list(rows.glob("*.json")))
    runs = [f"shard {shard}" for shard in range(1, SHARDS + 1)]
    halfway = place.report(*runs, code=1)
    lost = sum(kind == "not run" for kind in halfway.values())
    assert halfway.keys() == expected.keys() and lost > 0, "the report does not tell what did not run"
    again = place.batch(manifest, f"shard {killed}", f"--shard={killed}/{SHARDS}", *options)
    jobs = again["jobs"]
    tried_again = sum(kind in ("crash", "timeout") for kind in (halfway[row["id"]] for row in again["rows"]))
    tried_again += MISSING in {row["id"] for row in again["rows"]} and halfway[MISSING] == "exit"
    assert again["rendered"] <= jobs - done_before + tried_again, (again["rendered"], jobs, done_before, tried_again)
    assert place.report(*runs, code=1) == expected
    print(f"{SHARDS} shards, one killed after {done_before} of {jobs} jobs ({lost} not run) and run again, which rendered "
          f"{again['rendered']}: the same report", flush=True)


def a_hundred(place, count, options):
    good, bad = logs_and_wrong_ones(count)
    began = place.batch(place.manifest("good", good), "good", "--update-golden", "begun", *options)
    assert len(began["golden_taken"]) == count
    manifest = write_wrong_logs(place, bad, timeout_s=1)
    summary = place.batch(manifest, "whole", *options)
    assert summary["failed"] == len(WRONG), summary["failed"]
    expected = {job: WRONG.get(job, "passed") for job in good}
    assert {row["id"]: row["kind"] for row in summary["rows"]} == expected
    assert place.report("whole", code=1) == expected
    print(f"{count} logs, {len(WRONG)} wrong: reported as such, all else done, exit code 1", flush=True)
    shards_of_which_one_is_killed(place, manifest, options, expected)


def small_changes(place, sliders):
    """With pictures, and the usual tolerances: everything but the one pixel is seen in the state."""
    good = {**{f"slider {name}": log(7) for name in sliders}, "one stroke": log(7), "no change": log(7), "one pixel": log(8)}
    place.batch(place.manifest("before", good), "before", "--update-golden", "begun")
    changed = {**good, **{f"slider {name}": log(7, **{name: SLIDERS[name] * 1.01}) for name in sliders},
               "one stroke": log(7, strokes=2)}
    manifest = place.manifest("after", changed)
    manifest.write_text(manifest.read_text().replace("after one pixel", "after one pixel, changed"))
    (place.folder / "after one pixel.jsonl").rename(place.folder / "after one pixel, changed.jsonl")
    rows = {row["id"]: row["kind"] for row in place.batch(manifest, "after")["rows"]}
    expected = {job: "state" for job in good} | {"one pixel": "picture", "no change": "passed"}
    assert rows == expected, rows
    print(f"seen: 1 % of each of {len(sliders)} sliders, one stroke, one pixel", flush=True)


def no_false_alarm(place, count, options):
    """On 1 to 4 threads in turn."""
    logs = {f"log {i}": log(i) for i in range(count)}
    place.batch(place.manifest("repeat", logs), "repeat", "--update-golden", "begun", *options)
    for i in range(REPEATS):
        threads = {job: {"options": ["--threads", str(1 + i % 4)]} for job in logs}
        summary = place.batch(place.manifest("repeat", logs, **threads), f"repeat {i}", *options)
        assert summary["rendered"] == count and summary["failed"] == 0, summary
    print(f"{REPEATS} repeats of {count} logs: no false alarm", flush=True)


def main():
    if sys.argv[1:2] == ["--one-pixel"]:
        render_with_one_pixel_off(sys.argv[2], sys.argv[3:])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--pictures", action="store_true")
    arguments = parser.parse_args()
    states = ["--no-pictures"]
    with tempfile.TemporaryDirectory() as name:
        place = Place(arguments.command.resolve(), pathlib.Path(name))
        for show, *how in ((a_hundred, FEW_LOGS if arguments.short else LOGS, [] if arguments.pictures else states),
                           (small_changes, ["medium"] if arguments.short else SLIDERS),
                           (no_false_alarm, *((1, states) if arguments.short else (10, [])))):
            began = time.monotonic()
            show(place, *how)
            print(f"  {time.monotonic() - began:.1f} s", flush=True)


if __name__ == "__main__":
    main()
