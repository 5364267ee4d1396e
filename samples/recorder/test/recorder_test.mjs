// Paints on the recorder's page as people do, saves, and replays the log with the command.
//   node recorder_test.mjs PENTIMENTO PAGE [PICTURES]
// PENTIMENTO: the command. PAGE: index.html. PICTURES: a folder for what the page and its replay look like.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { gunzipSync } from "node:zlib";
import { Hand, canvasOf, eventsOf, openBrowser, openPage, ready, saved, sleep } from "./browser.mjs";

const [command, file, pictures] = process.argv.slice(2);
if (!file) throw new Error("usage: recorder_test.mjs PENTIMENTO PAGE [PICTURES]");
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "recorder-"));
const PHONE = { width: 360, height: 640, deviceScaleFactor: 2, isMobile: true, hasTouch: true };
const TABLET = { width: 1024, height: 768, deviceScaleFactor: 1.5 };

const pentimento = (...words) => execFileSync(command, words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
const line = (count, of) => Array.from({ length: count }, (_, i) => of(i / (count - 1)));
const touches = (events) => events.filter((event) => event.type === "touch");

let browser = await openBrowser(folder);

// Each opens a page of its own on an empty store.
async function fresh(view) {
  const page = await openPage(browser, file, view);
  await page.evaluate(() => new Promise((resolve) => {
    const request = indexedDB.deleteDatabase("pentimento-recorder");
    request.onsuccess = request.onerror = request.onblocked = resolve;
  }));
  await page.reload();
  await ready(page);
  return page;
}

// The samples lie where the device was: within a pixel of the screen, pressure within 1/1000.
function expectPlaces(samples, expected, box) {
  assert.equal(samples.length, expected.length);
  samples.forEach((sample, i) => {
    const off = Math.hypot(sample.x - expected[i].x * box.width_m, sample.y - expected[i].y * box.height_m);
    assert.ok(off < box.width_m / box.width, `sample ${i} is ${off} m off`);
    if (expected[i].force !== undefined) assert.ok(Math.abs(sample.pressure - expected[i].force) < 1e-3, `pressure ${sample.pressure}`);
  });
}

// How far the page's picture is from the replay's: the mean difference, of 255, of small pictures.
async function previewError(page, log) {
  const picture = path.join(folder, "preview.png");
  pentimento("render", log, "--width", "120", "-o", picture, "--quiet");
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = data;
    await image.decode();
    const codes = (sources) => {
      const canvas = document.createElement("canvas");
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext("2d");
      context.imageSmoothingQuality = "high";
      context.fillStyle = "#f5f4f4";
      context.fillRect(0, 0, canvas.width, canvas.height);
      for (const source of sources) context.drawImage(source, 0, 0, canvas.width, canvas.height);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    };
    const a = codes([image]), b = codes([document.getElementById("dry"), document.getElementById("wet")]);
    return a.reduce((sum, code, i) => sum + Math.abs(code - b[i]), 0) / (0.75 * a.length);
  }, "data:image/png;base64," + fs.readFileSync(picture).toString("base64"));
}

