// How the preview paints: a tuft of bristles that each draw a line, run dry one by one, and take up
// the wet paint that they meet. It feels like paint; the real thing is the replay's.
(function (R) {
  "use strict";

  const CHORD = 0.12; // of the diameter: the step along the path
  const TURN = 0.25; // of the diameter: way over which an edge turns with the stroke
  const FULL = 0.2; // of the capacity: so far a stroke is full ...
  const EMPTY = 0.7; // ... and here the last bristle is dry

  // A small generator of even numbers 0..1, so that a redrawn stroke is the same stroke.
  function random(seed) {
    let state = (seed * 2654435761 + 1) >>> 0;
    return () => {
      state = (state + 0x6d2b79f5) >>> 0;
      let t = Math.imul(state ^ (state >>> 15), state | 1);
      t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
      return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
  }

  const toLinear = (v) => (v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4));
  const toSrgb = (v) => (v <= 0.0031308 ? v * 12.92 : 1.055 * Math.pow(v, 1 / 2.4) - 0.055);
  const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);

  const EDGE = 0.8; // of the diameter: so wide is the mark of an edge

  // The colour of a pass of paint, 0..255: what the replay shows of one pass on white.
  function passColor(pigment) {
    const white = channels(pigment.overWhite).map(toLinear);
    const black = channels(pigment.overBlack).map(toLinear);
    return white.map((w, c) => 255 * toSrgb(0.85 * Math.pow(w, 1.08) + 0.15 * black[c]));
  }

  class Tuft {
    // settings: {brush, size, pigment, medium, load, pickup, rgb}; perMetre: pixels.
    constructor(settings, seed, perMetre) {
      this.settings = settings;
      this.brush = R.paints.brushes[settings.brush];
      this.perMetre = perMetre;
      this.way = 0; // in diameters
      this.heading = null;
      const next = random(seed);
      this.bristles = [];
      for (let i = 0; i < this.brush.count; ++i) {
        const around = 2 * Math.PI * next();
        const out = Math.sqrt(next());
        const edge = this.brush.tip === "edge";
        this.bristles.push({
          across: edge ? EDGE * (2 * ((i + next()) / this.brush.count) - 1) : 0.9 * out * Math.cos(around),
          along: edge ? 0.24 * (next() - 0.5) : 0.9 * out * Math.sin(around),
          dry: FULL + (EMPTY - FULL) * next(), // when it has no paint left, of the capacity
          reach: 0.55 * next() * next(), // the pressure that it needs
          shade: 10 * (next() - 0.5),
          rgb: settings.rgb.slice(),
          at: null,
        });
      }
    }

    // Draws one straight piece; points are {x, y, pressure} in pixels. wet, dry: contexts.
    line(wet, dry, from, to, light) {
      const diameter = this.settings.size * this.perMetre;
      const length = Math.hypot(to.x - from.x, to.y - from.y);
      const chords = Math.max(1, Math.ceil(length / (CHORD * diameter)));
      for (let i = 1; i <= chords; ++i) {
        const u = i / chords;
        this.chord(wet, dry, {
          x: from.x + u * (to.x - from.x),
          y: from.y + u * (to.y - from.y),
          pressure: from.pressure + u * (to.pressure - from.pressure),
        }, (to.x - from.x) / (length || 1), (to.y - from.y) / (length || 1), length / chords, diameter, light);
      }
    }

    chord(wet, dry, point, dx, dy, length, diameter, light) {
      this.turn(dx, dy, length / diameter);
      const { brush, settings } = this;
      const size = diameter * (1 - brush.sizePressure * (1 - point.pressure));
      const radius = size / 2;
      this.way += length / diameter;
      const used = this.way / (brush.capacity * Math.max(0.05, settings.load));
      const flow = 1 - brush.flowPressure * (1 - point.pressure);
      if (settings.pickup > 0 || !brush.lays) this.meet(wet, point, radius, length / diameter);
      if (settings.brush === "rag") return this.wipe(wet, point, radius);
      const alpha = Math.min(1, (0.15 + 1.1 * settings.pigment) * (0.45 + 0.55 * flow));
      for (const bristle of this.bristles) {
        const x = point.x + radius * (bristle.across * -this.heading.y + bristle.along * this.heading.x);
        const y = point.y + radius * (bristle.across * this.heading.x + bristle.along * this.heading.y);
        const last = bristle.at;
        bristle.at = { x, y };
        if (point.pressure < bristle.reach || (brush.lays && used > bristle.dry)) continue;
        if (!brush.lays && !bristle.carries) continue;
        this.mark(wet, last || { x: x - 0.01, y }, { x, y }, bristle, brush.mark * size * 1.3, alpha, light);
      }
    }

    // A bristle's mark, with a lit and a shaded side.
    mark(wet, from, to, bristle, width, alpha, light) {
      const tone = (by) =>
        "rgb(" + bristle.rgb.map((v) => Math.max(0, Math.min(255, Math.round(v + bristle.shade + by)))).join() + ")";
      const lift = 0.35 * width * (0.4 + this.settings.medium);
      wet.lineCap = "round";
      wet.lineWidth = Math.max(0.7, width);
      const stroke = (by, strength, off) => {
        wet.globalAlpha = alpha * strength;
        wet.strokeStyle = tone(by);
        wet.beginPath();
        wet.moveTo(from.x + off * light.x, from.y + off * light.y);
        wet.lineTo(to.x + off * light.x, to.y + off * light.y);
        wet.stroke();
      };
      if (bristle.shade > 2) stroke(-26, 0.35, -lift);
      stroke(0, 0.9, 0);
      if (bristle.shade > 2) stroke(30, 0.3, lift);
      wet.globalAlpha = 1;
    }

    // Takes up what wet paint lies under the tip, each bristle at its own place.
    meet(wet, point, radius, way) {
      this.since = (this.since || 0) + way;
      if (this.since < 0.2) return;
      const share = Math.min(0.5, this.settings.pickup * this.since * 1.2);
      this.since = 0;
      const left = Math.floor(point.x - radius), top = Math.floor(point.y - radius);
      const side = Math.max(1, Math.ceil(2 * radius));
      const pixels = wet.getImageData(left, top, side, side).data;
      for (const bristle of this.bristles) {
        if (!bristle.at) continue;
        const x = Math.round(bristle.at.x) - left, y = Math.round(bristle.at.y) - top;
        if (x < 0 || y < 0 || x >= side || y >= side) continue;
        const at = 4 * (y * side + x);
        if (pixels[at + 3] < 40) continue;
        const part = this.brush.lays ? share : bristle.carries ? 0.4 : 1;
        bristle.carries = true;
        for (let c = 0; c < 3; ++c) bristle.rgb[c] += part * (pixels[at + c] - bristle.rgb[c]);
      }
    }

    wipe(wet, point, radius) {
      wet.globalCompositeOperation = "destination-out";
      for (const bristle of this.bristles) {
        wet.globalAlpha = 0.12 * point.pressure;
        wet.beginPath();
        wet.arc(point.x + radius * bristle.across, point.y + radius * bristle.along, 0.3 * radius, 0, 7);
        wet.fill();
      }
      wet.globalAlpha = 1;
      wet.globalCompositeOperation = "source-over";
    }

    turn(dx, dy, way) {
      if (!this.heading) {
        this.heading = dx || dy ? { x: dx, y: dy } : { x: 1, y: 0 };
        return;
      }
      // An edge is the same back and forth.
      const side = this.heading.x * dx + this.heading.y * dy < 0 ? -1 : 1;
      const k = Math.min(1, way / TURN);
      const x = this.heading.x + k * (side * dx - this.heading.x);
      const y = this.heading.y + k * (side * dy - this.heading.y);
      const norm = Math.hypot(x, y);
      if (norm > 0) this.heading = { x: x / norm, y: y / norm };
    }
  }

  R.Tuft = Tuft;
  R.passColor = passColor;
})((window.Recorder = window.Recorder || {}));
