/**
 * Every change of the seams is checked by the service at once, and again when it can be reached
 * again.
 */

import { isTransient, postJson } from "./api.js";
import { sayVerdict } from "./say.js";
import { state, update, watch } from "./state.js";
import { plural, sentence } from "./words.js";

/** Pause before a check is tried again [ms], doubled up to the longest. */
const RETRY_MS = 1000;
const LONGEST_RETRY_MS = 16_000;

let checking = null;
let retry = null;

/** The verdict on the seams: `{text, tone}`. */
function verdict(check) {
  const seam = check.seams.find((finding) => finding.id === state.selected);
  const bad = check.seams.filter((finding) => !finding.ok).length;
  if (seam && !seam.ok) return { text: `Seam ${seam.id} cannot be sewn: ${sentence(seam.errors[0]?.detail ?? "see the list")}`, tone: "bad" };
  if (bad) return { text: `${bad} of ${plural(check.seams.length, "seam")} cannot be sewn.`, tone: "bad" };
  if (seam?.warnings.length) return { text: `It can be sewn, but ${sentence(seam.warnings[0].detail)}`, tone: "warn" };
  if (seam) return { text: "It can be sewn. Pick the next pair, or sew the garment.", tone: false };
  const doubtful = check.seams.filter((finding) => finding.warnings.length > 0).length;
  const doubt = doubtful ? ` ${plural(doubtful, "seam")} ${doubtful === 1 ? "is" : "are"} doubtful: see the list.` : "";
  return { text: (check.seams.length === 1 ? "The seam can be sewn." : `All ${check.seams.length} seams can be sewn.`) + doubt, tone: doubt ? "warn" : false };
}

async function check(pause = RETRY_MS) {
  checking?.abort();
  clearTimeout(retry);
  const { pattern, garment } = state;
  if (!pattern?.stored || garment.seams.length === 0) {
    update({ check: null, checkProblem: null });
    return;
  }
  const { signal } = (checking = new AbortController());
  try {
    const body = { seams: garment.seams, ...(Object.keys(garment.panels).length && { panels: garment.panels }), simulate: garment.simulate };
    const answer = await postJson(`/v1/patterns/${pattern.id}/seams/check`, body, { signal });
    update({ check: answer, checkProblem: null });
    // While a side is picked no verdict is said, but that the check failed is no longer true.
    const { text, tone } = state.picked ? { text: "" } : verdict(answer);
    sayVerdict(text, tone);
  } catch (problem) {
    if (problem.name === "AbortError") return;
    update({ check: null, checkProblem: problem });
    const again = isTransient(problem) ? " It is tried again." : "";
    sayVerdict(`The seams could not be checked. ${sentence(problem.message)}${again}`, true);
    if (again) retry = setTimeout(check, pause, Math.min(2 * pause, LONGEST_RETRY_MS));
  }
}

/** Checks whenever seams or faces change. */
export function startCheck() {
  let asked = { pattern: null, text: "" };
  watch(["pattern", "garment"], () => {
    const { seams, panels, simulate } = state.garment;
    const { pattern } = state;
    const text = JSON.stringify([seams, panels, simulate]);
    if (pattern === asked.pattern && text === asked.text) return;
    asked = { pattern, text };
    check();
  });
}
