#!/usr/bin/env python3
"""What is in the Debian packages, taken apart into an empty folder: the command paints, its pages
can be read, Python paints, and each says what it needs.

usage: package_test.py FOLDER-OF-PACKAGES
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PACKAGES = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else pathlib.Path("build/packages")
LOG = ('{"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.1,"height":0.075},'
       '"grid":{"width":64,"height":48},"palette":[{"name":"Titanium White"}]}\n'
       '{"t":0,"type":"touch","id":1,"phase":"down","x":0.02,"y":0.04,"pressure":0.6}\n'
       '{"t":0.2,"type":"touch","id":1,"phase":"move","x":0.08,"y":0.04,"pressure":0.6}\n'
       '{"t":0.25,"type":"touch","id":1,"phase":"up","x":0.08,"y":0.04}\n')
PAINT = ("import pentimento; c = pentimento.Canvas(0.4, 0.3, grid=(80, 60), palette=['French Ultramarine']);"
         "c.paint([(0.1, 0.15), (0.3, 0.15)]); print(pentimento.__file__, c.state_sha256)")


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=True, **options).stdout


class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.fields = {}
        for package in PACKAGES.glob("*.deb"):
            name = run("dpkg-deb", "--field", package, "Package").strip()
            cls.fields[name] = run("dpkg-deb", "--field", package)
            run("dpkg-deb", "--extract", package, cls.root / name)

    def test_three_packages_with_licence_and_dependencies(self):
        self.assertEqual({"pentimento", "libpentimento-dev", "python3-pentimento"}, set(self.fields))
        for name, fields in self.fields.items():
            self.assertTrue((self.root / name / "usr/share/doc" / name / "copyright").exists(), name)
            self.assertNotIn("Depends: \n", fields)
        self.assertRegex(self.fields["pentimento"], r"Depends: .*libtiff6.*\n")
        self.assertRegex(self.fields["pentimento"], r"Recommends: libosmesa6")
        self.assertRegex(self.fields["python3-pentimento"], r"Depends: .*python3-numpy")
        self.assertIn("libeigen3-dev", self.fields["libpentimento-dev"])

    def test_the_command_paints(self):
        log = self.root / "log.jsonl"
        log.write_text(LOG)
        report = run(self.root / "pentimento/usr/bin/pentimento", "render", log, "-o", self.root / "log.png", "--json")
        self.assertRegex(report, r'"state_sha256":\s*"[0-9a-f]{64}"')
        self.assertEqual(b"\x89PNG", (self.root / "log.png").read_bytes()[:4])

    def test_each_command_has_a_page_that_man_reads(self):
        command = self.root / "pentimento/usr/bin/pentimento"
        folder = self.root / "pentimento/usr/share/man/man1"
        names = re.findall(r"^  (\S+) +", run(command, "--help").split("Commands:")[1], re.M)
        self.assertGreaterEqual(len(names), 10)
        for name in names:
            pages = list(folder.glob(f"pentimento-{name}.1*"))
            self.assertEqual(1, len(pages), name)
            page = run("man", "--warnings", "-l", pages[0], env={**os.environ, "MANWIDTH": "200", "LC_ALL": "C"})
            for option in re.findall(r"^  (?:-\w,)?(--[\w-]+)", run(command, name, "--help"), re.M):
                self.assertRegex(page, rf"(?<![\w-]){option}(?![\w-])", name)

    def test_python_paints(self):
        packages = self.root / "python3-pentimento/usr/lib/python3/dist-packages"
        file, sha = run("/usr/bin/python3", "-c", PAINT, env={**os.environ, "PYTHONPATH": str(packages)}).split()
        self.assertTrue(file.startswith(str(packages)))
        self.assertEqual(64, len(sha))

    def test_the_libraries_are_found(self):
        folder = self.root / "libpentimento-dev/usr"
        self.assertTrue(list(folder.glob("lib/**/libpentimento-replay.a")))
        self.assertTrue((folder / "include/pentimento/core/simulation/simulation.h").exists())
        self.assertTrue(list(folder.glob("lib/**/pentimentoConfig.cmake")))


if __name__ == "__main__":
    unittest.main()
