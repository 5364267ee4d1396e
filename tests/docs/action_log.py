#!/usr/bin/env python3
"""Tables of docs/action-log.md that tell another range or another event than the command knows.

Every range of a member (`0..1`) is tried: a log with a greater value must be refused with that range in
the message. The types of events and their required members are those of the JSON Schema, which the
samples are checked against. Names, defaults and reasons of model parameters and sliders are compared by
tests/formats/log/docs_test.cpp.

usage: action_log.py REPOSITORY COMMAND
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = "docs/action-log.md"
SCHEMA = "docs/action-log.schema.json"
HEADER = {"type": "header", "format": "pentimento-log", "version": 1, "canvas": {"width": 1, "height": 0.75}}
# What an event needs beside the member that is tried.
EVENTS = {"touch": {"phase": "down", "x": 0, "y": 0}, "gravity": {"x": 0, "y": 0, "z": 9.81}, "light": {},
          "camera": {"file": "none.png"}}
NUMBER = r"-?\d[\d.]*(?:e-?\d+)?"
RANGE = re.compile(rf"({NUMBER}?)\.\.({NUMBER})")
MEMBER = re.compile(r"`([\w.]+)`")
# `start` 0..1e6 s (0): members of an event and their ranges in one cell.
MEMBERS = re.compile(rf"((?:\*{{0,2}}`\w+`\*{{0,2}}(?:, )?)+):? ({NUMBER})\.\.({NUMBER})")
OUTSIDE = re.compile(rf"outside ({NUMBER})\.\.({NUMBER})")


def rows(text, heading):
    """The cells of each row of the tables under a heading, up to the next heading."""
    body = re.split(r"^#+ ", text.partition(f"\n{heading}\n")[2], maxsplit=1, flags=re.MULTILINE)[0]
    lines = [line for line in body.split("\n") if line.startswith("| `")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def ranged(text, heading, column):
    """(member, least, greatest) of each row whose cell is one range."""
    for cells in rows(text, heading):
        match = RANGE.match(cells[column])
        if match and "," not in cells[column]:
            for member in MEMBER.findall(cells[0]):
                yield member, float(match[1]), float(match[2])


def nested(path, value):
    for name in reversed(path.split(".")):
        value = {name: value}
    return value


def tries(text):
    """(what, least, greatest, log) of each range: the log has a value beyond the greatest."""
    def log(header, *events):
        return "".join(json.dumps(line) + "\n" for line in ({**HEADER, **header}, *events))

    for member, low, high in ranged(text, "## Header", 2):
        top, _, inner = member.partition(".")
        value = nested(inner, high + 1) if inner else high + 1
        if top == "canvas":
            value = {**HEADER["canvas"], **value}
        if top == "grid":
            value = {"width": 4, "height": 3, **value}
        yield member, low, high, log({top: value})
    for member, low, high in ranged(text, "### Brushes", 2):
        yield f"brush {member}", low, high, log({"brushes": [{"name": "b", "shape": "bristle",
                                                              **nested(member, high + 1)}]})
    for member, low, high in ranged(text, "### Model parameters", 2):
        yield f"model {member}", low, high, log({"model": {member: high + 1}})
    for member, low, high in ranged(text, "### `touch`", 2):
        yield f"touch {member}", low, high, log({}, {"t": 0, "type": "touch", **EVENTS["touch"], member: high + 1})
    for member, low, high in ranged(text, "### Other events", 2):
        yield f"slider {member}", low, high, log({}, {"t": 0, "type": "slider", "name": member, "value": high + 1})
    for cells in rows(text, "### Other events"):
        for members, low, high in MEMBERS.findall(cells[1]):
            event = MEMBER.match(cells[0])[1]
            for member in MEMBER.findall(members):
                yield f"{event} {member}", float(low), float(high), log({}, {
                    "t": 0, "type": event, **EVENTS[event], member: float(high) + 1})


def refusals(logs, command):
    """What the command says of each log; None where it is valid."""
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder) / f"{i}.jsonl" for i in range(len(logs))]
        for file, text in zip(files, logs):
            file.write_text(text)
        told = subprocess.run([command, "validate", "--json", *files], capture_output=True, text=True, check=False)
        return [verdict.get("error") for verdict in json.loads(told.stdout)]


def check_ranges(text, command):
    tried = list(tries(text))
    for (what, low, high, _), error in zip(tried, refusals([log for *_, log in tried], command)):
        match = OUTSIDE.search(error or "")
        if not match or (float(match[1]), float(match[2])) != (low, high):
            yield f"{PAGE}: {what} is {low:g}..{high:g}, the command says: {error}"


def told_events(text):
    """{type: its required members} in the page."""
    touch = text.partition("\n### `touch`\n")[2]
    events = {"touch": set(MEMBER.findall(re.search(r"(`.*) are required\.", touch)[1]))}
    for cells in rows(text, "### Other events"):
        if len(cells) == 3:
            for name in MEMBER.findall(cells[0]):
                events[name] = set(re.findall(r"\*\*`(\w+)`\*\*", cells[1]))
    return events


def schema_events(schema):
    """{type: its required members} in the schema."""
    return {name.removesuffix("_event"): set(event["required"]) - {"t", "type"}
            for name, event in schema["$defs"].items() if name.endswith("_event") and "required" in event}


def check_events(text, schema):
    told, known = told_events(text), schema_events(schema)
    for name in sorted(told.keys() | known.keys()):
        if told.get(name) != known.get(name):
            yield f"{PAGE}: event {name} requires {told.get(name)}, the schema says {known.get(name)}"


def check(text, schema, command):
    return [*check_ranges(text, command), *check_events(text, schema)]


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    found = check((root / PAGE).read_text(), json.loads((root / SCHEMA).read_text()), sys.argv[2])
    for problem in found:
        print(problem)
    sys.exit(1 if found else 0)
