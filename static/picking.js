/** Two picked edges become a seam: selection, and the changes of seams. */

import { byId } from "./dom.js";
import { change, redo, undo } from "./history.js";
import { reversedSide, wayOf } from "./outline.js";
import { panelOf, titleOf } from "./panels.js";
import { act, say } from "./say.js";
import { state, update } from "./state.js";

export function panelName(id) {
  const panel = panelOf(id);
  return panel ? titleOf(panel) : id;
}

const placeName = (place) => {
  if (typeof place === "number") return String(place);
  if (place && "notch" in place) return `notch ${place.notch}`;
  if (place && "edge" in place) return `edge ${place.edge} at ${place.at}`;
  return JSON.stringify(place);
};

/** `FRONT 3 → 4`. */
export const runName = (run) => `${panelName(run.panel)} ${placeName(run.from)} → ${placeName(run.to)}`;

function freshId(a, b) {
  const used = new Set(state.garment.seams.map((seam) => seam.id));
  const stem = a.panel === b.panel ? a.panel : `${a.panel}-${b.panel}`;
  for (let n = 1; ; n++) if (!used.has(`${stem}-${n}`)) return `${stem}-${n}`;
}

/** The panels of the garment with other placements; `null` takes one away. */
function withPlacements(placements) {
  const panels = { ...state.garment.panels };
  for (const [id, placement] of Object.entries(placements)) {
    const { placement: _, ...rest } = panels[id] ?? {};
    panels[id] = placement ? { ...rest, placement } : rest;
    if (Object.keys(panels[id]).length === 0) delete panels[id];
  }
  return panels;
}

/** Replaces the seams, and with them what a suggestion brings; `words` name the change. */
export function changeSeams(seams, words, { selected = state.selected, placements = {}, leftOut = state.leftOut, suggested = state.suggested } = {}) {
  const garment = { ...state.garment, seams, panels: withPlacements(placements) };
  const isThere = seams.some((seam) => seam.id === selected);
  change({ garment, leftOut, suggested, selected: isThere ? selected : null }, words);
}

/** Takes a step of the history by `move` and says so. */
function travel(move, verb) {
  const words = move();
  if (words !== null) act(`${verb}: ${words}.`);
}

export function changeSeam(id, patch, words = `options of ${id}`) {
  const seams = state.garment.seams.map((seam) => (seam.id === id ? { ...seam, ...patch } : seam));
  changeSeams(seams, words, { selected: id });
}

export function reverseSeam(id) {
  const seam = state.garment.seams.find((one) => one.id === id);
  changeSeam(id, { b: reversedSide(seam.b) }, `turning ${id}`);
  act(`${id}: the second side now runs the other way.`);
}

export function deleteSeam(id) {
  changeSeams(state.garment.seams.filter((seam) => seam.id !== id), `deleting ${id}`);
  act(`Seam ${id} deleted.`);
}

export function letGo() {
  if (!state.picked) return;
  update({ picked: null });
  say("Let go. Pick the first edge of a seam.");
}

const clockwise = (run) => {
  const panel = panelOf(run.panel);
  // On a mirrored copy the numbers run the other way round.
  return (wayOf(panel, run) === "ccw") === !panel.copy_of ? "counter-clockwise" : "clockwise";
};

/** The one way in for pointer and keyboard: the first edge, then its partner. */
export function select(run) {
  const first = state.picked;
  if (!first) {
    update({ picked: run, selected: null });
    say(`First side: ${runName(run)}, ${clockwise(run)}. Now pick its partner, beginning at the end that meets corner ${run.from}.`);
    return;
  }
  const same = first.panel === run.panel && [first.from, first.to].sort().join() === [run.from, run.to].sort().join();
  if (same) {
    if (first.direction === run.direction) letGo();
    else {
      update({ picked: run });
      say(`First side turned: ${runName(run)}, ${clockwise(run)}.`);
    }
    return;
  }
  const seam = { id: freshId(first, run), a: first, b: run };
  update({ picked: null });
  changeSeams([...state.garment.seams, seam], `seam ${seam.id}`, { selected: seam.id });
  act(`Seam ${seam.id}: ${runName(first)} with ${runName(run)}.`);
}

export function startPicking() {
  byId("undo").addEventListener("click", () => travel(undo, "Undone"));
  byId("redo").addEventListener("click", () => travel(redo, "Done again"));
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") letGo();
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.target.matches?.("input, select, textarea")) return;
    const isRedo = key === "y" || (key === "z" && event.shiftKey);
    if (!isRedo && key !== "z") return;
    event.preventDefault();
    if (isRedo) travel(redo, "Done again");
    else travel(undo, "Undone");
  });
}
