/**
 * Sides of seams: edges joined to one run, darts in an edge, mirrored twins, stretches that are
 * taken.
 */

import { isMirrorId, mirrorOf, sourceOf } from "./mirrored.js";
import { along, edgesOf, reversedSide, runsOf } from "./outline.js";

/** Largest distance of a corner or notch from its mirror image [m]. */
const MIRRORED_M = 0.004;
/** An edge that turns by more than this [rad] at one of its points has an apex there. */
const APEX = 0.9;

const samePlace = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/** A list of one run is the run. */
const plain = (runs) => (runs.length === 1 ? runs[0] : runs);

/** The side with another run: joined where the two touch, else as a further one of the list. */
export function joined(side, run) {
  const runs = runsOf(side);
  const last = runs.at(-1);
  for (const next of [run, reversedSide(run)]) {
    if (next.panel !== last.panel || next.direction !== last.direction) continue;
    if (samePlace(last.to, next.from)) return plain([...runs.slice(0, -1), { ...last, to: next.to }]);
    if (runs.length === 1 && samePlace(next.to, last.from)) return { ...last, from: next.from };
  }
  return [...runs, run];
}

/** The stretches of edges that sides take: `{key, from, to}`; `find(id)` gives a panel. */
export function stretchesOf(sides, find) {
  return sides.flatMap(runsOf).flatMap((run) => {
    const panel = find(run.panel);
    const covered = panel ? edgesOf(panel, run) : [];
    if (covered.length) return covered.map(({ edge, from, to }) => ({ key: `${run.panel} ${edge}`, from, to }));
    return [{ key: JSON.stringify([run.panel, run.from, run.to]), from: 0, to: 1 }];
  });
}

/** True if some stretch lies on another. */
export const overlap = (stretches, others) => stretches.some(({ key, from, to }) =>
  others.some((other) => other.key === key && Math.min(to, other.to) - Math.max(from, other.from) > 1e-6));

/** True if two sides take the same stretches. */
export function isSameStretch(one, other, find) {
  const keys = (side) => stretchesOf([side], find).map(({ key, from, to }) => `${key} ${from.toFixed(4)} ${to.toFixed(4)}`).sort().join();
  return keys(one) === keys(other);
}

/** Fraction of an edge's length at which it has its apex, or null. */
function apexOf({ points }) {
  let best = { turn: APEX, at: null };
  let length = 0;
  for (let i = 1; i < points.length - 1; i++) {
    const [ax, ay] = [points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]];
    const [bx, by] = [points[i + 1][0] - points[i][0], points[i + 1][1] - points[i][1]];
    length += Math.hypot(ax, ay);
    const turn = Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by));
    if (turn > best.turn) best = { turn, at: length };
  }
  if (best.at === null) return null;
  return best.at / (length + Math.hypot(points.at(-1)[0] - points.at(-2)[0], points.at(-1)[1] - points.at(-2)[1]));
}

/**
 * The two sides of a dart in one edge, by two picks of it: from its ends to its apex, or from two
 * notches to the middle between them. Null where it has neither.
 */
export function dartIn(panel, edge, first, second) {
  const sides = (from, to, middle) => ({
    a: { panel: panel.id, from, to: middle, direction: "cw" },
    b: { panel: panel.id, from: to, to: middle, direction: "ccw" },
  });
  const apex = apexOf(edge);
  if (apex !== null && first.direction !== second.direction) return sides(edge.from, edge.to, { edge: edge.index, at: apex });
  const [one, other] = [first.notch, second.notch].map((index) => panel.notches?.[index]);
  if (!one || !other || one === other) return null;
  const order = one.at < other.at ? [first.notch, second.notch] : [second.notch, first.notch];
  return sides({ notch: order[0] }, { notch: order[1] }, { edge: edge.index, at: (one.at + other.at) / 2 });
}

const nearest = (points, [x, y]) => {
  const distances = points.map(([px, py]) => Math.hypot(px - x, py - y));
  const index = distances.indexOf(Math.min(...distances));
  return distances[index] <= MIRRORED_M ? index : null;
};

/** A place of a symmetric panel on its other half; null where the panel is not symmetric there. */
function mirroredPlace(panel, place) {
  const xs = panel.corners.map((corner) => corner.x);
  const axis = (Math.min(...xs) + Math.max(...xs)) / 2;
  const across = ([x, y]) => [2 * axis - x, y];
  const corner = (index) => nearest(panel.corners.map(({ x, y }) => [x, y]), across([panel.corners[index].x, panel.corners[index].y]));
  if (typeof place === "number") return corner(place);
  const at = (notch) => along(panel.edges[notch.edge].points, notch.at).point;
  if (place && "notch" in place) {
    const notch = nearest(panel.notches.map(at), across(at(panel.notches[place.notch])));
    return notch === null ? null : { notch };
  }
  if (!place || !("edge" in place) || "hole" in place) return null;
  const edge = corner(panel.edges[place.edge].to);
  return edge === null ? null : { edge, at: 1 - place.at };
}

/** The run on the other half of the body; null where there is none. */
function mirroredRun(run, find) {
  if (isMirrorId(run.panel)) return { ...run, panel: sourceOf(run.panel) };
  const panel = find(run.panel);
  const isPair = panel?.quantity?.left > 0 && panel.quantity.right > 0;
  if (isPair || find(mirrorOf(run.panel))) return { ...run, panel: mirrorOf(run.panel) };
  if (!panel) return null;
  const [from, to] = [mirroredPlace(panel, run.from), mirroredPlace(panel, run.to)];
  if (from === null || to === null) return null;
  return { ...run, from, to, direction: run.direction === "cw" ? "ccw" : "cw" };
}

/**
 * The sides of the seam on the other half of the body: `{a, b}`, or null where that is no other
 * seam.
 */
export function twinOf({ a, b }, find) {
  const mirroredSide = (side) => {
    const runs = runsOf(side).map((run) => mirroredRun(run, find));
    return runs.includes(null) ? null : plain(runs);
  };
  const [one, other] = [mirroredSide(a), mirroredSide(b)];
  if (one === null || other === null) return null;
  const isSame = isSameStretch(one, a, find) || isSameStretch(one, b, find);
  return isSame ? null : { a: one, b: other };
}
