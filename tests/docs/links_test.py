#!/usr/bin/env python3
"""Every relative link in the documentation leads somewhere, and so does every source file that
docs/model.md and docs/architecture.md name.

usage: links_test.py REPOSITORY
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv[1])
LINK = re.compile(r"\]\(([^)\s]+)\)")
SOURCE = re.compile(r"`((?:core|formats|replay|cli|tests|samples|docs)/[\w./{},-]*)`")


def pages():
    return [page for page in ROOT.rglob("*.md")
            if not any(part.startswith(("build", ".", "out")) for part in page.relative_to(ROOT).parts)]


def anchors(page):
    """The ids that a renderer gives the headings of a page."""
    return {re.sub(r"[^\w\- ]", "", line.lstrip("#").strip().lower()).replace(" ", "-")
            for line in page.read_text().splitlines() if line.startswith("#")}


def alternatives(name):
    """`a/{b,c}.h` names two files."""
    braces = re.search(r"\{([^}]*)\}", name)
    if not braces:
        return [name]
    return [name[:braces.start()] + choice + name[braces.end():]
            for choice in braces.group(1).split(",")]


class LinksTest(unittest.TestCase):
    def test_relative_links_lead_somewhere(self):
        for page in pages():
            for target in LINK.findall(page.read_text()):
                if "://" in target:
                    continue
                name, _, anchor = target.partition("#")
                file = page.parent / name if name else page
                with self.subTest(page=str(page.relative_to(ROOT)), target=target):
                    self.assertTrue(file.exists())
                    if anchor:
                        self.assertIn(anchor, anchors(file))

    def test_named_sources_exist(self):
        for page in ("docs/model.md", "docs/architecture.md", "CONTRIBUTING.md"):
            text = (ROOT / page).read_text()
            for name in SOURCE.findall(text):
                for file in alternatives(name):
                    with self.subTest(page=page, file=file):
                        self.assertTrue((ROOT / file).exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
