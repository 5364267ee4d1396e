#!/usr/bin/env python3
"""No two types of the program or its tests have one name in one namespace. Compilers see one file
at a time: of two such types, members and templates of either may be linked for both.

usage: names_test.py REPOSITORY
"""

import collections
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv[1])
FOLDERS = ("core", "formats", "replay", "cli", "tests")
OPENED = re.compile(r"^namespace(?: ([\w:]+))? \{")
CLOSED = re.compile(r"^\}  // namespace")
TYPE = re.compile(r"^(?:struct|class|enum class|enum|union) (?:\[\[\w+\]\] |alignas\(\w+\) )?"
                  r"(\w+)(?: final)?(?: : .*)? \{")


def types(file):
    """Qualified names of the types that the file defines where other files' types can be meant."""
    opened = []
    for line in file.read_text().splitlines():
        if match := OPENED.match(line):
            opened.append(match[1])  # None where it has no name: seen by this file alone
        elif CLOSED.match(line):
            opened.pop()
        elif (match := TYPE.match(line)) and None not in opened:
            yield "::".join([*opened, match[1]])


class NamesTest(unittest.TestCase):
    def test_a_type_is_defined_once(self):
        files = collections.defaultdict(list)
        for folder in FOLDERS:
            for file in sorted((ROOT / folder).rglob("*")):
                if file.suffix in (".h", ".cpp"):
                    for name in types(file):
                        files[name].append(str(file.relative_to(ROOT)))
        self.assertGreater(len(files), 100)
        self.assertIn("pentimento::DetailCanvas", files)
        for name, found in files.items():
            with self.subTest(type=name):
                self.assertEqual(len(found), 1, found)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
