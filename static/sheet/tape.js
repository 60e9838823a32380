/** A tape between two points of the sheet, caught by corners and outlines. */

import { svg } from "../dom.js";
import { along } from "../outline.js";
import { centimeters } from "../words.js";
import { onSheet } from "./arrangement.js";
import { pathOf } from "./drawing.js";
import { textWidth } from "./labels.js";
import { toScreen } from "./view.js";

const FONT = "600 12px";
/** Reach of the ends of edges, which catch the tape [px]. */
const SNAP_PX = 10;

/** The text of a tape: its length, how far across and how far down. */
function tapeText([ax, ay], [bx, by]) {
  const [dx, dy] = [Math.abs(bx - ax), Math.abs(by - ay)];
  const straight = centimeters(Math.hypot(dx, dy));
  return dx > 0.002 && dy > 0.002 ? `${straight} (${centimeters(dx)} across, ${centimeters(dy)} along)` : straight;
}

/**
 * The point of an edge that a click near it means: its end where that is near, else the nearest
 * point.
 */
export function caughtPoint({ edge, fraction, at }, place, view) {
  const ends = [edge.points[0], edge.points.at(-1)].map((point) => onSheet(place, point));
  const isNear = (point) => {
    const [x, y] = toScreen(view, point);
    return Math.hypot(x - at[0], y - at[1]) <= SNAP_PX;
  };
  return ends.find(isNear) ?? onSheet(place, along(edge.points, fraction).point);
}

/** Paints a tape between two points of the sheet; nothing while one of them is not set. */
export function drawTape(from, to, view) {
  if (!from || !to) return [];
  const text = tapeText(from, to);
  const [[ax, ay], [bx, by]] = [toScreen(view, from), toScreen(view, to)];
  const width = textWidth(text, FONT) + 14;
  const [x, y] = [(ax + bx) / 2, (ay + by) / 2 - 14];
  return [svg("g", { class: "tape" },
    svg("path", { d: pathOf([[ax, ay], [bx, by]]) }),
    svg("circle", { cx: ax, cy: ay, r: 3.5 }), svg("circle", { cx: bx, cy: by, r: 3.5 }),
    svg("rect", { x: x - width / 2, y: y - 10, width, height: 20, rx: 6 }),
    svg("text", { x, y }, text))];
}
