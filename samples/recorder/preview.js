// The picture while it is painted: a canvas of dry paint under one of wet paint, and the list of
// what was done, so that undo can draw all again.
(function (R) {
  "use strict";

  const SNAPSHOT_EVERY = 20; // units between two kept states of the canvases
  const SNAPSHOTS = 4;
  const NO_SENSOR_PRESSURE = 0.6; // of a finger or a mouse

  const copyOf = (canvas) => {
    const copy = document.createElement("canvas");
    copy.width = canvas.width;
    copy.height = canvas.height;
    copy.getContext("2d").drawImage(canvas, 0, 0);
    return copy;
  };

  // A point of which each property is told by its name.
  const mixed = (of) => ({ x: of("x"), y: of("y"), pressure: of("pressure"), tiltX: of("tiltX"), tiltY: of("tiltY"), twist: of("twist") });

  class Preview {
    constructor(wetCanvas, dryCanvas) {
      this.wetCanvas = wetCanvas;
      this.dryCanvas = dryCanvas;
      this.wet = wetCanvas.getContext("2d", { willReadFrequently: true });
      this.dry = dryCanvas.getContext("2d", { willReadFrequently: true });
      this.light = { x: -0.7, y: -0.7 };
      this.frame = () => this.draw();
      this.resize(1, 1, 1);
    }

    // width, height in pixels; perMetre: pixels.
    resize(width, height, perMetre) {
      for (const canvas of [this.wetCanvas, this.dryCanvas]) {
        canvas.width = width;
        canvas.height = height;
      }
      this.perMetre = perMetre;
      this.units = []; // {kind: "stroke" | "dry" | "clear", ..}
      this.undone = [];
      this.live = new Map(); // id -> stroke
      this.snapshots = [];
      this.seed = 1;
    }

    // The light's direction on the screen, y down.
    setLight(x, y) {
      const norm = Math.hypot(x, y) || 1;
      this.light = { x: x / norm, y: y / norm };
    }

    down(id, sample, settings) {
      const unit = { kind: "stroke", settings, seed: this.seed++, samples: [sample], light: this.light };
      this.begin(unit);
      this.push(unit);
      this.live.set(id, unit);
      this.request();
    }

    move(id, sample) {
      const unit = this.live.get(id);
      if (!unit) return;
      unit.samples.push(sample);
      this.request();
    }

    up(id, sample) {
      this.move(id, sample);
      this.draw();
      const unit = this.live.get(id);
      if (unit) this.finish(unit);
      this.live.delete(id);
    }

    cancel(id) {
      const unit = this.live.get(id);
      if (!unit) return;
      this.live.delete(id);
      this.units = this.units.filter((other) => other !== unit);
      this.redraw();
    }

    act(kind) {
      const unit = { kind };
      this.push(unit);
      this.apply(unit);
    }

    undo() {
      if (this.units.length === 0) return;
      this.undone.push(this.units.pop());
      this.redraw();
    }

    redo() {
      if (this.undone.length === 0) return;
      const unit = this.undone.pop();
      this.units.push(unit);
      this.apply(unit);
    }

    push(unit) {
      this.undone = [];
      if (this.units.length % SNAPSHOT_EVERY === 0 && this.live.size === 0) this.snapshot();
      this.units.push(unit);
    }

    snapshot() {
      this.snapshots.push({ count: this.units.length, wet: copyOf(this.wetCanvas), dry: copyOf(this.dryCanvas) });
      if (this.snapshots.length > SNAPSHOTS) this.snapshots.shift();
    }

    request() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(this.frame);
    }

    draw() {
      this.waiting = false;
      for (const unit of this.live.values()) this.extend(unit);
    }

    point(sample) {
      const pressure = sample.pressure === undefined ? NO_SENSOR_PRESSURE : sample.pressure;
      const { tilt_x = 0, tilt_y = 0, twist = 0 } = sample;
      return { x: sample.x * this.perMetre, y: sample.y * this.perMetre, pressure, tiltX: tilt_x, tiltY: tilt_y, twist };
    }

    begin(unit) {
      unit.tuft = new R.Tuft(unit.settings, unit.seed, this.perMetre);
      unit.drawn = 0; // samples that have been passed
      unit.at = null;
    }

    // Draws what has come since, from the middle between two samples to the next middle.
    extend(unit) {
      for (; unit.drawn + 1 < unit.samples.length; ++unit.drawn) {
        const a = this.point(unit.samples[unit.drawn]), b = this.point(unit.samples[unit.drawn + 1]);
        const middle = mixed((key) => (a[key] + b[key]) / 2);
        this.bend(unit, unit.at || a, a, middle);
        unit.at = middle;
      }
    }

    bend(unit, from, control, to) {
      const steps = Math.hypot(to.x - from.x, to.y - from.y) > 6 ? 6 : 1;
      let last = from;
      for (let i = 1; i <= steps; ++i) {
        const u = i / steps, v = 1 - u;
        const next = mixed((key) => v * v * from[key] + 2 * u * v * control[key] + u * u * to[key]);
        unit.tuft.line(this.wet, this.dry, last, next, unit.light);
        last = next;
      }
    }

    finish(unit) {
      this.extend(unit);
      const end = this.point(unit.samples[unit.samples.length - 1]);
      const from = unit.at || { ...end, x: end.x - 0.1 };
      unit.tuft.line(this.wet, this.dry, from, end, unit.light);
      unit.tuft = null;
    }

    apply(unit) {
      const { width, height } = this.wetCanvas;
      if (unit.kind === "stroke") {
        this.begin(unit);
        this.finish(unit);
      } else if (unit.kind === "dry") {
        this.dry.drawImage(this.wetCanvas, 0, 0);
        this.wet.clearRect(0, 0, width, height);
      } else {
        this.wet.clearRect(0, 0, width, height);
        this.dry.clearRect(0, 0, width, height);
      }
    }

    // From the last kept state on.
    redraw() {
      while (this.snapshots.length > 0 && this.snapshots[this.snapshots.length - 1].count > this.units.length)
        this.snapshots.pop();
      const from = this.snapshots[this.snapshots.length - 1];
      this.apply({ kind: "clear" });
      if (from) {
        this.wet.drawImage(from.wet, 0, 0);
        this.dry.drawImage(from.dry, 0, 0);
      }
      for (const unit of this.units.slice(from ? from.count : 0)) {
        if (unit.tuft) this.begin(unit); // it is being painted: the next frame goes on
        else this.apply(unit);
      }
      this.draw();
    }
  }

  R.Preview = Preview;
})((window.Recorder = window.Recorder || {}));
