#!/usr/bin/env python3
"""record.py: runs add up, also those that end at one time, and the page is what the record says.

usage: record_test.py
"""

import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import record

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs/reliability.md"


class Record(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.file = pathlib.Path(self.folder.name) / "record.json"

    def tearDown(self):
        self.folder.cleanup()

    def command(self, *words):
        return subprocess.run([sys.executable, HERE / "record.py", *words], capture_output=True, text=True)

    def test_runs_add_up(self):
        record.add(self.file, "log", 100, 10.4, 7, 0)
        record.add(self.file, "csv", 5, 3600, 1, 1)
        record.add(self.file, "log", 50, 2.1, 3, 0)
        self.assertEqual(json.loads(self.file.read_text()), {
            "csv": {"inputs": 5, "processor_s": 3600, "edges": 1, "finds": 1},
            "log": {"inputs": 150, "processor_s": 12, "edges": 7, "finds": 0}})

    def test_so_do_runs_that_end_at_one_time(self):
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            list(pool.map(lambda _: record.add(self.file, "log", 1, 1, 1, 0), range(200)))
        self.assertEqual(json.loads(self.file.read_text())["log"]["inputs"], 200)

    def test_the_page_is_written_between_its_comments(self):
        record.add(self.file, "log", 12345, 7200, 9, 0)
        page = pathlib.Path(self.folder.name) / "page.md"
        page.write_text("before\n" + record.BEGIN + "old\n" + record.END + "after\n")
        self.assertEqual(self.command(self.file, page, "--check").returncode, 1)
        self.assertEqual(self.command(self.file, page).returncode, 0)
        self.assertEqual(self.command(self.file, page, "--check").returncode, 0)
        text = page.read_text()
        self.assertIn("| `log` | 2.00 | 12 345 | 1.7 | 9 | 0 |\n\nTogether 2.0 hours", text)
        self.assertTrue(text.startswith("before\n") and text.endswith("after\n") and "old" not in text)

    def test_a_page_without_the_comments_is_an_error(self):
        record.add(self.file, "log", 1, 1, 1, 0)
        page = pathlib.Path(self.folder.name) / "page.md"
        page.write_text("nothing\n")
        done = self.command(self.file, page)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1))
        self.assertEqual(page.read_text(), "nothing\n")

    def test_the_documentation_says_what_the_record_says(self):
        done = self.command(HERE / "record.json", PAGE, "--check")
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
