"""The text of docs/bench/phases.md, from what report.py measured and the work that phases.json declares."""

BYTES = 4  # of a float: a plane is one float a cell
PROBES = [f"Probe/{kind}/{where}" for where in ("L2", "DRAM") for kind in ("read", "update", "copy", "triad")]
PROBES += ["Probe/add_multiply", "Probe/divide"]
PROBE_BYTES = {"read": 4, "update": 8, "copy": 8, "triad": 12}  # of a float of one plane, as STREAM counts
CANVAS = 1024 * 768
PARTS = "ConservativeStep/1#parts"
# A phase that takes less than this many times its bound is said to be bound by it.
NEAR_BOUND = 1.7

INTRODUCTION = """# Time by phase

`tests/bench/report.py` wrote this page from `docs/bench/measured.json`, which it measured; nothing here is typed by hand.

```sh
./bootstrap bench --report                      # measure, and write this page
./bootstrap bench --report --before PROGRAM     # with the times of an older build beside them, in the same run
./bootstrap bench --check                       # is a phase 15 % behind its stored ratio?
```

"""

MACHINE = """{processor}, {processors} processors, {instruction_set}, {system}. Load while it was measured: {load_before} \
at the start, {load_after} at the end (this measurement is 1 of it), so {busy}. Each time is the least \
processor time of an iteration in {rounds} runs, all benchmarks in turns; the middle one of the runs took {spread} % \
longer, in the middle of all benchmarks.
"""


class Measured:
    """Least times in ns, and the counters."""

    def __init__(self, document, which="now"):
        self.times, self.counters = document.get(which, {}), document["counters"]

    def ns(self, reference):
        entry = self.times.get(reference)
        return entry["best"] if entry else None

    def gbytes_s(self, probe):
        return PROBE_BYTES[probe.split("/")[1]] / self.ns(probe)

    def parts(self):
        return self.counters.get(PARTS, 1)


def number(value):
    if value is None:
        return ""
    if value == 0:
        return "0"
    return f"{value:.3g}" if abs(value) < 1000 else f"{value:,.0f}"


