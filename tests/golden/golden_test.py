#!/usr/bin/env python3
"""Frozen results that are missing, left over or changed by hand fail (golden.py)."""

import pathlib
import tempfile
import unittest

import golden

COMPARE = """#!/bin/sh
cmp -s "$2" "$3" || { echo differs; exit 1; }
"""


class Frozen(unittest.TestCase):
    """A folder of frozen pictures, and a program that paints `right` for every case."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "pictures").mkdir()
        (self.folder / "new").mkdir()
        program = self.folder / "pentimento"
        program.write_text(COMPARE)
        program.chmod(0o755)
        self.addCleanup(setattr, golden, "HERE", golden.HERE)
        self.addCleanup(setattr, golden, "render", golden.render)
        golden.HERE = self.folder
        golden.render = lambda root, build, case, file: file.write_text("right")
        self.cases = {"pictures": [{"name": "a"}, {"name": "b"}]}
        for name in "ab":
            self.picture(name).write_text("right")

    def picture(self, name):
        return self.folder / "pictures" / f"{name}.png"

    def changed(self):
        return golden.changed_pictures(self.folder, self.folder, self.cases, self.folder / "new")

    def test_what_is_as_it_was_frozen_passes(self):
        self.assertEqual(self.changed(), [])
        self.assertEqual(golden.pictures_without_case(self.cases), [])
        self.assertEqual(golden.changed_states({"x": "1"}, {"x": "1"}), [])

    def test_a_picture_that_is_missing_is_told(self):
        self.picture("a").unlink()
        self.assertEqual(self.changed(), ["a.png: not frozen yet"])

    def test_a_picture_that_was_changed_is_told(self):
        self.picture("b").write_text("wrong")
        self.assertEqual(self.changed(), ["b.png: differs"])

    def test_a_picture_that_is_left_over_is_told(self):
        self.picture("c").write_text("right")
        self.assertEqual(golden.pictures_without_case(self.cases), [self.picture("c")])

    def test_states_that_are_missing_left_over_or_changed_are_told(self):
        lines = golden.changed_states({"x": "1", "y": "2"}, {"x": "3", "z": "4"})
        self.assertEqual(lines, ["x: 1 is now 3", "y: no longer a case", "z: not frozen yet"])


if __name__ == "__main__":
    unittest.main()
