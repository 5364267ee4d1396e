#!/usr/bin/env python3
"""Posters beside enlargements: the crops of docs/fidelity.md.

    crops.py COMMAND OUT.png [--scale 8] LOG:X,Y,SIZE...

For each log a row: SIZE x SIZE cells of its own grid from cell (X, Y) on; left the picture at the
grid's size, enlarged with a Lanczos filter, right the poster.
"""
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

Image.MAX_IMAGE_PIXELS = None
GAP = 8


def render(command, log, path, *options):
    subprocess.run([command, "render", log, "--quiet", "-o", path, *options], check=True)
    return Image.open(path).convert("RGB")


def pair(command, spec, scale, folder):
    log, at = spec.rsplit(":", 1)
    x, y, size = (int(v) for v in at.split(","))
    tablet = render(command, log, f"{folder}/tablet.png").crop((x, y, x + size, y + size))
    enlarged = tablet.resize((size * scale, size * scale), Image.LANCZOS)
    poster = render(command, log, f"{folder}/poster.png", "--scale", str(scale),
                    "--crop", f"{x * scale},{y * scale},{size * scale},{size * scale}")
    for picture in ("tablet.png", "poster.png"):
        pathlib.Path(folder, picture).unlink()
    return enlarged, poster


def main(arguments):
    scale = 8
    if "--scale" in arguments:
        at = arguments.index("--scale")
        scale = int(arguments[at + 1])
        del arguments[at:at + 2]
    if len(arguments) < 3:
        sys.exit(__doc__)
    command, out, *specs = arguments
    with tempfile.TemporaryDirectory() as folder:
        pairs = [pair(command, spec, scale, folder) for spec in specs]
    width = max(a.width for a, _ in pairs)
    sheet = Image.new("RGB", (2 * width + GAP, sum(a.height + GAP for a, _ in pairs) - GAP), "white")
    top = 0
    for enlarged, poster in pairs:
        sheet.paste(enlarged, (0, top))
        sheet.paste(poster, (width + GAP, top))
        top += enlarged.height + GAP
    sheet.save(out)


if __name__ == "__main__":
    main(sys.argv[1:])
