/**
 * What the cloth shows: itself, or a map of the fit with legend, stated error and words. Maps that
 * a fit does not have are not offered, and it is said why.
 */

import { byId, el, replaceChildren } from "../dom.js";
import { state, update, watch } from "../state.js";
import { errorText, MAPS, wordsOn } from "./maps.js";
import { gradientOf, OVER } from "./palette.js";
import { placeButton } from "./place_button.js";

const CLOTH = "cloth";

let show = async () => null;
let shown = null; // {summary, range} of the map on the cloth

/** Maps of the shown fit, as its report sums them up. */
const offered = () => (state.shape !== null && state.shape === state.fit?.id ? state.report?.maps ?? [] : []).filter(({ name, panels }) => MAPS[name] && panels.length > 0);

/** Reason why maps are missing; empty where none is. */
function missing(maps) {
  if (state.shape === null || maps.length === Object.keys(MAPS).length) return "";
  if (state.shape !== state.fit?.id) return "";
  if (maps.length === 0) return "This fit has no maps of strain and pressure: sew again to see them.";
  return state.garment.over ? "No pressure and gap of what is worn over another garment." : "No pressure and gap without a body.";
}

function segment(name, label) {
  return el("button", {
    type: "button", "data-key": `view ${name}`, "data-fit-view": name, "aria-pressed": String(state.fitView === name),
    onclick: () => update({ fitView: name }),
  }, label);
}

function drawChoice() {
  const maps = offered();
  const why = missing(maps);
  const segments = maps.length > 0 ? [segment(CLOTH, "Cloth"), ...maps.map(({ name }) => segment(name, MAPS[name].label))] : [];
  replaceChildren(byId("fit-views"), segments);
  byId("fit-views").hidden = segments.length === 0;
  byId("fit-views-why").textContent = why;
}

function bar({ scale, hasOver }) {
  const colors = el("span", { class: "colors" });
  colors.style.background = gradientOf(scale);
  const over = hasOver && el("span", { class: "over" });
  if (over) over.style.background = OVER;
  return [colors, over];
}

/** Legend of a map over a range: colors, ends and middle with units, error and words. */
function legend(summary, [least, most]) {
  const map = MAPS[summary.name];
  const { text, at } = wordsOn(summary);
  const ticks = [least, (least + most) / 2, most].map((value) => el("span", {}, map.text(value)));
  return [
    el("div", { class: "scale" }, bar(map)),
    el("div", { class: "ticks" }, ticks, map.hasOver && el("span", {}, "over")),
    el("p", {}, errorText(summary)),
    placeButton(`most ${summary.name}`, text, { points: [at] }, { kind: "words" }),
  ];
}

async function drawView() {
  const summary = offered().find(({ name }) => name === state.fitView);
  if (!summary && state.fitView !== CLOTH && state.shape === state.fit?.id && state.report) update({ fitView: CLOTH });
  const range = await show(summary ? MAPS[summary.name] : null);
  shown = summary && range ? { summary, range } : null;
  byId("legend").hidden = shown === null;
  replaceChildren(byId("legend"), shown ? legend(summary, range) : []);
}

/** The legend as it stands on a picture: `{scale, ticks, lines}`; null where the cloth is seen. */
export function legendOnPicture() {
  if (shown === null) return null;
  const { summary, range } = shown;
  const { label, scale, text } = MAPS[summary.name];
  return { scale, ticks: range.map(text), lines: [`${label}, ${errorText(summary)}`, wordsOn(summary).text] };
}

/** Puts the choice to work; `onShow(map)` colors the cloth and answers the range of the colors. */
export function startFitViews(onShow) {
  show = onShow;
  watch(["shape", "fit", "report", "fitView"], drawChoice);
  watch(["shape", "fit", "report", "fitView"], drawView);
}
