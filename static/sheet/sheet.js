/** The sheet: panels as SVG, one focusable path per edge. Pointer and keyboard end in the same `select`. */

import { byId, el, svg } from "../dom.js";
import { edgesOf, runOfEdge, runsOf } from "../outline.js";
import { leftOut, panelsShown, titleOf } from "../panels.js";
import { state, update, watch } from "../state.js";
import { arrange, boxOf, extend, onPanel, onSheet, sheetBox } from "./arrangement.js";
import { differenceText, gradeText, likeness } from "./compare.js";
import { drawPanel, edgeLabel } from "./drawing.js";
import { startGestures } from "./gestures.js";
import { isInside, nearestEdge } from "./hit.js";
import { placeLabels } from "./labels.js";
import { commonStart } from "./names.js";
import { labelsOf, marksOf } from "./overlay.js";
import { drawSide } from "./seam_marks.js";
import { drawTag, firstLengthFor } from "./tag.js";
import { fitted, panned, resized, toScreen, toSheet, zoomed } from "./view.js";

/** How far from an edge it is still pointed at [px]. */
const REACH_PX = 12;
const TOUCH_REACH_PX = 24;
/** Margin around a panel that is fitted, and around an edge that is brought to view [px]. */
const MARGIN_PX = 56;
const EDGE_MARGIN_PX = 30;
const ZOOM_STEP = 1.4;
/** Most edges that are shown as likely partners. */
const PARTNERS = 5;

let select = () => {};
let letGo = () => {};
let space = null;
let pattern = null; // the pattern that is drawn
let sheet = null; // {all, panels, boxes, arrangement, start, size}
let layers = null; // {root, cloth, marks, labels, hover}
let hovered = null; // {panel, edge, direction, at}
let frame = 0;
const current = new Map(); // panel id -> the edge that Tab stops at

const host = () => byId("sheet");
const sizeNow = () => ({ width: host().clientWidth, height: host().clientHeight });
const keyOf = (panel, edge) => `edge ${panel.id} ${edge.index}`;
const pathFor = (panel, edge) => layers.cloth.querySelector(`[data-key="${CSS.escape(keyOf(panel, edge))}"]`);
const placeOf = (panel) => sheet.arrangement.places.get(panel.id);

/** Maps between a panel and the window in the view of now. */
function mapOf(panel) {
  const { view } = state;
  const place = placeOf(panel);
  return {
    point: (at) => toScreen(view, onSheet(place, at)),
    back: (at) => onPanel(place, toSheet(view, at)),
  };
}

/** Names of the seams that each edge is in, by key. */
function seamsByEdge() {
  const found = new Map();
  for (const seam of state.garment.seams) {
    for (const run of [...runsOf(seam.a), ...runsOf(seam.b)]) {
      const panel = sheet.panels.get(run.panel);
      if (!panel) continue;
      for (const { edge } of edgesOf(panel, run)) {
        const key = keyOf(panel, { index: edge });
        found.set(key, [...new Set([...(found.get(key) ?? []), seam.id])]);
      }
    }
  }
  return found;
}

/** The edge at a point of the window, with the direction of a run that begins at the nearer end. */
function edgeAt(at, reach = REACH_PX) {
  if (!sheet) return null;
  const candidates = sheet.all.map((panel) => ({ panel, box: sheet.boxes.get(panel.id), at: mapOf(panel).back(at) }));
  const found = nearestEdge(candidates, reach / state.view.k);
  return found && { ...found, direction: found.fraction <= 0.5 ? "cw" : "ccw", at };
}

const panelAt = (at) => sheet?.all.find((panel) => isInside(panel, mapOf(panel).back(at)));

const setView = (view, home = false) => update({ view: { ...view, home } });

const wholeBox = ({ width, height }) => ({ left: 0, top: 0, right: width, bottom: height });

