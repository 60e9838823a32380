/**
 * Files of patterns, garments and bodies: opened by choice, drop or sample, read again in another
 * way, saved.
 */

import { call, getJson } from "./api.js";
import { fromAddress } from "./address.js";
import { byId, commitEdit, el, replaceChildren } from "./dom.js";
import { freshName, takeOver } from "./drafts.js";
import { change } from "./history.js";
import { keepSeams } from "./kept_seams.js";
import { openRail } from "./layout.js";
import { runsOf } from "./outline.js";
import { plainPattern } from "./panels.js";
import { say } from "./say.js";
import { uploadBody } from "./settings.js";
import { emptyGarment, hasWork, NO_RESULT, NO_SELECTION, state, update } from "./state.js";
import { suggest } from "./suggest.js";
import { plural, problemItems, sentence } from "./words.js";

let loads = 0;

/** A garment from a file, over the defaults; the pattern is kept apart. */
function garmentFrom(saved) {
  const { pattern, ...garment } = saved ?? {};
  return { ...emptyGarment(), ...garment, seams: Array.isArray(garment.seams) ? garment.seams : [], panels: garment.panels ?? {} };
}

function greeting({ pattern, garment }) {
  if (!pattern.stored) return `${pattern.name}. The service does not hold this pattern: seams are checked when you sew.`;
  return garment.seams.length
    ? `${pattern.name}: ${plural(pattern.panels.length, "panel")}, ${plural(garment.seams.length, "seam")}.`
    : "Pick the first edge of a seam: click it near the end where sewing begins. Or have the seams suggested.";
}

/**
 * Shows a pattern with a garment; the shown fit goes. What was there can be brought back, and stays
 * as a draft of its own, unless this is the same work still; `said` replaces the greeting.
 */
function show(found) {
  const { pattern, garment, reading = { file: null, options: {} }, suggested = {}, offers = [], leftOut = [], numbers = {}, colors = {} } = found;
  const { said = greeting(found), isSameWork = false } = found;
  commitEdit();
  const isLeft = state.pattern !== null && hasWork(state) && !isSameWork;
  const replaced = isLeft ? ` Undo brings back ${state.pattern.name}.` : "";
  const draft = found.draft ?? (isLeft ? null : state.draft) ?? freshName();
  const patch = { pattern, garment, reading, suggested, offers, leftOut, numbers, colors, draft, ...NO_SELECTION, ...NO_RESULT };
  if (state.pattern) change(patch, `opening ${pattern.name}`);
  else update(patch);
  say(said + replaced);
}

/** Sends a pattern file; answers the stored pattern. */
async function upload(file, options) {
  const query = new URLSearchParams(Object.entries(options).filter(([, value]) => value));
  const body = new FormData();
  body.append("file", file, file.name);
  const answer = await call(`/v1/patterns${query.size ? `?${query}` : ""}`, { method: "POST", body });
  return { ...(await answer.json()), stored: true };
}

/** Runs a load; a later one wins, and faults are shown beside the pattern. */
async function load(work) {
  const mine = ++loads;
  byId("pattern-faults").replaceChildren();
  say("Reading…");
  try {
    const found = await work();
    if (mine !== loads || !found) return false;
    show(found);
    return true;
  } catch (problem) {
    if (mine !== loads) return false;
    replaceChildren(byId("pattern-faults"), problemItems(problem));
    if (innerWidth >= 1000) openRail();
    say(`The file could not be used. ${sentence(problem.faults?.[0]?.detail ?? problem.message)}`, true);
    return false;
  }
}

async function openPattern(file) {
  await load(async () => {
    const pattern = await upload(file, {});
    return { pattern, garment: garmentFrom({ seams: pattern.seams ?? [] }), reading: { file, options: {} } };
  });
}

/** Reads the same file in another way; seams stay where their edges do. */
export async function readAgain(options) {
  const { pattern: before, reading: { file } } = state;
  if (!file) return;
  await load(async () => {
    const pattern = await upload(file, options);
    if (state.pattern !== before) {
      say(`${before.name} was not read again, because another pattern is shown now.`);
      return null;
    }
    commitEdit();
    const { leftOut, suggested, numbers, offers, colors } = state;
    const { garment, lost } = keepSeams(state.garment, before, pattern);
    const isBare = garment.seams.length === 0 && lost.length === 0;
    if (isBare) garment.seams = pattern.seams ?? [];
    const found = { pattern, garment, reading: { file, options }, leftOut, suggested, numbers, colors, isSameWork: true };
    const said = [
      isBare ? greeting(found) : `${plural(garment.seams.length, "seam")} kept.`,
      lost.length > 0 && `${plural(lost.length, "seam")} went, because the edges are others: ${lost.join(", ")}.`,
      offers.length > 0 && `${plural(offers.length, "offer")} went: ${offers.map(({ id }) => id).join(", ")}.`,
      lost.length + offers.length > 0 && "Undo brings all back.",
    ];
    return { ...found, said: said.filter(Boolean).join(" ") };
  });
}

export async function openSample(name) {
  await load(async () => {
    const [dxf, garment] = await Promise.all([call(`/samples/${name}.dxf`), getJson(`/samples/${name}.garment.json`)]);
    const file = new File([await dxf.blob()], `${name}.dxf`);
    return { pattern: await upload(file, {}), garment: garmentFrom(garment), reading: { file, options: {} } };
  });
}

