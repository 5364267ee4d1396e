#!/usr/bin/env python3
"""action_log.py reports planted faults of the page, and nothing in the page as it is.

usage: action_log_test.py REPOSITORY COMMAND
"""

import json
import pathlib
import sys
import unittest

import action_log

ROOT, COMMAND = pathlib.Path(sys.argv[1]), sys.argv[2]


class ActionLogTest(unittest.TestCase):
    def setUp(self):
        self.page = (ROOT / action_log.PAGE).read_text()
        self.schema = json.loads((ROOT / action_log.SCHEMA).read_text())

    def assert_reported(self, before, after, *beginnings):
        self.assertIn(before, self.page)
        found = action_log.check(self.page.replace(before, after), self.schema, COMMAND)
        self.assertEqual(len(found), len(beginnings), found)
        for line, beginning in zip(found, beginnings):
            self.assertTrue(line.startswith(f"{action_log.PAGE}: {beginning}"), line)

    def test_the_page_has_nothing(self):
        self.assertEqual(action_log.check(self.page, self.schema, COMMAND), [])

    def test_all_tables_are_read(self):
        tried = {what for what, *_ in action_log.tries(self.page)}
        self.assertTrue({"paper.relief", "brush grip", "model gamma", "touch twist", "slider load", "light lamp",
                         "gravity z", "camera fov"} <= tried, tried)

    def test_a_range_of_the_header(self):
        self.assert_reported("| 0..0.1 | 0.0003", "| 0..0.2 | 0.0003", "paper.relief is 0..0.2")

    def test_a_range_of_a_brush(self):
        self.assert_reported("| 1..2000 |", "| 2..2000 |", "brush bristles.count is 2..2000")

    def test_a_model_parameter_that_is_not(self):
        self.assert_reported("| `crowding` |", "| `crowd` |", "model crowd is 0..100000")

    def test_a_range_of_a_touch(self):
        self.assert_reported("-360..360", "0..360", "touch twist is 0..360")

    def test_a_range_in_an_event(self):
        self.assert_reported("1..179 degrees", "1..178 degrees", "camera fov is 1..178")

    def test_an_event_left_out(self):
        self.assert_reported("| `dry` |", "| dried |", "event dry requires None")

    def test_a_member_that_is_not_said_to_be_required(self):
        self.assert_reported("| `mark` | **`name`** |", "| `mark` | `name` |", "event mark requires set()")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
