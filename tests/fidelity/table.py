#!/usr/bin/env python3
"""How faithful posters are: the table of docs/fidelity.md.

    table.py COMMAND RESULTS.jsonl [--scale 2,4,8,16] LOG...

Renders each log on its own grid and at each scale, compares dumps and pictures with `COMMAND compare`
and adds a line per log and scale to RESULTS.jsonl; what is there already is not done again. Each
picture is compared with the tablet's and with that of the scale before. Then prints both tables. Dumps
live in a temporary folder (TMPDIR), one pair at a time. Needs NumPy and Pillow.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

Image.MAX_IMAGE_PIXELS = None


def run(*arguments):
    done = subprocess.run(arguments, stdout=subprocess.PIPE, check=False, text=True)
    if done.returncode not in (0, 1):  # compare: 1 says that they differ
        sys.exit(f"{' '.join(arguments)}: exit code {done.returncode}")
    return json.loads(done.stdout)


def render(command, log, folder, name, scale):
    outputs = [f"{folder}/{name}.h5", f"{folder}/{name}.png"]
    return run(command, "render", log, "--scale", str(scale), "--quiet", "--json",
               "-o", outputs[0], "-o", outputs[1])


def judged(planes):
    """Depth, pigments summed over their layers, the dry relief; not single layers."""
    return [p for p in planes if "relative_l2" in p and not p["name"].startswith("/layers/pigment[")]


def light(path):
    """Mean of the picture in linear light."""
    code = numpy.arange(256) / 255
    linear = numpy.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)
    counts = numpy.array(Image.open(path).convert("RGB").histogram()).reshape(3, 256)
    return (counts @ linear).sum() / counts.sum()


def rms(picture):
    return (sum(p["rms"] ** 2 for p in picture["planes"]) / len(picture["planes"])) ** 0.5


def compare_with_last(command, folder):
    """With the poster of the scale before, if that divides this one; then takes its place."""
    poster, last = (pathlib.Path(folder) / name for name in ("poster.png", "last.png"))
    found = None
    if last.exists():
        picture = run(command, "compare", str(last), str(poster), "--json")
        found = rms(picture) if picture["comparable"] else None
    poster.replace(last)
    return found


def measure(command, log, folder, tablet, scale):
    poster = render(command, log, folder, "poster", scale)
    state = run(command, "compare", f"{folder}/tablet.h5", f"{folder}/poster.h5", "--json")
    picture = run(command, "compare", f"{folder}/tablet.png", f"{folder}/poster.png", "--json")
    planes = judged(state["planes"])
    pigments = [p for p in planes if p["name"].startswith("pigment")]
    depth = next(p for p in planes if p["name"] == "/fluid/depth")
    share = light(f"{folder}/poster.png") / light(f"{folder}/tablet.png")
    return {
        "log": pathlib.Path(log).stem, "scale": scale,
        "depth_l2": depth["relative_l2"],
        "pigment_l2": max((p["relative_l2"] for p in pigments), default=0),
        "worst_block": max(p["worst_block"] for p in planes),
        "same_guide": poster["guide_sha256"] == tablet["state_sha256"],
        "rms": rms(picture), "flip": picture["flip"]["mean"], "light": share,
        "rms_to_last": compare_with_last(command, folder),
        "lock": poster["lock"], "wall_s": poster["wall_s"],
        "peak_memory_bytes": poster["peak_memory_bytes"],
    }


def decibels(value):
    return "" if value is None else f"{-20 * math.log10(value):.1f}" if value > 0 else "inf"


def print_tables(rows):
    rows = sorted(rows, key=lambda r: (r["log"], r["scale"]))
    print("| sample | k | depth, relative L2 | pigments | worst block | guide's hash "
          "| blocks within 1 % before the lock |")
    print("|---|---|---|---|---|---|---|")
    for r in rows:
        print(f"| {r['log']} | {r['scale']} | {r['depth_l2']:.1e} | {r['pigment_l2']:.1e} "
              f"| {r['worst_block']:.1e} | {'the same' if r['same_guide'] else 'ANOTHER'} "
              f"| {100 * r['lock']['within_0.01']:.1f} % |")
    print()
    scales = sorted({r["scale"] for r in rows})
    print("| sample | " + " | ".join(f"k = {k}" for k in scales) + " |")
    print("|---|" + "---|" * len(scales))
    for log in sorted({r["log"] for r in rows}):
        found = {r["scale"]: r for r in rows if r["log"] == log}
        print(f"| {log} | " + " | ".join(picture_text(found.get(k)) for k in scales) + " |")


def picture_text(r):
    """PSNR to the tablet's picture, mean FLIP, light; in brackets the PSNR to the k before."""
    if r is None:
        return ""
    last = decibels(r["rms_to_last"])
    return f"{decibels(r['rms'])}, {r['flip']:.3f}, {r['light']:.4f}" + (f" ({last})" if last else "")


def main(arguments):
    scales = [2, 4, 8, 16]
    if "--scale" in arguments:
        at = arguments.index("--scale")
        scales = [int(k) for k in arguments[at + 1].split(",")]
        del arguments[at:at + 2]
    if len(arguments) < 2:
        sys.exit(__doc__)
    command, results, *logs = arguments
    path = pathlib.Path(results)
    rows = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
    known = {(r["log"], r["scale"]) for r in rows}
    for log in logs:
        wanted = [k for k in scales if (pathlib.Path(log).stem, k) not in known]
        if not wanted:
            continue
        with tempfile.TemporaryDirectory() as folder:
            tablet = render(command, log, folder, "tablet", 1)
            for k in wanted:
                rows.append(measure(command, log, folder, tablet, k))
                with path.open("a") as out:
                    out.write(json.dumps(rows[-1]) + "\n")
    print_tables(rows)


main(sys.argv[1:])
