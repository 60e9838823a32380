/**
 * The sheet: panels as SVG, one focusable path per edge. Pointer and keyboard end in the same
 * `select`.
 */

import { byId, svg } from "../dom.js";
import { panelsShown } from "../panels.js";
import { state, watch } from "../state.js";
import { arrange, boxOf, extend } from "./arrangement.js";
import { drawn, host, placeOf, scene, sizeNow } from "./drawn.js";
import { drawPanel } from "./drawing.js";
import { bindEdge, forgetStops, startEdgeKeys } from "./edge_keys.js";
import { refreshEdges } from "./edges.js";
import { startGestures } from "./gestures.js";
import { placeLabels } from "./labels.js";
import { laidTape, measure, startMeasuring, stretch } from "./measuring.js";
import { fitPanel, panBy, setView, showAll, zoomBy, zoomIn, zoomOut } from "./moving.js";
import { commonStart } from "./names.js";
import { labelsOf, marksOf } from "./overlay.js";
import { drag, drawHover, drawPointed, edgeAt, forgetHover, hover, panelAt, pick, startPointing } from "./pointing.js";
import { resized } from "./view.js";
import { welcome } from "./welcome.js";

let pattern = null; // the pattern that is drawn
let frame = 0;

/** Shows all panels, arranged anew for the window of now. */
function fitAll() {
  const { sheet } = drawn;
  if (!sheet) return;
  sheet.size = sizeNow();
  sheet.arrangement = arrange(sheet.all, sheet.size.width, sheet.size.height);
  drawCloth();
  showAll();
}

function drawView() {
  const { layers, sheet } = drawn;
  if (!layers || !state.view) return;
  const { x, y, k } = state.view;
  layers.cloth.setAttribute("transform", `matrix(${k} 0 0 ${k} ${x} ${y})`);
  const painted = scene();
  layers.marks.replaceChildren(...marksOf(painted), ...laidTape());
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
  const { cloth } = drawn.layers;
  const focused = cloth.contains(document.activeElement) ? document.activeElement.dataset.key : null;
  cloth.replaceChildren(...drawn.sheet.all.map((panel) =>
    drawPanel(panel, placeOf(panel), (path, edge) => bindEdge(panel, edge, path))));
  refreshEdges(cloth, drawn.sheet);
  if (focused !== null) (cloth.querySelector(`[data-key="${CSS.escape(focused)}"]`) ?? byId("work")).focus({ preventScroll: true });
}

/** Replaces all of the sheet; a focus in it stays in the work. */
function fill(content) {
  const hadFocus = host().contains(document.activeElement);
  host().replaceChildren(content);
  if (hadFocus) byId("work").focus({ preventScroll: true });
}

function openSheet() {
  const group = (name) => svg("g", { class: name, "aria-hidden": name === "cloth-layer" ? null : "true" });
  const layers = { cloth: group("cloth-layer"), marks: group("overlay"), labels: group("overlay labels"), hover: group("overlay hover") };
  drawn.layers = layers;
  fill(svg("svg", { role: "group", "aria-label": "Panels of the pattern", "aria-describedby": "keys" },
    layers.cloth, layers.marks, layers.labels, layers.hover));
}

function closeSheet() {
  drawn.sheet = drawn.layers = null;
  fill(welcome());
}

/** Takes the panels of now; those that have a place keep it. */
function takePanels() {
  const all = panelsShown();
  forgetHover();
  const isNew = pattern !== state.pattern;
  pattern = state.pattern;
  if (isNew) forgetStops();
  const before = isNew ? null : drawn.sheet;
  const size = before?.size ?? sizeNow();
  drawn.sheet = {
    all, size,
    panels: new Map(all.map((panel) => [panel.id, panel])),
    boxes: new Map(all.map((panel) => [panel.id, boxOf(panel)])),
    arrangement: before ? extend(before.arrangement, all) : arrange(all, size.width, size.height),
    start: commonStart(all.map((panel) => panel.name)),
  };
  drawCloth();
  if (isNew || state.view?.home) showAll();
}

function draw() {
  if (!state.pattern) {
    pattern = null;
    closeSheet();
    return;
  }
  if (!drawn.layers) {
    if (sizeNow().width === 0) return;
    openSheet();
  }
  if (pattern !== state.pattern || drawn.sheet.all !== panelsShown()) takePanels();
  else refreshEdges(drawn.layers.cloth, drawn.sheet);
  scheduleView();
}

function onResize() {
  const { sheet } = drawn;
  if (!sheet) {
    draw();
    return;
  }
  const size = sizeNow();
  if (size.width === 0 || (size.width === sheet.size.width && size.height === sheet.size.height)) return;
  const before = sheet.size;
  sheet.size = size;
  // Panels that are being picked stay where they are.
  if (state.view.home && !state.picked) fitAll();
  else if (state.view.home) showAll();
  else setView(resized(state.view, before, size));
}

/** Puts the sheet to work: `on.select(run, options)` for a picked run, `on.selectSeam(id)`. */
export function startSheet(on) {
  startPointing(on);
  byId("zoom-in").addEventListener("click", zoomIn);
  byId("zoom-out").addEventListener("click", zoomOut);
  byId("zoom-fit").addEventListener("click", fitAll);
  const space = startGestures(host(), {
    // A click without a place comes from assistive technology, which has no use for a tape.
    pick: (at, event) => (state.tape && at !== null ? measure(at) : pick(at, event)),
    hover(at, event) {
      hover(at, event);
      if (state.tape) stretch(at);
    },
    trace: drag,
    pan: panBy,
    zoom: (at, factor) => zoomBy(factor, at),
    fit(at) {
      const panel = panelAt(at);
      if (panel) fitPanel(panel);
    },
    isFree: (at) => !edgeAt(at),
  });
  startEdgeKeys({ select: on.select, fitAll, isMoving: () => space.used });
  startMeasuring();
  watch(["pattern", "garment", "leftOut", "suggested", "offers", "numbers", "check", "picked", "selected"], draw);
  watch(["view", "tape"], scheduleView);
  watch(["pointed"], drawPointed);
  new ResizeObserver(onResize).observe(host());
}