/**
 * The pattern that a garment names: stored under its id, or whole in the file; and what the file
 * left out of it.
 */
async function patternOf(saved) {
  const named = saved.pattern;
  const id = typeof named === "string" ? named : named?.id;
  if (id) {
    try {
      const pattern = { ...(await getJson(`/v1/patterns/${encodeURIComponent(id)}`)), stored: true };
      const sewn = named.panels && new Set(named.panels.map((panel) => panel.id));
      return { pattern, leftOut: sewn ? pattern.panels.map((panel) => panel.id).filter((one) => !sewn.has(one)) : [] };
    } catch (problem) {
      if (typeof named === "string" || problem.status !== 404) throw problem;
    }
  }
  if (named?.panels) return { pattern: { ...named, stored: false } };
  // A copy: works are told apart by the identity of their pattern.
  if (state.pattern) return { pattern: { ...state.pattern } };
  throw new Error("This garment file names no pattern. Open its DXF first, then the garment file.");
}

function parsed(text, name) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Error(`${name} is not JSON: ${error.message}`);
  }
}

const isPlace = (place) => typeof place === "number" || (typeof place === "object" && place !== null);

const isSide = (side) => runsOf(side).length > 0
  && runsOf(side).every((run) => typeof run?.panel === "string" && isPlace(run.from) && isPlace(run.to));

/** Refuses a garment whose seams the page cannot show. */
function refuseBroken(saved, name) {
  if (!Array.isArray(saved?.seams)) throw new Error(`${name} is not a garment file: it has no list of seams.`);
  const at = saved.seams.findIndex((seam) => typeof seam?.id !== "string" || !isSide(seam.a) || !isSide(seam.b));
  if (at < 0) return;
  const title = typeof saved.seams[at]?.id === "string" ? `seam ${saved.seams[at].id}` : `seam ${at + 1}`;
  throw new Error(`${name}: ${title} is not complete. A seam has an id and two sides, a and b, and each side has panel, from and to.`);
}

async function openGarment(file) {
  let asksForSeams = false;
  const shown = await load(async () => {
    const saved = parsed(await file.text(), file.name);
    asksForSeams = saved?.seams === "suggest";
    if (!asksForSeams) refuseBroken(saved, file.name);
    return { ...(await patternOf(saved)), garment: garmentFrom(saved) };
  });
  if (shown && asksForSeams) await suggest();
}

/** True if the text of a file is that of a garment, not of a pattern. */
function isGarment(text) {
  try {
    const found = JSON.parse(text);
    return found?.schema?.startsWith?.("seamster/garment") || (found?.seams !== undefined && found?.pattern !== undefined);
  } catch {
    return false;
  }
}

/** Opens a file of any kind that the page knows. */
export async function openFile(file) {
  if (/\.(obj|glb|ply)$/i.test(file.name)) await uploadBody(file);
  else if (/\.json$/i.test(file.name) && isGarment(await file.text())) await openGarment(file);
  else await openPattern(file);
}

/** The pattern of a draft, from its file where the service has it no longer. */
async function patternOfDraft({ pattern, patternId, reading }) {
  try {
    return (await patternOf({ pattern: pattern ?? patternId })).pattern;
  } catch (problem) {
    if (problem.status !== 404 || !reading?.file) throw problem;
    return upload(reading.file, reading.options);
  }
}

/** Opens work as a draft keeps it; with `fit` that fit is shown beside it, by `showFit`. */
export async function openDraft(draft, showFit) {
  const shown = await load(async () => {
    const [pattern, name] = [await patternOfDraft(draft), await takeOver(draft)];
    const { reading, suggested, offers, leftOut, numbers, colors } = draft;
    return { pattern, reading, garment: garmentFrom(draft.garment), suggested, offers, leftOut, numbers, colors, draft: name };
  });
  if (shown) update({ before: draft.before ?? null });
  if (shown && draft.fit) showFit(draft.fit, draft.ran);
}

/** Opens a fit with the garment that it sewed. */
export async function openFit(id, showFit) {
  const shown = await load(async () => {
    // The shape that it started from is large; the next run starts from its own.
    const { start_from: _, ...saved } = await getJson(`/v1/fits/${encodeURIComponent(id)}/garment`);
    return { ...(await patternOf(saved)), garment: garmentFrom(saved) };
  });
  if (shown) showFit(id);
}

/** Opens what the address names, as this tab left it where it has a draft of that. */
export async function openFromAddress(draft, showFit) {
  const { pattern: id, fit } = fromAddress();
  const isSame = draft && (fit ? draft.fit === fit : id ? draft.patternId === id : !draft.stored);
  if (isSame) await openDraft(draft, showFit);
  else if (fit) await openFit(fit, showFit);
  else if (id) {
    await load(async () => {
      const { pattern } = await patternOf({ pattern: id });
      return { pattern, garment: garmentFrom({ seams: pattern.seams }) };
    });
  }
}

/** Hands bytes to the browser as a file. */
export function save(blob, name) {
  const link = el("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** A file name from the pattern's. */
export const fileStem = () => (state.pattern?.name ?? "garment").replace(/[^\p{L}\p{N}_-]+/gu, "-").slice(0, 60) || "garment";

export function saveGarment() {
  const saved = { ...state.garment, pattern: plainPattern() };
  save(new Blob([`${JSON.stringify(saved, null, 2)}\n`], { type: "application/json" }), `${fileStem()}.garment.json`);
}
