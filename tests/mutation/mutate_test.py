#!/usr/bin/env python3
"""The runner of the mutations: which records it refuses, and in which order it asks the tests."""

import pathlib
import tempfile
import unittest

import mutate
import records

RECORD = {"id": "a", "file": "core/drop.cpp", "find": "a + b", "replace": "a - b", "breaks": "drops shrink"}


def a_test(name, file, program="core_tests", seconds=0.1):
    return mutate.Test(f"/build/{program}" if program else "", name, file, seconds, [])


class RecordsTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)
        (self.root / "core").mkdir()
        self.write("return a + b;\n")

    def write(self, text):
        (self.root / "core/drop.cpp").write_text(text)

    def problem(self, *faults):
        found = records.problems(faults, self.root)
        self.assertEqual(len(found), 1, found)
        return found[0]

    def test_a_record_that_fits_is_taken(self):
        self.assertEqual(records.problems([RECORD], self.root), [])

    def test_a_stale_record_is_told_by_its_id(self):
        self.write("return sum(a, b);\n")
        self.assertRegex(self.problem(RECORD), "^a: .*0 times")

    def test_a_record_that_fits_twice_is_told(self):
        self.write("return a + b;\nreturn a + b;\n")
        self.assertRegex(self.problem(RECORD), "^a: .*2 times")

    def test_a_file_that_is_gone_is_told(self):
        self.assertRegex(self.problem({**RECORD, "file": "core/gone.cpp"}), "^a: there is no core/gone.cpp")

    def test_an_id_is_used_once(self):
        self.assertRegex(self.problem(RECORD, RECORD), "^a: 2 records")

    def test_a_record_says_what_breaks(self):
        self.assertRegex(self.problem({key: RECORD[key] for key in RECORD if key != "breaks"}), "^a: lacks breaks")

    def test_a_fault_that_changes_nothing_is_told(self):
        self.assertRegex(self.problem({**RECORD, "replace": "a + b"}), "^a: changes nothing")


class OrderTest(unittest.TestCase):
    def test_the_nearest_test_is_asked_first(self):
        tests = [a_test("samples", "", ""), a_test("Log.Reads", "tests/formats/log/reader_test.cpp", "formats_tests"),
                 a_test("Field.Slow", "tests/core/base/field_test.cpp", seconds=9), a_test("golden", "", ""),
                 a_test("Field.Quick", "tests/core/base/field_test.cpp"),
                 a_test("Reservoir.Empties", "tests/core/brush/reservoir_test.cpp"),
                 a_test("Tip.Prints", "tests/core/brush/tip_test.cpp")]
        asked = [[test.name for test in group] for group in mutate.rounds(tests, "core/brush/tip.cpp")]
        self.assertEqual(asked, [["Tip.Prints"], ["Reservoir.Empties"], ["golden"], ["Field.Quick"], ["Field.Slow"],
                                 ["Log.Reads"], ["samples"]])

    def test_outside_core_the_frozen_results_are_asked_last(self):
        tests = [a_test("golden", "", ""), a_test("samples", "", "")]
        asked = [group[0].name for group in mutate.rounds(tests, "cli/command.cpp")]
        self.assertEqual(asked, ["samples", "golden"])

    def test_tests_of_the_folders_below_are_not_asked(self):
        tests = [a_test(f"{folder}.Does", "", f"{folder}_tests") for folder in ("core", "formats", "replay", "cli")]
        asked = {group[0].name for group in mutate.rounds(tests, "replay/play/hand.cpp")}
        self.assertEqual(asked, {"replay.Does", "cli.Does"})

    def test_what_caught_the_fault_last_time_is_asked_before_all(self):
        tests = [a_test("Tip.Prints", "tests/core/brush/tip_test.cpp"), a_test("samples", "", "")]
        self.assertEqual(mutate.rounds(tests, "core/brush/tip.cpp", "samples")[0][0].name, "samples")


class VerdictTest(unittest.TestCase):
    def good(self, caught, survived, **more):
        faults = [{**RECORD, "id": str(number), **more} for number in range(caught + survived)]
        found = {record["id"]: {"verdict": "caught" if int(record["id"]) < caught else "survived", "by": ""}
                 for record in faults}
        return mutate.report(faults, found)

    def test_a_survivor_needs_a_reason(self):
        self.assertTrue(self.good(10, 0))
        self.assertFalse(self.good(9, 1))
        self.assertTrue(self.good(9, 1, survives="a picture a thousandth darker"))

    def test_reasons_do_not_replace_tests(self):
        self.assertFalse(self.good(8, 2, survives="hard to test"))

    def test_a_survivor_is_asked_again_after_the_tests_changed(self):
        old = {"record": records.planted(RECORD), "verdict": "survived", "by": ""}
        self.assertTrue(mutate.settled(old, RECORD, same_tree=True))
        self.assertFalse(mutate.settled(old, RECORD, same_tree=False))
        self.assertTrue(mutate.settled({**old, "verdict": "caught"}, RECORD, same_tree=False))
        self.assertFalse(mutate.settled({**old, "verdict": "caught"}, {**RECORD, "replace": "b"}, same_tree=False))


if __name__ == "__main__":
    unittest.main()
