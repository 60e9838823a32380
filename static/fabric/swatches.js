/** Swatches of the fabrics in the garment: their kind, and a choice of color, which is not sent. */

import { byId, el, paintWhenFree, replaceChildren } from "../dom.js";
import { change } from "../history.js";
import { panelsShown } from "../panels.js";
import { allFabrics } from "../settings.js";
import { state, update, watch } from "../state.js";
import { COLORS, colorOf, fabricIdOf, kindOf } from "./looks.js";

const KIND = { denim: "denim", sheer: "sheer", leather: "leather", fleece: "napped", knit: "knit", satin: "satin", woven: "woven" };

let before = null; // the colors before one is tried

const withColor = (colors, id, color) => ({ ...colors, [id]: color });

function choose(id, name, color) {
  if (before !== null) update({ colors: before });
  before = null;
  change({ colors: withColor(state.colors, id, color) }, `the color of ${name}`);
}

/** Shows a color while it is looked for; only the one that is chosen can be undone. */
function attempt(id, color) {
  before ??= state.colors;
  update({ colors: withColor(before, id, color) });
}

function swatch(id, name, [word, color]) {
  const button = el("button", {
    type: "button", class: "swatch", "data-key": `${word} ${id}`, "aria-label": `${name} in ${word}`, title: word,
    "aria-pressed": String(colorOf(id) === color), onclick: () => choose(id, name, color),
  });
  button.style.background = color;
  return button;
}

function row(id) {
  const fabric = allFabrics()[id];
  const name = fabric?.name ?? id;
  return el("div", { class: "fabric-row", "data-row": id },
    el("input", {
      type: "color", value: colorOf(id), "data-key": `color ${id}`, "aria-label": `Color of ${name}`,
      oninput: (event) => attempt(id, event.target.value), onchange: (event) => choose(id, name, event.target.value),
    }),
    el("span", { class: "fabric-name" }, name), el("small", {}, KIND[kindOf(id, fabric)]),
    el("div", { class: "swatches" }, COLORS.map((color) => swatch(id, name, color))));
}

/** Fabrics that the panels have, that of all first. */
const used = () => [...new Set([state.garment.default_fabric, ...panelsShown().map(({ id }) => fabricIdOf(id))])];

export function startSwatches() {
  const host = byId("fabric-rows");
  watch(["fabrics", "garment", "pattern", "colors"], () => paintWhenFree(host, () => replaceChildren(host, used().map(row))));
}
