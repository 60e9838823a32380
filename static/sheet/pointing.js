/** Pointing at the sheet: the edge, panel or number under the pointer, its tag, clicks, drags. */

import { along, runOfEdge } from "../outline.js";
import { state, update } from "../state.js";
import { drawn, host, mapOf, pathFor, scene } from "./drawn.js";
import { moveTo } from "./edge_keys.js";
import { isInside, nearestEdge } from "./hit.js";
import { drawSide } from "./seam_marks.js";
import { drawTag, edgeRows, firstLengths, partRows } from "./tag.js";
import { advance, beginTrace, tracedRun } from "./trace.js";

/** Distance from an edge at which it is still pointed at [px]. */
const REACH_PX = 12;
const TOUCH_REACH_PX = 24;
/** A click so near to an edge is on it, whatever number lies there [px]. */
const ON_EDGE_PX = 5;
/** Reach of corners and notches, which catch a drag [px]. */
const SNAP_PX = 10;

let act = { select() {}, selectSeam() {} };
let hovered = null; // {panel, edge, direction, at}
let trace = null; // a drag along an outline

/** The edge at a point of the window, with the direction of a run that begins at the nearer end. */
export function edgeAt(at, reach = REACH_PX) {
  const { sheet } = drawn;
  if (!sheet) return null;
  const candidates = sheet.all.map((panel) => ({ panel, box: sheet.boxes.get(panel.id), at: mapOf(panel).back(at) }));
  const found = nearestEdge(candidates, reach / state.view.k);
  return found && { ...found, direction: found.fraction <= 0.5 ? "cw" : "ccw", at };
}

/** The panel at a point of the window: of the edge there, else the one that it lies in. */
export const panelAt = (at) => edgeAt(at)?.panel ?? drawn.sheet?.all.find((panel) => isInside(panel, mapOf(panel).back(at)));

/** Paints the run that a click would pick, and the tag. */
export function drawHover() {
  const { layers, sheet } = drawn;
  for (const path of layers.cloth.querySelectorAll(".edge.hovered")) path.classList.remove("hovered");
  host().classList.toggle("on-edge", hovered !== null);
  if (!hovered) {
    layers.hover.replaceChildren();
    return;
  }
  const { panel, edge, direction, at } = hovered;
  pathFor(panel, edge)?.classList.add("hovered");
  const firstLength = firstLengths(state.picked, sheet.panels)(panel, edge);
  layers.hover.replaceChildren(
    drawSide(scene(), runOfEdge(panel, edge, direction), "preview"),
    drawTag({ rows: edgeRows(panel, edge, firstLength), at, window: sheet.size }));
}

/** Forgets the edge under the pointer; the next drawing of the sheet does not mark it. */
export function forgetHover() {
  hovered = null;
}

function setHovered(found) {
  if (!drawn.layers || (!found && !hovered)) return;
  hovered = found;
  drawHover();
}

function pointAt(at) {
  const id = (at && panelAt(at)?.id) ?? null;
  if (id !== state.pointed) update({ pointed: id });
}

/** Follows the pointer; `at` is null where it left. */
export function hover(at, event) {
  pointAt(at);
  if (!state.tape) setHovered(at && edgeAt(at, event.pointerType === "touch" ? 0 : REACH_PX));
}

/** Marks the panel that is pointed at, here or in the list. */
export function drawPointed() {
  for (const group of drawn.layers?.cloth.children ?? []) group.classList.toggle("pointed", group.dataset.of === state.pointed);
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
  const [x, y] = [at[0] + box.left + host().clientLeft, at[1] + box.top + host().clientTop];
  const inside = [...drawn.layers.labels.querySelectorAll("[data-badge]")].find((badge) => {
    const { left, right, top, bottom } = badge.getBoundingClientRect();
    return x >= left && x <= right && y >= top && y <= bottom;
  });
  return inside?.dataset.badge ?? null;
}

/** Picks the edge that a click without a place is on. */
function pickTarget({ target }) {
  const { panel, edge } = target.dataset;
  if (edge === undefined) return;
  const found = drawn.sheet.panels.get(panel);
  act.select(runOfEdge(found, found.edges[edge], "cw"));
}

/** Takes a click: of a seam's number, or of an edge. */
export function pick(at, event) {
  if (!drawn.sheet) return;
  if (at === null) {
    pickTarget(event);
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

function drawTraced(run, at) {
  const { layers, sheet } = drawn;
  layers.hover.replaceChildren(...(run ? [
    drawSide(scene(), run, "preview"),
    drawTag({ rows: partRows(sheet.panels, run, state.picked), at, window: sheet.size }),
  ] : []));
}

/** Follows a drag along an outline, which picks a part of it. */
export function drag(phase, at, event) {
  if (phase === "begin") {
    const found = edgeAt(at);
    trace = found && !state.tape ? beginTrace(found) : null;
  }
  if (!trace) return;
  const { panel } = trace;
  const found = nearestEdge([{ panel, box: drawn.sheet.boxes.get(panel.id), at: mapOf(panel).back(at) }], Infinity);
  trace = advance(trace, found);
  const run = tracedRun(trace, SNAP_PX / state.view.k);
  if (phase === "move" || phase === "begin") {
    drawTraced(run, at);
    return;
  }
  trace = null;
  setHovered(null);
  drawTraced(null);
  if (phase === "end" && run) act.select(run, { more: event.shiftKey });
}

/** Puts pointing to work: `on.select(run, options)` for a picked run, `on.selectSeam(id)`. */
export function startPointing(on) {
  act = on;
}
