/**
 * The sheet: panels as SVG, one focusable path per edge. Pointer and keyboard end in the same
 * `select`.
 */

import { byId, svg } from "../dom.js";
import { along, runOfEdge } from "../outline.js";
import { panelsShown } from "../panels.js";
import { state, update, watch } from "../state.js";
import { arrange, boxOf, extend, onPanel, onSheet, sheetBox } from "./arrangement.js";
import { drawPanel } from "./drawing.js";
import { keyOf, refreshEdges } from "./edges.js";
import { startGestures } from "./gestures.js";
import { isInside, nearestEdge } from "./hit.js";
import { placeLabels } from "./labels.js";
import { commonStart } from "./names.js";
import { labelsOf, marksOf } from "./overlay.js";
import { drawSide } from "./seam_marks.js";
import { drawTag, edgeRows, firstLengths, partRows } from "./tag.js";
import { caughtPoint, drawTape } from "./tape.js";
import { advance, beginTrace, tracedRun } from "./trace.js";
import { welcome } from "./welcome.js";
import { fitted, panned, resized, toScreen, toSheet, zoomed } from "./view.js";

/** How far from an edge it is still pointed at [px]. */
const REACH_PX = 12;
const TOUCH_REACH_PX = 24;
/** Margin around a panel that is fitted, and around an edge that is brought to view [px]. */
const MARGIN_PX = 56;
const EDGE_MARGIN_PX = 30;
const ZOOM_STEP = 1.4;
/**
 * How near to an edge a click is on it whatever number lies there, and how near corners and notches
 * catch a drag [px].
 */
const ON_EDGE_PX = 5;
const SNAP_PX = 10;

let act = { select() {}, letGo() {}, selectSeam() {} };
let space = null;
let pattern = null; // the pattern that is drawn
let sheet = null; // {all, panels, boxes, arrangement, start, size}
let layers = null; // {root, cloth, marks, labels, hover}
let hovered = null; // {panel, edge, direction, at}
let trace = null; // a drag along an outline
let frame = 0;
const current = new Map(); // panel id -> the edge that Tab stops at

const host = () => byId("sheet");
const sizeNow = () => ({ width: host().clientWidth, height: host().clientHeight });
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
  setView(fitted(sheetBox(panel, placeOf(panel)), sheet.size, MARGIN_PX));
}

/** Shows one panel as large as it fits. */
export function fitPanelById(id) {
  const panel = sheet?.panels.get(id);
  if (panel) fitPanel(panel);
}

const zoomBy = (factor, at) => {
  if (!sheet) return;
  const { width, height } = sheet.size;
  setView(zoomed(state.view, at ?? [width / 2, height / 2], factor));
};

function drawHover() {
  const { hover } = layers;
  for (const path of layers.cloth.querySelectorAll(".edge.hovered")) path.classList.remove("hovered");
  host().classList.toggle("on-edge", hovered !== null);
  if (!hovered) return hover.replaceChildren();
  const { panel, edge, direction, at } = hovered;
  pathFor(panel, edge)?.classList.add("hovered");
  const firstLength = firstLengths(state.picked, sheet.panels)(panel, edge);
  hover.replaceChildren(
    drawSide(scene(), runOfEdge(panel, edge, direction), "preview"),
    drawTag({ rows: edgeRows(panel, edge, firstLength), at, window: sheet.size }));
  return undefined;
}

function hover(found, at = null) {
  pointAt(at);
  if (layers && state.tape) {
    layers.hover.replaceChildren(...(at && !state.tape.to ? drawTapeTo(tapePoint(at)) : []));
    return;
  }
  if (!layers || (!found && !hovered)) return;
  hovered = found;
  drawHover();
}

/** Marks the panel that is pointed at, here or in the list. */
function drawPointed() {
  for (const group of layers?.cloth.children ?? []) group.classList.toggle("pointed", group.dataset.of === state.pointed);
}

function pointAt(at) {
  const id = (at && (edgeAt(at)?.panel ?? panelAt(at))?.id) ?? null;
  if (id !== state.pointed) update({ pointed: id });
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
  const { width, height } = sheet.size;
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
  else if (event.key === "Enter") act.select(runOfEdge(panel, edge, event.shiftKey ? "ccw" : "cw"));
  else if (event.key === "a" || event.key === "A") act.select(runOfEdge(panel, edge, event.shiftKey ? "ccw" : "cw"), { more: true });
  else if (event.key === "Escape") act.letGo();
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
    if (event.key === " " && !space.used) act.select(runOfEdge(panel, edge, event.shiftKey ? "ccw" : "cw"));
  });
  path.addEventListener("focus", () => path.matches(":focus-visible") && reveal(panel, edge));
}

/** The notch within reach of a point of an edge, as `{notch}`. */
function notchNear({ panel, edge, at }) {
  const map = mapOf(panel);
  const away = (notch) => {
    const [x, y] = map.point(along(edge.points, notch.at).point);
    return Math.hypot(x - at[0], y - at[1]);
  };
  const found = (panel.notches ?? []).map((notch, index) => ({ notch, index }))
    .filter(({ notch }) => notch.edge === edge.index && away(notch) <= REACH_PX)
    .sort((a, b) => away(a.notch) - away(b.notch));
  return found.length ? { notch: found[0].index } : null;
}

/** The seam whose number is at a point, where no edge is nearer. */
function badgeAt(at, found) {
  if (found && found.distance * state.view.k < ON_EDGE_PX) return null;
  const box = host().getBoundingClientRect();
  const inside = [...layers.labels.querySelectorAll("[data-badge]")].find((badge) => {
    const { left, right, top, bottom } = badge.getBoundingClientRect();
    const [x, y] = [at[0] + box.left + host().clientLeft, at[1] + box.top + host().clientTop];
    return x >= left && x <= right && y >= top && y <= bottom;
  });
  return inside?.dataset.badge ?? null;
}

