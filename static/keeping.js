/** Keeps the work of this tab, and tells where another tab works on the same pattern. */

import { allDrafts, announce, keepDraft, openDrafts } from "./drafts.js";
import { fromAddress } from "./address.js";
import { sayBefore } from "./say.js";
import { fitId, hasWork, state, watch } from "./state.js";

const COPY = "This tab is a copy of another one. Each keeps its own work from here on.";
const ELSEWHERE = "This pattern is open in another tab too. Each tab keeps its own work; Open lists both.";
const OTHER_WORK = "There is other work on this pattern from another tab: Open lists it.";
const NOT_KEPT = "This browser cannot keep the work of this tab: save the garment before you close it.";

let isToldNotKept = false;

/** The state that a draft keeps; the pattern itself only where the service does not hold it. */
function work() {
  const { pattern, reading, garment, suggested, offers, leftOut, numbers, colors, ran, before } = state;
  return {
    name: pattern.name, patternId: pattern.id, stored: Boolean(pattern.stored), pattern: pattern.stored ? null : pattern,
    reading, garment, suggested, offers, leftOut, numbers, colors, ran, before, fit: fitId(),
  };
}

async function keep() {
  if (!state.pattern) return;
  try {
    await keepDraft(state.draft, work());
  } catch {
    if (!isToldNotKept) sayBefore(NOT_KEPT);
    isToldNotKept = true;
  }
}

/**
 * Opens the drafts and keeps this tab's from now on: `{draft, notice}`, the work that it left and a
 * function for the words to say about other work; null where there are none.
 */
export async function startKeeping() {
  const { draft, isCopy } = await openDrafts();
  const { pattern } = fromAddress();
  const isOther = pattern && draft?.patternId !== pattern;
  const others = isOther ? (await allDrafts()).filter((one) => one.patternId === pattern && hasWork(one)) : [];
  watch(["pattern", "garment", "suggested", "offers", "leftOut", "colors", "ran", "before", "fit", "pendingFitId"], keep);
  let isElsewhere = false;
  const tell = announce(() => {
    isElsewhere = true;
    sayBefore(ELSEWHERE);
  });
  let told = null;
  watch(["pattern"], () => {
    const id = state.pattern?.id ?? null;
    if (id !== told) tell(id);
    told = id;
  });
  // A tab that answered has said more than that there is other work.
  const notice = () => (isCopy ? COPY : others.length > 0 && !isElsewhere ? OTHER_WORK : null);
  return { draft, notice };
}
