/** Pattern and garment files: upload, samples, open, save, and what the address bar keeps. */

import { call, getJson } from "./api.js";
import { byId, el, replaceChildren, setOptions } from "./dom.js";
import { plainPattern } from "./panels.js";
import { forgetUndo, say } from "./picking.js";
import { uploadBody } from "./settings.js";
import { emptyGarment, state, update, watch } from "./state.js";
import { suggest } from "./suggest.js";
import { faultItem, plural, problemItems, sentence } from "./words.js";

let lastFile = null; // to read it again in another way
/** The parameters of the import, each with a field of its own. */
const importFields = ["units", "size", "outlines", "notches", "unfold", "encoding"];
let loads = 0;

/** What the address bar says: `#pattern=…&fit=…`. */
export const fromHash = () => Object.fromEntries(new URLSearchParams(location.hash.slice(1)));

function keepInHash() {
  const parts = {};
  if (state.pattern?.stored) parts.pattern = state.pattern.id;
  if (state.fit) parts.fit = state.fit.id;
  const hash = new URLSearchParams(parts).toString();
  if (hash !== location.hash.slice(1)) history.replaceState(null, "", hash ? `#${hash}` : location.pathname);
}

const draftKey = (id) => `seamster.draft.${id}`;

function keepDraft() {
  if (!state.pattern?.stored) return;
  try {
    const { garment, suggested, leftOut, ran } = state;
    const draft = { garment, suggested, leftOut, ran, fit: state.fit?.id };
    sessionStorage.setItem(draftKey(state.pattern.id), JSON.stringify(draft));
  } catch {
    // A full store only loses the draft.
  }
}

/** How a pattern was left in this tab: with the fit asked for, or with any if none is. */
function draftOf(id, fit) {
  const draft = JSON.parse(sessionStorage.getItem(draftKey(id)) ?? "null");
  return draft && (!fit || draft.fit === fit) ? draft : null;
}

/** A garment from a file, over the defaults; the pattern is kept apart. */
function garmentFrom(saved) {
  const { pattern, ...garment } = saved ?? {};
  return { ...emptyGarment(), ...garment, seams: Array.isArray(garment.seams) ? garment.seams : [], panels: garment.panels ?? {} };
}

/** Shows a pattern with a garment; the shown fit goes. */
function show({ pattern, garment, suggested = {}, leftOut = [] }) {
  forgetUndo();
  update({ pattern, garment, suggested, leftOut, picked: null, selected: null, check: null, fit: null, report: null, ran: null });
  const unchecked = pattern.stored ? "" : " The service does not hold this pattern: seams are checked when you sew.";
  if (unchecked) say(`${pattern.name}.${unchecked}`);
  else say(garment.seams.length
    ? `${pattern.name}: ${plural(pattern.panels.length, "panel")}, ${plural(garment.seams.length, "seam")}.`
    : "Pick the first edge of a seam: click it near the end where sewing begins. Or have the seams suggested.");
}

/** Reads the next file as it says itself. */
function forgetReading() {
  setOptions(byId("import-size"), [["", "Sample"]], "");
  for (const name of importFields) byId(`import-${name}`).value = "";
}

/** Sends a pattern file; answers the stored pattern. */
async function upload(file) {
  const query = new URLSearchParams();
  for (const name of importFields) {
    const { value } = byId(`import-${name}`);
    if (value) query.set(name, value);
  }
  const path = `/v1/patterns${query.size ? `?${query}` : ""}`;
  const body = new FormData();
  body.append("file", file, file.name);
  return { ...(await (await call(path, { method: "POST", body })).json()), stored: true };
}

/** Runs a load; a later one wins, and faults are shown beside the file field. */
async function load(work) {
  const mine = ++loads;
  byId("pattern-faults").replaceChildren();
  say("Reading…");
  try {
    const found = await work();
    if (mine === loads) show(found);
    return mine === loads;
  } catch (problem) {
    if (mine !== loads) return false;
    replaceChildren(byId("pattern-faults"), problemItems(problem));
    say(`The file could not be used. ${sentence(problem.faults?.[0]?.detail ?? problem.message)}`, true);
    return false;
  }
}

async function openPattern(file) {
  if (file !== lastFile) {
    forgetReading();
  }
  lastFile = file;
  await load(async () => {
    const pattern = await upload(file);
    return { pattern, garment: garmentFrom({ seams: pattern.seams ?? [] }) };
  });
}

async function openSample(name) {
  await load(async () => {
    const [dxf, garment] = await Promise.all([call(`/samples/${name}.dxf`), getJson(`/samples/${name}.garment.json`)]);
    lastFile = new File([await dxf.blob()], `${name}.dxf`);
    forgetReading();
    return { pattern: await upload(lastFile), garment: garmentFrom(garment) };
  });
}

