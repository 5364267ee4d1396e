#!/usr/bin/env python3
"""The folders of the program and who includes whom: fails on a circle between folders, on an arrow
that points upwards (core <- formats <- replay <- cli), and on a folder of more than 35 sources (a file
with its header is one).

usage: include_graph.py REPOSITORY
       include_graph.py REPOSITORY --dot > graph.dot     the drawing, for Graphviz: dot -Tsvg
"""

import collections
import pathlib
import re
import sys

import house

LARGEST_FOLDER = 35
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
BORDERS = ("core", "formats", "replay", "cli")  # each sees those before it
COLORS = {"core": "#dbe7f3", "formats": "#e4f0dc", "replay": "#f6ead2", "cli": "#f0dfe6"}


def folder_of(name):
    return name.rpartition("/")[0]


def includes(root):
    """The arrows between folders: (from, to) and the includes that make it."""
    sources = {house.relative(root, file) for file in house.cpp_sources(root)}
    arrows = collections.defaultdict(list)
    for name in sorted(sources):
        for target in INCLUDE.findall((root / name).read_text()):
            if target in sources and folder_of(target) != folder_of(name):
                arrows[folder_of(name), folder_of(target)].append(f"{name} includes {target}")
    return arrows


def circles(arrows):
    """Sets of folders that include each other, in one step or in several."""
    ahead = collections.defaultdict(set)
    for start, end in arrows:
        ahead[start].add(end)

    def reached(start):
        seen, waiting = set(), [start]
        while waiting:
            for folder in ahead[waiting.pop()] - seen:
                seen.add(folder)
                waiting.append(folder)
        return seen

    reach = {folder: reached(folder) for folder in list(ahead)}
    found = {frozenset(other for other in reach[folder] if folder in reach.get(other, ()))
             for folder in reach if folder in reach[folder]}
    return sorted(map(sorted, found))


def sizes(root):
    units = {house.relative(root, file).rpartition(".")[0] for file in house.cpp_sources(root)}
    return collections.Counter(map(folder_of, units))


def check(root):
    root = pathlib.Path(root)
    arrows = includes(root)
    problems = []
    for circle in circles(arrows):
        inside = [line for (start, end), lines in sorted(arrows.items())
                  if start in circle and end in circle for line in lines]
        problems.append(f"circle between {', '.join(circle)}: " + "; ".join(inside))
    for (start, end), lines in sorted(arrows.items()):
        if BORDERS.index(start.split("/")[0]) < BORDERS.index(end.split("/")[0]):
            problems.append(f"upwards: {lines[0]}")
    problems += [f"{folder}: {count} sources, {LARGEST_FOLDER} at most"
                 for folder, count in sorted(sizes(root).items()) if count > LARGEST_FOLDER]
    return problems


def dot(root):
    """Folders as boxes with their number of sources, arrows as thick as they have includes."""
    root = pathlib.Path(root)
    arrows, count = includes(root), sizes(root)
    inside = {folder for circle in circles(arrows) for folder in circle}
    lines = ["digraph folders {", ' rankdir=TB; node [shape=box, style=filled, fontname="sans-serif"];']
    for border in BORDERS:
        lines.append(f' subgraph "cluster_{border}" {{ label="{border}"; fontname="sans-serif";')
        lines += [f'  "{folder}" [label="{folder}\\n{number}", fillcolor="{COLORS[border]}"];'
                  for folder, number in sorted(count.items()) if folder.split("/")[0] == border]
        lines.append(" }")
    for (start, end), made in sorted(arrows.items()):
        red = ' color="#c02020"' if start in inside and end in inside else ' color="#00000060"'
        lines.append(f' "{start}" -> "{end}" [penwidth={min(1 + len(made) / 8, 4):.1f}{red}];')
    return "\n".join([*lines, "}"])


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[2] == "--dot":
        print(dot(sys.argv[1]))
    else:
        house.main(check, __doc__)
