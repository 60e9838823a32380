/** Paints seams over the panels: matched colours, arrows of direction, threads between matched ends. */

import { svg } from "./dom.js";
import { along, outwards, runPoints, runsOf } from "./outline.js";
import { beside, pathOf } from "./drawing.js";

/** Colour class of the seam at `index` of the list. */
export const colourClass = (index) => `seam-c${index % 10}`;

function arrow(points, map) {
  const { point, tangent: [tx, ty] } = along(points, 0.5);
  const [x, y] = map.point(point);
  const [ux, uy] = [tx, -ty];
  const at = (forward, side) => [x + ux * forward - uy * side, y + uy * forward + ux * side];
  return svg("path", { class: "arrow", d: pathOf([at(10, 0), at(-6, 7), at(-3, 0), at(-6, -7)], true) });
}

/** One run with its arrow, and the number of its seam outside the panel. */
function runMark(panel, map, run, number) {
  const points = runPoints(panel, run);
  if (points.length < 2) return [];
  const mark = [svg("path", { class: "seam-line", d: pathOf(points.map(map.point)) }), arrow(points, map)];
  if (number === undefined) return mark;
  const way = run.direction === "ccw" || (!run.direction && run.to === (run.from + panel.corners.length - 1) % panel.corners.length) ? -1 : 1;
  const [cx, cy] = beside(points, 0.5, map, 20 * way * outwards(panel));
  return [...mark,
    svg("circle", { class: "badge-disc", cx, cy, r: 9 }),
    svg("text", { class: "badge-text", x: cx, y: cy }, String(number))];
}

function ends(sheet, side) {
  const found = runsOf(side).map((run) => {
    const panel = sheet.panels.get(run.panel);
    const points = panel ? runPoints(panel, run) : [];
    return points.length ? points.map(sheet.maps.get(run.panel).point) : null;
  });
  if (found.some((points) => !points)) return null;
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
export function drawSeam(sheet, seam, { index, selected, dim, bad, reversed }) {
  const classes = ["seam-mark", colourClass(index), selected && "selected", dim && "dim", bad && "bad"];
  const mark = svg("g", { class: classes.filter(Boolean).join(" "), "data-seam": seam.id });
  for (const run of [...runsOf(seam.a), ...runsOf(seam.b)]) {
    const panel = sheet.panels.get(run.panel);
    if (panel) mark.append(...runMark(panel, sheet.maps.get(run.panel), run, index + 1));
  }
  if (selected) mark.append(...threads(sheet, seam, reversed));
  return mark;
}

/** The first edge of a pair, or the one under the pointer. */
export function drawRun(sheet, run, className) {
  const panel = sheet.panels.get(run.panel);
  return svg("g", { class: className }, panel ? runMark(panel, sheet.maps.get(run.panel), run) : []);
}
