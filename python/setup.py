"""Builds the engine with the project's own CMake, from the tree that this folder lies in.

PENTIMENTO_BUILD names a folder, seen from the tree, in which that has been done before; then only what changed is compiled.
"""

import os
import pathlib
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

TREE = pathlib.Path(__file__).resolve().parent.parent


class CMakeBuild(build_ext):
    """Compiles pentimento_engine and puts it beside the package's sources."""

    def build_extension(self, ext):
        build = TREE / (os.environ.get("PENTIMENTO_BUILD") or pathlib.Path(self.build_temp).resolve())
        if not (build / "CMakeCache.txt").exists():
            subprocess.run(["cmake", "-S", str(TREE), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            "-DPENTIMENTO_TESTS=OFF", "-DPENTIMENTO_BENCH=OFF", f"-DPENTIMENTO_PYTHON={sys.executable}"],
                           check=True)
        subprocess.run(["cmake", "--build", str(build), "--target", "pentimento_engine"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        made = sorted((build / "python" / "pentimento").glob("_engine*.so"))
        shutil.copy2(made[0], target)


setup(ext_modules=[Extension("pentimento._engine", sources=[])], cmdclass={"build_ext": CMakeBuild})
