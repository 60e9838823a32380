/** Two picked edges become a seam; every change is checked by the service at once. */

import { postJson } from "./api.js";
import { byId } from "./dom.js";
import { change, redo, undo } from "./history.js";
import { reversedSide, wayOf } from "./outline.js";
import { panelOf, titleOf } from "./panels.js";
import { state, update, watch } from "./state.js";
import { plural, sentence } from "./words.js";

let checking = null;
let did = ""; // the last change in words, until its check answers

/** Says something to everyone: shown above the sheet and read out. */
export function say(text, bad = false) {
  const status = byId("status");
  status.firstElementChild.textContent = text;
  status.classList.toggle("bad", bad);
}

/** Says what was changed; the verdict of the check is added to it. */
export function act(text) {
  did = text;
  say(text);
}

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

function verdict(check) {
  const seam = check.seams.find((finding) => finding.id === state.selected);
  const bad = check.seams.filter((finding) => !finding.ok).length;
  if (seam && !seam.ok) return `Seam ${seam.id} cannot be sewn: ${sentence(seam.errors[0]?.detail ?? "see the list")}`;
  if (bad) return `${bad} of ${plural(check.seams.length, "seam")} cannot be sewn.`;
  if (seam) return "It can be sewn. Pick the next pair, or sew the garment.";
  return check.seams.length === 1 ? "The seam can be sewn." : `All ${check.seams.length} seams can be sewn.`;
}

function sayVerdict(check) {
  const before = did;
  did = "";
  if (!state.picked) say([before, verdict(check)].filter(Boolean).join(" "), check.seams.some((finding) => !finding.ok));
}

async function check() {
  checking?.abort();
  const { pattern, garment } = state;
  if (!pattern?.stored || garment.seams.length === 0) {
    update({ check: null });
    return;
  }
  const { signal } = (checking = new AbortController());
  try {
    const body = { seams: garment.seams, ...(Object.keys(garment.panels).length && { panels: garment.panels }), simulate: garment.simulate };
    const answer = await postJson(`/v1/patterns/${pattern.id}/seams/check`, body, { signal });
    update({ check: answer });
    sayVerdict(answer);
  } catch (problem) {
    if (problem.name === "AbortError") return;
    update({ check: { ok: false, seams: [], corrected: [], problem } });
    say(`The seams could not be checked: ${problem.message}`, true);
  }
}

/** Checks whenever seams or faces change. */
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
  let asked = "";
  watch(["pattern", "garment"], () => {
    const { seams, panels, simulate } = state.garment;
    const now = JSON.stringify([state.pattern?.id, seams, panels, simulate]);
    if (now === asked) return;
    asked = now;
    check();
  });
}
