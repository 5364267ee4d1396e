#!/usr/bin/env python3
"""Every relative link in the documentation leads somewhere. The files that pages name without a link
are checked by tests/house/named_files.py.

usage: links_test.py REPOSITORY
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv[1])
LINK = re.compile(r"\]\(([^)\s]+)\)")


def pages():
    return [page for page in ROOT.rglob("*.md")
            if not any(part.startswith(("build", ".", "out")) for part in page.relative_to(ROOT).parts)]


def anchors(page):
    """The ids that a renderer gives the headings of a page."""
    return {re.sub(r"[^\w\- ]", "", line.lstrip("#").strip().lower()).replace(" ", "-")
            for line in page.read_text().splitlines() if line.startswith("#")}


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


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
