/** Keys of the edges: Tab stops at one edge of each panel, the arrows go along its outline. */

import { runOfEdge } from "../outline.js";
import { drawn, pathFor } from "./drawn.js";
import { keyOf } from "./edges.js";
import { fitPanel, reveal, zoomIn, zoomOut } from "./moving.js";

const STEPS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

let act = { select() {}, fitAll() {}, isMoving: () => false };
const stops = new Map(); // panel id -> the edge that Tab stops at

const stopOf = (panel) => (stops.get(panel.id) ?? 0) % panel.edges.length;

/** Forgets at which edges Tab stops, which are of another pattern. */
export const forgetStops = () => stops.clear();

/** Brings the focus to an edge, at which Tab stops from then on. */
export function moveTo(panel, edge) {
  for (const path of drawn.layers.cloth.querySelectorAll(`[data-panel="${CSS.escape(panel.id)}"]`)) {
    path.setAttribute("tabindex", Number(path.dataset.edge) === edge.index ? 0 : -1);
  }
  stops.set(panel.id, edge.index);
  pathFor(panel, edge)?.focus({ preventScroll: true });
}

const pick = (panel, edge, event, options) => act.select(runOfEdge(panel, edge, event.shiftKey ? "ccw" : "cw"), options);

/** Acts of the keys, letters in lower case. */
const KEYS = {
  Home: (panel) => moveTo(panel, panel.edges[0]),
  End: (panel) => moveTo(panel, panel.edges.at(-1)),
  Enter: pick,
  a: (panel, edge, event) => pick(panel, edge, event, { more: true }),
  f: fitPanel,
  "+": zoomIn,
  "=": zoomIn,
  "-": zoomOut,
  0: () => act.fitAll(),
};

function onKey(panel, edge, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const count = panel.edges.length;
  if (Object.hasOwn(STEPS, key)) moveTo(panel, panel.edges[(edge.index + STEPS[key] + count) % count]);
  else if (Object.hasOwn(KEYS, key)) KEYS[key](panel, edge, event);
  else return;
  event.preventDefault();
}

/** Readies the path of an edge. */
export function bindEdge(panel, edge, path) {
  Object.assign(path.dataset, { key: keyOf(panel, edge), panel: panel.id, edge: edge.index });
  path.setAttribute("tabindex", stopOf(panel) === edge.index ? 0 : -1);
  path.addEventListener("keydown", (event) => onKey(panel, edge, event));
  // The space bar also moves the sheet: it picks when it is let go without that.
  path.addEventListener("keyup", (event) => {
    if (event.key === " " && !act.isMoving()) pick(panel, edge, event);
  });
  path.addEventListener("focus", () => path.matches(":focus-visible") && reveal(panel, edge));
}

/**
 * Puts the keys to work: `on.select(run, options)` and `on.fitAll()`; `on.isMoving()` tells if the
 * space bar moved the sheet.
 */
export function startEdgeKeys(on) {
  act = on;
}
