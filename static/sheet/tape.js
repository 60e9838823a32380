/** A tape between two points of the sheet, caught by corners and outlines. */

import { svg } from "../dom.js";
import { textWidth } from "./labels.js";
import { pathOf } from "./drawing.js";

const FONT = "600 12px";

const centimetres = (metres) => `${(metres * 100).toFixed(1)} cm`;

/** The text of a tape: its length, how far across and how far down. */
export function tapeText([ax, ay], [bx, by]) {
  const [dx, dy] = [Math.abs(bx - ax), Math.abs(by - ay)];
  const straight = centimetres(Math.hypot(dx, dy));
  return dx > 0.002 && dy > 0.002 ? `${straight} (${centimetres(dx)} across, ${centimetres(dy)} along)` : straight;
}

/** Paints a tape between two points in pixels. */
export function drawTape([ax, ay], [bx, by], text) {
  const width = textWidth(text, FONT) + 14;
  const [x, y] = [(ax + bx) / 2, (ay + by) / 2 - 14];
  return svg("g", { class: "tape" },
    svg("path", { d: pathOf([[ax, ay], [bx, by]]) }),
    svg("circle", { cx: ax, cy: ay, r: 3.5 }), svg("circle", { cx: bx, cy: by, r: 3.5 }),
    svg("rect", { x: x - width / 2, y: y - 10, width, height: 20, rx: 6 }),
    svg("text", { x, y }, text));
}
