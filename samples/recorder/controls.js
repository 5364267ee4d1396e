// The controls of the page: they show the settings and change them.
(function (R) {
  "use strict";

  const $ = (id) => document.getElementById(id);

  // The slider of the size goes evenly from 3 mm to 150 mm in ratio.
  const LEAST_M = 0.003, MOST_M = 0.15;
  const sizeOf = (position) => R.round(LEAST_M * Math.pow(MOST_M / LEAST_M, position / 100), 1e4);
  const positionOf = (size_m) => (100 * Math.log(size_m / LEAST_M)) / Math.log(MOST_M / LEAST_M);

  class Controls {
    // settings: those of the session. actions: {changed, undo, redo, dry, clear, mark, light, gravity,
    // save, fresh}.
    constructor(settings, actions) {
      this.settings = settings;
      this.actions = actions;
      this.addBrushes();
      this.addPalette();
      this.addSliders();
      this.addButtons();
      this.addLamp();
      this.addKeys();
      this.show();
    }

    addBrushes() {
      for (const name of Object.keys(R.paints.brushes)) $("brush").add(new Option(name, name));
      $("brush").addEventListener("change", () => {
        this.settings.brush = $("brush").value;
        this.actions.changed();
      });
    }

    addPalette() {
      for (const pigment of R.paints.pigments) {
        const swatch = document.createElement("button");
        swatch.type = "button";
        swatch.setAttribute("role", "radio");
        swatch.title = pigment.name;
        swatch.setAttribute("aria-label", pigment.name);
        swatch.dataset.pigment = pigment.name;
        const mass = R.passColor(pigment).map(Math.round).join();
        swatch.style.background = "linear-gradient(135deg, " + pigment.overWhite + ", rgb(" + mass + ") 60%)";
        swatch.addEventListener("click", () => this.take(R.pigmentColor(pigment.name), pigment.name));
        $("palette").append(swatch);
      }
      $("palette").addEventListener("keydown", (e) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[e.key];
        const swatches = [...$("palette").children];
        const next = swatches[swatches.indexOf(document.activeElement) + step];
        if (!step || !next) return;
        next.focus();
        next.click();
        e.preventDefault();
      });
      $("picked").addEventListener("input", () => this.take(R.pickedColor($("picked").value), $("picked").value));
    }

    take(color, name) {
      this.settings.color = color;
      this.actions.changed();
      this.show();
      this.say(name);
    }

    addSliders() {
      $("size").addEventListener("input", () => this.slide("size", sizeOf(Number($("size").value))));
      for (const name of ["medium", "pigment", "load", "pickup"])
        $(name).addEventListener("input", () => this.slide(name, Number($(name).value)));
    }

    slide(name, value) {
      this.settings[name] = value;
      this.actions.changed();
      this.show();
    }

    addButtons() {
      const press = (id, action) => $(id).addEventListener("click", () => action());
      press("undo", this.actions.undo);
      press("redo", this.actions.redo);
      press("do-dry", this.actions.dry);
      press("mark", this.actions.mark);
      press("clear", this.actions.clear);
      press("new", this.actions.fresh);
      press("save", this.actions.save);
      press("gravity", this.actions.gravity);
      press("more", () => {
        $("panel").hidden = !$("panel").hidden;
        $("more").setAttribute("aria-expanded", String(!$("panel").hidden));
        window.dispatchEvent(new Event("resize"));
      });
    }

    addLamp() {
      const lamp = $("lamp");
      this.lampAt = { x: -0.55, y: -0.55 };
      const set = (x, y) => {
        const norm = Math.max(1, Math.hypot(x, y));
        this.lampAt = { x: x / norm, y: y / norm };
        this.actions.light(this.lampAt.x, this.lampAt.y);
        this.show();
      };
      const point = (e) => {
        const box = lamp.getBoundingClientRect();
        set((2 * (e.clientX - box.left)) / box.width - 1, (2 * (e.clientY - box.top)) / box.height - 1);
      };
      lamp.addEventListener("pointerdown", (e) => {
        lamp.setPointerCapture(e.pointerId);
        point(e);
      });
      lamp.addEventListener("pointermove", (e) => {
        if (lamp.hasPointerCapture(e.pointerId)) point(e);
      });
      lamp.addEventListener("keydown", (e) => {
        const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
        if (!step) return;
        set(this.lampAt.x + 0.15 * step[0], this.lampAt.y + 0.15 * step[1]);
        e.preventDefault();
      });
    }

    addKeys() {
      const keys = { z: "undo", y: "redo", d: "dry", m: "mark", s: "save" };
      document.addEventListener("keydown", (e) => {
        if (e.altKey || $("left-over").open || e.target.tagName === "SELECT") return;
        const key = e.key.toLowerCase(), control = e.ctrlKey || e.metaKey;
        if (control && !"zys".includes(key)) return; // the browser's own, such as a bookmark
        const action = control && e.shiftKey && key === "z" ? "redo" : keys[key];
        if (action) {
          this.actions[action]();
          e.preventDefault();
        } else if (e.key === "[" || e.key === "]") {
          const by = e.key === "[" ? -3 : 3;
          this.slide("size", sizeOf(Math.min(100, Math.max(0, positionOf(this.settings.size) + by))));
        }
      });
    }

    show() {
      const { settings } = this;
      $("brush").value = settings.brush;
      $("size").value = positionOf(settings.size);
      $("size-text").textContent = Math.round(settings.size * 1000) + " mm";
      for (const name of ["medium", "pigment", "load", "pickup"]) {
        $(name).value = settings[name];
        $(name + "-text").textContent = Math.round(settings[name] * 100) + " %";
      }
      for (const swatch of $("palette").children) {
        const chosen = swatch.dataset.pigment === settings.color.pigment;
        swatch.setAttribute("aria-checked", String(chosen));
        swatch.tabIndex = chosen ? 0 : -1;
      }
      const dot = $("lamp").firstElementChild;
      dot.style.left = 50 + 40 * this.lampAt.x + "%";
      dot.style.top = 50 + 40 * this.lampAt.y + "%";
    }

    // A word to the painter, under the canvas.
    say(text) {
      $("status").textContent = text;
    }
  }

  R.Controls = Controls;
})((window.Recorder = window.Recorder || {}));
