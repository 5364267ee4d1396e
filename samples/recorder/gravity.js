// How the tablet is held: readings of `devicemotion` as the log wants them, x to the right, y up
// and z out of the screen, flat (0, 0, 9.81).
(function (R) {
  "use strict";

  const SHORTEST_MS = 20; // at most 50 readings a second
  const CHANGE_M_S2 = 0.15; // a hand's tremor is less

  // Safari on iOS reports the opposite sign of what the standard says.
  const isApple = () =>
    /iPad|iPhone|iPod/.test(navigator.userAgent) ||
    (navigator.platform === "MacIntel" && navigator.maxTouchPoints > 1);

  // From the device's axes to those of a screen that is turned by `angle` degrees.
  function turned({ x, y, z }, angle) {
    switch (((angle % 360) + 360) % 360) {
      case 90:
        return { x: -y, y: x, z };
      case 180:
        return { x: -x, y: -y, z };
      case 270:
        return { x: y, y: -x, z };
      default:
        return { x, y, z };
    }
  }

  class Gravity {
    // sink(reading, clock_ms) gets readings that differ.
    constructor(sink) {
      this.sink = sink;
      this.on = false;
      this.last = null;
      this.last_ms = -Infinity;
      this.handler = (e) => this.read(e);
    }

    // Asks for permission where the browser wants that; call it in a tap. Returns what is wrong, or
    // "" if all is well.
    async start() {
      if (typeof DeviceMotionEvent === "undefined") return "This browser has no motion sensor.";
      if (typeof DeviceMotionEvent.requestPermission === "function") {
        try {
          const answer = await DeviceMotionEvent.requestPermission();
          if (answer !== "granted") return "The browser does not allow the motion sensor.";
        } catch (problem) {
          return "The motion sensor cannot be read here: " + problem.message;
        }
      }
      if (!this.on) window.addEventListener("devicemotion", this.handler);
      this.on = true;
      return "";
    }

    stop() {
      window.removeEventListener("devicemotion", this.handler);
      this.on = false;
      this.last = null;
    }

    read(e) {
      const raw = e.accelerationIncludingGravity;
      if (!raw || raw.x === null || raw.y === null || raw.z === null) return;
      const sign = isApple() ? -1 : 1;
      const angle = screen.orientation ? screen.orientation.angle : window.orientation || 0;
      const now = turned({ x: sign * raw.x, y: sign * raw.y, z: sign * raw.z }, angle);
      for (const axis of ["x", "y", "z"]) now[axis] = R.round(now[axis], 1e3) + 0;
      if (e.timeStamp - this.last_ms < SHORTEST_MS) return;
      if (this.last && Math.hypot(now.x - this.last.x, now.y - this.last.y, now.z - this.last.z) < CHANGE_M_S2)
        return;
      this.last = now;
      this.last_ms = e.timeStamp;
      this.sink(now, e.timeStamp);
    }
  }

  R.Gravity = Gravity;
  R.turned = turned;
})((window.Recorder = window.Recorder || {}));
