/** Two picked sides become a seam: one way in for pointer and keyboard. */

import { byId, isDialogOpen, isTyping } from "./dom.js";
import { redo, undo } from "./history.js";
import { edgesOf, lengthOfSide, runsOf } from "./outline.js";
import { forgetCopies, panelOf, panelsShown } from "./panels.js";
import { clockwise, runName, sideName } from "./run_names.js";
import { say } from "./say.js";
import { changeSeams, deleteSeam, freshId } from "./seams.js";
import { dartIn, isSameStretch, joined, overlap, stretchesOf, twinOf } from "./sides.js";
import { state, update, watch } from "./state.js";
import { centimeters } from "./words.js";

/** Takes a step of the history by `move` and says so. */
function travel(move, verb) {
  const words = move();
  forgetCopies();
  if (words !== null) say(`${verb}: ${words}.`);
}

function letGo() {
  if (!state.picked) return;
  update({ picked: null, pickedAt: null });
  say("Let go. Pick the first edge of a seam.");
}

const lengthText = (side) => {
  const panels = new Map(panelsShown().map((panel) => [panel.id, panel]));
  return centimeters(lengthOfSide(panels, side));
};

function pickFirst(run, at) {
  update({ picked: run, pickedAt: at, selected: null, growing: null });
  const start = typeof run.from === "number" ? `corner ${run.from}` : "this place";
  say(`First side: ${runName(run)}, ${clockwise(run)}. Now pick its partner, beginning at the end that meets ${start}. Shift adds edges.`);
}

/**
 * Adds a run to the side that was picked last: the first one, or the second of the seam just made.
 */
function extend(run) {
  const side = state.picked ?? state.garment.seams.find((seam) => seam.id === state.growing).b;
  if (overlap(stretchesOf([run], panelOf), stretchesOf([side], panelOf))) {
    say("This edge is in the side already.");
    return;
  }
  if (state.picked) {
    const picked = joined(state.picked, run);
    update({ picked });
    say(`First side: ${sideName(picked)}, ${lengthText(picked)}. Shift adds more, or pick its partner.`);
    return;
  }
  const { growing } = state;
  const seams = state.garment.seams.map((seam) => (seam.id === growing ? { ...seam, b: joined(seam.b, run) } : seam));
  changeSeams(seams, `an edge more of ${growing}`, { selected: growing });
  say(`Seam ${growing}: second side ${sideName(seams.find((seam) => seam.id === growing).b)}.`);
}

/** The twin on the other half of the body, where there is one and its edges are free. */
function twinFor(seam) {
  const twin = state.mirror ? twinOf(seam, panelOf) : null;
  if (!twin) return [];
  const taken = stretchesOf([...state.garment.seams, seam].flatMap(({ a, b }) => [a, b]), panelOf);
  if (overlap(stretchesOf([twin.a, twin.b], panelOf), taken)) return [];
  return [{ id: freshId(twin.a, twin.b, [seam]), ...twin }];
}

function sew(a, b) {
  const seam = { id: freshId(a, b), a, b };
  const twins = twinFor(seam);
  update({ picked: null, pickedAt: null, growing: seam.id });
  changeSeams([...state.garment.seams, seam, ...twins], `seam ${seam.id}`, { selected: seam.id });
  say(`Seam ${seam.id}: ${sideName(a)} with ${sideName(b)}${twins.length ? `, and mirrored ${twins[0].id}` : ""}.`);
}

/** A second pick of the first side: a dart in it, the side turned, or let go. */
function pickAgain(run, at) {
  const panel = panelOf(run.panel);
  const [{ edge }] = edgesOf(panel, run);
  const pick = (direction, where) => ({ direction, notch: where?.notch });
  const dart = dartIn(panel, panel.edges[edge], pick(runsOf(state.picked)[0].direction, state.pickedAt), pick(run.direction, at));
  if (dart) return sew(dart.a, dart.b);
  if (runsOf(state.picked)[0].direction === run.direction) return letGo();
  update({ picked: run, pickedAt: at });
  return say(`First side turned: ${runName(run)}, ${clockwise(run)}.`);
}

/**
 * Picks a run: the first side, then its partner. `more` adds it to the side picked last; `at` says
 * which notch was near.
 */
export function select(run, { more = false, at = null } = {}) {
  const first = state.picked;
  const grows = state.garment.seams.some((seam) => seam.id === state.growing);
  if (more && (first || grows)) extend(run);
  else if (!first) pickFirst(run, at);
  else if (isSameStretch(first, run, panelOf)) pickAgain(run, at);
  else sew(first, run);
}

/** Shows a seam in full, as a click of its number does. */
export function selectSeam(id) {
  update({ selected: state.selected === id ? null : id, picked: null, pickedAt: null, growing: null });
}

function onKey(event) {
  if (isDialogOpen()) return;
  if (event.key === "Escape") letGo();
  if (isTyping(event.target)) return;
  const key = event.key.toLowerCase();
  if ((key === "delete" || key === "backspace") && state.selected !== null) {
    event.preventDefault();
    deleteSeam(state.selected);
    return;
  }
  if (!(event.ctrlKey || event.metaKey)) return;
  const isRedo = key === "y" || (key === "z" && event.shiftKey);
  if (!isRedo && key !== "z") return;
  event.preventDefault();
  if (isRedo) travel(redo, "Done again");
  else travel(undo, "Undone");
}

/** Numbers of seams by id: a seam keeps its number and color whatever comes and goes. */
function numberSeams() {
  const { numbers, garment } = state;
  const ids = garment.seams.map((seam) => seam.id);
  const known = ids.filter((id) => Object.hasOwn(numbers, id)).map((id) => [id, numbers[id]]);
  const fresh = ids.filter((id) => !Object.hasOwn(numbers, id));
  if (fresh.length === 0 && known.length === Object.keys(numbers).length) return;
  const first = Math.max(0, ...known.map(([, number]) => number)) + 1;
  // A deleted seam takes its number along: another may have its id later.
  update({ numbers: Object.fromEntries([...known, ...fresh.map((id, i) => [id, first + i])]) });
}

export function startPicking() {
  byId("undo").addEventListener("click", () => travel(undo, "Undone"));
  byId("redo").addEventListener("click", () => travel(redo, "Done again"));
  byId("mirror").addEventListener("click", () => update({ mirror: !state.mirror }));
  document.addEventListener("keydown", onKey);
  watch(["mirror"], () => byId("mirror").setAttribute("aria-pressed", String(state.mirror)));
  watch(["garment"], numberSeams);
}
