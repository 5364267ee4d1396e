"""Installs the Python package by pip, without an index, and paints with it.

  python_test.py SOURCE BUILD COMMAND

SOURCE: the tree. BUILD: its build, which has the engine. COMMAND: pentimento.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FIRST_PICTURE = """
import pentimento
canvas = pentimento.Canvas(0.4, 0.3, grid=(80, 60), palette=["French Ultramarine"])
canvas.paint([(0.1, 0.15), (0.3, 0.15)])
canvas.save("first.png")
print(pentimento.__file__, canvas.state_sha256)
"""


def main():
    source, build, command = map(pathlib.Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        scratch = pathlib.Path(name)
        subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", scratch / "venv"], check=True)
        # Pip builds in the folder that it is given, and is told of a build beside it by a relative name, as docs/python.md does.
        (scratch / "build").symlink_to(build.resolve())
        shutil.copytree(source / "python", scratch / "python",
                        ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__", "*.so"))
        subprocess.run([scratch / "venv/bin/pip", "install", "--quiet", "--no-index", "--no-build-isolation", "--no-deps",
                        scratch / "python"], check=True, env={**os.environ, "PENTIMENTO_BUILD": "build"})
        painted = subprocess.run([scratch / "venv/bin/python", "-c", FIRST_PICTURE], check=True, cwd=scratch,
                                 capture_output=True, text=True).stdout.split()
        assert painted[0].startswith(str(scratch / "venv")), painted
        told = subprocess.run([command, "info", scratch / "first.png"], check=True, capture_output=True, text=True).stdout
        assert painted[1] in told, told
        print("installed, painted, and the picture has the state's hash")


main()
