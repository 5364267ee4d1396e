"""Runs the benchmarks and reads what they write: the nanoseconds of an item (a cell, mostly) by the name
of a benchmark, as `check.py` and `report.py` use them. Where a benchmark notes its least time (least_time.h), that is its time.

A *reference* names a time: `NAME`, the processor time of an item of that benchmark; `NAME#counter`, a
counter of it in nanoseconds; `NAME@wall`, the time on the clock of an item. NAME is without Google
Benchmark's own parts (`/iterations:8`, `/real_time`, `/process_time`).
"""

import json
import os
import pathlib
import re
import subprocess
import tempfile

OWN_PARTS = re.compile(r"/(?:iterations:\d+|repeats:\d+|real_time|process_time|manual_time|min_time:[\d.]+)")
SET_PROBE = "Probe/add_multiply"  # its label is the instruction set
NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


def plain_name(name):
    return OWN_PARTS.sub("", name)


def benchmark_of(reference):
    return re.split("[#@]", reference, maxsplit=1)[0]


def times_of(entry):
    """Every time that one entry of Google Benchmark's JSON gives: {reference: ns}. Times are of an item where
    items are counted, else of an iteration."""
    name, unit = plain_name(entry["name"]), NANOSECONDS[entry.get("time_unit", "ns")]
    cpu_ns, wall_ns = entry["cpu_time"] * unit, entry["real_time"] * unit
    items = 1.0
    if "items_per_second" in entry:
        # Google Benchmark divides by the clock's time where the benchmark asked for it, else by processor time.
        counted_ns = wall_ns if "/real_time" in entry["name"] else cpu_ns
        items = entry["items_per_second"] * counted_ns * 1e-9
    times = {name: cpu_ns / items, f"{name}@wall": wall_ns / items}
    if "ns_least" in entry:
        times[name] = entry["ns_least"]
    for counter, value in entry.items():
        if counter.startswith("ns_"):
            times[f"{name}#{counter}"] = value
    return times


def counters_of(entry):
    """What else an entry has, by `NAME#counter`: bytes a second, what the benchmark counts, its label."""
    name = plain_name(entry["name"])
    known = {"cpu_time", "real_time", "iterations", "repetitions", "repetition_index", "threads",
             "family_index", "per_family_instance_index", "items_per_second"}
    return {f"{name}#{counter}": value for counter, value in entry.items()
            if counter == "label" or isinstance(value, (int, float)) and counter not in known
            and not counter.startswith("ns_")}


def add_document(document, samples, counters):
    """Adds the times of one run's JSON to `samples` ({reference: [ns, ...]})."""
    for entry in document["benchmarks"]:
        if entry.get("run_type") == "aggregate" or entry.get("error_occurred"):
            continue
        for reference, ns in times_of(entry).items():
            samples.setdefault(reference, []).append(ns)
        counters.update(counters_of(entry))


def filter_of(names):
    return "^(" + "|".join(sorted(map(re.escape, names))) + ")(/(iterations|real_time|process_time).*)?$"


def run_once(program, names):
    """The JSON of one run of the benchmarks `names`, each once."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.json"
        run = subprocess.run([program, f"--benchmark_filter={filter_of(names)}", f"--benchmark_out={out}",
                              "--benchmark_out_format=json", "--benchmark_min_time=0.1"],
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        if run.returncode != 0 or not out.exists():
            raise SystemExit(f"{program}: {run.stderr.strip() or 'wrote nothing'}")
        return json.loads(out.read_text())


def processor(counters):
    """(model, instruction set of the kernels) of this machine, from a run with the probe."""
    model = re.search(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return (model[1] if model else "unknown"), counters.get(f"{SET_PROBE}#label", "unknown")


def load():
    """How many processes want a processor, in the mean over the last minute; how many processors there are."""
    return os.getloadavg()[0], os.cpu_count()
