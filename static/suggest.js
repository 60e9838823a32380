/** Seams that the service suggests: they come beside those that are there, each with how sure it is and why. */

import { postJson } from "./api.js";
import { byId } from "./dom.js";
import { edgesOf, runsOf } from "./outline.js";
import { panelOf, sewnIds, sourceOf } from "./panels.js";
import { changeSeams } from "./picking.js";
import { act, say } from "./say.js";
import { state, update, watch } from "./state.js";
import { plural, sentence } from "./words.js";

let asking = false;

const sidesOf = (seam) => JSON.stringify([seam.a, seam.b]);

/** `{confidence, because}` of a seam that is still as it was suggested. */
export function suggestionOf(seam) {
  const found = state.suggested[seam.id];
  return found?.sides === sidesOf(seam) ? found : null;
}

/** The stretches of edges that a seam takes: `{key, from, to}`. */
function stretches(seam) {
  return [...runsOf(seam.a), ...runsOf(seam.b)].flatMap((run) => {
    const panel = panelOf(run.panel) ?? panelOf(sourceOf(run.panel));
    const covered = panel ? edgesOf(panel, run) : [];
    if (covered.length) return covered.map(({ edge, from, to }) => ({ key: `${run.panel} ${edge}`, from, to }));
    return [{ key: JSON.stringify([run.panel, run.from, run.to]), from: 0, to: 1 }];
  });
}

/** Whether a seam lies on a stretch that is taken. */
function clashes(seam, taken) {
  return stretches(seam).some(({ key, from, to }) =>
    taken.some((other) => other.key === key && Math.min(to, other.to) - Math.max(from, other.from) > 1e-6));
}

function withFreshId(seam, used) {
  let { id } = seam;
  for (let n = 2; used.has(id); n++) id = `${seam.id}-${n}`;
  used.add(id);
  return { ...seam, id };
}

/** Where panels start, of those of which neither the garment nor the pattern's file says so. */
function placementsFor(panels) {
  const { garment, pattern } = state;
  const isOpen = (id) => !garment.panels[id]?.placement && !pattern.placements?.[id];
  return Object.fromEntries(Object.entries(panels).filter(([id]) => isOpen(id)).map(([id, { placement }]) => [id, placement]));
}

function add(found) {
  const there = state.garment.seams;
  const taken = there.flatMap(stretches);
  const used = new Set(there.map((seam) => seam.id));
  const free = found.seams.filter((seam) => !clashes(seam, taken)).map((seam) => withFreshId(seam, used));
  if (free.length === 0) {
    say(found.seams.length
      ? "Nothing to add: every suggested seam lies on an edge that is sewn already."
      : "No seam is suggested: no panel was recognised by its name and shape. Pick the seams by hand.");
    return;
  }
  const suggested = { ...state.suggested };
  const seams = free.map(({ confidence, because, ...seam }) => {
    suggested[seam.id] = { confidence, because, sides: sidesOf(seam) };
    return seam;
  });
  const sewn = new Set([...sewnIds(found.seams)].map(sourceOf));
  const spare = state.pattern.panels.map((panel) => panel.id).filter((id) => !sewn.has(sourceOf(id)));
  changeSeams([...there, ...seams], "suggested seams", { selected: null, placements: placementsFor(found.panels), leftOut: spare, suggested });
  const kept = found.seams.length - free.length;
  const offers = free.filter((seam) => seam.confidence < 0.5).length;
  const unsure = offers ? `, ${offers} of them less than half sure: look at ${offers === 1 ? "it" : "these"} before you sew` : "";
  act(`${plural(free.length, "seam")} suggested${unsure}${kept ? `, ${kept} left as they were picked` : ""}.`);
}

/** Asks the service for seams and adds those whose edges are free. */
export async function suggest() {
  const { pattern } = state;
  if (asking || !pattern?.stored) return;
  asking = true;
  update({ picked: null });
  say("Looking for seams…");
  try {
    const found = await postJson(`/v1/patterns/${encodeURIComponent(pattern.id)}/seams/suggest`, {});
    if (state.pattern === pattern) add(found);
  } catch (problem) {
    if (state.pattern === pattern) say(`No seams could be suggested: ${sentence(problem.message)}`, true);
  } finally {
    asking = false;
  }
}

function drawButton() {
  const { pattern } = state;
  const button = byId("suggest");
  button.disabled = !pattern?.stored;
  button.title = !pattern || pattern.stored
    ? "Adds the seams that garments of this kind have; yours stay"
    : "The service does not hold this pattern: open its file first";
}

export function startSuggest() {
  byId("suggest").addEventListener("click", suggest);
  watch(["pattern"], drawButton);
}
