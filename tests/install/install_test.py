#!/usr/bin/env python3
"""The libraries as others use them: installed into an empty prefix, their headers compiled one by
one, found with find_package, the sample built on them and run.

usage: install_test.py REPOSITORY BUILD CXX VERSION
"""

import concurrent.futures
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

ROOT, BUILD = (pathlib.Path(argument) for argument in sys.argv[1:3])
CXX, VERSION = sys.argv[3:5]
MAJOR, MINOR = (int(part) for part in VERSION.split(".")[:2])
PROJECT = "cmake_minimum_required(VERSION 3.25)\nproject(consumer LANGUAGES CXX)\n"
# The standard library's headers have no suffix and lie in no folder.
ALLOWED = re.compile(r"^<([a-z_0-9]+|Eigen/\w+)>$")
INCLUDE = re.compile(r'^\s*#\s*include\s*(<[^>]+>|"[^"]+")', re.M)


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)


def pixels(png):
    """Width, height and the rows of a PNG of 8-bit RGB, still filtered."""
    data, at, packed, size = png.read_bytes(), 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            size = struct.unpack(">II", data[at + 8:at + 16])
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += length + 12
    return *size, zlib.decompress(packed)


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.scratch = pathlib.Path(folder.name)
        cls.prefix = cls.scratch / "prefix"
        cls.include = cls.prefix / "include/pentimento"
        installed = run("cmake", "--install", BUILD, "--prefix", cls.prefix)
        assert installed.returncode == 0, installed.stdout + installed.stderr

    def configure(self, source, build):
        return run("cmake", "-S", source, "-B", build, "-G", "Ninja",
                   f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_CXX_COMPILER={CXX}")

    def consumer(self, name, text):
        """Configures a project of these lines."""
        source = self.scratch / name
        source.mkdir()
        (source / "CMakeLists.txt").write_text(PROJECT + text)
        return self.configure(source, source / "build")

    def compile_headers(self, headers):
        """Syntax only, from the prefix, with Eigen and nothing else where the compiler looks."""
        eigen = run("pkg-config", "--variable=includedir", "eigen3").stdout.strip() or "/usr/include"
        return run(CXX, "-std=c++20", "-fsyntax-only", f"-I{self.include}",
                   f"-isystem{eigen}/eigen3", "-x", "c++", "-",
                   input="".join(f'#include "{header}"\n' for header in headers))

    def headers(self):
        found = sorted(path.relative_to(self.include) for path in self.include.rglob("*.h"))
        self.assertGreater(len(found), 100)
        return found

    def test_all_headers_compile_with_eigen_only(self):
        result = self.compile_headers(self.headers())
        self.assertEqual(result.returncode, 0, result.stderr[:2000])

    def test_each_header_compiles_alone(self):
        # The build has compiled those which a source of their name includes before anything else.
        def untried(header):
            source = (ROOT / header).with_suffix(".cpp")
            return not source.is_file() or INCLUDE.search(source.read_text())[1] != f'"{header}"'

        headers = [header for header in self.headers() if untried(header)]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for header, result in zip(headers, pool.map(lambda h: self.compile_headers([h]), headers)):
                with self.subTest(header=str(header)):
                    self.assertEqual(result.returncode, 0, result.stderr[:2000])

    def test_no_header_includes_another_library(self):
        # Most of them would compile here: they lie where the compiler looks unasked.
        for header in self.include.rglob("*.h"):
            for name in INCLUDE.findall(header.read_text()):
                if name.startswith("<"):
                    with self.subTest(header=str(header.relative_to(self.include)), includes=name):
                        self.assertRegex(name, ALLOWED)

    def test_the_version_asked_for_is_minded(self):
        # Before 1.0, what another minor version says is no promise.
        for name, asked, found in (("same", f"{MAJOR}.{MINOR}", True),
                                   ("older_minor", f"{MAJOR}.{max(MINOR - 1, 0)}", MINOR == 0),
                                   ("newer_minor", f"{MAJOR}.{MINOR + 1}", False),
                                   ("newer_major", f"{MAJOR + 1}", False)):
            with self.subTest(asked=asked):
                configured = self.consumer(name, f"""
                    find_package(pentimento {asked} CONFIG REQUIRED)
                    message(STATUS "found ${{pentimento_VERSION}}")""")
                self.assertEqual(configured.returncode == 0, found, configured.stderr)
                if found:
                    self.assertIn(f"found {VERSION}", configured.stdout)

    def test_of_our_options_consumers_get_one(self):
        configured = self.consumer("options", """
            find_package(pentimento CONFIG REQUIRED COMPONENTS core formats replay)
            foreach(library core formats replay)
              get_target_property(options pentimento::${library} INTERFACE_COMPILE_OPTIONS)
              get_target_property(linked pentimento::${library} INTERFACE_LINK_LIBRARIES)
              message(STATUS "${library}: ${options} | ${linked}")
            endforeach()""")
        self.assertEqual(configured.returncode, 0, configured.stderr)
        self.assertIn("-ffp-contract=off", configured.stdout)
        self.assertNotRegex(configured.stdout, r"-W|-fsanitize|-fno|pentimento_options")

    def test_the_samples_build_run_and_paint(self):
        build = self.scratch / "sample"
        configured = self.configure(ROOT / "samples/cpp", build)
        self.assertEqual(configured.returncode, 0, configured.stderr)
        built = run("cmake", "--build", build)
        self.assertEqual(built.returncode, 0, built.stdout)
        for name, wanted in (("hill", (400, 300)), ("sunflowers", (432, 432))):
            with self.subTest(name):
                self.assert_paints(build / name, ROOT / f"samples/cpp/{name}.png", wanted)

    def assert_paints(self, program, frozen, wanted):
        picture = self.scratch / frozen.name
        painted = run(program, picture)
        self.assertEqual(painted.returncode, 0, painted.stderr)
        # Two levels of 8 bits: one for another machine's shader compiler, one for rounding.
        same = run(self.prefix / "bin/pentimento", "compare", frozen, picture, "--max", "0.0079")
        self.assertEqual(same.returncode, 0, same.stdout + same.stderr)
        width, height, rows = pixels(picture)
        self.assertEqual((width, height), wanted)
        # A blank canvas has a handful of codes, a painted one most of them: 192 and more of 256.
        self.assertGreater(len(set(rows)), 100)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
