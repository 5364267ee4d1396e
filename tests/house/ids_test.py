#!/usr/bin/env python3
"""ids.py reports a planted id without its row, and nothing in a clean tree."""

import unittest

import ids
import planted

TREE = {"docs/model.md": "| R9 | sweeps |\n| R10, R11 | speed |\n"
                         "| R36 (path) | stamps |\n| R36 | order |\n| A7 | brackets |\n",
        "docs/adr/0003-thickness.md": "# 3. Thickness\n",
        "docs/a.md": "R9, R10-R11 and A7 by [ADR 3](adr/0003-thickness.md)\n",
        "core/a.h": "// R11 with A7, ADR 3\nint A8 = 0;\n",
        "core/shading/a.glsl": "float R = A1;  // R9\n"}


class IdsTest(planted.PlantedTest):
    def assert_reported(self, file, text, wanted):
        self.assertEqual(ids.check(self.plant({**TREE, file: text})), [wanted])

    def test_a_clean_tree_has_nothing(self):
        self.assertEqual(ids.check(self.plant(TREE)), [])

    def test_a_rule_in_a_comment(self):
        self.assert_reported("core/b.cpp", "int a;  // R12\n", "core/b.cpp:1: R12 has no row in docs/model.md")

    def test_a_reading_in_a_comment(self):
        self.assert_reported("core/b.h", "/// Source: (A70).\n", "core/b.h:1: A70 has no row in docs/model.md")

    def test_a_reading_in_a_page(self):
        self.assert_reported("docs/b.md", "| 1 | A9 | front |\n", "docs/b.md:1: A9 has no row in docs/model.md")

    def test_a_shader(self):
        self.assert_reported("core/a.glsl", "// as R1 says\n", "core/a.glsl:1: R1 has no row in docs/model.md")

    def test_two_rows(self):
        self.assert_reported("docs/model.md", TREE["docs/model.md"] + "| A7 | again |\n",
                             "docs/model.md: A7 has 2 rows")

    def test_a_decision(self):
        self.assert_reported("core/b.h", "// see ADR 4\n", "core/b.h:1: there is no ADR 4")

    def test_a_link_to_another_decision(self):
        self.assert_reported("docs/b.md", "[ADR 3](adr/0002-b.md)\n",
                             "docs/b.md:1: ADR 3 is 0003-thickness.md, not adr/0002-b.md")


if __name__ == "__main__":
    unittest.main()
