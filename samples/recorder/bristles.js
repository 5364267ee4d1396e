// How the preview paints: a tuft of bristles that each draw a line, run dry one by one, and take up
// the wet paint that they meet. It feels like paint; the real thing is the replay's.
(function (R) {
  "use strict";

  const CHORD = 0.12; // of the diameter: the step along the path
  const TURN = 0.25; // of the diameter: way over which an edge turns with the stroke
  const FULL = 0.2; // of the capacity: so far a stroke is full ...
  const EMPTY = 0.7; // ... and here the last bristle is dry
  const EDGE = 0.86; // of the diameter: so wide is the mark of an edge
  const DISC = 0.85; // ... and of a disc
  const DISC_DEPTH = 0.6; // of a disc's width: bristles drag behind
  const EDGE_DEPTH = 0.12; // of the radius: half the length of an edge along the stroke
  const LEAN_STRETCH = 0.5, LEAN_SHIFT = 0.25, LOWEST_TILT = 1.4; // as of core/brush/tip_pose.h
  const PAPER = 245; // of 255, as the replay shows it
  const PICKED_UP = 0.04; // share of wet paint in the brush, after a diameter of way at full pickup
  const FRESH_ALPHA = 0.92; // of a bristle's mark; what is left lets the marks below show

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

  const clamp01 = (v) => Math.min(1, Math.max(0, v));
  const toLinear = (v) => (v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4));
  const toSrgb = (v) => (v <= 0.0031308 ? v * 12.92 : 1.055 * Math.pow(v, 1 / 2.4) - 0.055);
  const CODE_LINEAR = Array.from({ length: 256 }, (_, code) => toLinear(code / 255));
  const channels = (hex) => [1, 3, 5].map((at) => toLinear(parseInt(hex.slice(at, at + 2), 16) / 255));

  // What the replay shows of paint, fitted to one pass of twelve pigments over white, blue and yellow
  // (to 3 of 255): gloss over a coat whose light over the ground G is black + (white - black) G.
  const GLOSS = 0.0275, BODY = 0.979, LIGHTER = 0.79, DEEPER = 1.19;
  const FITTED_FLOW = 0.79, FITTED_PIGMENT = 0.7; // of that pass

  // The two ends of a coat, linear light: over white and over black.
  function coatOf(pigment) {
    const white = channels(pigment.overWhite), black = channels(pigment.overBlack);
    return {
      white: white.map((w, c) => LIGHTER * Math.pow(w, DEEPER) + (1 - LIGHTER) * black[c]),
      black,
    };
  }

  // A coat of a colour that covers.
  const coatOfHex = (hex) => coatOf({ overWhite: hex, overBlack: hex });

  // What a coat of `thickness` passes shows over a ground, both linear light.
  function shown({ white, black }, ground, thickness) {
    return white.map((w, c) => {
      const through = Math.min(0.999, Math.max(1e-4, w - black[c]));
      const passed = Math.pow(through, thickness);
      return GLOSS + BODY * ((black[c] * (1 - passed)) / (1 - through) + passed * ground[c]);
    });
  }

  // The ground that shows as this colour.
  const groundOf = (linear) => linear.map((v) => clamp01((v - GLOSS) / BODY));
  const codesOf = (linear) => linear.map((v) => 255 * toSrgb(clamp01(v)));

  // The colour of a pass on white, 0..255.
  const passColor = (pigment) => codesOf(shown(coatOf(pigment), [1, 1, 1], 1));

  // How the pen's lean moves and stretches the tip, and where its axis points, as on the replay.
  function poseOf(point, heading, diameter) {
    const slope = (deg) => Math.tan(Math.min(LOWEST_TILT, Math.max(-LOWEST_TILT, ((deg || 0) * Math.PI) / 180)));
    const x = slope(point.tiltX), y = slope(point.tiltY), norm = Math.sqrt(1 + x * x + y * y);
    const lean = { x: x / norm, y: y / norm }, size = Math.hypot(lean.x, lean.y);
    const along = size > 0 ? { x: lean.x / size, y: lean.y / size } : { x: 1, y: 0 };
    const stretch = 1 + LEAN_STRETCH * size;
    const turn = ((point.twist || 0) * Math.PI) / 180, c = Math.cos(turn), s = Math.sin(turn);
    const axis = { x: heading.x * c - heading.y * s, y: heading.x * s + heading.y * c };
    return {
      x: point.x + LEAN_SHIFT * diameter * lean.x,
      y: point.y + LEAN_SHIFT * diameter * lean.y,
      // From the tip's own axes, in radii, to the canvas.
      place(bristle, radius) {
        const px = radius * (bristle.along * axis.x - bristle.across * axis.y);
        const py = radius * (bristle.along * axis.y + bristle.across * axis.x);
        const a = (px * along.x + py * along.y) * (stretch - 1 / stretch);
        return { x: this.x + px / stretch + along.x * a, y: this.y + py / stretch + along.y * a };
      },
    };
  }

  // What lies on the canvas in a box: wet paint over dry paint over paper.
  class Ground {
    constructor(wet, dry, left, top, width, height) {
      this.left = Math.floor(left);
      this.top = Math.floor(top);
      this.width = Math.max(1, Math.ceil(width));
      this.height = Math.max(1, Math.ceil(height));
      this.wet = wet.getImageData(this.left, this.top, this.width, this.height).data;
      this.dry = dry.getImageData(this.left, this.top, this.width, this.height).data;
    }
    // Index of the pixel; -1 outside.
    at({ x, y }) {
      const u = Math.round(x) - this.left, v = Math.round(y) - this.top;
      return u < 0 || v < 0 || u >= this.width || v >= this.height ? -1 : 4 * (v * this.width + u);
    }
    // Linear light; bare paper is white.
    ground(place) {
      const i = this.at(place);
      const wet = i < 0 ? 0 : this.wet[i + 3] / 255, dry = i < 0 ? 0 : this.dry[i + 3] / 255;
      if (wet === 0 && dry === 0) return [1, 1, 1];
      const linear = [0, 1, 2].map((c) => {
        const below = dry * this.dry[i + c] + (1 - dry) * PAPER;
        return CODE_LINEAR[Math.round(wet * this.wet[i + c] + (1 - wet) * below)];
      });
      return groundOf(linear);
    }
    // The wet paint there as a coat that covers, or null.
    wetPaint(place) {
      const i = this.at(place);
      if (i < 0 || this.wet[i + 3] < 40) return null;
      return groundOf([0, 1, 2].map((c) => CODE_LINEAR[this.wet[i + c]]));
    }
  }

  class Tuft {
    // settings: {brush, size, pigment, medium, load, pickup, coat}; perMetre: pixels.
    constructor(settings, seed, perMetre) {
      this.settings = settings;
      this.brush = R.paints.brushes[settings.brush];
      this.perMetre = perMetre;
      this.way = 0; // in diameters
      this.heading = null;
      const next = random(seed);
      const wide = this.brush.wide || 1;
      this.bristles = [];
      for (let i = 0; i < this.brush.count; ++i) {
        const around = 2 * Math.PI * next();
        const out = DISC * wide * Math.sqrt(next());
        const edge = this.brush.tip === "edge";
        this.bristles.push({
          across: edge ? EDGE * (2 * ((i + next()) / this.brush.count) - 1) : out * Math.cos(around),
          along: edge ? 2 * EDGE_DEPTH * (next() - 0.5) : DISC_DEPTH * out * Math.sin(around),
          dry: FULL + (EMPTY - FULL) * next(), // when it has no paint left, of the capacity
          reach: 0.55 * next() * next(), // the pressure that it needs
          shade: 10 * (next() - 0.5),
          white: settings.coat.white.slice(),
          black: settings.coat.black.slice(),
          at: null,
          ahead: [], // grounds that it comes to, and after which way
        });
      }
      // Half the tip's length along the stroke, of the radius.
      this.front = this.brush.tip === "edge" ? EDGE_DEPTH : DISC * DISC_DEPTH * wide;
    }

    // Draws one straight piece; points are {x, y, pressure, tiltX, tiltY, twist}, places in pixels and
    // angles in degrees. wet, dry: contexts.
    line(wet, dry, from, to, light) {
      const diameter = this.settings.size * this.perMetre;
      const length = Math.hypot(to.x - from.x, to.y - from.y);
      const chords = Math.max(1, Math.ceil(length / (CHORD * diameter)));
      for (let i = 1; i <= chords; ++i) {
        const u = i / chords, point = {};
        for (const key of ["x", "y", "pressure", "tiltX", "tiltY", "twist"]) point[key] = from[key] + u * (to[key] - from[key]);
        this.chord(wet, dry, point, (to.x - from.x) / (length || 1), (to.y - from.y) / (length || 1), length / chords, diameter, light);
      }
    }

    chord(wet, dry, point, dx, dy, length, diameter, light) {
      this.turn(dx, dy, length / diameter);
      const { brush, settings } = this;
      const size = diameter * (1 - brush.sizePressure * (1 - point.pressure));
      const radius = size / 2, width = brush.mark * size * 1.3;
      this.way += length / diameter;
      const pose = poseOf(point, this.heading, size);
      if (settings.brush === "rag") return this.wipe(wet, pose, radius, point.pressure);
      const used = this.way / (brush.capacity * Math.max(0.05, settings.load));
      const flow = 1 - brush.flowPressure * (1 - point.pressure);
      const thickness = (flow / FITTED_FLOW) * (settings.pigment / FITTED_PIGMENT);
      const reach = 2.6 * radius + width + 2;
      const ground = new Ground(wet, dry, pose.x - reach, pose.y - reach, 2 * reach, 2 * reach);
      const share = Math.min(0.5, (PICKED_UP * settings.pickup * length) / diameter);
      for (const bristle of this.bristles) {
        const last = bristle.at;
        bristle.at = pose.place(bristle, radius);
        this.look(bristle, ground, dx, dy, radius, width, diameter, share);
        if (point.pressure < bristle.reach || (brush.lays && used > bristle.dry)) continue;
        if (!brush.lays && !bristle.carries) continue;
        const color = codesOf(shown(bristle, bristle.ahead[0].ground, thickness));
        this.mark(wet, last || { x: bristle.at.x - 0.01, y: bristle.at.y }, bristle.at, color, bristle.shade, width, light);
      }
    }

    // Looks at the ground before the tip, which no bristle of this stroke has painted yet.
    look(bristle, ground, dx, dy, radius, width, diameter, share) {
      if (bristle.ahead.length === 0) bristle.ahead.push({ due: 0, ground: ground.ground(bristle.at) });
      const back = this.heading.x * dx + this.heading.y * dy < 0;
      const lead = radius * (this.front - (back ? -bristle.along : bristle.along)) + width / 2 + 2;
      const place = { x: bristle.at.x + lead * dx, y: bristle.at.y + lead * dy };
      bristle.ahead.push({ due: this.way + lead / diameter, ground: ground.ground(place) });
      this.meet(bristle, ground.wetPaint(place), share);
      while (bristle.ahead.length > 1 && bristle.ahead[1].due <= this.way) bristle.ahead.shift();
    }

    // A bristle's mark, with a lit and a shaded side.
    mark(wet, from, to, color, shade, width, light) {
      const tone = (by) => "rgb(" + color.map((v) => Math.max(0, Math.min(255, Math.round(v + 0.6 * shade + by)))).join() + ")";
      const lift = 0.35 * width * (0.4 + this.settings.medium);
      wet.lineCap = "round";
      wet.lineWidth = Math.max(0.7, width);
      const stroke = (by, strength, off) => {
        wet.globalAlpha = FRESH_ALPHA * strength;
        wet.strokeStyle = tone(by);
        wet.beginPath();
        wet.moveTo(from.x + off * light.x, from.y + off * light.y);
        wet.lineTo(to.x + off * light.x, to.y + off * light.y);
        wet.stroke();
      };
      if (shade > 2) stroke(-18, 0.3, -lift);
      stroke(0, 0.95, 0);
      if (shade > 2) stroke(18, 0.25, lift);
      wet.globalAlpha = 1;
    }

    // Takes up the wet paint that lies before the tip.
    meet(bristle, met, share) {
      if (!met) return;
      const part = this.brush.lays ? share : bristle.carries ? 0.4 : 1;
      bristle.carries = true;
      for (const end of [bristle.white, bristle.black])
        for (let c = 0; c < 3; ++c) end[c] += part * (met[c] - end[c]);
    }

    wipe(wet, pose, radius, pressure) {
      wet.globalCompositeOperation = "destination-out";
      for (const bristle of this.bristles) {
        const { x, y } = pose.place(bristle, radius);
        wet.globalAlpha = 0.12 * pressure;
        wet.beginPath();
        wet.arc(x, y, 0.3 * radius, 0, 7);
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
  R.coatOf = coatOf;
  R.coatOfHex = coatOfHex;
})((window.Recorder = window.Recorder || {}));
