/**
 * The state of the page, and those who hear of its changes. Views only paint; they never keep a
 * copy.
 */

/** The body that a new garment is draped on [m]: a woman in size M. */
export const DEFAULT_FORM = { height_m: 1.68, bust_m: 0.92, waist_m: 0.74, hip_m: 0.98 };

export const emptyGarment = () => ({
  schema: "seamster/garment/1",
  seams: [],
  panels: {},
  default_fabric: "cotton-poplin",
  avatar: { form: { ...DEFAULT_FORM } },
  simulate: { edge_length_m: 0.012 },
});

/** True if something was done with a pattern since it was opened, in this tab or as a draft. */
export const hasWork = ({ garment, offers, leftOut, colors }) =>
  JSON.stringify(garment) !== JSON.stringify(emptyGarment()) || offers?.length > 0 || leftOut?.length > 0 || Object.keys(colors ?? {}).length > 0;

/** State in which nothing is picked, measured or selected. */
export const NO_SELECTION = { picked: null, pickedAt: null, growing: null, tape: null, selected: null };

/** State in which nothing is checked or sewn. */
export const NO_RESULT = { check: null, checkProblem: null, fit: null, pendingFitId: null, report: null, measures: null, before: null, ran: null };

export const state = {
  pattern: null,
  reading: { file: null, options: {} }, // the file that the pattern came from, and how it was read
  garment: emptyGarment(),
  fabrics: {},
  picked: null, // the first side of a seam that is being picked
  pickedAt: null, // where on it: {notch} if one was near
  growing: null, // id of the seam made last, whose second side takes more edges
  mirror: false, // true if a seam brings its twin on the other half of the body
  numbers: {}, // number of each seam by its id
  tape: null, // {from, to}: points of the sheet, null where not set
  pointed: null, // id of the panel under the pointer, in the list or on the sheet
  selected: null, // id of the seam shown in full
  suggested: {}, // what the service said of seams that it suggested, by id: {confidence, because, sides}
  offers: [], // suggested seams that are not sewn before they are accepted
  colors: {}, // colors of fabrics that were chosen, by id: the page's own, not sent
  leftOut: [], // ids of panels that no seam was suggested for
  check: null, // the answer of seams/check
  checkProblem: null, // the error by which the last check came to nothing
  fit: null,
  pendingFitId: null, // id of the pattern's fit, until it is shown or known to be gone
  report: null,
  measures: null, // girths and areas of the shown fit
  before: null, // figures of the fit that was shown before
  shape: null, // id of the fit whose shape is on the stage
  fitView: "cloth", // what the cloth shows: itself, or a map by its name in the report
  lit: null, // {key, points or girth or opening}: what on the stage a person asked to see
  ran: null, // the garment of the shown fit as text, to tell when it is out of date
  draft: null, // name of the draft that the work is kept as
  history: { undo: null, redo: null }, // the changes that can be taken back and made again, in words
  layout: { split: 50, rail: true, drawer: null, full: null },
  view: null, // the part of the sheet that is seen: {x, y, k, home}
};

/** Id of the fit that belongs to the pattern, shown or still to come; null where there is none. */
export const fitId = () => state.fit?.id ?? state.pendingFitId;

const listeners = [];
let changed = new Set();

/** Calls `paint` once in a frame in which one of `keys` changed, and once now. */
export function watch(keys, paint) {
  listeners.push({ keys, paint });
  paint();
}

function flush() {
  const now = changed;
  changed = new Set();
  for (const { keys, paint } of listeners) {
    if (!keys.some((key) => now.has(key))) continue;
    try {
      paint();
    } catch (error) {
      // The others are painted all the same.
      reportError(error);
    }
  }
}

export function update(patch) {
  Object.assign(state, patch);
  if (changed.size === 0) queueMicrotask(flush);
  for (const key of Object.keys(patch)) changed.add(key);
}
