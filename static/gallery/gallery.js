/**
 * The gallery: earlier fits with their pictures, drawn from the stage when each was shown; opened,
 * named and erased from here.
 */

import { figuresToKeep } from "../again.js";
import { byId, el, paintWhenFree, replaceChildren } from "../dom.js";
import { openFit } from "../files.js";
import { verdictOf } from "../report.js";
import { say } from "../say.js";
import { state, update, watch } from "../state.js";
import { seconds } from "../words.js";
import { allEntries, forget, keepEntry, rename } from "./pictures.js";

const LONGEST_NAME = 80;

let showFit = async () => {};
let takePicture = async () => null;
let urls = []; // of the pictures that are shown
let pictured = null; // id of the fit whose picture was taken last

/** Keeps a picture of the fit on the stage, once for each time that it is shown. */
async function keepPicture() {
  const { fit, shape, report, pattern } = state;
  if (!report || shape === null || shape !== fit?.id || shape === pictured) return;
  pictured = shape;
  const picture = await takePicture();
  if (!picture || state.shape !== shape) return;
  const { good, text } = verdictOf(report, fit.status);
  const entry = { fit: shape, name: pattern.name, verdict: text, isGood: good, cpu_s: report.cpu_s.total, picture };
  // A browser that keeps nothing has no gallery.
  await keepEntry(entry).then(refresh, () => {});
}

/** Opens a fit; one of the same pattern is compared with the one that was shown, in its colors. */
async function open(fit) {
  if (fit === state.fit?.id) return;
  const { pattern, colors } = state;
  const before = figuresToKeep();
  await openFit(fit, showFit);
  if (state.pattern?.id === pattern?.id) update({ before, colors });
}

/** Erases picture and name here; the service has no call that erases a fit. */
async function erase({ fit, name }) {
  await forget(fit);
  say(`${name} is out of the gallery. The service keeps the fit itself.`);
  await refresh();
}

function pictureOf({ picture }) {
  const url = URL.createObjectURL(picture);
  urls.push(url);
  return el("img", { src: url, alt: "", width: 96, height: 120 });
}

function card(entry) {
  const { fit, name, verdict, isGood, cpu_s: time } = entry;
  const isShown = fit === state.fit?.id;
  return el("li", { class: `card${isShown ? " shown" : ""}`, "data-row": fit },
    el("button", { type: "button", class: "open", "data-key": `open ${fit}`, "aria-label": `Show ${name}`, "aria-current": isShown && "true", onclick: () => open(fit) }, pictureOf(entry)),
    el("input", { type: "text", value: name, maxlength: LONGEST_NAME, "data-key": `name ${fit}`, "aria-label": "Name of the fit", onchange: (event) => rename(fit, event.target.value.trim() || name).then(refresh) }),
    el("p", { class: isGood ? "note" : "note bad" }, `${isGood ? "✓" : "✗"} ${verdict} ${seconds(time)}`),
    el("button", { type: "button", class: "small", "data-key": `erase ${fit}`, "aria-label": `Erase ${name}`, title: "Erases picture and name here", onclick: () => erase(entry) }, "Erase"));
}

const matches = ({ name }, words) => name.toLowerCase().includes(words);

/** Shows what is kept, if the gallery is open. */
async function refresh() {
  const entries = await allEntries();
  byId("fit-count").textContent = entries.length > 0 ? String(entries.length) : "";
  if (state.layout.drawer !== "fits") return;
  const words = byId("gallery-search").value.trim().toLowerCase();
  const found = entries.filter((entry) => matches(entry, words));
  byId("gallery-note").textContent = entries.length === 0 ? "Fits that were shown here are kept with a picture, by this browser alone." : found.length === 0 ? "No fit has such a name." : "";
  paintWhenFree(byId("gallery"), () => {
    for (const url of urls) URL.revokeObjectURL(url);
    urls = [];
    replaceChildren(byId("gallery"), found.map(card));
  });
}

/** Puts the gallery to work; `onFit(id)` shows a fit, `onPicture()` draws what is on the stage. */
export function startGallery(onFit, onPicture) {
  showFit = onFit;
  takePicture = onPicture;
  byId("gallery-search").addEventListener("input", refresh);
  watch(["shape", "fit", "report"], keepPicture);
  watch(["layout", "fit"], refresh);
}
