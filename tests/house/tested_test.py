#!/usr/bin/env python3
"""tested.py reports a planted source without its test, and nothing in a clean tree."""

import unittest

import planted
import tested

TREE = {"core/brush/tip.h": "#pragma once\n",
        "core/brush/tip.cpp": '#include "core/brush/tip.h"\n#include "core/brush/noise.h"\n',
        "core/brush/noise.h": "inline int twice(int a) {\n  return a + a;\n}\n",
        "core/brush/point.h": "struct Point {\n  int x = 0;  // for the brush\n};\n",
        "cli/main.cpp": "int main() {}\n",
        "tests/core/brush/tip_test.cpp": '#include "core/brush/tip.h"\n',
        "tests/core/brush/other_test.cpp": "",
        "tests/cli/render_test.cpp": "",
        tested.LIST: "# why not\n\ncore/brush/noise.h  tests/core/brush/tip_test.cpp\n"
                     "core/brush/point.h  no behaviour\ncli/main.cpp  tests/cli/render_test.cpp\n"}


class TestedTest(planted.PlantedTest):
    def assert_reported(self, change, wanted):
        self.assertEqual(tested.check(self.plant({**TREE, **change})), [wanted])

    def listing(self, line):
        return {tested.LIST: TREE[tested.LIST] + line + "\n"}

    def test_a_clean_tree_has_nothing(self):
        self.assertEqual(tested.check(self.plant(TREE)), [])

    def test_a_source_without_test(self):
        self.assert_reported({"core/brush/hair.cpp": ""}, "core/brush/hair.cpp: has no "
                             "tests/core/brush/hair_test.cpp and no line in tests/house/tested_elsewhere.txt")

    def test_a_header_alone_without_test(self):
        self.assert_reported({"core/hair.h": ""}, "core/hair.h: has no tests/core/hair_test.cpp and no line in "
                             "tests/house/tested_elsewhere.txt")

    def test_a_line_for_a_source_that_is_gone(self):
        self.assert_reported(self.listing("core/gone.h  no behaviour"),
                             "tests/house/tested_elsewhere.txt:6: there is no core/gone.h")

    def test_a_line_for_a_source_that_has_its_test(self):
        self.assert_reported(self.listing("core/brush/tip.cpp  no behaviour"), "tests/house/tested_elsewhere.txt:6: "
                             "core/brush/tip.cpp has its test: strike the line")

    def test_a_source_listed_twice(self):
        self.assert_reported(self.listing("core/brush/point.h  no behaviour"),
                             "tests/house/tested_elsewhere.txt:6: core/brush/point.h is listed twice")

    def test_behaviour_in_what_is_said_to_have_none(self):
        self.assert_reported({"core/brush/point.h": "inline int f(int a) {\n  if (a) return 1;\n  return 2;\n}\n"},
                             "tests/house/tested_elsewhere.txt:4: core/brush/point.h has behaviour")

    def test_a_test_that_is_gone(self):
        self.assert_reported({tested.LIST: TREE[tested.LIST].replace("tip_test", "gone_test")},
                             "tests/house/tested_elsewhere.txt:3: there is no test 'tests/core/brush/gone_test.cpp'")

    def test_a_test_that_has_nothing_to_do_with_it(self):
        self.assert_reported({tested.LIST: TREE[tested.LIST].replace("tip_test", "other_test")},
                             "tests/house/tested_elsewhere.txt:3: tests/core/brush/other_test.cpp does not reach "
                             "core/brush/noise.h")


if __name__ == "__main__":
    unittest.main()
