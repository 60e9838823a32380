/** The sheet before a pattern is on it. */

import { byId, el } from "../dom.js";

export function welcome() {
  const by = (id) => () => byId(id).click();
  const sample = (name) => () => document.querySelector(`.rail [data-sample="${name}"]`).click();
  return el("div", { class: "welcome" },
    el("p", {}, "Open a pattern, or drop its file anywhere on the page."),
    el("div", { class: "tools" }, el("button", { type: "button", class: "primary", onclick: by("open-file") }, "Open a file…")),
    el("p", { class: "note" }, "DXF, as exported for AAMA or ASTM or drawn in any CAD, or a GarmentCode specification"),
    el("div", { class: "tools" },
      el("button", { type: "button", onclick: sample("skirt") }, "Try the skirt"),
      el("button", { type: "button", onclick: sample("top") }, "Try the top")));
}
