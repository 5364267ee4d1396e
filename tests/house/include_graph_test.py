#!/usr/bin/env python3
"""include_graph.py reports a planted circle, an arrow upwards and a crowded folder."""

import unittest

import include_graph
import planted

TREE = {"core/base/a.h": "int a;\n", "core/fluid/b.h": '#include "core/base/a.h"\n',
        "core/fluid/b.cpp": '#include "core/fluid/b.h"\n#include <vector>\n',
        "formats/c.cpp": '#include "core/fluid/b.h"\n', "cli/d.cpp": '#include "core/base/a.h"\n'}


class IncludeGraphTest(planted.PlantedTest):
    def problems(self, **more):
        return include_graph.check(self.plant({**TREE, **more}))

    def test_a_clean_tree_has_nothing(self):
        self.assertEqual(self.problems(), [])

    def test_a_circle(self):
        found = self.problems(**{"core/base/e.cpp": '#include "core/fluid/b.h"\n'})
        self.assertEqual(found, ["circle between core/base, core/fluid: core/base/e.cpp includes "
                                 "core/fluid/b.h; core/fluid/b.h includes core/base/a.h"])

    def test_a_circle_over_a_third(self):
        found = self.problems(**{"core/base/e.cpp": '#include "core/mid/m.h"\n',
                                 "core/mid/m.h": '#include "core/fluid/b.h"\n'})
        self.assertEqual(len(found), 1)
        self.assertIn("circle between core/base, core/fluid, core/mid:", found[0])

    def test_a_border_crossed_upwards(self):
        found = self.problems(**{"formats/e.cpp": '#include "replay/r.h"\n', "replay/r.h": "int r;\n"})
        self.assertEqual(found, ["upwards: formats/e.cpp includes replay/r.h"])

    def test_a_crowded_folder(self):
        crowd = {f"core/crowd/f{i}.{end}": "" for i in range(36) for end in ("h", "cpp")}
        self.assertEqual(self.problems(**crowd), ["core/crowd: 36 sources, 35 at most"])

    def test_the_drawing_has_each_folder_and_arrow(self):
        drawn = include_graph.dot(self.plant(TREE))
        self.assertIn('"core/fluid" [label="core/fluid\\n1"', drawn)
        self.assertIn('"formats" -> "core/fluid"', drawn)


if __name__ == "__main__":
    unittest.main()