/** Shows all panels, arranged anew for the window of now. */
function fitAll() {
  if (!sheet) return;
  sheet.size = sizeNow();
  sheet.arrangement = arrange(sheet.all, sheet.size.width, sheet.size.height);
  drawCloth();
  setView(fitted(wholeBox(sheet.arrangement), sheet.size, 0), true);
}

function fitPanel(panel) {
  setView(fitted(sheetBox(panel, placeOf(panel)), sizeNow(), MARGIN_PX));
}

const zoomBy = (factor, at) => {
  const { width, height } = sizeNow();
  if (sheet) setView(zoomed(state.view, at ?? [width / 2, height / 2], factor));
};

function drawHover() {
  const { hover } = layers;
  for (const path of layers.cloth.querySelectorAll(".edge.hovered")) path.classList.remove("hovered");
  host().classList.toggle("on-edge", hovered !== null);
  if (!hovered) return hover.replaceChildren();
  const { panel, edge, direction, at } = hovered;
  pathFor(panel, edge)?.classList.add("hovered");
  const firstLength = firstLengthFor(state.picked, sheet.panels, panel, edge);
  hover.replaceChildren(
    drawSide(scene(), runOfEdge(panel, edge, direction), "preview"),
    drawTag({ panel, edge, at, firstLength, window: sizeNow() }));
  return undefined;
}

function hover(found) {
  if (!layers || (!found && !hovered)) return;
  hovered = found;
  drawHover();
}

/** What the painters of seams need. */
const scene = () => ({ ...sheet, maps: new Map(sheet.all.map((panel) => [panel.id, mapOf(panel)])) });

function moveTo(panel, edge) {
  for (const path of layers.cloth.querySelectorAll(`[data-panel="${CSS.escape(panel.id)}"]`)) {
    path.setAttribute("tabindex", Number(path.dataset.edge) === edge.index ? 0 : -1);
  }
  current.set(panel.id, edge.index);
  pathFor(panel, edge)?.focus({ preventScroll: true });
}

/** Moves the sheet until the middle of an edge is seen. */
function reveal(panel, edge) {
  const { width, height } = sizeNow();
  const middle = edge.points[Math.floor(edge.points.length / 2)];
  const [x, y] = mapOf(panel).point(middle);
  const shift = (at, size) => Math.max(EDGE_MARGIN_PX - at, 0) + Math.min(size - EDGE_MARGIN_PX - at, 0);
  const [dx, dy] = [shift(x, width), shift(y, height)];
  if (dx || dy) setView(panned(state.view, [dx, dy]));
}

const STEPS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

function onKey(panel, edge, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const count = panel.edges.length;
  if (event.key in STEPS) moveTo(panel, panel.edges[(edge.index + STEPS[event.key] + count) % count]);
  else if (event.key === "Home") moveTo(panel, panel.edges[0]);
  else if (event.key === "End") moveTo(panel, panel.edges[count - 1]);
  else if (event.key === "Enter") select(runOfEdge(panel, edge, event.shiftKey ? "ccw" : "cw"));
  else if (event.key === "Escape") letGo();
  else if (event.key === "+" || event.key === "=") zoomBy(ZOOM_STEP);
  else if (event.key === "-") zoomBy(1 / ZOOM_STEP);
  else if (event.key === "0") fitAll();
  else if (event.key === "f") fitPanel(panel);
  else return;
  event.preventDefault();
}

function bindEdge(panel, edge, path) {
  Object.assign(path.dataset, { key: keyOf(panel, edge), panel: panel.id, edge: edge.index });
  path.setAttribute("tabindex", (current.get(panel.id) ?? 0) === edge.index ? 0 : -1);
  path.addEventListener("keydown", (event) => onKey(panel, edge, event));
  // The space bar also moves the sheet: it picks when it is let go without that.
  path.addEventListener("keyup", (event) => {
    if (event.key === " " && !space.used) select(runOfEdge(panel, edge, event.shiftKey ? "ccw" : "cw"));
  });
  path.addEventListener("focus", () => path.matches(":focus-visible") && reveal(panel, edge));
}

