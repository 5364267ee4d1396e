// The page in a headless browser, and hands that paint on it: events as the browser itself gets
// them from devices, over its debugging protocol.

import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const CHROMIUM = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((file) => fs.existsSync(file));

export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

// folder: for the browser's profile and downloads.
export async function openBrowser(folder) {
  const browser = await puppeteer.launch({
    executablePath: CHROMIUM,
    headless: true,
    userDataDir: path.join(folder, "profile"),
    args: ["--no-sandbox", "--disable-gpu", "--disable-background-timer-throttling"],
  });
  const session = await browser.target().createCDPSession();
  await session.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder, eventsEnabled: true });
  await session.send("Browser.grantPermissions", { permissions: ["sensors"] });
  return browser;
}

// file: the page. view: {width, height, deviceScaleFactor, isMobile, hasTouch}.
export async function openPage(browser, file, view) {
  const page = await browser.newPage();
  page.problems = [];
  page.on("pageerror", (problem) => page.problems.push(problem.message));
  page.on("console", (message) => {
    if (message.type() === "error") page.problems.push(message.text());
  });
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) page.problems.push("network: " + request.url());
  });
  page.on("dialog", (dialog) => dialog.accept());
  await page.setViewport(view);
  await page.goto(pathToFileURL(file).href);
  return page;
}

export const ready = (page) => page.waitForFunction("window.Recorder.ready === true");

// The canvas on the screen and in metres.
export const canvasOf = (page) =>
  page.evaluate(() => {
    const { left, top, width, height } = document.getElementById("wet").getBoundingClientRect();
    const { width_m, height_m } = window.Recorder.session.log;
    return { left, top, width, height, width_m, height_m };
  });

export const eventsOf = async (page) =>
  (await page.evaluate(() => window.Recorder.session.log.lines)).map((line) => JSON.parse(line));

// Devices. Places are shares of the canvas.
export class Hand {
  constructor(page, client, box) {
    this.page = page;
    this.client = client;
    this.box = box;
  }
  static async of(page) {
    return new Hand(page, await page.createCDPSession(), await canvasOf(page));
  }
  at({ x, y }) {
    return { x: this.box.left + x * this.box.width, y: this.box.top + y * this.box.height };
  }
  send(type, sample, pointerType, more) {
    const { force = 0.5, tiltX = 0, tiltY = 0, twist = 0 } = sample;
    const pen = pointerType === "pen" ? { force, tiltX, tiltY, twist } : {};
    return this.client.send("Input.dispatchMouseEvent", { type, ...this.at(sample), ...pen, pointerType, ...more });
  }
  async stroke(samples, pointerType = "pen", atOnce = false) {
    const pressed = { button: "left", buttons: 1 };
    await this.send("mousePressed", samples[0], pointerType, { ...pressed, clickCount: 1 });
    const moves = [];
    for (const sample of samples.slice(1)) {
      const move = this.send("mouseMoved", sample, pointerType, pressed);
      if (atOnce) moves.push(move);
      else await move;
    }
    await Promise.all(moves);
    await this.send("mouseReleased", samples[samples.length - 1], pointerType, { button: "left", clickCount: 1 });
  }
  touch(type, fingers) {
    const touchPoints = fingers.map(({ id, force = 1, ...place }) => ({ ...this.at(place), id, force }));
    return this.client.send("Input.dispatchTouchEvent", { type, touchPoints });
  }
}

// Waits for the file that a save leaves.
export async function saved(page, folder) {
  const before = new Set(fs.readdirSync(folder));
  await page.evaluate(() => document.getElementById("save").click());
  for (let i = 0; i < 100; ++i) {
    const file = fs.readdirSync(folder).find((name) => !before.has(name) && name.endsWith(".jsonl.gz"));
    if (file) return path.join(folder, file);
    await sleep(50);
  }
  throw new Error("nothing was saved");
}
