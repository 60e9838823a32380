/**
 * The list of panels: a picture of each, its fabric and face, a mirrored copy, left out or not;
 * hovered here and on the sheet.
 */

import { byId, el, paintWhenFree, replaceChildren, svg } from "./dom.js";
import { colorOf, fabricIdOf } from "./fabric/looks.js";
import { change, changeGarment } from "./history.js";
import { isMirrorId, mirrorOf } from "./mirrored.js";
import { runsOf } from "./outline.js";
import { forgetCopies, leftOut, panelsShown, titleOf } from "./panels.js";
import { say } from "./say.js";
import { allFabrics, fabricOptions } from "./settings.js";
import { boxOf } from "./sheet/arrangement.js";
import { state, update, watch } from "./state.js";
import { plural } from "./words.js";

const PICTURE = 30;

const open = new Set(); // ids of the panels whose settings are shown
let fit = () => {};
let drawn = { pattern: null, contents: "" };

function setPanel(id, patch, words) {
  const panel = { ...state.garment.panels[id], ...patch };
  for (const [field, value] of Object.entries(panel)) if (value === "" || value === "auto") delete panel[field];
  const panels = { ...state.garment.panels, [id]: panel };
  if (Object.keys(panel).length === 0 && !isMirrorId(id)) delete panels[id];
  changeGarment({ panels }, words);
}

/** The outline, small. */
function picture(panel) {
  const { left, right, bottom, top } = boxOf(panel);
  const scale = (PICTURE - 4) / Math.max(right - left, top - bottom);
  const [dx, dy] = [(PICTURE - scale * (right - left)) / 2, (PICTURE - scale * (top - bottom)) / 2];
  const at = ([x, y]) => `${(dx + scale * (x - left)).toFixed(1)} ${(dy + scale * (top - y)).toFixed(1)}`;
  const d = `M${panel.edges.flatMap((edge) => edge.points.slice(0, -1)).map(at).join("L")}Z`;
  const outline = svg("path", { class: "cloth", d });
  outline.style.fill = colorOf(fabricIdOf(panel.id));
  return svg("svg", { width: PICTURE, height: PICTURE, "aria-hidden": "true" }, outline);
}

function choice(panel, field, text, pairs) {
  const chosen = state.garment.panels[panel.id]?.[field] ?? pairs[0][0];
  return el("label", {}, text,
    el("select", {
      "data-key": `${field} ${panel.id}`, "aria-label": `${text} of ${titleOf(panel)}`,
      onchange: (event) => setPanel(panel.id, { [field]: event.target.value }, `${text.toLowerCase()} of ${titleOf(panel)}`),
    }, pairs.map(([value, label]) => el("option", { value, selected: value === chosen }, label))));
}

/** Turns the other side of the cloth out. */
function flip(panel) {
  const now = state.garment.panels[panel.id]?.face ?? state.check?.faces?.[panel.id] ?? "up";
  setPanel(panel.id, { face: now === "up" ? "down" : "up" }, `turning ${titleOf(panel)}`);
  say(`${titleOf(panel)}: the other side is out.`);
}

/** The garment without the seams and settings of a panel. */
function without(id) {
  const { garment } = state;
  const seams = garment.seams.filter((seam) => ![...runsOf(seam.a), ...runsOf(seam.b)].some((run) => run.panel === id));
  const { [id]: _, ...panels } = garment.panels;
  return { gone: garment.seams.length - seams.length, garment: { ...garment, seams, panels } };
}

function removeCopy(panel) {
  const { gone, garment } = without(panel.id);
  change({ garment }, `taking ${titleOf(panel)} away`);
  forgetCopies();
  say(`${titleOf(panel)} is taken away${gone ? `, with ${plural(gone, "seam")}` : ""}.`);
}

function leaveOut(panel) {
  const { gone, garment } = without(panel.id);
  change({ garment, leftOut: [...state.leftOut, panel.id] }, `leaving ${titleOf(panel)} out`);
  say(`${titleOf(panel)} is left out${gone ? `, with ${plural(gone, "seam")}` : ""}.`);
}

function takeIn(panel) {
  change({ leftOut: state.leftOut.filter((id) => id !== panel.id) }, `taking ${titleOf(panel)} in`);
  say(`${titleOf(panel)} is sewn with the others.`);
}

const button = (panel, what, act, key = what) =>
  el("button", { type: "button", class: "small", "data-key": `${key} ${panel.id}`, "aria-label": `${what}: ${titleOf(panel)}`, onclick: act }, what);

function actions(panel, spare, hasCopy) {
  const copy = isMirrorId(panel.id)
    ? button(panel, "Take away", () => removeCopy(panel))
    : !panel.copy_of && !panel.unfolded && !hasCopy && button(panel, "Mirrored copy", () => setPanel(mirrorOf(panel.id), {}, `a mirrored copy of ${titleOf(panel)}`));
  return el("div", { class: "actions" },
    button(panel, "Show", () => fit(panel.id)),
    button(panel, "Flip", () => flip(panel)),
    copy,
    !isMirrorId(panel.id) && (spare ? button(panel, "Take in", () => takeIn(panel), "in or out") : button(panel, "Leave out", () => leaveOut(panel), "in or out")));
}

function row(panel, { spare, ids }) {
  const own = allFabrics()[state.garment.panels[panel.id]?.fabric]?.name;
  const found = state.check?.faces?.[panel.id];
  const toggle = (event) => (event.target.open ? open.add(panel.id) : open.delete(panel.id));
  const point = (id) => () => state.pointed !== id && update({ pointed: id });
  return el("details", { class: "panel-row", "data-row": panel.id, open: open.has(panel.id), ontoggle: toggle, onmouseenter: point(panel.id), onmouseleave: point(null) },
    el("summary", { "data-key": `panel ${panel.id}`, onfocus: point(panel.id), onblur: point(null) },
      picture(panel), el("span", { class: "name" }, titleOf(panel)),
      (spare || own) && el("small", {}, spare ? "left out" : own)),
    choice(panel, "fabric", "Fabric", [["", "As all"], ...fabricOptions()]),
    choice(panel, "face", "Face", [["auto", found ? `Found: ${found}` : "Found"], ["up", "Up"], ["down", "Down"]]),
    actions(panel, spare, ids.has(mirrorOf(panel.id))));
}

/** All that the list shows, as text, to draw it only when that changes. */
const contents = (panels, spare) =>
  JSON.stringify([panels.map((panel) => panel.id), [...spare], state.garment.panels, state.check?.faces, Object.keys(allFabrics()), state.colors, state.garment.default_fabric]);

function draw() {
  const panels = panelsShown();
  const spare = new Set(leftOut());
  const now = contents(panels, spare);
  if (state.pattern === drawn.pattern && now === drawn.contents) return;
  drawn = { pattern: state.pattern, contents: now };
  const ids = new Set(panels.map((panel) => panel.id));
  byId("panels").hidden = panels.length === 0;
  byId("panel-count").textContent = panels.length ? String(panels.length) : "";
  replaceChildren(byId("panel-rows"), panels.map((panel) => row(panel, { spare: spare.has(panel.id), ids })));
}

function drawPointed() {
  for (const one of byId("panel-rows").children) one.classList.toggle("pointed", one.dataset.row === state.pointed);
}

/** Puts the list to work; `onFit(id)` shows a panel on the sheet. */
export function startPanelList(onFit) {
  fit = onFit;
  watch(["fabrics", "garment", "pattern", "check", "leftOut", "colors"], () => paintWhenFree(byId("panel-rows"), draw));
  watch(["pointed"], drawPointed);
}
