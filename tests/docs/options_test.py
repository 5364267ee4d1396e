#!/usr/bin/env python3
"""options.py reports planted faults of a page, and nothing in a clean one."""

import sys
import unittest

import options

HELP = {name: {} for name in options.COMMANDS} | {
    "render": {"--dpi": " N   dots per inch (300 with --print)", "--refine": " guided|direct  guided: ..."},
    "relight": {"--dpi": " N   dots per inch (300 with --print)", "--fps": " N  frames a second (25)"},
    "compare": {"--max": " N"}}
PAGE = ("# Command line\n`pentimento COMMAND --help`\n## render\n`--dpi` (300), `--refine guided|direct`\n"
        "## relight\n`--fps N`\n(25)\n## info, validate\n## compare\n`--max`\n")


class OptionsTest(unittest.TestCase):
    def assert_reported(self, before, after, *wanted):
        self.assertIn(before, PAGE)
        self.assertEqual(options.check_page(PAGE.replace(before, after), HELP), list(wanted))

    def test_a_clean_page_has_nothing(self):
        self.assertEqual(options.check_page(PAGE, HELP), [])

    def test_an_option_left_out(self):
        self.assert_reported("`--max`", "", "docs/cli.md: leaves out --max")

    def test_an_option_that_is_not(self):
        self.assert_reported("`--max`", "`--max` `--min`", "docs/cli.md: compare has no option --min")

    def test_an_option_of_another_command(self):
        self.assert_reported("`--max`", "`--max` `--fps`", "docs/cli.md: compare has no option --fps")

    def test_another_default(self):
        self.assert_reported("(25)", "(24)", "docs/cli.md: --fps (24), but the help says: "
                             "N  frames a second (25)")

    def test_another_choice(self):
        self.assert_reported("guided|direct", "guided|exact", "docs/cli.md: --refine has no choice exact in the help: "
                             "guided|direct  guided: ...")

    def test_a_call_with_an_option_of_another_command(self):
        self.assertEqual(options.check_calls("a.md", "```\npentimento render a.jsonl --dpi 3 --fps 4\n```\n", HELP),
                         ["a.md: pentimento render has no option --fps"])

    def test_a_call_that_is_right(self):
        self.assertEqual(options.check_calls("a.md", "`pentimento compare a b --max 1 | less --fps`", HELP), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
