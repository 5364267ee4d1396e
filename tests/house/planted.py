"""Small repositories with a planted fault, for the gates' own tests."""

import pathlib
import tempfile
import unittest


class PlantedTest(unittest.TestCase):
    """Runs a gate over files that a test names: {path: text}."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name) / "repository"
        self.root.mkdir()

    def plant(self, texts):
        for name, text in texts.items():
            file = self.root / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        return self.root
