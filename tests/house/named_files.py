#!/usr/bin/env python3
"""Files and folders that pages and comments name but that do not exist.

A path that starts with a folder of ours is meant from the root, from the page, or as the end of a
longer path; `a/{b,c}.h` names two files, `cmd_*.cpp` at least one. A bare name (`tip.cpp`) means some
file of that name. NAME stands for any name, and so does a single letter (`v.h` is a dot product). The
changelog is history and names what was; a header in angle brackets is somebody else's.

usage: named_files.py REPOSITORY
"""

import fnmatch
import pathlib
import re

import house

HISTORY = ("CHANGELOG.md",)
# Not in the repository: made by the build, or what the page tells its reader to write.
ELSEWHERE = {
    "draw.py": "docs/action-log.md: a script of the reader's own",
}
# Placeholders of a file's or folder's name.
PLACEHOLDER = re.compile(r"(?:^|/)(?:NAME|FILE|[a-z])(?:/|\.|$)")
OURS = "|".join(house.FOLDERS)
NAME = re.compile(
    r"(?<![\w<>./{}*-])((?:%s)/[\w./{},*-]*[\w}*]|(?:[\w{},*-]+/)*[\w{},*-]+\.(?:h|cpp|glsl|cmake|py|sh|md))(?![\w/*-])"
    % OURS)


def alternatives(name):
    """`a/{b,c}.h` names two files."""
    braces = re.search(r"\{([^}]*)\}", name)
    if not braces:
        return [name]
    return [alternative for choice in braces[1].split(",")
            for alternative in alternatives(name[:braces.start()] + choice + name[braces.end():])]


def known_paths(root):
    """Every file, and every folder that has one."""
    known = set()
    for file in house.files(root):
        path = pathlib.PurePosixPath(house.relative(root, file))
        known.update(map(str, [path, *path.parents]))
    return known


def exists(name, known):
    if "*" in name:
        return any(fnmatch.fnmatch(path, pattern) for path in known for pattern in (name, "*/" + name))
    return name in known or any(path.endswith("/" + name) for path in known)


def check(root):
    """One line for each name that leads nowhere."""
    root = pathlib.Path(root)
    known = known_paths(root)
    answers = {}
    problems = []
    for file in house.files(root):
        page = house.relative(root, file)
        if page in HISTORY:
            continue
        for number, line in house.prose(file):
            for match in NAME.findall(line):
                for name in alternatives(match):
                    if PLACEHOLDER.search(name):
                        continue
                    if name not in answers:
                        answers[name] = name in ELSEWHERE or exists(name, known)
                    if not answers[name]:
                        problems.append(f"{page}:{number}: no file or folder is called {name}")
    return problems


if __name__ == "__main__":
    house.main(check, __doc__)
