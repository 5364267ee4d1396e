#!/usr/bin/env python3
"""Every sample can be made again, is a valid log, and says where it comes from.

usage: samples_test.py SAMPLES_FOLDER SCHEMA COMMAND
"""

import gzip
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

SAMPLES, SCHEMA, COMMAND = (pathlib.Path(argument) for argument in sys.argv[1:4])
LARGEST_FILE = 2_000_000  # bytes: the repository stays small
LARGEST_PICTURE = 400_000
EVERY_TOUCH = 25  # of the touches, how many go through the (slow) schema; the command reads all


def logs():
    found = sorted([*SAMPLES.glob("*/*.jsonl"), *SAMPLES.glob("*/*.jsonl.gz")])
    assert len(found) >= 6, found
    return found


def content(path):
    data = path.read_bytes()
    return gzip.decompress(data) if path.suffix == ".gz" else data


class SamplesTest(unittest.TestCase):
    def test_make_py_writes_the_log_byte_for_byte(self):
        for log in logs():
            with self.subTest(log.name), tempfile.TemporaryDirectory() as folder:
                again = pathlib.Path(folder) / log.name
                subprocess.run([sys.executable, log.parent / "make.py", again], check=True)
                # Uncompressed: other releases of zlib may pack the same bytes differently.
                self.assertEqual(content(log), content(again))

    def test_schema_accepts_every_sample(self):
        schema = json.loads(SCHEMA.read_text())
        validator = jsonschema.validators.validator_for(schema)(schema)
        for log in logs():
            touches = 0
            for number, line in enumerate(content(log).decode().splitlines(), 1):
                entry = json.loads(line)
                touches += entry["type"] == "touch"
                if entry["type"] == "touch" and touches % EVERY_TOUCH:
                    continue
                errors = [error.message for error in validator.iter_errors(entry)]
                self.assertEqual(errors, [], f"{log.name}:{number}")

    def test_command_validates_every_sample(self):
        run = subprocess.run([COMMAND, "validate", *logs()], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_chart_replays_to_its_picture(self):
        golden = SAMPLES / "tips/tips.png"
        with tempfile.TemporaryDirectory() as folder:
            again = pathlib.Path(folder) / "tips.png"
            subprocess.run([COMMAND, "render", SAMPLES / "tips/tips.jsonl", "--width", "608",
                            "-o", again, "--quiet"], check=True)
            # Two levels of 8 bits: one for another machine's shader compiler, one for rounding.
            run = subprocess.run([COMMAND, "compare", golden, again, "--max", "0.0079"],
                                 capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_each_sample_has_its_picture_and_its_page(self):
        for log in logs():
            with self.subTest(log.name):
                name = log.name.split(".")[0]
                self.assertTrue((log.parent / "README.md").is_file())
                self.assertTrue((log.parent / f"{name}.png").is_file())

    def test_files_stay_small(self):
        for file in SAMPLES.rglob("*"):
            if file.is_file():
                self.assertLess(file.stat().st_size, LARGEST_FILE, file)
        for picture in SAMPLES.parent.glob("samples/*/*.png"):
            self.assertLess(picture.stat().st_size, LARGEST_PICTURE, picture)
        for picture in SAMPLES.parent.glob("docs/pictures/*"):
            self.assertLess(picture.stat().st_size, LARGEST_PICTURE, picture)

    def test_recordings_of_others_name_their_licence(self):
        for folder in (SAMPLES / "data").iterdir():
            if folder.is_dir():
                self.assertIn("Licence", (folder / "SOURCE.txt").read_text())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
