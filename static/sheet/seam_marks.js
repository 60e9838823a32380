/**
 * Paints seams over the panels: matched colors, arrows of direction, threads between matched ends.
 */

import { svg } from "../dom.js";
import { along, outwards, runPoints, runsOf } from "../outline.js";
import { beside, pathOf } from "./drawing.js";

const BADGE_PX = 19;
/** Places of a badge: fraction of its run, and distance beside it [px]. */
const BADGE_PLACES = [[0.5, 20], [0.35, 20], [0.65, 20], [0.2, 20], [0.8, 20], [0.5, -20], [0.35, -20], [0.65, -20], [0.5, 34]];

/** Color class of the seam with a number. */
export const colorClass = (number) => `seam-c${(number + 9) % 10}`;

function arrow(points, map) {
  const { point, tangent: [tx, ty] } = along(points, 0.5);
  const [x, y] = map.point(point);
  const [ux, uy] = [tx, -ty];
  const at = (forward, side) => [x + ux * forward - uy * side, y + uy * forward + ux * side];
  return svg("path", { class: "arrow", d: pathOf([at(10, 0), at(-6, 7), at(-3, 0), at(-6, -7)], true) });
}

const pointsOf = (sheet, run) => {
  const panel = sheet.panels.get(run.panel);
  return panel ? runPoints(panel, run) : [];
};

/** One run with its arrow. */
function runMark(sheet, run) {
  const points = pointsOf(sheet, run);
  if (points.length < 2) return [];
  const map = sheet.maps.get(run.panel);
  return [svg("path", { class: "seam-line", d: pathOf(points.map(map.point)) }), arrow(points, map)];
}

const isBackwards = (panel, run) =>
  run.direction === "ccw" || (!run.direction && run.to === (run.from + panel.corners.length - 1) % panel.corners.length);

function badge(sheet, run, seam, number) {
  const points = pointsOf(sheet, run);
  if (points.length < 2) return [];
  const panel = sheet.panels.get(run.panel);
  const way = (isBackwards(panel, run) ? -1 : 1) * outwards(panel);
  const places = BADGE_PLACES.map(([at, px]) => {
    const [x, y] = beside(points, at, sheet.maps.get(run.panel), px * way);
    return { x, y, width: BADGE_PX, height: BADGE_PX };
  });
  const draw = ({ x, y }) => svg("g", { class: `label badge ${colorClass(number)}`, "data-badge": seam.id },
    svg("circle", { class: "badge-disc", cx: x, cy: y, r: 9 }),
    svg("text", { class: "badge-text", x, y }, String(number)));
  return [{ places, draw }];
}

/** The numbers of a seam beside its sides, as labels. */
export const badgesOf = (sheet, seam, number) =>
  [...runsOf(seam.a), ...runsOf(seam.b)].flatMap((run) => badge(sheet, run, seam, number));

function ends(sheet, side) {
  const found = runsOf(side).map((run) => pointsOf(sheet, run).map((point) => sheet.maps.get(run.panel).point(point)));
  if (found.some((points) => points.length === 0)) return null;
  return { start: found[0][0], end: found.at(-1).at(-1) };
}

/** Lines between the ends that meet, with a ring round each of these corners. */
function threads(sheet, seam, reversed) {
  const a = ends(sheet, seam.a);
  const b = ends(sheet, seam.b);
  if (!a || !b) return [];
  const pairs = reversed ? [[a.start, b.end], [a.end, b.start]] : [[a.start, b.start], [a.end, b.end]];
  return pairs.flatMap(([p, q]) => [
    svg("path", { class: "thread", d: pathOf([p, q]) }),
    ...[p, q].map(([cx, cy]) => svg("circle", { class: "thread-end", cx, cy, r: 11.5 })),
  ]);
}

/** A seam on the sheet; the selected one has threads. */
export function drawSeam(sheet, seam, { number, selected, dim, bad, proposed, reversed }) {
  const classes = ["seam-mark", colorClass(number), proposed && "proposed", selected && "selected", dim && "dim", bad && "bad"];
  const mark = svg("g", { class: classes.filter(Boolean).join(" "), "data-seam": seam.id });
  for (const run of [...runsOf(seam.a), ...runsOf(seam.b)]) mark.append(...runMark(sheet, run));
  if (selected) mark.append(...threads(sheet, seam, reversed));
  return mark;
}

/** The first side of a pair, or the edge under the pointer. */
export const drawSide = (sheet, side, className) =>
  svg("g", { class: className }, runsOf(side).flatMap((run) => runMark(sheet, run)));
