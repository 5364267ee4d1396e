#!/usr/bin/env python3
"""named_files.py reports a planted name that leads nowhere, and nothing in a clean tree."""

import unittest

import named_files
import planted

TREE = {"core/brush/tip.h": "#pragma once\n// See tip.cpp.\n",
        "core/brush/tip.cpp": '#include "core/brush/tip.h"\n#include "gone.h"\n',
        "docs/brush.md": "The tip: `core/brush/tip.{h,cpp}`, all of `core/brush/*.h` in `core/brush`, n.h.\n",
        "tests/look.py": 'print("gone.py")\n',
        "CHANGELOG.md": "`gone.h` is gone.\n"}

QUOTES = 3 * '"'


class NamedFilesTest(planted.PlantedTest):
    def assert_reported(self, file, text, wanted):
        self.assertEqual(named_files.check(self.plant({**TREE, file: text})), [wanted])

    def test_a_clean_tree_has_nothing(self):
        self.assertEqual(named_files.check(self.plant(TREE)), [])

    def test_a_bare_name_in_a_comment(self):
        self.assert_reported("core/a.cpp", "int a;  // as in gone.h\n",
                             "core/a.cpp:1: no file or folder is called gone.h")

    def test_a_bare_name_in_a_page(self):
        self.assert_reported("docs/a.md", "\nsee `gone.cpp`\n", "docs/a.md:2: no file or folder is called gone.cpp")

    def test_a_path_in_a_page(self):
        self.assert_reported("docs/a.md", "see core/tip.h\n", "docs/a.md:1: no file or folder is called core/tip.h")

    def test_a_folder(self):
        self.assert_reported("README.md", "`core/fluid`\n", "README.md:1: no file or folder is called core/fluid")

    def test_one_of_two_in_braces(self):
        self.assert_reported("docs/a.md", "`core/brush/{tip,hair}.h`\n",
                             "docs/a.md:1: no file or folder is called core/brush/hair.h")

    def test_a_pattern_that_fits_nothing(self):
        self.assert_reported("docs/a.md", "`cmd_*.cpp`\n", "docs/a.md:1: no file or folder is called cmd_*.cpp")

    def test_a_docstring(self):
        self.assert_reported("tests/a.py", QUOTES + "Like gone.py." + QUOTES,
                             "tests/a.py:1: no file or folder is called gone.py")


if __name__ == "__main__":
    unittest.main()
