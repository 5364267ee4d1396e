// Puts the page together.
(function (R) {
  "use strict";

  const $ = (id) => document.getElementById(id);
  const MOST_PIXELS = 1600; // of the preview's longer side
  const FLAT = { x: 0, y: 0, z: 9.81 };
  const now = () => performance.now();

  const settings = { brush: "flat", color: R.pigmentColor("French Ultramarine"), size: 0.03, medium: 0.5, pigment: 0.7, load: 1, pickup: 0.3 };
  const preview = new R.Preview($("wet"), $("dry"));
  const store = new R.Store();
  const size = { width_m: 1, height_m: 0.75 };
  let session = null;
  let changed = false; // since the last save

  // The largest box of the painting's shape on the stage.
  function fit() {
    const stage = $("stage"), style = getComputedStyle(stage);
    const width = stage.clientWidth - 2 * parseFloat(style.paddingLeft);
    const height = stage.clientHeight - 2 * parseFloat(style.paddingTop);
    const scale = Math.min(width / size.width_m, height / size.height_m);
    $("painting").style.width = scale * size.width_m + "px";
    $("painting").style.height = scale * size.height_m + "px";
  }

  // A canvas of the stage's shape, whose longer side is 1 m.
  function begin(log) {
    size.width_m = log.width_m;
    size.height_m = log.height_m;
    fit();
    const longer = Math.max(size.width_m, size.height_m);
    const box = $("painting").getBoundingClientRect();
    const pixels = Math.min(MOST_PIXELS, Math.max(box.width, box.height) * (window.devicePixelRatio || 1));
    const perMetre = pixels / longer;
    preview.resize(Math.round(size.width_m * perMetre), Math.round(size.height_m * perMetre), perMetre);
    session = new R.Session(log, preview, settings);
    log.onLine = (line) => {
      changed = true;
      store.add(line);
    };
    R.session = session;
  }

  function freshLog() {
    const stage = $("stage");
    const width = Math.max(1, stage.clientWidth - 16), height = Math.max(1, stage.clientHeight - 16);
    const longer = Math.max(width, height);
    return new R.Log(width / longer, height / longer);
  }

  async function fresh() {
    pointers.liftAll(now());
    const log = freshLog();
    begin(log);
    await store.begin(log);
    changed = false;
  }

  async function save() {
    pointers.liftAll(now());
    if (session.log.isEmpty) return controls.say("Nothing is painted yet.");
    const { name, blob } = await session.log.file();
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    changed = false;
    controls.say("Saved " + name + ", " + Math.ceil(blob.size / 1024) + " kB");
  }

  // A screen that goes dark ends a stroke.
  async function keepAwake() {
    try {
      if (navigator.wakeLock && !document.hidden) await navigator.wakeLock.request("screen");
    } catch {
      // Low battery or no permission: the screen behaves as always.
    }
  }

  const sink = {
    down(id, sample, clock_ms) {
      if (session.log.isEmpty) keepAwake();
      session.down(id, sample, clock_ms);
    },
    move: (...of) => session.move(...of),
    up: (...of) => session.up(...of),
    cancel: (...of) => session.cancel(...of),
  };
  const pointers = new R.Pointers($("wet"), size, sink);
  const gravity = new R.Gravity((reading, clock_ms) => session.gravity(reading, clock_ms));

  const act = (type) => () => session.act(type, now());
  const controls = new R.Controls(settings, {
    changed: () => session && session.settingsChanged(now()),
    undo: act("undo"),
    redo: act("redo"),
    dry: () => {
      session.act("dry", now());
      controls.say("The paint is dry.");
    },
    clear: act("clear"),
    mark: () => controls.say("Marked: " + session.mark(now())),
    light: (x, y) => session.light(x, y, now()),
    gravity: async () => {
      let problem = "";
      if (gravity.on) {
        gravity.stop();
        session.gravity(FLAT, now()); // else the last reading would hold
      } else problem = await gravity.start();
      $("gravity").setAttribute("aria-pressed", String(gravity.on));
      controls.say(problem || (gravity.on ? "Paint will run as you hold the tablet." : "The canvas lies flat."));
    },
    save,
    fresh: () => {
      if (!changed || confirm("Begin anew? What is not saved is lost.")) fresh();
    },
  });

  // The ring shows how wide the brush is.
  function ring(e) {
    const box = $("painting").getBoundingClientRect();
    const diameter = (settings.size * box.width) / size.width_m;
    const style = $("ring").style;
    style.width = style.height = diameter + "px";
    style.left = e.clientX - box.left + "px";
    style.top = e.clientY - box.top + "px";
    $("ring").hidden = e.pointerType === "touch";
  }
  $("wet").addEventListener("pointermove", ring);
  $("wet").addEventListener("pointerleave", () => ($("ring").hidden = true));

  async function offerLeftOver() {
    const left = await store.left();
    if (!left) return false;
    $("left-when").textContent = new Date(left.recordedAt).toLocaleString();
    $("left-strokes").textContent = left.lines.filter((line) => line.includes('"down"')).length;
    $("left-over").showModal();
    await new Promise((resolve) => $("left-over").addEventListener("close", resolve, { once: true }));
    const log = new R.Log(left.width_m, left.height_m);
    log.recordedAt = left.recordedAt;
    begin(log);
    for (const line of session.restore(left.lines)) store.add(line);
    if (left.lines.some((line) => line.includes('"gravity"'))) session.gravity(FLAT, now());
    changed = true;
    controls.show();
    if ($("left-over").returnValue !== "save") return true;
    await save();
    return false;
  }

  addEventListener("resize", fit);
  addEventListener("beforeunload", (e) => {
    store.flush();
    if (changed && store.problem) e.preventDefault();
  });
  document.addEventListener("visibilitychange", () => {
    if (session && !session.log.isEmpty) keepAwake();
  });

  (async () => {
    begin(freshLog());
    store.onProblem = (problem) => controls.say(problem);
    await store.open();
    if (!(await offerLeftOver())) await fresh();
    controls.say(store.problem || "Paint: this browser keeps what you paint.");
    R.ready = true;
  })();
})((window.Recorder = window.Recorder || {}));
