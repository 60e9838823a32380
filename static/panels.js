/**
 * Panels as they are seen and sewn: mirrored copies that the garment names come along, spare panels
 * stay out.
 */

import { mirrorOf, sourceOf } from "./mirrored.js";
import { runsOf } from "./outline.js";
import { state } from "./state.js";

/** A panel's name; a mirrored copy has that of its source. */
export const titleOf = (panel) => (panel.copy_of ? `${panel.name}, mirrored` : panel.name);

const reflected = ([x, y]) => [0 - x, y];

/**
 * The panel reflected x -> -x, as the service has it: all numbers are kept, and `cw` is still from
 * corner 0 to 1.
 */
function mirrored(panel) {
  const line = (points) => (points ?? []).map(reflected);
  const edges = (all) => all.map((edge) => ({ ...edge, points: line(edge.points) }));
  const corners = (all) => all.map((corner) => ({ ...corner, x: 0 - corner.x }));
  const hole = (one) => ({ corners: corners(one.corners), edges: edges(one.edges) });
  return {
    ...panel, id: mirrorOf(panel.id), copy_of: panel.id, quantity: null,
    corners: corners(panel.corners), edges: edges(panel.edges), holes: (panel.holes ?? []).map(hole),
    cut_line: line(panel.cut_line), drill_holes: line(panel.drill_holes), internal_lines: (panel.internal_lines ?? []).map(line),
    grain: panel.grain && { angle_deg: (360 - panel.grain.angle_deg) % 180 },
  };
}

const runsIn = (seams) => seams.flatMap((seam) => [...runsOf(seam.a), ...runsOf(seam.b)]);

/** Ids of panels that seams run along. */
export const sewnIds = (seams) => new Set(runsIn(seams).map((run) => run.panel));

/** Ids that the garment names: in seams, panels and pins. */
const namedIds = ({ seams, panels, pins }) =>
  new Set([...sewnIds(seams), ...Object.keys(panels), ...(pins ?? []).map((pin) => pin.panel)]);

let shown = { pattern: null, garment: null, panels: [] };

/** The pattern's panels, and the mirrored copies that the garment names or has named. */
export function panelsShown() {
  const { pattern, garment } = state;
  if (!pattern) return [];
  if (shown.pattern !== pattern) shown = { pattern, garment: null, panels: pattern.panels };
  if (shown.garment !== garment) {
    const named = namedIds(garment);
    const there = new Set(shown.panels.map((panel) => panel.id));
    const missing = pattern.panels.filter(({ id, copy_of: copy }) => !copy && named.has(mirrorOf(id)) && !there.has(mirrorOf(id)));
    shown = { pattern, garment, panels: missing.length ? [...shown.panels, ...missing.map(mirrored)] : shown.panels };
  }
  return shown.panels;
}

/** Forgets mirrored copies that the garment no longer names. */
export function forgetCopies() {
  shown = { pattern: null, garment: null, panels: [] };
}

export const panelOf = (id) => panelsShown().find((panel) => panel.id === id);

/**
 * Spare panels that stay out when the garment is sewn: those that no seam was suggested for, while
 * nothing names them.
 */
export function leftOut() {
  const named = new Set([...namedIds(state.garment)].map(sourceOf));
  return state.leftOut.filter((id) => !named.has(sourceOf(id)));
}

/** The pattern as it is sewn: without what only the page knows and without spare panels. */
export function plainPattern() {
  const { stored, ...pattern } = state.pattern;
  const out = new Set(leftOut());
  if (out.size === 0) return pattern;
  const placements = Object.fromEntries(Object.entries(pattern.placements ?? {}).filter(([id]) => !out.has(id)));
  return { ...pattern, panels: pattern.panels.filter(({ id }) => !out.has(id)), placements };
}

/** Maps that a fit is judged by; of what is worn over another garment there are fewer. */
const mapsOf = (garment) => (garment.over ? ["strain"] : ["strain", "pressure", "gap"]);

/**
 * The garment as it is sent: the pattern by id where the service has it and all of it is sewn;
 * `from` is the fit whose shape it starts from, else it starts as the garment says.
 */
export function garmentToSend(from) {
  const { pattern, garment } = state;
  const sent = { ...garment, maps: mapsOf(garment), pattern: pattern.stored && leftOut().length === 0 ? pattern.id : plainPattern() };
  return from ? { ...sent, start_from: from } : sent;
}