function pick(at, event) {
  if (!sheet) return;
  if (at === null) {
    const { panel, edge } = event.target.dataset;
    if (edge === undefined) return;
    const found = sheet.panels.get(panel);
    act.select(runOfEdge(found, found.edges[edge], "cw"));
    return;
  }
  if (state.tape) {
    measure(at);
    return;
  }
  const found = edgeAt(at, event.pointerType === "touch" ? TOUCH_REACH_PX : REACH_PX);
  const seam = badgeAt(at, found);
  if (seam !== null) act.selectSeam(seam);
  else if (found) {
    moveTo(found.panel, found.edge);
    act.select(runOfEdge(found.panel, found.edge, found.direction), { more: event.shiftKey, at: notchNear(found) });
  }
}

/** A drag along an outline, which picks a part of it. */
function drag(phase, at, event) {
  if (phase === "begin") {
    const found = edgeAt(at);
    trace = found && !state.tape ? beginTrace(found) : null;
  }
  if (!trace) return;
  const { panel } = trace;
  const found = nearestEdge([{ panel, box: sheet.boxes.get(panel.id), at: mapOf(panel).back(at) }], Infinity);
  trace = advance(trace, found);
  const run = tracedRun(trace, SNAP_PX / state.view.k);
  if (phase === "move" || phase === "begin") {
    layers.hover.replaceChildren(...(run ? [
      drawSide(scene(), run, "preview"),
      drawTag({ rows: partRows(sheet.panels, run, state.picked), at, window: sheet.size }),
    ] : []));
    return;
  }
  trace = null;
  hover(null);
  layers.hover.replaceChildren();
  if (phase === "end" && run) act.select(run, { more: event.shiftKey });
}

const tapePoint = (at) => {
  const found = edgeAt(at);
  return found ? caughtPoint(found, placeOf(found.panel), state.view) : toSheet(state.view, at);
};

/** Lays the tape: the first click is its beginning, the second its end. */
function measure(at) {
  const point = tapePoint(at);
  const { from, to } = state.tape;
  update({ tape: from && !to ? { from, to: point } : { from: point, to: null } });
}

const drawTapeTo = (end) => drawTape(state.tape.from, end, state.view);

function drawView() {
  if (!layers || !state.view) return;
  const { x, y, k } = state.view;
  layers.cloth.setAttribute("transform", `matrix(${k} 0 0 ${k} ${x} ${y})`);
  const painted = scene();
  layers.marks.replaceChildren(...marksOf(painted), ...(state.tape?.to ? drawTapeTo(state.tape.to) : []));
  layers.labels.replaceChildren(...placeLabels(labelsOf(painted), sheet.size));
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
  refreshEdges(layers.cloth, sheet);
  if (focused) layers.cloth.querySelector(`[data-key="${CSS.escape(focused)}"]`)?.focus({ preventScroll: true });
}

function openSheet() {
  const group = (name) => svg("g", { class: name, "aria-hidden": name === "cloth-layer" ? null : "true" });
  layers = { cloth: group("cloth-layer"), marks: group("overlay"), labels: group("overlay labels"), hover: group("overlay hover") };
  host().replaceChildren(svg("svg", { role: "group", "aria-label": "Panels of the pattern", "aria-describedby": "keys" },
    layers.cloth, layers.marks, layers.labels, layers.hover));
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
  if (isNew) current.clear();
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
  if (!layers) {
    if (sizeNow().width === 0) return;
    openSheet();
  }
  if (pattern !== state.pattern || sheet.all !== panelsShown()) takePanels();
  else refreshEdges(layers.cloth, sheet);
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

/**
 * Puts the sheet to work: `on.select(run, options)` for a picked run, `on.selectSeam(id)`,
 * `on.letGo()` for Escape.
 */
export function startSheet(on) {
  act = on;
  const toggleTape = () => update({ tape: state.tape ? null : { from: null, to: null } });
  byId("tape").addEventListener("click", toggleTape);
  host().addEventListener("keydown", (event) => {
    if (event.key === "t" && !event.ctrlKey && !event.metaKey) toggleTape();
  });
  watch(["tape"], () => {
    byId("tape").setAttribute("aria-pressed", String(state.tape !== null));
    host().classList.toggle("measuring", state.tape !== null);
    layers?.hover.replaceChildren();
    scheduleView();
  });
  byId("zoom-in").addEventListener("click", () => zoomBy(ZOOM_STEP));
  byId("zoom-out").addEventListener("click", () => zoomBy(1 / ZOOM_STEP));
  byId("zoom-fit").addEventListener("click", fitAll);
  space = startGestures(host(), {
    pick,
    hover: (at, event) => hover(at && edgeAt(at, event.pointerType === "touch" ? 0 : REACH_PX), at),
    trace: drag,
    pan: (shift) => sheet && setView(panned(state.view, shift)),
    zoom: (at, factor) => zoomBy(factor, at),
    fit: (at) => {
      const panel = edgeAt(at)?.panel ?? panelAt(at);
      if (panel) fitPanel(panel);
    },
    isFree: (at) => !edgeAt(at),
  });
  watch(["pattern", "garment", "leftOut", "suggested", "offers", "numbers", "check", "picked", "selected"], draw);
  watch(["view"], scheduleView);
  watch(["pointed"], drawPointed);
  new ResizeObserver(onResize).observe(host());
}
