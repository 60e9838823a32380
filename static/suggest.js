/**
 * Seams that the service suggests: they come beside those that are there, each with how sure it is
 * and why.
 */

import { postJson } from "./api.js";
import { byId, commitEdit } from "./dom.js";
import { change } from "./history.js";
import { sourceOf } from "./mirrored.js";
import { panelOf, sewnIds } from "./panels.js";
import { say } from "./say.js";
import { changeSeams } from "./seams.js";
import { overlap, stretchesOf } from "./sides.js";
import { state, update, watch } from "./state.js";
import { plural, sentence } from "./words.js";

const asking = new Set(); // patterns whose answer is awaited

const sidesOf = (seam) => JSON.stringify([seam.a, seam.b]);

/** `{confidence, because}` of a seam that is still as it was suggested. */
export function suggestionOf(seam) {
  const found = state.suggested[seam.id];
  return found?.sides === sidesOf(seam) ? found : null;
}

const find = (id) => panelOf(id) ?? panelOf(sourceOf(id));

const takenBy = (seams) => stretchesOf(seams.flatMap(({ a, b }) => [a, b]), find);

function withFreshId(seam, used) {
  let { id } = seam;
  for (let n = 2; used.has(id); n++) id = `${seam.id}-${n}`;
  used.add(id);
  return { ...seam, id };
}

/** Placements of those panels of which neither the garment nor the pattern's file has one. */
function placementsFor(panels) {
  const { garment, pattern } = state;
  const isOpen = (id) => !garment.panels[id]?.placement && !pattern.placements?.[id];
  return Object.fromEntries(Object.entries(panels).filter(([id]) => isOpen(id)).map(([id, { placement }]) => [id, placement]));
}

/** A proposal below this confidence is an offer, which is not sewn before it is accepted. */
const OFFER = 0.5;

const plainSeam = ({ confidence, because, ...seam }) => seam;

const reasonOf = (seam) => ({ confidence: seam.confidence, because: seam.because, sides: sidesOf(seam) });

/** Number of panels that the proposals understand, in words. */
function understood(seams) {
  const sewn = new Set([...sewnIds(seams)].map(sourceOf));
  const all = state.pattern.panels.filter((panel) => !panel.copy_of);
  return `${all.filter((panel) => sewn.has(panel.id)).length} of ${plural(all.length, "panel")} understood`;
}

function summary(proposals, offers, kept) {
  const parts = [`${plural(proposals.length, "seam")} suggested`];
  if (offers.length) parts.push(`${offers.length} more only offered, as less than half sure`);
  if (kept) parts.push(`${kept} left as they were picked`);
  return `${parts.join(", ")}; ${understood([...proposals, ...offers])}.`;
}

function add(found) {
  commitEdit();
  const there = state.garment.seams;
  const taken = takenBy(there);
  const used = new Set(there.map((seam) => seam.id));
  const free = found.seams.filter((seam) => !overlap(takenBy([seam]), taken)).map((seam) => withFreshId(seam, used));
  if (free.length === 0) {
    say(found.seams.length
      ? "Nothing to add: every suggested seam lies on an edge that is sewn already."
      : "No seam is suggested: no panel was recognized by its name and shape. Pick the seams by hand.");
    return;
  }
  const proposals = free.filter((seam) => seam.confidence >= OFFER);
  const offers = free.filter((seam) => seam.confidence < OFFER);
  const suggested = { ...state.suggested, ...Object.fromEntries(proposals.map((seam) => [seam.id, reasonOf(seam)])) };
  const sewn = new Set([...sewnIds(found.seams)].map(sourceOf));
  const leftOut = state.pattern.panels.map((panel) => panel.id).filter((id) => !sewn.has(sourceOf(id)));
  changeSeams([...there, ...proposals.map(plainSeam)], "suggested seams",
    { selected: null, placements: placementsFor(found.panels), leftOut, suggested, offers });
  say(summary(proposals, offers, found.seams.length - free.length));
}

/** Takes proposals as they are: they are no longer marked as such. */
export function accept(ids) {
  const suggested = Object.fromEntries(Object.entries(state.suggested).filter(([id]) => !ids.includes(id)));
  change({ suggested }, `accepting ${ids.length === 1 ? ids[0] : plural(ids.length, "proposal")}`);
  say(ids.length === 1 ? `Seam ${ids[0]} accepted.` : `${plural(ids.length, "proposal")} accepted.`);
}

const withoutOffer = (id) => state.offers.filter((offer) => offer.id !== id);

/** Makes an offer a seam. */
export function acceptOffer(offer) {
  const seam = withFreshId(plainSeam(offer), new Set(state.garment.seams.map(({ id }) => id)));
  changeSeams([...state.garment.seams, seam], `accepting ${offer.id}`, { selected: seam.id, offers: withoutOffer(offer.id) });
  say(`Seam ${seam.id} accepted.`);
}

export function refuseOffer(offer) {
  change({ offers: withoutOffer(offer.id) }, `refusing ${offer.id}`);
  say(`${offer.id} refused.`);
}

/** Asks the service for seams and adds those whose edges are free. */
export async function suggest() {
  const { pattern } = state;
  if (asking.has(pattern) || !pattern?.stored) return;
  asking.add(pattern);
  update({ picked: null });
  say("Looking for seams…");
  try {
    const found = await postJson(`/v1/patterns/${encodeURIComponent(pattern.id)}/seams/suggest`, {});
    if (state.pattern === pattern) add(found);
  } catch (problem) {
    if (state.pattern === pattern) say(`No seams could be suggested: ${sentence(problem.message)}`, true);
  } finally {
    asking.delete(pattern);
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