const tests = {
  async "the paints are those of the command"() {
    const page = await fresh(TABLET);
    const { pigments, brushes } = await page.evaluate(() => window.Recorder.paints);
    const of = (what) => JSON.parse(pentimento("list", what, "--json"))[what];
    const byName = (a, b) => a.name.localeCompare(b.name);
    assert.deepEqual(
      pigments.sort(byName),
      of("pigments").map((p) => ({ name: p.name, overWhite: p.over_white, overBlack: p.over_black })).sort(byName),
    );
    assert.deepEqual(
      Object.entries(brushes).map(([name, b]) => ({ name, size_pressure: b.sizePressure, flow_pressure: b.flowPressure, capacity: b.capacity })),
      of("brushes"),
    );
    return page;
  },

  async "a pen's samples have place, pressure, tilt and twist"() {
    const page = await fresh(TABLET);
    const hand = await Hand.of(page);
    const samples = line(30, (u) => ({ x: 0.1 + 0.7 * u, y: 0.3 + 0.2 * u * u, force: 0.1 + 0.8 * u, tiltX: Math.round(-40 + 80 * u), tiltY: 25, twist: Math.round(100 * u) }));
    await hand.stroke(samples);
    const drawn = touches(await eventsOf(page));
    assert.deepEqual([drawn[0].phase, drawn.at(-1).phase], ["down", "up"]);
    expectPlaces(drawn.slice(0, -1), samples, hand.box);
    drawn.slice(1, -1).forEach((sample, i) => {
      assert.equal(sample.tilt_x, samples[i + 1].tiltX);
      assert.equal(sample.tilt_y, 25);
      assert.equal(sample.twist ?? 0, samples[i + 1].twist);
    });
    assert.ok(Math.abs(drawn.at(-1).pressure - 0.9) < 1e-3, "a lifted pen keeps its pressure");
    return page;
  },

  async "what a fast pen measures between two frames is not lost"() {
    const page = await fresh(TABLET);
    const hand = await Hand.of(page);
    const samples = line(120, (u) => ({ x: 0.5 + 0.3 * Math.cos(6 * u), y: 0.5 + 0.3 * Math.sin(6 * u), force: 0.2 + 0.6 * u }));
    await hand.stroke(samples, "pen", true);
    const drawn = touches(await eventsOf(page));
    expectPlaces(drawn.slice(0, -1), samples, hand.box);
    const times = drawn.map((sample) => sample.t);
    assert.ok(times.every((t, i) => i === 0 || t >= times[i - 1]), "times run back");
    assert.equal(times[0], 0);
    return page;
  },

  async "a mouse has no pressure"() {
    const page = await fresh(TABLET);
    await (await Hand.of(page)).stroke(line(5, (u) => ({ x: 0.2 + 0.1 * u, y: 0.2 })), "mouse");
    assert.ok(touches(await eventsOf(page)).every((sample) => !("pressure" in sample) && !("tilt_x" in sample)));
    return page;
  },

  async "fingers paint at once, and a cancelled one leaves nothing"() {
    const page = await fresh(PHONE);
    const hand = await Hand.of(page);
    await hand.touch("touchStart", [{ id: 4, x: 0.2, y: 0.2, force: 0.3 }]);
    await hand.touch("touchStart", [{ id: 4, x: 0.2, y: 0.2, force: 0.3 }, { id: 9, x: 0.8, y: 0.2, force: 0.7 }]);
    for (const u of [0.2, 0.4, 0.6])
      await hand.touch("touchMove", [{ id: 4, x: 0.2, y: 0.2 + u, force: 0.3 }, { id: 9, x: 0.8, y: 0.2 + u, force: 0.7 }]);
    await hand.touch("touchEnd", [{ id: 4, x: 0.2, y: 0.8, force: 0.3 }]);
    await hand.touch("touchCancel", []);
    const drawn = touches(await eventsOf(page));
    const of = (id) => drawn.filter((sample) => (sample.id ?? 0) === id);
    assert.deepEqual(new Set(drawn.map((sample) => sample.id ?? 0)), new Set([0, 1]));
    expectPlaces(of(0).slice(0, 4), [0, 0.2, 0.4, 0.6].map((u) => ({ x: 0.2, y: 0.2 + u, force: 0.3 })), hand.box);
    expectPlaces(of(1).slice(0, 4), [0, 0.2, 0.4, 0.6].map((u) => ({ x: 0.8, y: 0.2 + u, force: 0.7 })), hand.box);
    assert.deepEqual([of(0).at(-1).phase, of(1).at(-1).phase].sort(), ["cancel", "up"]);
    return page;
  },

  async "a page that is hidden lifts the brush"() {
    const page = await fresh(TABLET);
    const hand = await Hand.of(page);
    await hand.send("mousePressed", { x: 0.4, y: 0.4 }, "pen", { button: "left", buttons: 1, clickCount: 1 });
    await page.evaluate(() => {
      Object.defineProperty(document, "hidden", { value: true, configurable: true });
      document.dispatchEvent(new Event("visibilitychange"));
    });
    assert.equal(touches(await eventsOf(page)).at(-1).phase, "up");
    await hand.send("mouseReleased", { x: 0.4, y: 0.4 }, "pen", { button: "left", clickCount: 1 });
    assert.equal(touches(await eventsOf(page)).length, 2);
    return page;
  },

  async "the tablet's tilt is Android's gravity on the turned screen"() {
    const page = await fresh(TABLET);
    const client = await page.createCDPSession();
    for (const type of ["accelerometer", "linear-acceleration", "gyroscope"])
      await client.send("Emulation.setSensorOverrideEnabled", { enabled: true, type, metadata: { available: true } });
    const hold = async (x, y, z) => {
      await client.send("Emulation.setSensorOverrideReadings", { type: "accelerometer", reading: { xyz: { x, y, z } } });
      for (const type of ["linear-acceleration", "gyroscope"])
        await client.send("Emulation.setSensorOverrideReadings", { type, reading: { xyz: { x: 0, y: 0, z: 0 } } });
      await sleep(300);
    };
    await page.click("#more");
    await page.click("#gravity");
    await page.waitForFunction(() => document.getElementById("gravity").ariaPressed === "true");
    await hold(0, 0, 9.8);
    await hold(0, 9.8, 0);
    await hold(0, 9.8, 0.05);
    const readings = (await eventsOf(page)).filter((event) => event.type === "gravity");
    const last = readings.at(-1), flat = readings.find((r) => r.z > 9);
    assert.ok(flat && Math.abs(flat.z - 9.8) < 0.11 && Math.abs(flat.x) < 0.11, JSON.stringify(readings));
    assert.ok(Math.abs(last.y - 9.8) < 0.11 && Math.abs(last.z) < 0.11, JSON.stringify(last));
    assert.ok(readings.length <= 4, "what hardly changes is not written");
    await page.click("#gravity");
    const { x, y, z } = (await eventsOf(page)).at(-1);
    assert.deepEqual({ x, y, z }, { x: 0, y: 0, z: 9.81 }, "without the tilt the canvas lies flat");
    // The same turns as `convert --gravity-turn`.
    const turned = await page.evaluate(() => [0, 90, 180, 270].map((angle) => window.Recorder.turned({ x: 1, y: 2, z: 3 }, angle)));
    assert.deepEqual(turned, [{ x: 1, y: 2, z: 3 }, { x: -2, y: 1, z: 3 }, { x: -1, y: -2, z: 3 }, { x: 2, y: -1, z: 3 }]);
    return page;
  },

  async "settings, actions and the light are in the log, and it replays to what was drawn"() {
    const page = await fresh(TABLET);
    const hand = await Hand.of(page);
    await page.click("#more");
    hand.box = await canvasOf(page);
    const bar = (x, y, force) => line(25, (u) => ({ x: x + 0.2 * u, y, force }));
    await hand.stroke(bar(0.1, 0.2, 0.8));
    await page.click("#do-dry");
    await page.click('[data-pigment="Cadmium Red"]');
    await page.select("#brush", "round");
    await hand.stroke(bar(0.6, 0.2, 0.8));
    await hand.stroke(bar(0.1, 0.7, 0.8));
    await page.click("#undo");
    await page.click("#redo");
    await page.click("#undo");
    await page.click("#mark");
    await page.focus("#lamp");
    await page.keyboard.press("ArrowRight");
    await page.evaluate(() => {
      const picked = document.getElementById("picked");
      picked.value = "#106020";
      picked.dispatchEvent(new Event("input"));
      const medium = document.getElementById("medium");
      medium.value = 0.8;
      medium.dispatchEvent(new Event("input"));
    });
    await hand.stroke(bar(0.6, 0.7, 0.8));
    const events = await eventsOf(page);
    const kinds = events.filter((event) => event.type !== "touch").map((event) => event.type);
    assert.deepEqual(kinds, ["brush", "color", "dry", "brush", "color", "undo", "redo", "undo", "mark", "light", "slider", "color"]);
    assert.deepEqual(events.filter((event) => event.type === "color").map((event) => event.pigment ?? event.value), ["French Ultramarine", "Cadmium Red", "#106020"]);

    const log = await saved(page, folder);
    assert.match(pentimento("validate", log), /valid/);
    const header = JSON.parse(gunzipSync(fs.readFileSync(log)).toString().split("\n")[0]);
    assert.deepEqual(header.palette, [{ name: "French Ultramarine" }, { name: "Cadmium Red" }]);
    const picture = path.join(folder, "replay.png");
    pentimento("render", log, "--width", "512", "-o", picture, "--quiet");
    // Colours in the middle of each stroke, in the picture and on the page.
    const at = [[0.2, 0.2], [0.7, 0.2], [0.2, 0.7], [0.7, 0.7], [0.5, 0.45]];
    const [replayed, shown] = await page.evaluate(async (data, places) => {
      const image = new Image();
      image.src = data;
      await image.decode();
      const colours = (sources) => {
        const canvas = document.createElement("canvas");
        canvas.width = sources[0].width;
        canvas.height = sources[0].height;
        const context = canvas.getContext("2d");
        context.fillStyle = "#e8e5df";
        context.fillRect(0, 0, canvas.width, canvas.height);
        for (const source of sources) context.drawImage(source, 0, 0);
        return places.map(([x, y]) => [...context.getImageData(x * canvas.width, y * canvas.height, 1, 1).data.slice(0, 3)]);
      };
      return [colours([image]), colours([document.getElementById("dry"), document.getElementById("wet")])];
    }, "data:image/png;base64," + fs.readFileSync(picture).toString("base64"), at);
    for (const colours of [replayed, shown]) {
      const [blue, red, none, green, paper] = colours;
      assert.ok(blue[2] > blue[0] + 40, `blue ${blue}`);
      assert.ok(red[0] > red[2] + 60, `red ${red}`);
      assert.ok(green[1] > green[0] + 20, `green ${green}`);
      for (const ground of [none, paper]) assert.ok(Math.min(...ground) > 170, `paper ${ground}`);
    }
    return page;
  },

  async "a crash of the tab loses a second at most"() {
    const page = await fresh(TABLET);
    const hand = await Hand.of(page);
    await hand.stroke(line(20, (u) => ({ x: 0.2 + 0.5 * u, y: 0.5, force: 0.5 })));
    await hand.send("mousePressed", { x: 0.3, y: 0.8 }, "pen", { button: "left", buttons: 1, clickCount: 1 });
    await hand.send("mouseMoved", { x: 0.5, y: 0.8 }, "pen", { button: "left", buttons: 1 });
    await sleep(1300);
    const before = await eventsOf(page);
    const client = await page.createCDPSession();
    client.send("Page.crash").catch(() => {}); // nobody is left to answer
    await sleep(500);
    const again = await openPage(browser, file, TABLET);
    await again.waitForFunction(() => document.getElementById("left-over").open);
    await again.click('#left-over button[value="go-on"]');
    await ready(again);
    const after = await eventsOf(again);
    assert.deepEqual(after.slice(0, before.length), before);
    assert.equal(after.at(-1).phase, "up", "the stroke that was open is lifted");
    await (await Hand.of(again)).stroke(line(5, (u) => ({ x: 0.2 + 0.5 * u, y: 0.2, force: 0.5 })));
    const log = await saved(again, folder);
    assert.match(pentimento("validate", log), /valid/);
    assert.equal(JSON.parse(pentimento("info", log, "--json")).strokes, 3);
    return again;
  },

  async "a second tab leaves the painting of the first alone"() {
    const page = await fresh(TABLET);
    await (await Hand.of(page)).stroke(line(5, (u) => ({ x: 0.2 + 0.5 * u, y: 0.5, force: 0.5 })));
    await sleep(1300);
    const second = await openPage(browser, file, TABLET);
    await ready(second).catch(() => {});
    assert.match(await second.$eval("#status", (status) => status.textContent), /Another tab/);
    await second.close();
    await page.reload();
    await page.waitForFunction(() => document.getElementById("left-over").open);
    await page.click('#left-over button[value="go-on"]');
    await ready(page);
    assert.equal(touches(await eventsOf(page)).filter((sample) => sample.phase === "down").length, 1);
    return page;
  },

  async "what the storage refuses is kept for the next try"() {
    const page = await fresh(TABLET);
    await page.evaluate(() => {
      const open = IDBDatabase.prototype.transaction;
      IDBDatabase.prototype.transaction = function (...of) {
        IDBDatabase.prototype.transaction = open;
        throw new DOMException("closed", "InvalidStateError");
      };
    });
    const hand = await Hand.of(page);
    await hand.stroke(line(10, (u) => ({ x: 0.2 + 0.5 * u, y: 0.5, force: 0.5 })));
    await sleep(2300);
    assert.match(await page.$eval("#status", (status) => status.textContent), /storage/);
    const before = await eventsOf(page);
    await page.reload();
    await page.waitForFunction(() => document.getElementById("left-over").open);
    await page.click('#left-over button[value="go-on"]');
    await ready(page);
    assert.deepEqual(await eventsOf(page), before);
    return page;
  },

  async "a phone on its side keeps a canvas to paint on"() {
    const page = await fresh({ ...PHONE, width: 640, height: 360 });
    await page.click("#more");
    const { width, height } = await canvasOf(page);
    assert.ok(width > 350 && height > 100, `${width} x ${height}`);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 640), "the page is wider than the phone");
    return page;
  },

  async "every tool has a name and can be reached by keyboard"() {
    const page = await fresh(PHONE);
    await page.click("#more");
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll("button, select, input, [role=slider], canvas#wet")]
        .filter((tool) => !(tool.ariaLabel || tool.textContent.trim() || (tool.labels && tool.labels.length)))
        .map((tool) => tool.outerHTML));
    assert.deepEqual(nameless, []);
    const small = await page.evaluate(() =>
      [...document.querySelectorAll("#tools button, #panel button")].filter((tool) => tool.getBoundingClientRect().height < 38).map((tool) => tool.id));
    assert.deepEqual(small, [], "too small for a finger");
    const hand = await Hand.of(page);
    await hand.stroke(line(5, (u) => ({ x: 0.3 + 0.3 * u, y: 0.4, force: 0.6 })));
    for (const key of ["z", "y", "d", "m"]) await page.keyboard.press(key);
    await page.keyboard.down("Control");
    await page.keyboard.press("d"); // the browser's own
    await page.keyboard.up("Control");
    await page.focus('#palette [aria-checked="true"]');
    await page.keyboard.press("ArrowRight");
    await hand.stroke(line(5, (u) => ({ x: 0.3 + 0.3 * u, y: 0.6, force: 0.6 })));
    const kinds = (await eventsOf(page)).filter((event) => event.type !== "touch").map((event) => event.type);
    assert.deepEqual(kinds, ["brush", "color", "undo", "redo", "dry", "mark", "color"]);
    return page;
  },

  async "twenty strokes on a phone"() {
    const page = await fresh(PHONE);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 360), "the page is wider than the phone");
    const hand = await Hand.of(page);
    const paint = async (pigment, brush, position) => {
      await page.evaluate((name) => document.querySelector(`[data-pigment="${name}"]`).click(), pigment);
      await page.select("#brush", brush);
      await page.evaluate((value) => {
        document.getElementById("size").value = value;
        document.getElementById("size").dispatchEvent(new Event("input"));
      }, position);
    };
    const arc = (x, y, w, h, swell, tilt) => line(40, (u) => ({ x: x + w * u, y: y + h * u + 0.02 * Math.sin(6 * u), force: 0.35 + swell * Math.sin(Math.PI * u), tiltX: tilt, tiltY: 20 }));
    await paint("Cerulean Blue", "flat", 85);
    for (let i = 0; i < 6; ++i) await hand.stroke(arc(0.06, 0.08 + 0.075 * i, 0.88, 0.01, 0.4, 30));
    await paint("Naples Yellow", "flat", 80);
    for (let i = 0; i < 3; ++i) await hand.stroke(arc(0.06, 0.5 + 0.05 * i, 0.88, 0, 0.3, -30));
    await paint("Chromium Oxide Green", "bristle", 85);
    for (let i = 0; i < 5; ++i) await hand.stroke(arc(0.06, 0.66 + 0.065 * i, 0.88, 0.02, 0.4, 10));
    await paint("Burnt Umber", "round", 60);
    await hand.stroke(line(40, (u) => ({ x: 0.6 + 0.03 * Math.sin(3 * u), y: 0.75 - 0.45 * u, force: 0.9 - 0.5 * u, tiltX: 20 })));
    await paint("Viridian", "filbert", 75);
    for (let i = 0; i < 5; ++i) await hand.stroke(line(30, (u) => ({ x: 0.6 + (0.1 + 0.02 * i) * Math.cos(1.3 * i + 2 * u), y: 0.28 + 0.09 * Math.sin(1.3 * i + 2 * u), force: 0.7, tiltY: 40 })));
    const log = await saved(page, folder);
    const facts = JSON.parse(pentimento("info", log, "--json"));
    assert.equal(facts.strokes, 20);
    assert.match(pentimento("validate", log), /valid/);
    // A preview without the pen's lean and without the paint below is 20 off.
    const error = await previewError(page, log);
    console.log(`        the preview is ${error.toFixed(1)} of 255 off`);
    assert.ok(error < 12, `the preview is ${error} of 255 off`);
    if (pictures) {
      await sleep(200); // what is saved is told first
      fs.mkdirSync(pictures, { recursive: true });
      await page.screenshot({ path: path.join(pictures, "phone.png") });
      fs.copyFileSync(log, path.join(pictures, "phone.jsonl.gz"));
    }
    return page;
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  const begin = Date.now();
  try {
    const page = await test();
    assert.deepEqual(page.problems, []);
    await page.close();
    console.log(`ok      ${name} (${Date.now() - begin} ms)`);
  } catch (problem) {
    ++failed;
    console.log(`FAILED  ${name}\n${problem.stack}`);
    for (const page of (await browser.pages()).slice(1)) await page.close().catch(() => {});
  }
}
await browser.close();
fs.rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
console.log(failed ? `${failed} failed` : `all ${Object.keys(tests).length} passed`);
process.exitCode = failed ? 1 : 0;
