#!/usr/bin/env python3
"""Sources without the test of their name: core/x/y.cpp (or y.h, where that is all) is tested by
tests/core/x/y_test.cpp, or has a line in tests/house/tested_elsewhere.txt with the reason.

A reason is either `no behaviour` (a header alone, with no branch, loop or sum) or the test that it is
tested by. That test must reach the source: include it, or a header of ours that leads to it. A test
that runs the command reaches all.

usage: tested.py REPOSITORY
"""

import pathlib
import re

import house

LIST = "tests/house/tested_elsewhere.txt"
NO_BEHAVIOUR = "no behaviour"
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
BEHAVIOUR = re.compile(r"\b(?:if|for|while|switch)\b|\?|\breturn [^;]*\w\)* (?:[-+*/%^|]|<<|>>) ")
RUNS_THE_COMMAND = re.compile(r"tests/cli/.*|.*\.py|tests/.*\.sh")


def implemented(source, included):
    """The headers that a source may implement."""
    own = source[:-4] + ".h"
    if own in included:
        return [own]
    return [header for header in included if source.startswith(header.rsplit("/", 1)[0] + "/")]


def include_graph(root):
    """What leads where: a file to what it includes, and a header to the sources that may implement it:
    that of its name, or any in its folder or in one below that has no header of its own name."""
    leads = {}
    for file in house.cpp_sources(root, (*house.SOURCES, "tests")):
        name = house.relative(root, file)
        included = INCLUDE.findall(file.read_text())
        leads.setdefault(name, set()).update(included)
        if file.suffix == ".cpp" and not name.startswith("tests/"):
            for header in implemented(name, included):
                leads.setdefault(header, set()).add(name)
    return leads


def reached(test, leads):
    seen, todo = set(), [test]
    while todo:
        name = todo.pop()
        if name not in seen:
            seen.add(name)
            todo += leads.get(name, ())
    return seen


def units(root):
    """The sources to be tested: a .cpp, or a header that has none."""
    names = {house.relative(root, file) for file in house.cpp_sources(root)}
    return sorted(name for name in names if name.endswith(".cpp") or name[:-2] + ".cpp" not in names)


def test_of(unit):
    return f"tests/{unit.rsplit('.', 1)[0]}_test.cpp"


def reasons(root):
    """(number, source, reason) of each line of the list."""
    for number, line in enumerate((root / LIST).read_text().split("\n"), 1):
        line = line.partition("#")[0].strip()
        if line:
            source, _, reason = line.partition(" ")
            yield number, source, reason.strip()


def wrong_with(root, source, reason, leads):
    """What is wrong with a line of the list; None if nothing."""
    if not (root / source).is_file():
        return f"there is no {source}"
    if (root / test_of(source)).is_file():
        return f"{source} has its test: strike the line"
    if reason == NO_BEHAVIOUR:
        text = house.without_comments((root / source).read_text())
        if source.endswith(".cpp") or BEHAVIOUR.search(text):
            return f"{source} has behaviour"
    elif not (root / reason).is_file() or not reason.startswith("tests/"):
        return f"there is no test {reason!r}"
    elif not RUNS_THE_COMMAND.fullmatch(reason) and source not in reached(reason, leads):
        return f"{reason} does not reach {source}"
    return None


def check(root):
    root = pathlib.Path(root)
    leads = include_graph(root)
    listed = set()
    problems = []
    for number, source, reason in reasons(root):
        if source in listed:
            problems.append(f"{LIST}:{number}: {source} is listed twice")
        listed.add(source)
        if wrong := wrong_with(root, source, reason, leads):
            problems.append(f"{LIST}:{number}: {wrong}")
    return problems + [f"{unit}: has no {test_of(unit)} and no line in {LIST}" for unit in units(root)
                       if unit not in listed and not (root / test_of(unit)).is_file()]


if __name__ == "__main__":
    house.main(check, __doc__)
