#!/usr/bin/env python3
"""type_names.py reports planted types of one name, and nothing in a clean tree."""

import unittest

import planted
import type_names

TREE = {"core/tip.h": "namespace pentimento {\n\nstruct Tip {\n  enum class Side { kLeft };\n};\n\n"
                      "}  // namespace pentimento\n",
        "core/tip.cpp": "namespace pentimento {\nnamespace {\n\nstruct Hair {};\nusing Row = int;\n\n"
                        "}  // namespace\n\nstruct Tip::Parts {};\n}  // namespace pentimento\n",
        "formats/row.cpp": "using Row = int;\nstruct Declared;\n// struct Hair {\n",
        "tests/core/tip_test.cpp": "namespace pentimento {\nnamespace {\n\nstruct Tip {};\n\n}  // namespace\n"
                                   "}  // namespace pentimento\n"}


class TypeNamesTest(planted.PlantedTest):
    def assert_reported(self, file, text, *wanted):
        self.assertEqual(type_names.check(self.plant({**TREE, file: text})), list(wanted))

    def test_a_clean_tree_has_nothing(self):
        self.assertEqual(type_names.check(self.plant(TREE)), [])

    def test_two_types_that_their_files_alone_see(self):
        self.assert_reported("replay/a.cpp", "namespace {\nclass Hair final : public Tip {\n};\n}  // namespace\n",
                             "the type Hair is defined more than once: core/tip.cpp, replay/a.cpp")

    def test_a_type_in_a_type(self):
        self.assert_reported("cli/a.h", "struct Outer {\n  struct Hair {\n  };\n};\n",
                             "the type Hair is defined more than once: cli/a.h, core/tip.cpp")

    def test_two_in_one_file(self):
        self.assert_reported("cli/a.h", "struct One {\n  enum Kind { kA };\n};\nstruct Two {\n  enum Kind { kB };\n};\n",
                             "the type Kind is defined more than once: cli/a.h, cli/a.h")

    def test_another_name_of_another_type(self):
        self.assert_reported("replay/a.h", "using Row = float;\n",
                             "the type Row is defined more than once: core/tip.cpp, replay/a.h")

    def test_a_type_of_a_test_in_the_same_namespace(self):
        self.assert_reported("tests/a.h", "namespace pentimento {\nstruct Tip {\n};\n}  // namespace pentimento\n",
                             "pentimento::Tip is defined more than once: core/tip.h, tests/a.h")


if __name__ == "__main__":
    unittest.main()
