/** Buttons that light a place on the stage, and put it out again. */

import { el } from "../dom.js";
import { state, update, watch } from "../state.js";

function toggle(key, place) {
  update({ lit: state.lit?.key === key ? null : { key, ...place } });
}

/**
 * A button that lights `{points}`, `{girth}` or `{opening}`; `key` tells it from the others, and
 * `label` names it where its text does not say enough.
 */
export const placeButton = (key, text, place, { label, kind = "place" } = {}) => el("button", {
  type: "button", class: kind, "data-key": key, "data-lights": key, "aria-label": label, title: "Show the place on the garment",
  "aria-pressed": String(state.lit?.key === key), onclick: () => toggle(key, place),
}, text);

function draw() {
  for (const button of document.querySelectorAll("[data-lights]")) {
    button.setAttribute("aria-pressed", String(button.dataset.lights === state.lit?.key));
  }
}

export const startPlaceButtons = () => watch(["lit"], draw);