function pick(at, event) {
  if (!sheet) return;
  if (at === null) {
    const { panel, edge } = event.target.dataset;
    if (edge === undefined) return;
    const found = sheet.panels.get(panel);
    select(runOfEdge(found, found.edges[edge], "cw"));
    return;
  }
  const found = edgeAt(at, event.pointerType === "touch" ? TOUCH_REACH_PX : REACH_PX);
  if (!found) return;
  moveTo(found.panel, found.edge);
  select(runOfEdge(found.panel, found.edge, found.direction));
}

/** Edges that are not sewn and about as long as the first side, the likeliest first. */
function partners(seams) {
  const { picked } = state;
  if (!picked) return new Set();
  const rated = sheet.all.flatMap((panel) => panel.edges.map((edge) => {
    const length = firstLengthFor(picked, sheet.panels, panel, edge);
    const key = keyOf(panel, edge);
    return { key, rate: length === null || seams.has(key) ? 0 : likeness(length, edge.length_m) };
  }));
  const likely = rated.filter(({ rate }) => rate > 0).sort((a, b) => b.rate - a.rate);
  return new Set(likely.slice(0, PARTNERS).map(({ key }) => key));
}

/** What is said of an edge beside the first side. */
function comparison(panel, edge) {
  const length = firstLengthFor(state.picked, sheet.panels, panel, edge);
  return length === null ? "" : `; ${differenceText(length, edge.length_m)}: ${gradeText(length, edge.length_m)}`;
}

/** Brings names and states of the edges up to date, in place. */
function refreshEdges() {
  const seams = seamsByEdge();
  const likely = partners(seams);
  const spare = new Set(leftOut());
  const pickedEdges = new Set((state.picked ? runsOf(state.picked) : []).flatMap((run) => {
    const panel = sheet.panels.get(run.panel);
    return panel ? edgesOf(panel, run).map(({ edge }) => keyOf(panel, { index: edge })) : [];
  }));
  for (const group of layers.cloth.children) {
    const panel = sheet.panels.get(group.dataset.of);
    group.classList.toggle("spare", spare.has(panel.id));
    group.setAttribute("aria-label", `Panel ${titleOf(panel)}${spare.has(panel.id) ? ", left out" : ""}`);
    for (const path of group.querySelectorAll(".edge")) {
      const edge = panel.edges[path.dataset.edge];
      const { key } = path.dataset;
      path.setAttribute("aria-label", edgeLabel(panel, edge, seams.get(key) ?? []) + comparison(panel, edge));
      path.setAttribute("aria-pressed", String(pickedEdges.has(key)));
      path.classList.toggle("likely", likely.has(key));
    }
  }
}

function drawView() {
  if (!layers || !state.view) return;
  const { x, y, k } = state.view;
  layers.cloth.setAttribute("transform", `matrix(${k} 0 0 ${k} ${x} ${y})`);
  const painted = scene();
  layers.marks.replaceChildren(...marksOf(painted));
  layers.labels.replaceChildren(...placeLabels(labelsOf(painted), sizeNow()));
  drawHover();
}

function scheduleView() {
  frame ||= requestAnimationFrame(() => {
    frame = 0;
    drawView();
  });
}

/** The panels themselves: drawn anew only when there are others. */
function drawCloth() {
  const focused = layers.cloth.contains(document.activeElement) ? document.activeElement.dataset.key : null;
  layers.cloth.replaceChildren(...sheet.all.map((panel) =>
    drawPanel(panel, placeOf(panel), (path, edge) => bindEdge(panel, edge, path))));
  refreshEdges();
  if (focused) layers.cloth.querySelector(`[data-key="${CSS.escape(focused)}"]`)?.focus({ preventScroll: true });
}

