/** Words on the stage: whose shape it is where it is not simply the result, and what is wrong. */

import { byId } from "../dom.js";
import { isUpToDate } from "../ran.js";
import { verdictOf } from "../report.js";
import { state, watch } from "../state.js";
import { plural } from "../words.js";
import { crossingPlaces } from "./crossings.js";

function marksText(report) {
  const { cloth, body } = crossingPlaces(report);
  return [
    cloth.length > 0 && `○ ${plural(cloth.length, "place")} where cloth crosses cloth`,
    body.length > 0 && `□ ${plural(body.length, "place")} where cloth crosses the body`,
  ].filter(Boolean);
}

/** The words, and true where they are of something wrong: `{lines, isBad}`. */
function caption() {
  const { shape, fit, report } = state;
  const nothing = { lines: [], isBad: false };
  if (shape === null) return nothing;
  if (shape !== fit?.id) return { lines: ["The shape of an earlier fit"], isBad: false };
  const { good, text } = report ? verdictOf(report, fit.status) : { good: true };
  const marks = marksText(report);
  if (fit.status === "canceled") return { lines: ["Stopped before it came to rest", ...marks], isBad: true };
  if (!isUpToDate()) return { lines: ["As it was before the last changes", ...marks], isBad: !good };
  return good ? { lines: marks, isBad: false } : { lines: [`✗ ${text}`, ...marks], isBad: true };
}

/** The words as they stand on a picture of the stage. */
export const captionLines = () => caption().lines;

function draw() {
  const { lines, isBad } = caption();
  byId("stage-caption").textContent = lines.join(" · ");
  byId("stage").classList.toggle("bad", isBad);
  if (state.shape === null) delete byId("stage").dataset.shape;
  else byId("stage").dataset.shape = state.shape;
}

export function startCaption() {
  watch(["shape", "fit", "report", "garment", "ran", "leftOut"], draw);
}
