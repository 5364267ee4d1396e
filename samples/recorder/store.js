// Keeps what is painted in the browser, so that a crash of the tab loses a second at most. Lines of
// the log are appended in batches to IndexedDB, which also works on a page that was opened from a
// folder.
(function (R) {
  "use strict";

  const NAME = "pentimento-recorder";
  const EVERY_MS = 1000;
  const MOST_WAIT_MS = 500; // for the lock of the page before

  const done = (request) =>
    new Promise((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });

  // Whether this page alone writes: a second tab would mix its lines with ours. The lock ends with
  // the tab, also in a crash. A page that is reloaded waits for its own to end.
  async function isAlone() {
    if (!navigator.locks) return true; // plain http has none
    return new Promise((resolve) => {
      const waiting = new AbortController();
      const late = setTimeout(() => waiting.abort(), MOST_WAIT_MS);
      const hold = () => {
        clearTimeout(late);
        resolve(true);
        return new Promise(() => {});
      };
      navigator.locks.request(NAME, { signal: waiting.signal }, hold).catch((problem) => resolve(problem.name !== "AbortError"));
    });
  }

  class Store {
    constructor() {
      this.pending = [];
      this.database = null;
      this.problem = ""; // why nothing is kept, for the painter
      this.onProblem = null; // told of it while painting
    }

    async open() {
      if (!(await isAlone())) {
        this.problem = "Another tab keeps its painting: save before you close this one.";
        return;
      }
      try {
        const request = indexedDB.open(NAME, 1);
        request.onupgradeneeded = () => {
          request.result.createObjectStore("session");
          request.result.createObjectStore("batches", { autoIncrement: true });
        };
        this.database = await done(request);
      } catch (problem) {
        this.problem = "This browser keeps nothing: save before you close the page.";
        return;
      }
      setInterval(() => this.flush(), EVERY_MS);
      document.addEventListener("visibilitychange", () => this.flush());
      window.addEventListener("pagehide", () => this.flush());
    }

    // What an earlier page left: {width_m, height_m, recordedAt, lines}, or null.
    async left() {
      if (!this.database) return null;
      const transaction = this.database.transaction(["session", "batches"]);
      const session = await done(transaction.objectStore("session").get("now"));
      const batches = await done(transaction.objectStore("batches").getAll());
      const lines = batches.flat();
      return session && lines.some((line) => line.includes('"touch"')) ? { ...session, lines } : null;
    }

    // Forgets all and begins a session.
    async begin(log) {
      this.pending = [];
      if (!this.database) return;
      const transaction = this.database.transaction(["session", "batches"], "readwrite");
      transaction.objectStore("batches").clear();
      const { width_m, height_m, recordedAt } = log;
      await done(transaction.objectStore("session").put({ width_m, height_m, recordedAt }, "now"));
    }

    add(line) {
      this.pending.push(line);
    }

    flush() {
      if (!this.database || this.pending.length === 0) return;
      const batch = this.pending;
      this.pending = [];
      try {
        const transaction = this.database.transaction("batches", "readwrite");
        transaction.objectStore("batches").add(batch);
        transaction.onabort = () => this.failed(batch, "The browser's storage is full: save now.");
        transaction.oncomplete = () => (this.problem = "");
      } catch {
        this.failed(batch, "The browser has closed its storage: save now.");
      }
    }

    // The lines wait for the next try: a log without them would begin in the middle of a stroke.
    failed(batch, problem) {
      this.pending = batch.concat(this.pending);
      if (this.problem !== problem && this.onProblem) this.onProblem(problem);
      this.problem = problem;
    }
  }

  R.Store = Store;
})((window.Recorder = window.Recorder || {}));