function openSheet() {
  const group = (name) => svg("g", { class: name, "aria-hidden": name === "cloth-layer" ? null : "true" });
  layers = { cloth: group("cloth-layer"), marks: group("overlay"), labels: group("overlay labels"), hover: group("overlay hover") };
  host().replaceChildren(svg("svg", { role: "group", "aria-label": "Panels of the pattern", "aria-describedby": "keys" },
    layers.cloth, layers.marks, layers.labels, layers.hover));
}

/** What is there before a pattern is. */
function welcome() {
  const by = (id) => () => byId(id).click();
  const sample = (name) => () => document.querySelector(`.rail [data-sample="${name}"]`).click();
  return el("div", { class: "welcome" },
    el("p", {}, "Open a pattern, or drop its file anywhere on the page."),
    el("div", { class: "tools" }, el("button", { type: "button", class: "primary", onclick: by("open-file") }, "Open a file…")),
    el("p", { class: "note" }, "DXF, as exported for AAMA or ASTM or drawn in any CAD, or a GarmentCode specification"),
    el("div", { class: "tools" },
      el("button", { type: "button", onclick: sample("skirt") }, "Try the skirt"),
      el("button", { type: "button", onclick: sample("top") }, "Try the top")));
}

function closeSheet() {
  sheet = layers = null;
  host().replaceChildren(welcome());
}

/** Takes the panels of now; those that have a place keep it. */
function takePanels() {
  const all = panelsShown();
  hovered = null;
  const isNew = pattern !== state.pattern;
  pattern = state.pattern;
  const before = isNew ? null : sheet;
  const size = before?.size ?? sizeNow();
  sheet = {
    all, size,
    panels: new Map(all.map((panel) => [panel.id, panel])),
    boxes: new Map(all.map((panel) => [panel.id, boxOf(panel)])),
    arrangement: before ? extend(before.arrangement, all) : arrange(all, size.width, size.height),
    start: commonStart(all.map((panel) => panel.name)),
  };
  drawCloth();
  if (isNew || state.view?.home) setView(fitted(wholeBox(sheet.arrangement), size, 0), true);
}

function draw() {
  if (!state.pattern) {
    pattern = null;
    closeSheet();
    return;
  }
  if (sizeNow().width === 0) return;
  if (!layers) openSheet();
  if (pattern !== state.pattern || sheet.all !== panelsShown()) takePanels();
  else refreshEdges();
  scheduleView();
}

function onResize() {
  if (!sheet) return draw();
  const size = sizeNow();
  if (size.width === 0 || (size.width === sheet.size.width && size.height === sheet.size.height)) return undefined;
  const before = sheet.size;
  sheet.size = size;
  if (state.view.home && !state.picked) fitAll();
  else if (state.view.home) setView(fitted(wholeBox(sheet.arrangement), size, 0), true);
  else setView(resized(state.view, before, size));
  return undefined;
}

/** Puts the sheet to work: `onSelect(run)` for a picked edge, `onLetGo()` for Escape. */
export function startSheet(onSelect, onLetGo) {
  select = onSelect;
  letGo = onLetGo;
  byId("zoom-in").addEventListener("click", () => zoomBy(ZOOM_STEP));
  byId("zoom-out").addEventListener("click", () => zoomBy(1 / ZOOM_STEP));
  byId("zoom-fit").addEventListener("click", fitAll);
  space = startGestures(host(), {
    pick,
    hover: (at, event) => hover(at && edgeAt(at, event.pointerType === "touch" ? 0 : REACH_PX)),
    pan: (shift) => sheet && setView(panned(state.view, shift)),
    zoom: (at, factor) => zoomBy(factor, at),
    fit: (at) => {
      const panel = edgeAt(at)?.panel ?? panelAt(at);
      if (panel) fitPanel(panel);
    },
    isFree: (at) => !edgeAt(at),
  });
  watch(["pattern", "garment", "leftOut", "check", "picked", "selected"], draw);
  watch(["view"], scheduleView);
  new ResizeObserver(onResize).observe(host());
}