def table(head, rows):
    lines = [f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
    lines += [f"| {' | '.join(cell if isinstance(cell, str) else number(cell) for cell in row)} |" for row in rows]
    return "\n".join(lines) + "\n\n"


def machine(document):
    spread = sorted(100 * (t["median"] / t["best"] - 1) for t in document["now"].values() if t["best"] > 0)
    load = max(document["machine"]["load_before"], document["machine"]["load_after"] - 1)
    busy = "the machine was quiet" if load < 0.5 else "other work shared caches and memory with it"
    return MACHINE.format(**document["machine"], rounds=document["rounds"], busy=busy,
                          spread=number(spread[len(spread) // 2])) + "\n"


def probes(m):
    rows = [[kind, m.gbytes_s(f"Probe/{kind}/L2"), m.gbytes_s(f"Probe/{kind}/DRAM")] for kind in PROBE_BYTES]
    text = "## The probe\n\nWhat one thread gets (`tests/bench/probe_bench.cpp`), GB/s; a byte that is written counts "
    text += "once, as STREAM counts.\n\n"
    text += table(["loop", "second cache", "memory"], rows)
    text += f"Additions and multiplications: {number(1 / m.ns('Probe/add_multiply'))} thousand million a second; "
    text += f"divisions: {number(1 / m.ns('Probe/divide'))}.\n\n"
    return text


def parts_of(phase, m):
    """How often a conservative pass is done in a step: once, or in each part of the step."""
    return m.parts() if phase["phase"].startswith("conservative/") and not phase.get("once") else 1


def phase_row(phase, m, before, with_work):
    ns, against = m.ns(phase["time"]), m.ns(phase.get("against", ""))
    work = phase.get("work")
    row = [f"`{phase['phase'].split('/', 1)[1]}`", ns]
    if before:
        was = before.ns(phase["time"])
        row += [was, f"{number(was / ns)} x" if was and ns else ""]
    if with_work and work is not None and ns:
        planes = (work["read"] + work["written"]) * parts_of(phase, m)
        speed = planes * BYTES / ns
        row += [speed, f"{100 * speed / m.gbytes_s('Probe/triad/DRAM'):.0f} %"]
    elif with_work:
        row += ["", ""]
    row += [ns / against if ns and against else None]
    return row


def phases_table(phases, m, before, with_work):
    head = ["phase", "ns"] + (["before", "faster"] if before else [])
    head += (["GB/s", "of the probe"] if with_work else []) + ["times its twin or probe"]
    return table(head, [phase_row(p, m, before, with_work) for p in phases])


# The groups of phases: the first part of their names, the heading, and what an item is.
GROUPS = [
    ("conservative", "The conservative fluid", "Nanoseconds a cell and step; 1024 x 768 cells, all awake and moving, "
     "2 layers of 4 channels, one thread. GB/s: of the planes that the pass must read and write at least, by the "
     "roofline's count; its share is of the triad from memory. The last column divides by an update of one plane in "
     "place (`Probe/update/DRAM`)."),
    ("paper", "The published fluid", "The same canvas size, layers and channels; nanoseconds a cell and call. A step "
     "has {sweeps} of each sweep, the others once, the two of pigment for each layer. GB/s and the last column as above."),
    ("twin", "Beside their plain twins", "The same work by the plain code that the tests hold the fast code to: "
     "whole batches in flat arrays for paint and momentum, double precision cell by cell for the sky and the light "
     "lock. Nanoseconds a cell, or a pixel of a colour."),
    ("solve", "One V-cycle of the solver", "Six grids, without a caller's stages; nanoseconds a cell."),
    ("brush", "A stamp", "60 cells across on wet paint, 2 layers of 4 channels. Nanoseconds a covered cell and plane "
     "(10 planes). Against an update of a plane in the second cache."),
    ("layers", "What a stamp does to the layers", "Nanoseconds a cell of a row; 2 layers of 4 channels. Against the "
     "same."),
    ("detail", "The detail canvas", "Nanoseconds a fine cell; 8 x 8 fine cells a cell, 2 layers of 2 channels, all "
     "moving. Against an update from memory."),
    ("replay", "Hashes of a step", "Nanoseconds a cell, every tile hashed; 2 layers of 4 channels. Against reading "
     "one plane."),
]


# The groups of which the roofline has all passes.
WITH_WORK = ("conservative", "paper")


def all_phases(phases, m, before):
    text = ""
    for prefix, heading, words in GROUPS:
        group = [p for p in phases if p["phase"].startswith(prefix + "/")]
        if group:
            with_work = prefix in WITH_WORK
            text += f"## {heading}\n\n{words.format(sweeps=4)}\n\n" + phases_table(group, m, before, with_work)
            if prefix == "conservative":
                total = sum(m.ns(p["time"]) or 0 for p in group)
                text += f"Together {number(total)} ns a cell and step, {number(total * CANVAS * 1e-6)} ms for the canvas. "
                text += f"A step was cut into {number(m.parts())} parts on average.\n\n"
    return text


def bounds(work, m):
    """How long the work takes at least by each limit, ns a cell: {limit: ns}."""
    return {
        "memory": (work["read"] + work["written"]) * BYTES / m.gbytes_s("Probe/triad/DRAM"),
        "second cache": work["near"] * BYTES / m.gbytes_s("Probe/triad/L2"),
        "arithmetic": work["operations"] * m.ns("Probe/add_multiply") + work["divisions"] * m.ns("Probe/divide"),
    }


def verdict(ns, limits):
    name, least = max(limits.items(), key=lambda item: item[1])
    if least == 0:
        return ""
    if ns <= NEAR_BOUND * least:
        return name
    return f"none of them ({name} alone: {100 * least / ns:.0f} %)"


def roofline_row(phase, m):
    work = phase["work"]
    ns = (m.ns(phase["time"]) or 0) * phase.get("items", 1) / parts_of(phase, m)
    limits = bounds(work, m)
    if phase.get("near_only"):
        limits["memory"] = 0  # its planes are in the second cache
    moved = (work["read"] + work["written"]) * BYTES
    operations = work["operations"] + work["divisions"]
    return [f"`{phase['phase'].split('/', 1)[1]}`", work["read"] * BYTES, work["written"] * BYTES, work["operations"],
            work["divisions"], operations / moved if moved else None, ns, *limits.values(), verdict(ns, limits)]


ROOFLINE = """## Roofline

What each pass must move and compute for a cell, what the probe allows at best, and which limit it stands at. Bytes
are those between memory and the core if a plane is fetched once in a pass: planes read, planes written, 4 bytes each.
Operations are additions, multiplications, minima, comparisons, selections, shifts and bit operations, one each;
divisions apart. The second cache's limit is that of all rows that the pass's kernels read and write, as often as they
do. All are counted in the source, by hand, and declared in `tests/bench/phases.json`; the last column says how. A pass
within {near} times of its highest limit is said to be bound by it; time beyond that goes into what is not counted:
calls for each row, rows whose ends are no whole vector, loads that straddle cache lines, branches, integers.

"""
ROOFLINES = [
    ("conservative", "The conservative fluid", "For a cell and part of a step."),
    ("paper", "The published fluid", "For a cell and call. What one pass writes the next one may find in the third "
     "cache, so some take less time than memory allows."),
    ("brush", "A stamp", "For a covered cell; its planes lie in the second cache."),
    ("detail", "The detail canvas", "For a fine cell."),
]


def roofline(phases, m):
    text = ROOFLINE.format(near=NEAR_BOUND)
    for prefix, heading, words in ROOFLINES:
        passes = [p for p in phases if "work" in p and p["phase"].startswith(prefix + "/")]
        if not passes:
            continue
        text += f"### Roofline: {heading[0].lower()}{heading[1:]}\n\n{words}\n\n"
        text += table(["pass", "bytes read", "written", "operations", "divisions", "operations a byte", "ns a cell",
                       "memory allows", "second cache", "arithmetic", "bound by", "counted as"],
                      [[*roofline_row(p, m), p["work"]["counted"]] for p in passes])
    return text


FLUIDS = (("conservative", "GrowthConservative"), ("published", "GrowthPaper"))
WET = (0, 128, 256, 512, 1024)
WIDTHS = (256, 512, 1024, 2048)
TWO_THREADS = (1024, 2048)
DETAILS = (1, 2, 4, 8)


def growth_names():
    names = [f"{name}/1024/{wet}/1" for _, name in FLUIDS for wet in WET]
    names += [f"{name}/{width}/{width}/1" for _, name in FLUIDS for width in WIDTHS]
    names += [f"{name}/{width}/{width}/2" for _, name in FLUIDS for width in TWO_THREADS]
    return names + [f"DetailStrokes/{detail}" for detail in DETAILS]


def step_ms(m, name, width, clock=""):
    ns = m.ns(f"{name}{clock}")
    return ns * width * width * 0.75e-6 if ns is not None else None


def growth(m):
    text = ("## How cost grows\n\nMilliseconds of processor time a step, one thread. With a wet corner of a canvas of "
            "1024 x 768 cells; whole tiles are awake, and those that paint runs into:\n\n")
    rows = []
    for wet in WET:
        awake = m.counters.get(f"GrowthConservative/1024/{wet}/1#awake_share")
        rows.append([f"{100 * (wet / 1024) ** 2:.3g} %", f"{100 * awake:.0f} %" if awake is not None else "",
                     *(step_ms(m, f"{name}/1024/{wet}/1", 1024) for _, name in FLUIDS)])
    text += table(["wet", "awake (conservative)", *(fluid for fluid, _ in FLUIDS)], rows)
    text += "With the size of a canvas that is wet all over:\n\n"
    rows = []
    for width in WIDTHS:
        row = [f"{width} x {width * 3 // 4}"]
        for _, name in FLUIDS:
            ms = step_ms(m, f"{name}/{width}/{width}/1", width)
            row += [ms, ms * 1e6 / (width * width * 0.75) if ms else None]
        rows.append(row)
    text += table(["cells", *(f"{fluid}, {what}" for fluid, _ in FLUIDS for what in ("ms", "ns a cell"))], rows)
    text += ("With threads: milliseconds on the clock, and processor time of all threads together. The clock also "
             "counts what other programs take of the processors.\n\n")
    rows = []
    for width in TWO_THREADS:
        for fluid, name in FLUIDS:
            names = [f"{name}/{width}/{width}/{threads}" for threads in (1, 2)]
            rows.append([f"{fluid}, {width} x {width * 3 // 4}", *(step_ms(m, one, width, "@wall") for one in names),
                         *(step_ms(m, one, width) for one in names)])
    text += table(["", "1 thread, clock", "2 threads, clock", "1 thread, processor", "2 threads, processor"], rows)
    text += ("With the detail k: processor time of three crossing strokes on a guide of 256 x 192 cells, all that the "
             "detail canvas does with them.\n\n")
    rows = [[str(detail), (m.ns(f"DetailStrokes/{detail}") or 0) * 1e-6,
             (m.ns(f"DetailStrokes/{detail}") or 0) / (256 * 192 * detail * detail)] for detail in DETAILS]
    return text + table(["k", "ms", "ns a fine cell of the whole canvas"], rows)


def text(phases, document):
    m = Measured(document)
    before = Measured(document, "before") if "before" in document else None
    return (INTRODUCTION + machine(document) + probes(m) + all_phases(phases, m, before) + growth(m)
            + roofline(phases, m)).rstrip() + "\n"
