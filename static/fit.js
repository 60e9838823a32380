/** A fit: start, watch, cancel, show, download. */

import { linkTo } from "./address.js";
import { comparison, figuresToKeep, startableFit, startWords, submit } from "./again.js";
import { call, events, getJson, isGone, isTransient, Problem } from "./api.js";
import { byId, el, replaceChildren } from "./dom.js";
import { fileStem, save } from "./files.js";
import { girthTable } from "./measures.js";
import { say } from "./say.js";
import { reportSummary, verdictOf, verdictText } from "./report.js";
import { asText, isUpToDate } from "./ran.js";
import { state, update, watch } from "./state.js";
import { distance, problemItems, seconds } from "./words.js";
import { showOutcome } from "./stage/stage.js";

const FINAL = new Set(["succeeded", "failed", "canceled"]);
const STAGES = { mesh: "Meshing the panels", assemble: "Placing the panels", sew: "Sewing", drape: "Draping", export: "Writing the result" };
/** Pause before a lost connection is tried again [ms], doubled up to the longest. */
const RETRY_MS = 1000;
const LONGEST_RETRY_MS = 8000;
/** Failures in a row after which a person is told. */
const TELL_AFTER = 2;

let watching = null; // {controller, pattern} of the fit that is shown, with the pattern it is of
let submitting = false;

const fitPath = (id) => `/v1/fits/${encodeURIComponent(id)}`;

const pause = (ms) => new Promise((done) => { setTimeout(done, ms); });

/** Ends the showing of an earlier fit, whose late answers are dropped; the signal of the next. */
function begin() {
  watching?.controller.abort();
  watching = { controller: new AbortController(), pattern: state.pattern };
  byId("fit-faults").replaceChildren();
  return watching.controller.signal;
}

const isRunning = () => state.fit !== null && !FINAL.has(state.fit.status);

function showProgress(progress) {
  if (progress.fraction !== undefined) byId("progress-bar").value = progress.fraction;
  const stage = STAGES[progress.stage] ?? progress.stage;
  // Only a new stage is read out.
  if (stage && byId("progress-stage").textContent !== stage) byId("progress-stage").textContent = stage;
  byId("progress-figures").textContent = [
    progress.fraction !== undefined && `${Math.round(progress.fraction * 100)} %`,
    progress.seam_gap_m != null && `widest gap ${distance(progress.seam_gap_m)}`,
    progress.cpu_s > 0 && `${seconds(progress.cpu_s)} of computing`,
  ].filter(Boolean).join(" · ");
}

/** Follows the events until the connection breaks or they end; the last id seen. */
async function followOnce(id, lastId, signal, onEvent) {
  let last = lastId;
  try {
    for await (const event of events(`${fitPath(id)}/events`, { lastId, signal })) {
      last = event.id ?? last;
      onEvent();
      if (event.type === "progress") showProgress(event.data);
      const isRunningNow = event.type === "status" && event.data.status === "running";
      if (isRunningNow && state.fit?.id === id) update({ fit: { ...state.fit, status: "running" } });
    }
  } catch (error) {
    if (error.name === "AbortError" || !isTransient(error)) throw error;
  }
  return last;
}

/**
 * Follows a fit to its final status; a connection that broke is tried again for as long as the page
 * is open.
 */
async function follow(id, signal) {
  let lastId = null;
  let failures = 0;
  const isBack = () => {
    if (failures >= TELL_AFTER) say("The service is back.");
    failures = 0;
  };
  for (;;) {
    lastId = await followOnce(id, lastId, signal, isBack);
    const fit = await getJson(fitPath(id), { signal }).catch((error) => {
      if (error.name === "AbortError" || !isTransient(error)) throw error;
      return null;
    });
    if (fit) isBack();
    if (fit && FINAL.has(fit.status)) return fit;
    failures += 1;
    if (failures === TELL_AFTER) say("The connection to the service is lost. It is tried again; the fit goes on meanwhile.", true);
    await pause(Math.min(LONGEST_RETRY_MS, RETRY_MS * 2 ** (failures - 1)));
    signal.throwIfAborted();
  }
}

