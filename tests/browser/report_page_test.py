"""The page of a batch's report in a headless Chromium: the keyboard, the filter, the views.

  report_page_test.py COMMAND CHROMIUM
"""

import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HEADER = {"type": "header", "format": "pentimento-log", "version": 1, "canvas": {"width": 0.4, "height": 0.3},
          "grid": {"width": 80, "height": 60}}

# Runs in the page after it has opened: what a reader would do, and what is seen then.
READER = """{
const seen = {};
const key = (name) => document.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));
const shown = () => [...document.querySelectorAll("#rows .id")].map((one) => one.textContent);
const chosen = () => document.querySelector("#rows [aria-selected=true] .id").textContent;
const stage = () => document.getElementById("stage");
const look = (name) => { seen[name] = { shown: shown(), chosen: chosen(), stage: stage() && stage().className }; };
// All at once when everything is loaded: the browser writes the page down soon after, whatever is still to be done.
window.addEventListener("load", () => {
  for (const image of document.images) if (!image.complete || image.naturalWidth === 0) seen.broken = image.src;
  seen.summary = document.getElementById("summary").textContent;
  look("opened");
  key("d"); look("difference"); seen.blend = getComputedStyle(stage().children[1]).mixBlendMode;
  key("f"); look("flicker"); key("g"); look("golden"); key("n"); look("new"); key("s"); look("slider");
  stage().dispatchEvent(new PointerEvent("pointermove", { clientX: stage().getBoundingClientRect().left, bubbles: true }));
  seen.cut = stage().style.getPropertyValue("--cut");
  key("j"); look("next"); key("k"); look("back");
  seen.detail = document.getElementById("detail").textContent;
  key("a"); look("all");
  const filter = document.getElementById("filter");
  filter.value = "fine"; filter.dispatchEvent(new Event("input")); look("filtered");
  document.title = JSON.stringify(seen);
});
}"""


def log(y, pressure=0.8):
    touches = [{"t": 0.1 * k, "type": "touch", "phase": phase, "x": 0.1 + 0.1 * k, "y": y, "pressure": pressure}
               for k, phase in enumerate(("down", "move", "up"))]
    return "".join(json.dumps(line) + "\n" for line in [HEADER, *touches])


def make_report(command, folder):
    """One log that is as it was, one that paints otherwise, one that is broken."""
    for name, y in (("fine", 0.1), ("moved", 0.2), ("broken", 0.1)):
        (folder / f"{name}.jsonl").write_text(log(y))
    manifest = folder / "m.jsonl"
    manifest.write_text("".join(json.dumps({"id": name, "log": f"{name}.jsonl"}) + "\n"
                                for name in ("moved", "fine", "broken")))
    batch = [command, "batch", manifest, "-o", folder / "run", "--golden", folder / "golden", "--states", "--quiet"]
    subprocess.run([*batch, "--update-golden", "begun"], check=True)
    (folder / "moved.jsonl").write_text(log(0.21))
    (folder / "broken.jsonl").write_text("no log\n")
    assert subprocess.run(batch).returncode == 1
    subprocess.run([command, "batch-report", folder / "run", "--html", folder / "html"], stdout=subprocess.DEVNULL)


def read(chromium, folder):
    page = (folder / "html/index.html").read_text()
    (folder / "html/read.html").write_text(page.replace("</body>", f"<script>{READER}</script></body>"))
    told = subprocess.run([chromium, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                           "--virtual-time-budget=8000", "--dump-dom", f"file://{folder}/html/read.html"],
                          check=True, capture_output=True, text=True, timeout=120).stdout
    return json.loads(html.unescape(re.search("<title>(.*?)</title>", told, re.S)[1]))


def check(seen):
    assert "broken" not in seen, seen
    assert seen["summary"] == "3 jobs, 2 failed, 0 not run", seen
    assert seen["opened"] == {"shown": ["moved", "broken"], "chosen": "moved", "stage": "stage slider"}, seen
    for view in ("difference", "flicker", "golden", "new", "slider"):
        assert seen[view]["stage"] == f"stage {view}", (view, seen)
    assert seen["blend"] == "difference" and seen["cut"] == "0%", seen
    assert seen["next"]["chosen"] == "broken" and seen["next"]["stage"] is None, seen
    assert seen["back"]["chosen"] == "moved", seen
    for word in ("the state is not the golden one", "/fluid/depth", "FLIP", "the last run"):
        assert word in seen["detail"], (word, seen["detail"])
    assert seen["all"]["shown"] == ["moved", "fine", "broken"], seen
    assert seen["filtered"]["shown"] == ["fine"], seen


def main():
    command, chromium = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        make_report(command, pathlib.Path(name))
        check(read(chromium, pathlib.Path(name)))
    print("the page shows what it should")


main()
