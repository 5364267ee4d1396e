"""What the scripts of this folder that make sheets of pictures share."""
import subprocess
import sys
import tempfile

from PIL import Image

Image.MAX_IMAGE_PIXELS = None
GAP = 8


def render(command, log, path, *options):
    subprocess.run([command, "render", log, "--quiet", "-o", path, *options], check=True)
    return Image.open(path).convert("RGB")


def cells_of(spec):
    """The log and the numbers of LOG:X,Y,SIZE."""
    log, at = spec.rsplit(":", 1)
    return log, *(int(v) for v in at.split(","))


def make(arguments, usage, row, **options):
    """COMMAND OUT [--scale 8] SPEC...: saves the pictures row(command, spec, scale, folder) of each
    spec side by side, one spec below the other."""
    scale = 8
    if "--scale" in arguments:
        at = arguments.index("--scale")
        scale = int(arguments[at + 1])
        del arguments[at:at + 2]
    if len(arguments) < 3:
        sys.exit(usage)
    command, out, *specs = arguments
    with tempfile.TemporaryDirectory() as folder:
        rows = [row(command, spec, scale, folder) for spec in specs]
    width = max(sum(p.width + GAP for p in pictures) - GAP for pictures in rows)
    sheet = Image.new("RGB", (width, sum(p[0].height + GAP for p in rows) - GAP), "white")
    top = 0
    for pictures in rows:
        left = 0
        for picture in pictures:
            sheet.paste(picture, (left, top))
            left += picture.width + GAP
        top += pictures[0].height + GAP
    sheet.save(out, **options)
