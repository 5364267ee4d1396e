// The page of a batch's report: a grid of jobs, a filter, and the chosen job's pictures side by side.
"use strict";

const report = JSON.parse(document.getElementById("report").textContent);
const byId = (id) => document.getElementById(id);
const views = ["slider", "flicker", "difference", "golden", "new"];
const state = { shown: [], at: -1, view: "slider", text: "", failedOnly: report.failed > 0 };

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const seconds = (value) => (value === undefined ? "" : `${value.toFixed(2)} s`);

function timing(row) {
  const now = row.result ? row.result.wall_s : undefined;
  if (now === undefined) return "";
  if (row.last_wall_s === undefined) return seconds(now);
  return `${seconds(now)} (${(now / row.last_wall_s).toFixed(2)} times the last run's ${seconds(row.last_wall_s)})`;
}

function tile(row, index) {
  const picture = row.thumbnail
    ? element("img", { src: row.thumbnail, alt: "", loading: "lazy" })
    : element("div", { class: "none" }, row.kind);
  const item = element("li", { role: "option", class: row.kind === "passed" ? "passed" : "failed", tabindex: -1 },
    picture, element("div", { class: "id" }, row.id), element("div", { class: "kind" }, row.kind));
  item.addEventListener("click", () => choose(index));
  return item;
}

function matches(row) {
  if (state.failedOnly && row.kind === "passed") return false;
  return !state.text || `${row.id} ${row.kind}`.toLowerCase().includes(state.text.toLowerCase());
}

function showRows() {
  state.shown = report.rows.filter(matches);
  byId("rows").replaceChildren(...state.shown.map(tile));
  byId("count").textContent = `${state.shown.length} shown`;
  choose(state.shown.length ? 0 : -1, false);
}

function differencesTable(row) {
  if (!row.differences.length) return "";
  const head = element("tr", {}, ...["", "field", "largest", "at", "share"].map((text) => element("th", {}, text)));
  const lines = row.differences.map((d) => element("tr", {},
    element("td", {}, d.of), element("td", {}, d.name),
    element("td", { class: "number" }, d.max === null ? "not finite" : d.max.toPrecision(4)),
    element("td", { class: "number" }, d.x < 0 ? "" : `${d.x}, ${d.y}`),
    element("td", { class: "number" }, `${(100 * d.share).toPrecision(3)} %`)));
  return element("table", { class: "differences" }, head, ...lines);
}

function stage(row) {
  const box = element("div", { class: `stage ${state.view}`, id: "stage" },
    element("img", { src: row.golden, alt: "golden" }), element("img", { src: row.picture, alt: "new" }));
  box.addEventListener("pointermove", (event) => {
    const area = box.getBoundingClientRect();
    box.style.setProperty("--cut", `${(100 * (event.clientX - area.left)) / area.width}%`);
  });
  return box;
}

function pictures(row) {
  if (!row.picture) return [];
  if (!row.golden) return [element("img", { src: row.picture, alt: row.id, style: "max-width:100%" })];
  const buttons = views.map((view) => {
    const button = element("button", { type: "button", "aria-pressed": view === state.view }, view);
    button.addEventListener("click", () => show(view));
    return button;
  });
  const gain = element("input", { type: "range", min: 1, max: 64, value: 8, "aria-label": "gain of the difference" });
  gain.addEventListener("input", () => byId("stage").style.setProperty("--gain", gain.value));
  return [element("div", { class: "views" }, ...buttons, element("label", {}, "gain ", gain)), stage(row)];
}

function showDetail(row) {
  const facts = [timing(row), row.flip === undefined ? "" : `FLIP ${row.flip.toFixed(5)}`,
    row.result && row.result.state_sha256 ? `state ${row.result.state_sha256.slice(0, 16)}` : "", row.run || ""];
  byId("detail").replaceChildren(
    element("h2", {}, row.id), element("p", {}, ...row.reasons.flatMap((reason) => [reason, element("br")])),
    element("p", {}, facts.filter(Boolean).join(" · ")), differencesTable(row), ...pictures(row));
}

function choose(index, scroll = true) {
  state.at = index;
  [...byId("rows").children].forEach((item, i) => item.setAttribute("aria-selected", i === index));
  if (index < 0) return byId("detail").replaceChildren();
  if (scroll) byId("rows").children[index].scrollIntoView({ block: "nearest" });
  showDetail(state.shown[index]);
}

function show(view) {
  state.view = view;
  if (state.at >= 0) showDetail(state.shown[state.at]);
}

function step(by) {
  if (state.shown.length) choose(Math.min(state.shown.length - 1, Math.max(0, state.at + by)));
}

const keys = { j: () => step(1), ArrowRight: () => step(1), k: () => step(-1), ArrowLeft: () => step(-1),
  s: () => show("slider"), f: () => show("flicker"), d: () => show("difference"), g: () => show("golden"), n: () => show("new"),
  a: () => byId("failed-only").click(), "/": () => byId("filter").focus() };

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.id === "filter") {
    if (event.key === "Escape") event.target.blur();
    return;
  }
  if (!keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
});
byId("filter").addEventListener("input", (event) => { state.text = event.target.value; showRows(); });
byId("failed-only").addEventListener("change", (event) => { state.failedOnly = event.target.checked; showRows(); });
byId("failed-only").checked = state.failedOnly;
byId("summary").textContent = `${report.jobs} jobs, ${report.failed} failed, ${report.not_run} not run`;
showRows();
