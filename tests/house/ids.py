#!/usr/bin/env python3
"""Ids in pages and comments that have no row: rules of the paper (R11) and readings of it (A7) in
docs/model.md, decisions (ADR 3) in docs/adr.

The rows' first column holds the ids, alone or as `R10, R11`. A link called `ADR 3` leads to a page
whose name begins with 0003. Sizes of sheets (A2, A4) are taken for readings, and all have rows.

usage: ids.py REPOSITORY
"""

import collections
import pathlib
import re

import house

TABLE = "docs/model.md"
HISTORY = ("CHANGELOG.md",)
ID = re.compile(r"(?<![\w.#/&])([RA][1-9]\d?)(?![\w.]*\w)")
DECISION = re.compile(r"\bADRs? (\d+)\b(?:\]\(([^)]*)\))?")
ROW = re.compile(r"^\| ([RA]\d+[^|]*)\|")


def rows(root):
    """How many rows of the tables each id has. `R36 (path)` is a second part of R36."""
    found = collections.Counter()
    for line in (root / TABLE).read_text().split("\n"):
        if match := ROW.match(line):
            for name in match[1].split(","):
                found[name.strip()] += 1
    return found


def decisions(root):
    return {int(page.name[:4]): page.name for page in (root / "docs/adr").glob("[0-9]*.md")}


def check(root):
    root = pathlib.Path(root)
    known, pages = rows(root), decisions(root)
    problems = [f"{TABLE}: {name} has {count} rows" for name, count in known.items() if count > 1]
    for file in house.files(root):
        name = house.relative(root, file)
        if name in HISTORY:
            continue
        for number, line in house.prose(file):
            problems += [f"{name}:{number}: {found} has no row in {TABLE}"
                         for found in ID.findall(line) if found not in known]
            for decision, target in DECISION.findall(line):
                if int(decision) not in pages:
                    problems.append(f"{name}:{number}: there is no ADR {decision}")
                elif target and pages[int(decision)] not in target:
                    problems.append(f"{name}:{number}: ADR {decision} is {pages[int(decision)]}, not {target}")
    return problems


if __name__ == "__main__":
    house.main(check, __doc__)
