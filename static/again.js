/** A garment sewn again: where it starts from, and what became better or worse than before. */

import { postJson } from "./api.js";
import { el } from "./dom.js";
import { garmentToSend } from "./panels.js";
import { verdictOf } from "./report.js";
import { state } from "./state.js";
import { centimeters, seconds, sentence } from "./words.js";

/** The fit whose shape the next run starts from; null where none of this pattern succeeded. */
export function startableFit() {
  const { fit, before } = state;
  if (fit?.status === "succeeded" && state.report) return fit.id;
  return before?.status === "succeeded" ? before.id : null;
}

/** True if a garment is refused only because it cannot start from the last shape. */
const isStartRefused = ({ faults }) => faults?.length > 0 && faults.every(({ code }) => code.startsWith("garment/start_"));

/** Sends the garment, to start from the shape of a fit where it can: `{fit, refused}`. */
export async function submit(from) {
  try {
    return { fit: await postJson("/v1/fits", garmentToSend(from)), refused: null };
  } catch (problem) {
    if (from === null || !isStartRefused(problem)) throw problem;
    return { fit: await postJson("/v1/fits", garmentToSend(null)), refused: problem };
  }
}

/** Where the run that was sent starts, where that is not to be expected. */
export function startWords(from, refused) {
  if (refused) return ` It starts anew: ${sentence(refused.faults[0].detail)}`;
  return from ? " It goes on from the last shape." : "";
}

/**
 * Figures of the shown fit, to be compared with those of the next; those before where it has none.
 */
export function figuresToKeep() {
  const { fit, report, measures, before } = state;
  if (!report || fit.status === "canceled") return before;
  return { id: fit.id, ...figuresOf(fit, report, measures) };
}

const verdictWord = (report, status) => (verdictOf(report, status).good ? "Good" : report.converged ? "Not right" : "Not at rest");

/** What a fit is compared by. */
function figuresOf({ status }, report, measures) {
  return {
    status, verdict: verdictWord(report, status), cpu_s: report.cpu_s.total,
    isOn: Boolean(report.started_from), girths: measures?.girths ?? [],
  };
}

const START = { true: "the last shape", false: "flat panels" };

const girthOf = ({ girths }, at) => girths.find((girth) => girth.at === at);

function girthRow(at, before, now) {
  const text = (figures) => {
    const girth = girthOf(figures, at);
    return girth ? `${centimeters(girth.cloth_m)}, ease ${centimeters(girth.ease_m)}` : "–";
  };
  return [sentence(at).slice(0, -1), text(before), text(now)];
}

function rows(before, now) {
  const places = [...new Set([...now.girths, ...before.girths].map(({ at }) => at))];
  return [
    ["Verdict", before.verdict, now.verdict],
    ["Computing", seconds(before.cpu_s), seconds(now.cpu_s)],
    ["Sewn from", START[before.isOn], START[now.isOn]],
    ...places.map((at) => girthRow(at, before, now)),
  ];
}

/** The fit before beside the shown one; null where there is none. */
export function comparison() {
  const { before, fit, report, measures } = state;
  if (!before || !report || before.id === fit.id) return null;
  const now = figuresOf(fit, report, measures);
  const heads = ["", "Before", "Now"].map((text) => (text ? el("th", { scope: "col" }, text) : el("td")));
  const row = ([name, ...figures]) => el("tr", {}, el("th", { scope: "row" }, name), figures.map((text) => el("td", {}, text)));
  return el("table", { class: "figures", id: "comparison" },
    el("thead", {}, el("tr", {}, heads)), el("tbody", {}, rows(before, now).map(row)));
}
