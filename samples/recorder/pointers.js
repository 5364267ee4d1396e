// From pointer events to samples of strokes: places on the canvas in metres, pressure where the
// device has a sensor, tilt and twist of pens. Pointers get the smallest free id, at most 64.
(function (R) {
  "use strict";

  const MOST = 64;
  // A device without a sensor reports one of these, and nothing else.
  const CONSTANT_PRESSURES = new Set([0, 0.5, 1]);

  class Pointers {
    // element: the canvas; size: {width_m, height_m}; sink: {down, move, up, cancel}, called with
    // (id, sample, clock_ms).
    constructor(element, size, sink) {
      this.element = element;
      this.size = size;
      this.sink = sink;
      this.open = new Map(); // pointerId -> {id, last}
      this.sensor = { pen: true, touch: false, mouse: false }; // who has told a pressure
      const on = (type, handler) => element.addEventListener(type, handler);
      on("pointerdown", (e) => this.down(e));
      on("pointermove", (e) => this.move(e));
      on("pointerup", (e) => this.end(e, "up"));
      on("pointercancel", (e) => this.end(e, "cancel"));
      on("lostpointercapture", (e) => this.end(e, "up"));
      on("contextmenu", (e) => e.preventDefault());
      document.addEventListener("visibilitychange", () => {
        if (document.hidden) this.liftAll(performance.now());
      });
      window.addEventListener("pagehide", () => this.liftAll(performance.now()));
    }

    get count() {
      return this.open.size;
    }

    sample(e) {
      const box = this.element.getBoundingClientRect();
      const out = {
        x: R.round(((e.clientX - box.left) / box.width) * this.size.width_m, 1e7),
        y: R.round(((e.clientY - box.top) / box.height) * this.size.height_m, 1e7),
      };
      const kind = e.pointerType in this.sensor ? e.pointerType : "mouse";
      if (kind === "touch" && !CONSTANT_PRESSURES.has(e.pressure)) this.sensor.touch = true;
      if (this.sensor[kind]) out.pressure = R.round(Math.min(1, Math.max(0, e.pressure)), 1e5);
      if (kind === "pen") this.addAngles(e, out);
      return out;
    }

    addAngles(e, out) {
      if (e.tiltX || e.tiltY || this.tilts) {
        this.tilts = true;
        out.tilt_x = R.round(e.tiltX, 100);
        out.tilt_y = R.round(e.tiltY, 100);
      }
      if (e.twist || this.twists) {
        this.twists = true;
        out.twist = R.round(e.twist, 100);
      }
    }

    freeId() {
      const used = new Set([...this.open.values()].map((pointer) => pointer.id));
      let id = 0;
      while (used.has(id)) ++id;
      return id;
    }

    down(e) {
      if (e.pointerType === "mouse" && e.button !== 0) return;
      e.preventDefault();
      if (this.open.has(e.pointerId)) this.end(e, "up");
      if (this.open.size >= MOST) return;
      try {
        this.element.setPointerCapture(e.pointerId);
      } catch {
        // The pointer is gone already; its up comes or the page's end lifts it.
      }
      const pointer = { id: this.freeId(), last: this.sample(e) };
      this.open.set(e.pointerId, pointer);
      this.sink.down(pointer.id, pointer.last, e.timeStamp);
    }

    // Browsers deliver what a fast pen measured between two frames as one event with parts. The
    // parts' own pointerId is wrong in some browsers: the parent's counts.
    move(e) {
      const pointer = this.open.get(e.pointerId);
      if (!pointer) return;
      const parts = e.getCoalescedEvents ? e.getCoalescedEvents() : [];
      for (const part of parts.length > 0 ? parts : [e]) {
        const sample = this.sample(part);
        if (JSON.stringify(sample) === JSON.stringify(pointer.last)) continue;
        pointer.last = sample;
        this.sink.move(pointer.id, sample, part.timeStamp || e.timeStamp);
      }
    }

    end(e, phase) {
      const pointer = this.open.get(e.pointerId);
      if (!pointer) return;
      this.open.delete(e.pointerId);
      // A lifted pen presses no more: its last pressure stays.
      const place = phase === "up" && e.type === "pointerup" ? this.sample(e) : pointer.last;
      this.sink[phase](pointer.id, { ...pointer.last, x: place.x, y: place.y }, e.timeStamp);
    }

    liftAll(clock_ms) {
      for (const pointer of this.open.values()) this.sink.up(pointer.id, pointer.last, clock_ms);
      this.open.clear();
    }
  }

  R.Pointers = Pointers;
})((window.Recorder = window.Recorder || {}));
