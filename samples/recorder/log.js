// The log of a painting session: a header line and one line for each event, as docs/action-log.md
// has them. Times begin at the first event and never run back.
(function (R) {
  "use strict";

  const round = (value, perUnit) => Math.round(value * perUnit) / perUnit;

  class Log {
    // width_m, height_m: the canvas; the longer side is 1 m.
    constructor(width_m, height_m) {
      this.width_m = round(width_m, 1e4);
      this.height_m = round(height_m, 1e4);
      this.recordedAt = new Date().toISOString();
      this.lines = []; // events as JSON
      this.last_s = 0;
      this.origin_ms = null; // of the page's clock, where the log's time is 0
      this.pigments = new Set();
      this.onLine = null; // called with each new line
    }

    // Seconds of the log at a time of the page's clock, in microseconds, never before the last.
    time(clock_ms) {
      if (this.origin_ms === null) this.origin_ms = clock_ms - this.last_s * 1000;
      const t = round((clock_ms - this.origin_ms) / 1000, 1e6);
      this.last_s = Math.max(this.last_s, t, 0);
      return this.last_s;
    }

    add(clock_ms, event) {
      if (event.type === "color" && event.pigment) this.pigments.add(event.pigment);
      const line = JSON.stringify({ t: this.time(clock_ms), ...event });
      this.lines.push(line);
      if (this.onLine) this.onLine(line);
    }

    // Goes on where another session ended: a second later.
    restore(lines) {
      this.lines = lines.slice();
      for (const line of lines) {
        const event = JSON.parse(line);
        this.last_s = Math.max(this.last_s, event.t);
        if (event.type === "color" && event.pigment) this.pigments.add(event.pigment);
      }
      this.last_s += 1;
      this.origin_ms = null;
    }

    get isEmpty() {
      return !this.lines.some((line) => line.includes('"touch"'));
    }

    header() {
      const longer = Math.max(this.width_m, this.height_m);
      const cells = (side_m) => Math.max(1, Math.round((side_m / longer) * 1024));
      return JSON.stringify({
        type: "header",
        format: "pentimento-log",
        version: 1,
        canvas: { width: this.width_m, height: this.height_m },
        grid: { width: cells(this.width_m), height: cells(this.height_m) },
        palette: [...this.pigments].map((name) => ({ name })),
        recorded_by: "pentimento recorder 1",
        recorded_at: this.recordedAt,
      });
    }

    text() {
      return [this.header(), ...this.lines, ""].join("\n");
    }

    // The file: compressed where the browser can.
    async file() {
      const name = "painting-" + this.recordedAt.slice(0, 19).replace(/[:T]/g, "-") + ".jsonl";
      const plain = new Blob([this.text()], { type: "application/x-ndjson" });
      if (typeof CompressionStream === "undefined") return { name, blob: plain };
      const packed = plain.stream().pipeThrough(new CompressionStream("gzip"));
      const bytes = await new Response(packed).arrayBuffer();
      return { name: name + ".gz", blob: new Blob([bytes], { type: "application/gzip" }) };
    }
  }

  R.Log = Log;
  R.round = round;
})((window.Recorder = window.Recorder || {}));
