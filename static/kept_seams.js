/**
 * Seams that stay when a pattern is read again in another size, unit or way: those whose edges
 * match.
 */

import { sourceOf } from "./mirrored.js";
import { runsOf } from "./outline.js";

/** Largest difference of an edge's share in the outline of its panel. */
const SHARE = 0.12;

const totalOf = (panel) => panel.edges.reduce((sum, edge) => sum + edge.length_m, 0);

/** True if two panels have the same edges in the same order, as sizes of one piece have. */
function matches(before, now) {
  if (!before || !now || before.edges.length !== now.edges.length) return false;
  const [old, fresh] = [totalOf(before), totalOf(now)];
  return before.edges.every((edge, i) => Math.abs(edge.length_m / old - now.edges[i].length_m / fresh) < SHARE);
}

/** Ids of the panels of `before` whose edges are the same in `now`. */
function matchingIds(before, now) {
  const fresh = new Map(now.panels.map((panel) => [panel.id, panel]));
  return new Set(before.panels.filter((panel) => matches(panel, fresh.get(panel.id))).map((panel) => panel.id));
}

/**
 * The garment for the pattern read anew, and the names of seams that could not stay: `{garment,
 * lost}`.
 */
export function keepSeams(garment, before, now) {
  const same = matchingIds(before, now);
  const stays = (id) => same.has(sourceOf(id));
  const isKept = (seam) => [...runsOf(seam.a), ...runsOf(seam.b)].every((run) => stays(run.panel));
  const seams = garment.seams.filter(isKept);
  const ids = new Set(now.panels.map((panel) => panel.id));
  const panels = Object.fromEntries(Object.entries(garment.panels).filter(([id]) => ids.has(sourceOf(id))));
  const kept = { ...garment, seams, panels };
  if (garment.pins) kept.pins = garment.pins.filter((pin) => stays(pin.panel));
  return { garment: kept, lost: garment.seams.filter((seam) => !isKept(seam)).map((seam) => seam.id) };
}