/** Faults of a fit that the report tells, with all that belongs to them. */
const REPORTED = new Set(["not_converged", "crossings", "body", "layers", "gap", "strain", "worn"].map((fault) => `fit/${fault}`));

/** Shows faults in the report, and the first of them above the panes. */
function showFaults(problem) {
  replaceChildren(byId("fit-faults"), problemItems(problem));
  say(problem.faults?.[0]?.detail ?? problem.message, true);
}

/** Tells the reason of a failed fit, but for what the report says. */
function showError(fit, report) {
  if (fit.status !== "failed" || !fit.error) return;
  const faults = fit.error.errors ?? [];
  if (report && faults.length > 0 && faults.every((fault) => REPORTED.has(fault.code))) return;
  showFaults(Problem.fromBody(fit.error, fit.error.status ?? 0));
}

/** The result of a fit that ended; a failed one may still have its best shape. */
async function showResult(fit, signal) {
  const report = await getJson(`${fitPath(fit.id)}/report`, { signal }).catch((problem) => {
    if (problem.status !== 404 && problem.status !== 409) throw problem;
    return null;
  });
  signal.throwIfAborted();
  showError(fit, report);
  update({ report });
  if (!report) {
    if (fit.status === "canceled") say("Canceled before the garment had a shape.");
    return;
  }
  say(verdictText(report, fit.status), verdictOf(report, fit.status).good ? "good" : "bad");
  showMeasures(fit.id, signal);
  // The saved garment says which limbs its body has; a body of one's own it has whole.
  const { avatar } = await getJson(`${fitPath(fit.id)}/garment`, { signal });
  signal.throwIfAborted();
  const shown = avatar?.body ? state.garment.avatar : avatar;
  await showOutcome(fit.id, shown, signal);
}

/** Girths and ease come when they are there; a garment that has none is shown all the same. */
async function showMeasures(id, signal) {
  const measures = await getJson(`${fitPath(id)}/measures`, { signal }).catch(() => null);
  if (!signal.aborted) update({ measures });
}

async function watchFit(fit, signal) {
  update({ fit, pendingFitId: null, report: null, measures: null, lit: null });
  byId("progress-bar").removeAttribute("value");
  byId("progress-stage").textContent = "Waiting for a worker";
  byId("progress-figures").textContent = "";
  try {
    const done = FINAL.has(fit.status) ? fit : await follow(fit.id, signal);
    signal.throwIfAborted();
    update({ fit: done });
    await showResult(done, signal);
  } catch (problem) {
    if (signal.aborted) return;
    // The address keeps a fit that is not gone: a reload asks again.
    if (isRunning()) update({ fit: null, pendingFitId: isGone(problem) ? null : fit.id });
    showFaults(problem);
  }
}

async function run(from) {
  if (submitting) return;
  submitting = true;
  byId("fit-faults").replaceChildren();
  const ran = asText();
  const { pattern } = state;
  try {
    const { fit, refused } = await submit(from);
    if (state.pattern !== pattern) {
      say(`${pattern.name} is being sewn: Open lists it among earlier fits.`);
      return;
    }
    const signal = begin();
    update({ ran, before: figuresToKeep() });
    say(`The garment is being sewn.${startWords(from, refused)} You can go on with the pattern meanwhile.`);
    watchFit(fit, signal);
  } catch (problem) {
    if (state.pattern === pattern) showFaults(problem);
  } finally {
    submitting = false;
  }
}

async function cancel() {
  const { id } = state.fit;
  byId("progress-stage").textContent = "Stopping";
  try {
    await call(fitPath(id), { method: "DELETE" });
  } catch (problem) {
    if (state.fit?.id === id) showFaults(problem);
  }
}

