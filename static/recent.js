/**
 * One place to open anything: a file, a sample, recent work of any tab, earlier fits of the
 * service.
 */

import { getJson } from "./api.js";
import { byId, el, isDialogOpen } from "./dom.js";
import { allDrafts } from "./drafts.js";
import { openDraft, openFit, openSample } from "./files.js";
import { plural } from "./words.js";

const FITS = 8;
const STATUS = { queued: "waiting", running: "being sewn", succeeded: "sewn", failed: "not right", canceled: "canceled" };

const when = (at) => new Date(at).toLocaleString("en", { day: "numeric", month: "short", hour: "2-digit", minute: "2-digit" });

let showFit = async () => {};

function entry(name, note, act) {
  const open = () => {
    byId("open-dialog").close();
    act();
  };
  return el("li", {}, el("button", { type: "button", class: "entry", onclick: open }, el("span", {}, name), el("small", {}, note)));
}

const list = (title, entries) => (entries.length > 0 ? [el("h3", {}, title), el("ul", { class: "entries" }, entries)] : []);

const draftEntry = (draft) =>
  entry(draft.name, `${plural(draft.garment.seams.length, "seam")}, ${when(draft.at)}`, () => openDraft(draft, showFit));

function fitEntry(fit, names) {
  const name = names.get(fit.id) ?? "A garment";
  return entry(name, `${STATUS[fit.status] ?? fit.status}, ${when(fit.created_at)}`, () => openFit(fit.id, showFit));
}

async function fill(host) {
  const drafts = await allDrafts();
  host.append(...list("Recent work", drafts.map(draftEntry)));
  const { fits } = await getJson(`/v1/fits?limit=${FITS}`).catch(() => ({ fits: [] }));
  const names = new Map(drafts.filter((draft) => draft.fit).map((draft) => [draft.fit, draft.name]));
  host.append(...list("Earlier fits", fits.map((fit) => fitEntry(fit, names))));
}

function show() {
  // Answers that come after the dialog was opened anew go into a node that is shown no longer.
  const host = el("div");
  byId("open-recent").replaceChildren(host);
  byId("open-dialog").showModal();
  fill(host);
}

/** Puts the button to work; `onFit(id, ran)` shows a fit. */
export function startRecent(onFit) {
  showFit = onFit;
  byId("open").addEventListener("click", show);
  byId("open-choose").addEventListener("click", () => {
    byId("open-dialog").close();
    byId("open-file").click();
  });
  byId("open-close").addEventListener("click", () => byId("open-dialog").close());
  for (const button of document.querySelectorAll("[data-open-sample]")) {
    button.addEventListener("click", () => {
      byId("open-dialog").close();
      openSample(button.dataset.openSample);
    });
  }
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "o" || isDialogOpen()) return;
    event.preventDefault();
    show();
  });
}
