#!/usr/bin/env python3
"""check.py on made-up measurements: what it lets pass and what it fails, and how it reads Google
Benchmark's JSON. page.py and report.py are held to what is in docs/bench by `report.py check`.

usage: check_test.py
"""

import json
import pathlib
import re
import unittest

import check
import page
import report
import results

PHASES = {"move": ("Fast", "Plain"), "rows": ("Step/1#ns_rows", "Probe")}


def entry(name, cpu_ms, **more):
    return {"name": name, "run_type": "iteration", "cpu_time": cpu_ms, "real_time": 2 * cpu_ms, "time_unit": "ms",
            **more}


def samples_of(*runs):
    samples = {}
    for run in runs:
        results.add_document({"benchmarks": run}, samples, {})
    return samples


def problems(samples, stored):
    return check.problems_of(PHASES, check.ratios_of(PHASES, samples), stored)


def run(move=1.0, rows=1.0, **left_out):
    """One round: `move` and `rows` times as slow as stored."""
    entries = [entry("Fast/iterations:8", 2 * move), entry("Plain/real_time", 4),
               entry("Step/1/iterations:8/real_time", 9, ns_rows=3 * rows), entry("Probe", 1e-6)]
    return [e for e in entries if results.plain_name(e["name"]) not in left_out.values()]


STORED = {"move": 0.5, "rows": 3.0}


class Check(unittest.TestCase):
    def test_what_is_as_stored_passes(self):
        self.assertEqual(problems(samples_of(run()), STORED), [])

    def test_sixteen_percent_slower_fails_and_fourteen_pass(self):
        self.assertEqual(problems(samples_of(run(move=1.14, rows=1.14)), STORED), [])
        lines = problems(samples_of(run(move=1.14, rows=1.16)), STORED)
        self.assertEqual(len(lines), 1)
        self.assertIn("rows: 16 % behind", lines[0])

    def test_faster_passes(self):
        self.assertEqual(problems(samples_of(run(move=0.3)), STORED), [])

    def test_the_least_of_several_rounds_counts(self):
        self.assertEqual(problems(samples_of(run(move=3), run(move=1), run(rows=2)), STORED), [])

    def test_a_phase_that_was_not_measured_fails(self):
        for name in ("Fast", "Plain"):
            lines = problems(samples_of(run(without=name)), STORED)
            self.assertEqual(len(lines), 1)
            self.assertIn("move: was not measured", lines[0])

    def test_a_phase_without_a_ratio_fails_and_so_does_a_ratio_without_its_phase(self):
        lines = problems(samples_of(run()), {"move": 0.5, "gone": 1})
        self.assertEqual([line.split(":")[0] for line in lines], ["gone", "rows"])

    def test_all_that_is_slow_is_named(self):
        self.assertEqual(len(problems(samples_of(run(move=2, rows=2)), STORED)), 2)


class Reading(unittest.TestCase):
    def test_times_are_of_an_item(self):
        # 4 ms of processor time and 8 ms of the clock for 1000 items.
        times = results.times_of(entry("Walk/4", 4, items_per_second=1000 / 4e-3))
        self.assertAlmostEqual(times["Walk/4"], 4000)
        self.assertAlmostEqual(times["Walk/4@wall"], 8000)
        # The same, counted by the clock.
        times = results.times_of(entry("Walk/4/real_time", 4, items_per_second=1000 / 8e-3))
        self.assertAlmostEqual(times["Walk/4"], 4000)
        self.assertAlmostEqual(times["Walk/4@wall"], 8000)

    def test_a_failed_benchmark_and_a_mean_are_not_read(self):
        samples = samples_of([entry("A", 1, error_occurred=True), {**entry("B", 1), "run_type": "aggregate"}])
        self.assertEqual(samples, {})

    def test_the_filter_finds_a_name_and_not_its_extension(self):
        pattern = re.compile(results.filter_of(["Step/1", "Probe/read/L2"]))
        for name in ("Step/1", "Step/1/iterations:8/real_time", "Probe/read/L2/iterations:3"):
            self.assertTrue(pattern.search(name), name)
        for name in ("Step/12", "Step/1/2", "MyStep/1"):
            self.assertFalse(pattern.search(name), name)


def made_up_page(phases, factor=None):
    """The page where every phase takes 2 ns, every probe 0.5, and `before` is `factor` times as slow."""
    times = {reference: {"best": 0.5 if reference.startswith("Probe") else 2.0, "median": 2.0}
             for p in phases for reference in (p["time"], p.get("against")) if reference}
    times.update({probe: {"best": 0.5, "median": 0.5} for probe in page.PROBES})
    document = {"machine": {"processor": "one", "instruction_set": "sse2", "processors": 2, "system": "Linux",
                            "load_before": 0, "load_after": 1}, "rounds": 1, "counters": {}, "now": times}
    if factor:
        document["before"] = {name: {"best": factor * t["best"], "median": 0} for name, t in times.items()}
    return page.text(phases, document)


class Page(unittest.TestCase):
    PHASES = [{"phase": "conservative/faces", "time": "Step/1#ns_faces", "against": "Probe/update/DRAM",
               "work": {"read": 5, "written": 3, "near": 10, "operations": 100, "divisions": 4, "counted": "so"}}]

    def test_says_speed_and_share_of_the_probe(self):
        # 8 planes of 4 bytes in 2 ns are 16 GB/s; the triad moves 12 bytes in 0.5 ns.
        self.assertIn("| `faces` | 2 | 16 | 67 % | 4 |", made_up_page(self.PHASES))

    def test_says_what_was_before(self):
        self.assertIn("| `faces` | 2 | 6 | 3 x | 16 |", made_up_page(self.PHASES, 3))

    def test_says_what_bounds_a_pass(self):
        # Memory: 32 bytes at 24 GB/s; arithmetic: 104 operations of half a nanosecond.
        self.assertIn("| 1.33 | 1.67 | 52 | arithmetic |", made_up_page(self.PHASES))
        lazy = json.loads(json.dumps(self.PHASES))
        lazy[0]["work"].update(operations=1, divisions=0, near=1, read=1, written=1)
        self.assertIn("| none of them (arithmetic alone: 25 %) |", made_up_page(lazy))

    def test_says_whether_the_machine_was_quiet(self):
        self.assertIn("the machine was quiet", made_up_page(self.PHASES))


class Registry(unittest.TestCase):
    def setUp(self):
        self.phases = json.loads(report.PHASES.read_text())["phases"]

    def test_every_phase_has_a_name_of_its_own_and_its_group(self):
        names = [p["phase"] for p in self.phases]
        self.assertEqual(len(names), len(set(names)))
        self.assertLessEqual({name.split("/")[0] for name in names}, {group[0] for group in page.GROUPS})

    def test_every_benchmark_is_in_the_sources(self):
        text = "".join(file.read_text() for file in pathlib.Path(report.HERE).glob("*_bench.cpp"))
        for name in report.names_of({"phases": self.phases}):
            if not name.startswith("Probe/"):
                self.assertRegex(text, r"BENCHMARK(_CAPTURE)?\(" + re.escape(name.split("/")[0]))
            else:
                self.assertIn(f'Name("{name}")', text)

    def test_every_phase_has_a_stored_ratio(self):
        stored = json.loads((report.HERE / "ratios.json").read_text())
        for instruction_set in stored.values():
            self.assertEqual(set(check.phases_of({"phases": self.phases})), set(instruction_set["ratios"]))


if __name__ == "__main__":
    unittest.main()
