// One painting: what the hand does goes into the log and onto the preview, settings as far as they
// are others than before.
(function (R) {
  "use strict";

  // Sliders of the log that the page has, with their defaults there.
  const SLIDERS = { size: 0.03, medium: 0.5, pigment: 0.7, load: 1, pickup: 0.3 };

  class Session {
    // settings: {brush, color: {pigment, coat} or {value, coat}, size, medium, ..}, changed by the
    // controls at any time.
    constructor(log, preview, settings) {
      this.log = log;
      this.preview = preview;
      this.settings = settings;
      this.sent = { brush: "round", color: "", ...SLIDERS };
      this.down_ = 0;
      this.marks = 0;
    }

    // Writes the settings that have changed.
    sendSettings(clock_ms) {
      const { settings, sent, log } = this;
      if (settings.brush !== sent.brush) {
        log.add(clock_ms, { type: "brush", name: settings.brush });
        sent.brush = settings.brush;
      }
      for (const name of Object.keys(SLIDERS)) {
        const value = R.round(settings[name], 1e5);
        if (value === sent[name]) continue;
        log.add(clock_ms, { type: "slider", name, value });
        sent[name] = value;
      }
      const { pigment, value } = settings.color;
      if ((pigment || value) === sent.color) return;
      log.add(clock_ms, pigment ? { type: "color", pigment } : { type: "color", value });
      sent.color = pigment || value;
    }

    // What the preview paints with; a copy, as a redrawn stroke must be the same.
    look() {
      const { color, ...rest } = this.settings;
      return { ...rest, coat: color.coat };
    }

    touch(phase, id, sample, clock_ms) {
      this.log.add(clock_ms, { type: "touch", phase, ...(id === 0 ? {} : { id }), ...sample });
    }
    down(id, sample, clock_ms) {
      this.sendSettings(clock_ms);
      this.touch("down", id, sample, clock_ms);
      this.preview.down(id, sample, this.look());
      ++this.down_;
    }
    move(id, sample, clock_ms) {
      this.touch("move", id, sample, clock_ms);
      this.preview.move(id, sample);
    }
    up(id, sample, clock_ms) {
      this.touch("up", id, sample, clock_ms);
      this.preview.up(id, sample);
      --this.down_;
    }
    cancel(id, sample, clock_ms) {
      this.touch("cancel", id, sample, clock_ms);
      this.preview.cancel(id);
      --this.down_;
    }

    // A slider that moves while a stroke is painted acts at once, as on the replay.
    settingsChanged(clock_ms) {
      if (this.down_ > 0) this.sendSettings(clock_ms);
    }

    // dry, clear, undo, redo: not while the hand is down.
    act(type, clock_ms) {
      if (this.down_ > 0) return;
      this.log.add(clock_ms, { type });
      if (type === "undo") this.preview.undo();
      else if (type === "redo") this.preview.redo();
      else this.preview.act(type);
    }

    mark(clock_ms) {
      const name = "mark " + ++this.marks;
      this.log.add(clock_ms, { type: "mark", name });
      return name;
    }

    gravity(reading, clock_ms) {
      this.log.add(clock_ms, { type: "gravity", ...reading });
    }

    // x, y: -1..1 on the screen, y down.
    light(x, y, clock_ms) {
      const flat = Math.min(0.95, Math.hypot(x, y)), norm = Math.hypot(x, y) || 1;
      const direction = [(flat * x) / norm, (-flat * y) / norm, Math.sqrt(1 - flat * flat)];
      this.log.add(clock_ms, { type: "light", direction: direction.map((v) => R.round(v, 1e4) + 0) });
      this.preview.setLight(x, y);
    }

    // Paints the lines of another session again and goes on from there. Strokes that a crash left
    // open are lifted.
    restore(lines) {
      const open = new Map();
      for (const line of lines) this.replay(JSON.parse(line), open);
      const kept = lines.slice();
      const end_s = lines.length > 0 ? JSON.parse(lines[lines.length - 1]).t : 0;
      for (const [id, { x, y }] of open) {
        this.preview.up(id, { x, y });
        kept.push(JSON.stringify({ t: end_s, type: "touch", phase: "up", ...(id ? { id } : {}), x, y }));
      }
      this.log.restore(kept);
      return kept.slice(lines.length);
    }

    replay(event, open) {
      const { settings, preview } = this;
      const { t, type, phase, id = 0, ...rest } = event;
      if (type === "touch") {
        if (phase === "down") preview.down(id, rest, this.look());
        else if (phase === "move") preview.move(id, rest);
        else preview[phase](id, rest);
        if (phase === "up" || phase === "cancel") open.delete(id);
        else open.set(id, rest);
      } else if (type === "slider") settings[rest.name] = this.sent[rest.name] = rest.value;
      else if (type === "brush") settings.brush = this.sent.brush = rest.name;
      else if (type === "color") {
        settings.color = rest.pigment ? R.pigmentColor(rest.pigment) : R.pickedColor(rest.value);
        this.sent.color = rest.pigment || rest.value;
      } else if (type === "undo") preview.undo();
      else if (type === "redo") preview.redo();
      else if (type === "dry" || type === "clear") preview.act(type);
      else if (type === "light") preview.setLight(rest.direction[0], -rest.direction[1]);
      else if (type === "mark") ++this.marks;
    }
  }

  R.Session = Session;
  R.pigmentColor = (name) => ({
    pigment: name,
    coat: R.coatOf(R.paints.pigments.find((pigment) => pigment.name === name)),
  });
  R.pickedColor = (value) => ({ value, coat: R.coatOfHex(value) });
})((window.Recorder = window.Recorder || {}));
