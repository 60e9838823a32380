/** Changes of the seams, each a step of the history. */

import { change } from "./history.js";
import { reversedSide, runsOf } from "./outline.js";
import { say } from "./say.js";
import { state } from "./state.js";

/** An id that no seam has, from the panels of its sides. */
export function freshId(sideA, sideB, others = []) {
  const [a, b] = [runsOf(sideA)[0], runsOf(sideB)[0]];
  const used = new Set([...state.garment.seams, ...others].map((seam) => seam.id));
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
export function changeSeams(seams, words, { selected = state.selected, placements = {}, ...rest } = {}) {
  const garment = { ...state.garment, seams, panels: withPlacements(placements) };
  const isThere = seams.some((seam) => seam.id === selected);
  change({ garment, ...rest, selected: isThere ? selected : null }, words);
}

export function changeSeam(id, patch, words = `options of ${id}`) {
  const seams = state.garment.seams.map((seam) => (seam.id === id ? { ...seam, ...patch } : seam));
  changeSeams(seams, words, { selected: id });
}

export function reverseSeam(id) {
  const seam = state.garment.seams.find((one) => one.id === id);
  changeSeam(id, { b: reversedSide(seam.b) }, `turning ${id}`);
  say(`${id}: the second side now runs the other way.`);
}

export function deleteSeam(id) {
  changeSeams(state.garment.seams.filter((seam) => seam.id !== id), `deleting ${id}`);
  say(`Seam ${id} deleted.`);
}

/** Gives a seam another name, which no other has; true if it took it. */
export function renameSeam(id, name) {
  const fresh = name.trim();
  if (fresh === "" || fresh === id) return false;
  if (state.garment.seams.some((seam) => seam.id === fresh)) {
    say(`There is a seam ${fresh} already; ${id} keeps its name.`, true);
    return false;
  }
  const { [id]: reason, ...suggested } = state.suggested;
  const { [id]: number, ...numbers } = state.numbers;
  changeSeams(state.garment.seams.map((seam) => (seam.id === id ? { ...seam, id: fresh } : seam)), `renaming ${id}`, {
    selected: fresh, suggested: reason ? { ...suggested, [fresh]: reason } : suggested, numbers: { ...numbers, [fresh]: number },
  });
  say(`Seam ${id} is now named ${fresh}.`);
  return true;
}
