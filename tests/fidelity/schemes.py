#!/usr/bin/env python3
"""Both fluids side by side, on the logs' own grids, and their closing paint accounts (docs/defaults.md).

    schemes.py COMMAND FOLDER LOG...

Writes FOLDER/scheme-NAME.jpg for each log, left `conservative`, right `paper`, and prints the accounts:
what was deposited less what was picked up, has dried and is wet, over what was deposited; of pigments the worst.
Dumps live in a temporary folder (TMPDIR). Needs Pillow.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

SCHEMES = ("conservative", "paper")


def painted(command, log, scheme, folder):
    """The picture, and the accounts of medium and of the worst pigment."""
    path = f"{folder}/{scheme}.png"
    report = json.loads(subprocess.run([command, "render", log, "--scheme", scheme, "--quiet", "--json", "-o", path],
                                       check=True, stdout=subprocess.PIPE, text=True).stdout)
    pigments = [p["relative_difference"] for p in report["paint"]["pigments"] if p["relative_difference"] is not None]
    account = report["paint"]["medium"]["relative_difference"], max(pigments, key=abs, default=0)
    return Image.open(path).convert("RGB"), account


def main(arguments):
    if len(arguments) < 3:
        sys.exit(__doc__)
    command, out, *logs = arguments
    print("| sample | medium, `conservative` | medium, `paper` | pigment, `conservative` | pigment, `paper` |")
    print("|---|---|---|---|---|")
    for log in logs:
        name = pathlib.Path(log).stem.removesuffix(".jsonl")
        with tempfile.TemporaryDirectory() as folder:
            (left, ours), (right, published) = (painted(command, log, scheme, folder) for scheme in SCHEMES)
        sheet = Image.new("RGB", (left.width + right.width, left.height))
        sheet.paste(left, (0, 0))
        sheet.paste(right, (left.width, 0))
        sheet.save(f"{out}/scheme-{name}.jpg", quality=75)
        print(f"| {name} | " + " | ".join(f"{account:.1e}" if abs(account) < 1e-3 else f"{account:.2g}"
                                          for account in (ours[0], published[0], ours[1], published[1])) + " |", flush=True)


main(sys.argv[1:])