/** The pattern that a garment names: stored under its id, or whole in the file; and what the file left out of it. */
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
  if (state.pattern) return { pattern: state.pattern };
  throw new Error("This garment file names no pattern. Open its DXF first, then the garment file.");
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
async function openFile(file) {
  if (/\.(obj|glb|ply)$/i.test(file.name)) await uploadBody(file);
  else if (/\.json$/i.test(file.name) && isGarment(await file.text())) await openGarment(file);
  else await openPattern(file);
}

async function openGarment(file) {
  let asksForSeams = false;
  const shown = await load(async () => {
    const text = await file.text();
    let saved;
    try {
      saved = JSON.parse(text);
    } catch (error) {
      throw new Error(`${file.name} is not JSON: ${error.message}`);
    }
    asksForSeams = saved?.seams === "suggest";
    if (!asksForSeams && !Array.isArray(saved?.seams)) throw new Error(`${file.name} is not a garment file: it has no list "seams".`);
    return { ...(await patternOf(saved)), garment: garmentFrom(saved) };
  });
  if (shown && asksForSeams) await suggest();
}

/** Hands bytes to the browser as a file. */
export function save(blob, name) {
  const link = el("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** A file name from the pattern's. */
export const fileStem = () => (state.pattern?.name ?? "garment").replace(/[^\p{L}\p{N}_-]+/gu, "-").slice(0, 60) || "garment";

function saveGarment() {
  const saved = { ...state.garment, pattern: plainPattern() };
  save(new Blob([`${JSON.stringify(saved, null, 2)}\n`], { type: "application/json" }), `${fileStem()}.garment.json`);
}

/** What the address bar names, with the seams as they were left or as the fit had them. */
export async function openFromHash(showFit) {
  const { pattern: id, fit } = fromHash();
  if (!id && !fit) return;
  let draft = null;
  const shown = await load(async () => {
    const saved = fit ? await getJson(`/v1/fits/${encodeURIComponent(fit)}/garment`) : null;
    const named = await patternOf(saved ?? { pattern: id });
    draft = draftOf(named.pattern.id, fit);
    const { suggested, leftOut = named.leftOut } = draft ?? {};
    return { ...named, suggested, leftOut, garment: garmentFrom(draft?.garment ?? saved ?? { seams: named.pattern.seams }) };
  });
  if (shown && fit) await showFit(fit, draft?.ran);
}

function drawFacts() {
  const { pattern } = state;
  byId("save-garment").disabled = !pattern;
  if (!pattern) return;
  const { source } = pattern;
  const allowance = { none: "none", unknown: "not stated", sew_line: "sew line used" }[source.allowance];
  const rows = [["Name", pattern.name], ["Panels", String(pattern.panels.length)], ["Units", source.units],
    source.sample_size && ["Size", source.sample_size], allowance && ["Seam allowance", allowance]].filter(Boolean);
  replaceChildren(byId("pattern-facts"),
    el("dl", { class: "facts" }, rows.flatMap(([term, value]) => [el("dt", {}, term), el("dd", {}, value)])),
    pattern.warnings?.length > 0 && el("div", { class: "warnings" }, pattern.warnings.map((one) => faultItem(one, "warning"))));
  const sizes = (source.sizes ?? []).map((size) => [size, size]);
  setOptions(byId("import-size"), [["", "Sample"], ...sizes], byId("import-size").value);
}

/** A file can be dropped anywhere on the page. */
function startDrop() {
  const hint = el("p", { class: "dropping", hidden: true }, "Drop the file to open it");
  document.body.append(hint);
  let depth = 0;
  const hasFile = (event) => event.dataTransfer?.types.includes("Files");
  document.addEventListener("dragenter", (event) => {
    if (!hasFile(event)) return;
    depth += 1;
    hint.hidden = false;
  });
  document.addEventListener("dragover", (event) => hasFile(event) && event.preventDefault());
  document.addEventListener("dragleave", () => {
    depth = Math.max(0, depth - 1);
    hint.hidden = depth === 0;
  });
  document.addEventListener("drop", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    depth = 0;
    hint.hidden = true;
    const [file] = event.dataTransfer.files;
    if (file) openFile(file);
  });
}

export function startFiles() {
  for (const button of document.querySelectorAll("[data-sample]")) {
    button.addEventListener("click", () => openSample(button.dataset.sample));
  }
  byId("open").addEventListener("click", () => byId("open-file").click());
  byId("open-file").addEventListener("change", (event) => {
    const [file] = event.target.files;
    event.target.value = "";
    if (file) openFile(file);
  });
  byId("save-garment").addEventListener("click", saveGarment);
  for (const name of importFields) {
    byId(`import-${name}`).addEventListener("change", () => lastFile && openPattern(lastFile));
  }
  startDrop();
  watch(["pattern"], drawFacts);
  watch(["pattern", "fit"], () => state.pattern && keepInHash());
  watch(["garment", "suggested", "leftOut", "ran", "fit"], keepDraft);
}
