"""A batch of small logs for the tests of the engines, of which one is broken."""

import json
import pathlib
import subprocess
import xml.etree.ElementTree

HEADER = {"type": "header", "format": "pentimento-log", "version": 1, "canvas": {"width": 0.4, "height": 0.3},
          "grid": {"width": 80, "height": 60}}
JOBS = 12
BROKEN = "job 7"


def write(folder):
    """Writes logs and manifest; returns the manifest."""
    folder = pathlib.Path(folder)
    lines = []
    for i in range(JOBS):
        touches = [{"t": round(0.1 * k, 3), "type": "touch", "phase": phase, "x": 0.05 + 0.02 * i, "y": 0.1 + 0.05 * k}
                   for k, phase in enumerate(("down", "move", "up"))]
        log = folder / f"log-{i}.jsonl"
        log.write_text("".join(json.dumps(line) + "\n" for line in [HEADER, *touches]))
        lines.append(json.dumps({"id": f"job {i}", "log": log.name}) + "\n")
    (folder / "log-7.jsonl").write_text("broken\n")
    manifest = folder / "m.jsonl"
    manifest.write_text("".join(lines))
    return manifest


def verdicts(junit):
    """{id: None, or the type of its failure} of a report."""
    found = {}
    for case in xml.etree.ElementTree.parse(junit).getroot().iter("testcase"):
        name = case.attrib["name"]
        assert name not in found, f"{name} is there twice"
        problems = list(case)
        found[name] = problems[0].attrib["type"] if problems else None
    return found


def expected():
    return {f"job {i}": "exit" if f"job {i}" == BROKEN else None for i in range(JOBS)}


def on_this_machine(command, manifest, folder):
    """The verdicts without an engine."""
    run = pathlib.Path(folder) / "alone"
    subprocess.run([command, "batch", manifest, "-o", run, "--no-pictures", "--quiet"], check=False)
    subprocess.run([command, "batch-report", run, "--junit", run / "r.xml"], check=False, stdout=subprocess.DEVNULL)
    return verdicts(run / "r.xml")
