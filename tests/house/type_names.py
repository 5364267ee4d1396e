#!/usr/bin/env python3
"""Types of one name. In the program a type's name means one thing, wherever it is defined: in a
namespace, in another type, seen by one file alone, or as another name of a type (`using`). In the
tests too, no two types have one name in one namespace: compilers see one file at a time, and of two
such types members and templates of either may be linked for both.

usage: type_names.py REPOSITORY
"""

import collections
import pathlib
import re

import house

OPENED = re.compile(r"^(?:inline )?namespace(?: ([\w:]+))? \{")
CLOSED = re.compile(r"^\}  // (?:inline )?namespace")
TYPE = re.compile(r"^\s*(?:template <[^>]*>\s*)?(?:struct|class|enum class|enum|union)"
                  r" (?:\[\[\w+\]\] |alignas\([^)]*\) )*(\w+)(?: final)?(?: : [^;]*)?(?: \{|$)")
ALIAS = re.compile(r"^\s*using (\w+) = (.*)")


def types(file):
    """(name, namespaces, whether other files can mean it, what it stands for or None) of each type that
    the file defines."""
    opened = []
    code = house.without_comments(file.read_text()).split("\n")
    for line, whole in zip(code, file.read_text().split("\n")):
        if match := OPENED.match(line):
            opened.append(match[1])  # None where it has no name: seen by this file alone
        elif CLOSED.match(whole) and opened:
            opened.pop()
        elif match := TYPE.match(line) or ALIAS.match(line):
            at_namespace = not line.startswith(" ") and not ALIAS.match(line)
            stands_for = match[2] if match.re is ALIAS else None
            yield match[1], tuple(opened), at_namespace and None not in opened, stands_for


def one_meaning(root):
    """Names that mean several things in the program. Two `using` of the same type are one meaning."""
    meanings = collections.defaultdict(dict)
    for file in house.cpp_sources(root):
        for number, (name, _, _, stands_for) in enumerate(types(file)):
            place = house.relative(root, file)
            meanings[name].setdefault(stands_for or f"{place}:{number}", place)
    problems = [f"the type {name} is defined more than once: {', '.join(found.values())}"
                for name, found in sorted(meanings.items()) if len(found) > 1]
    return problems


def one_definition(root):
    """Names that are repeated in one namespace, in program or tests."""
    places = collections.defaultdict(list)
    for file in house.cpp_sources(root, ("tests", *house.SOURCES)):
        for name, opened, seen, _ in types(file):
            if seen:
                places["::".join([*opened, name])].append(house.relative(root, file))
    return [f"{name} is defined more than once: {', '.join(found)}"
            for name, found in sorted(places.items()) if len(found) > 1]


def check(root):
    root = pathlib.Path(root)
    return one_meaning(root) + one_definition(root)


if __name__ == "__main__":
    house.main(check, __doc__)