function hint(running) {
  if (!state.pattern) return "Choose a pattern first.";
  if (state.garment.seams.length === 0) return "Pick at least one seam first.";
  if (state.check?.ok === false) return "Put the seams marked ✗ right first.";
  if (state.checkProblem) return "The seams could not be checked: sewing tells if they can be sewn.";
  if (state.report && !running && !isUpToDate()) return "Changed since this result. Sew again to see the change.";
  return "";
}

/** Shows one of two buttons in one place; the focus goes along. */
function swap(button, other, showOther) {
  const [shown, hidden] = showOther ? [other, button] : [button, other];
  const focused = document.activeElement === hidden;
  shown.hidden = false;
  hidden.hidden = true;
  if (focused) shown.focus();
}

function drawRun() {
  const running = isRunning();
  const ready = state.pattern && state.garment.seams.length > 0 && state.check?.ok !== false;
  byId("run").disabled = !ready;
  byId("run").textContent = state.report ? "Sew again" : "Sew and drape";
  byId("run").title = startableFit() ? "Goes on from the last shape" : "";
  byId("run-anew").hidden = running || !ready || !startableFit();
  swap(byId("run"), byId("cancel"), running);
  byId("progress").hidden = !running;
  byId("run-note").textContent = hint(running);
}

function drawReport() {
  const { fit, report, measures } = state;
  replaceChildren(byId("report"), report ? reportSummary(report, fit?.status) : []);
  replaceChildren(byId("measures-shown"), report && measures ? [el("h3", {}, "Girths"), girthTable(measures)] : []);
  const compared = comparison();
  replaceChildren(byId("compared"), compared ? [el("h3", {}, "Before and now"), compared] : []);
  byId("downloads").hidden = !report;
  const isGood = report && verdictOf(report, fit?.status).good;
  byId("report-mark").textContent = report ? (isGood ? "✓" : "✗") : "";
  byId("report-mark").classList.toggle("bad", Boolean(report) && !isGood);
}

async function download(what) {
  const { id } = state.fit;
  const name = fileStem() + (what.startsWith("mesh.") ? what.slice(4) : `.${what}.json`);
  try {
    save(await (await call(`${fitPath(id)}/${what}`)).blob(), name);
  } catch (problem) {
    if (state.fit?.id === id) showFaults(problem);
  }
}

/**
 * Shows a fit that the address bar names; `ran` is the garment it was run for, where that is not
 * the one shown.
 */
export async function showFit(id, ran) {
  const signal = begin();
  update({ pendingFitId: id, ran: ran ?? asText() });
  try {
    const fit = await getJson(fitPath(id), { signal });
    signal.throwIfAborted();
    await watchFit(fit, signal);
  } catch (problem) {
    if (signal.aborted) return;
    // The address keeps a fit that is not gone: a reload asks again.
    if (isGone(problem)) update({ pendingFitId: null });
    showFaults(problem);
  }
}

async function copyLink() {
  const link = linkTo(state.fit);
  try {
    await navigator.clipboard.writeText(link);
    say("The link is copied. It works for whoever may use this service as you do; give others the garment file.");
  } catch {
    say(`The link to this fit: ${link}`);
  }
}

export function startFit() {
  byId("copy-link").addEventListener("click", copyLink);
  byId("run").addEventListener("click", () => run(startableFit()));
  byId("run-anew").addEventListener("click", () => run(null));
  byId("cancel").addEventListener("click", cancel);
  for (const button of document.querySelectorAll("[data-download]")) {
    button.addEventListener("click", () => download(button.dataset.download));
  }
  watch(["pattern"], () => {
    // Another pattern was opened: the fit goes on, but neither it nor its faults are shown.
    if (state.fit || watching?.pattern === state.pattern) return;
    watching?.controller.abort();
    watching = null;
    byId("fit-faults").replaceChildren();
  });
  watch(["pattern", "garment", "check", "checkProblem", "fit", "report", "before", "ran"], drawRun);
  watch(["fit", "report", "measures", "before"], drawReport);
}
