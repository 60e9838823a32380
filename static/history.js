/**
 * Undo and redo of all work: every change of pattern or garment goes through `change`, which keeps
 * what was before.
 */

import { byId } from "./dom.js";
import { forgetSaid } from "./say.js";
import { fitId, NO_RESULT, NO_SELECTION, state, update, watch } from "./state.js";

const DEPTH = 200;
/** Parts of the state that are brought back. */
const KEPT = ["pattern", "reading", "garment", "suggested", "offers", "leftOut", "numbers", "colors", "draft"];

const past = [];
const future = [];
let reopen = () => {};

/** The fit that belongs to the pattern, as `{id, ran}`, or null. */
function fitNow() {
  const id = fitId();
  return id === null ? null : { id, ran: state.ran };
}

const snapshot = (words) => ({
  words, fit: fitNow(),
  ...Object.fromEntries(KEPT.map((name) => [name, state[name]])),
});

function tell() {
  update({ history: { undo: past.at(-1)?.words ?? null, redo: future.at(-1)?.words ?? null } });
}

/** Changes the state by `patch`; `words` name the change for undo. */
export function change(patch, words) {
  past.push(snapshot(words));
  if (past.length > DEPTH) past.shift();
  future.length = 0;
  forgetSaid();
  update(patch);
  tell();
}

/** Changes the garment; `patch` replaces its top-level fields. */
export function changeGarment(patch, words) {
  change({ garment: { ...state.garment, ...patch } }, words);
}

/** Goes one step from one list to the other; the words of that step, or null. */
function step(from, to) {
  const target = from.pop();
  if (!target) return null;
  to.push(snapshot(target.words));
  const { words, fit, ...kept } = target;
  const isOther = kept.pattern !== state.pattern;
  // In the same pattern, a seam that grew takes more edges still, and the tape stays in use.
  update({ ...kept, ...(isOther ? { ...NO_SELECTION, ...NO_RESULT } : { picked: null, selected: null }) });
  tell();
  if (isOther && fit) reopen(fit.id, fit.ran);
  return words;
}

/** Takes back the last change; its words, or null if there is none. */
export const undo = () => step(past, future);

/** Makes the change again that was taken back last. */
export const redo = () => step(future, past);

function drawButtons() {
  for (const [id, verb] of [["undo", "Undo"], ["redo", "Redo"]]) {
    const words = state.history[id];
    byId(id).disabled = words === null;
    byId(id).title = words === null ? verb : `${verb}: ${words}`;
  }
}

/**
 * Puts the buttons to work; `onReopen(id, ran)` shows the fit that belongs to a pattern that came
 * back.
 */
export function startHistory(onReopen) {
  reopen = onReopen;
  watch(["history"], drawButtons);
}
