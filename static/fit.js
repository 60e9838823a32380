/** A fit: start, watch, cancel, show, download. */

import { linkTo } from "./address.js";
import { call, events, getJson, postJson, Problem } from "./api.js";
import { byId, replaceChildren } from "./dom.js";
import { fileStem, save } from "./files.js";
import { say } from "./picking.js";
import { reportSummary, verdictOf, verdictText } from "./report.js";
import { garmentToSend, leftOut } from "./panels.js";
import { state, update, watch } from "./state.js";
import { distance, problemItems, scientific, seconds } from "./words.js";
import { showOutcome } from "./stage.js";

const FINAL = new Set(["succeeded", "failed", "canceled"]);
const STAGES = { mesh: "Meshing the panels", assemble: "Placing the panels", sew: "Sewing", drape: "Draping", export: "Writing the result" };
const RETRY_MS = 1000;
const RETRIES = 20;

let watching = null;
let submitting = false;

const fitPath = (id) => `/v1/fits/${encodeURIComponent(id)}`;

const pause = (ms) => new Promise((done) => { setTimeout(done, ms); });

const isRunning = () => state.fit !== null && !FINAL.has(state.fit.status);

function showProgress(progress) {
  if (progress.fraction !== undefined) byId("progress-bar").value = progress.fraction;
  const stage = STAGES[progress.stage] ?? progress.stage;
  // Only a new stage is read out.
  if (stage && byId("progress-stage").textContent !== stage) byId("progress-stage").textContent = stage;
  byId("progress-figures").textContent = [
    progress.fraction !== undefined && `${Math.round(progress.fraction * 100)} %`,
    progress.seam_gap_m != null && `widest gap ${distance(progress.seam_gap_m)}`,
    progress.residual != null && `residual ${scientific(progress.residual)}`,
    progress.cpu_s > 0 && `${seconds(progress.cpu_s)} of computing`,
  ].filter(Boolean).join(" · ");
}

/** Follows the events to a final status, resuming where a connection broke. */
async function follow(id, signal) {
  let lastId = null;
  for (let failures = 0; failures < RETRIES;) {
    try {
      for await (const event of events(`${fitPath(id)}/events`, { lastId, signal })) {
        lastId = event.id ?? lastId;
        failures = 0;
        if (event.type === "progress") showProgress(event.data);
        if (event.type === "status" && event.data.status === "running") update({ fit: { ...state.fit, status: "running" } });
      }
      const fit = await getJson(fitPath(id), { signal });
      if (FINAL.has(fit.status)) return fit;
    } catch (error) {
      if (error.name === "AbortError" || (error.status >= 400 && error.status < 500)) throw error;
    }
    failures += 1;
    await pause(RETRY_MS);
    signal.throwIfAborted();
  }
  throw new Problem("The connection to the service was lost. Reload the page to look again.", 0, []);
}

/** Faults of a fit that the report tells, with all that belongs to them. */
const REPORTED = new Set(["not_converged", "crossings", "body", "layers", "gap", "strain", "worn"].map((fault) => `fit/${fault}`));

/** Shows faults in the report, and the first of them above the panes. */
function showFaults(problem) {
  replaceChildren(byId("fit-faults"), problemItems(problem));
  say(problem.faults?.[0]?.detail ?? problem.message, true);
}

/** Why a fit failed, but for what the report says. */
function showError(fit, report) {
  if (fit.status !== "failed" || !fit.error) return;
  const faults = fit.error.errors ?? [];
  if (report && faults.length > 0 && faults.every((fault) => REPORTED.has(fault.code))) return;
  showFaults(Problem.fromBody(fit.error, fit.error.status ?? 0));
}

/** The result of a fit that ended; a failed one may still have its best shape. */
async function showResult(fit) {
  const report = await getJson(`${fitPath(fit.id)}/report`).catch((problem) => {
    if (problem.status !== 404 && problem.status !== 409) throw problem;
    return null;
  });
  showError(fit, report);
  update({ report });
  if (!report) return;
  say(verdictText(report, fit.status), !verdictOf(report, fit.status).good);
  // The saved garment says which limbs its body has; a body of one's own it has whole.
  const { avatar } = await getJson(`${fitPath(fit.id)}/garment`);
  const shown = avatar?.body ? state.garment.avatar : avatar;
  await showOutcome(fit.id, shown, report.intersections ?? []);
}

async function watchFit(fit) {
  watching?.abort();
  const { signal } = (watching = new AbortController());
  update({ fit, report: null });
  byId("fit-faults").replaceChildren();
  byId("progress-bar").removeAttribute("value");
  byId("progress-stage").textContent = "Waiting for a worker";
  byId("progress-figures").textContent = "";
  try {
    const done = FINAL.has(fit.status) ? fit : await follow(fit.id, signal);
    update({ fit: done });
    await showResult(done);
  } catch (problem) {
    if (problem.name === "AbortError") return;
    update({ fit: isRunning() ? null : state.fit });
    showFaults(problem);
  }
}

async function run() {
  if (submitting) return;
  submitting = true;
  byId("fit-faults").replaceChildren();
  const ran = asText();
  try {
    const fit = await postJson("/v1/fits", garmentToSend());
    update({ ran });
    watchFit(fit);
  } catch (problem) {
    showFaults(problem);
  } finally {
    submitting = false;
  }
}

async function cancel() {
  byId("progress-stage").textContent = "Stopping";
  try {
    await call(fitPath(state.fit.id), { method: "DELETE" });
  } catch (problem) {
    showFaults(problem);
  }
}

/** What a result depends on. */
const asText = () => JSON.stringify([state.pattern?.id, state.garment, leftOut()]);

function hint(running) {
  if (!state.pattern) return "Choose a pattern first.";
  if (state.garment.seams.length === 0) return "Pick at least one seam first.";
  if (state.check?.ok === false) return "Put the seams marked ✗ right first.";
  if (state.report && !running && state.ran !== asText()) return "Changed since this result. Sew again to see the change.";
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
  swap(byId("run"), byId("cancel"), running);
  byId("progress").hidden = !running;
  byId("run-note").textContent = hint(running);
}

function drawReport() {
  const { fit, report } = state;
  replaceChildren(byId("report"), report ? reportSummary(report, fit?.status) : []);
  byId("downloads").hidden = !report;
}

async function download(what) {
  const name = what.startsWith("mesh.") ? what.slice(4) : `.${what}.json`;
  try {
    save(await (await call(`${fitPath(state.fit.id)}/${what}`)).blob(), fileStem() + name);
  } catch (problem) {
    showFaults(problem);
  }
}

/** Shows a fit that the address bar names; `ran` is the garment it was run for, where that is not the one shown. */
export async function showFit(id, ran) {
  try {
    const fit = await getJson(fitPath(id));
    update({ ran: ran ?? asText() });
    await watchFit(fit);
  } catch (problem) {
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
  byId("run").addEventListener("click", run);
  byId("cancel").addEventListener("click", cancel);
  for (const button of document.querySelectorAll("[data-download]")) {
    button.addEventListener("click", () => download(button.dataset.download));
  }
  watch(["pattern"], () => {
    // Another pattern was opened while a fit ran: the fit goes on, but is no longer shown.
    if (!state.fit) watching?.abort();
  });
  watch(["pattern", "garment", "check", "fit", "report", "ran"], drawRun);
  watch(["fit", "report"], drawReport);
}
