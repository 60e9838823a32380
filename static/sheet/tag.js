/**
 * The tag at the pointer: which edge it is, its length, and how it compares with the first side.
 */

import { svg } from "../dom.js";
import { edgesOf, lengthOfSide, runsOf } from "../outline.js";
import { titleOf } from "../panels.js";
import { runName } from "../run_names.js";
import { centimeters } from "../words.js";
import { differenceText, gradeOf, gradeText } from "./compare.js";
import { textWidth } from "./labels.js";

const ROW_PX = 17;
const PAD_PX = 8;
const AWAY_PX = 16;
const FONT = "600 12px";

/** Rows that compare two lengths, as `{text, grade}`. */
function comparisonRows(first, second) {
  const grade = gradeOf(first, second);
  return [{ text: differenceText(first, second), grade }, { text: gradeText(first, second), grade }];
}

/** Rows of the tag for an edge. */
export function edgeRows(panel, edge, firstLength) {
  const row = { text: `${titleOf(panel)}, edge ${edge.index}, ${centimeters(edge.length_m)}` };
  return firstLength === null ? [row] : [row, ...comparisonRows(firstLength, edge.length_m)];
}

/** Rows of the tag for a part of an outline. */
export function partRows(panels, run, picked) {
  const length = lengthOfSide(panels, run);
  const row = { text: `${runName(run)}, ${centimeters(length)}` };
  return picked ? [row, ...comparisonRows(lengthOfSide(panels, picked), length)] : [row];
}

/** Beside the point, on the side where the window has room. */
function cornerOf([x, y], width, height, window) {
  const left = x + AWAY_PX + width < window.width ? x + AWAY_PX : Math.max(2, x - AWAY_PX - width);
  const top = y - AWAY_PX - height > 2 ? y - AWAY_PX - height : Math.min(window.height - height - 2, y + AWAY_PX);
  return [left, top];
}

/** True if a picked run lies on an edge, or on a part of it. */
const isOwn = (picked, panel, edge) => runsOf(picked).some((run) =>
  run.panel === panel.id && edgesOf(panel, run).some((covered) => covered.edge === edge.index));

/**
 * Gives the length of the first side for an edge beside it: null for its own edges, or where there
 * is none.
 */
export function firstLengths(picked, panels) {
  if (!picked) return () => null;
  const length = lengthOfSide(panels, picked);
  return (panel, edge) => (isOwn(picked, panel, edge) ? null : length);
}

export function drawTag({ rows, at, window }) {
  const width = Math.max(...rows.map(({ text }) => textWidth(text, FONT))) + 2 * PAD_PX;
  const height = rows.length * ROW_PX + PAD_PX;
  const [left, top] = cornerOf(at, width, height, window);
  return svg("g", { class: "edge-tag", transform: `translate(${left.toFixed(1)} ${top.toFixed(1)})` },
    svg("rect", { width, height, rx: 6 }),
    rows.map(({ text, grade }, i) =>
      svg("text", { class: grade && `grade-${grade}`, x: PAD_PX, y: (i + 0.5) * ROW_PX + PAD_PX / 2 }, text)));
}
