/** What lies under the pointer on the stage: the panel, and its value on the map that is shown. */

import { byId } from "../dom.js";
import { panelName } from "../run_names.js";
import { state, update } from "../state.js";
import { MAPS } from "./maps.js";

const AWAY_PX = 14;

let viewer = null;
let pointer = null; // the last place of the pointer that is not yet looked at

function textOf({ panel, value }) {
  const map = MAPS[state.fitView];
  const name = panelName(panel);
  return map && value !== null ? `${name}: ${map.text(value)} ${map.what}` : name;
}

function place(tag, x, y) {
  const { clientWidth, clientHeight } = byId("stage");
  tag.style.left = `${Math.min(x + AWAY_PX, clientWidth - tag.offsetWidth - 4)}px`;
  tag.style.top = `${Math.min(y + AWAY_PX, clientHeight - tag.offsetHeight - 4)}px`;
}

function look() {
  if (pointer === null) return;
  const { x, y } = pointer;
  pointer = null;
  const hit = viewer.probe(x, y);
  const tag = byId("probe");
  tag.hidden = hit === null;
  if (hit) {
    tag.textContent = textOf(hit);
    place(tag, x, y);
  }
  const panel = hit?.panel ?? null;
  if (panel !== state.pointed) update({ pointed: panel });
}

function leave() {
  pointer = null;
  byId("probe").hidden = true;
  if (state.pointed !== null) update({ pointed: null });
}

/** Looks under the pointer while it moves and no button turns the view. */
export function startProbe(ofViewer, canvas) {
  viewer = ofViewer;
  canvas.addEventListener("pointermove", ({ offsetX, offsetY, buttons }) => {
    if (buttons) return;
    if (pointer === null) requestAnimationFrame(look);
    pointer = { x: offsetX, y: offsetY };
  });
  canvas.addEventListener("pointerleave", leave);
  canvas.addEventListener("pointerdown", leave);
}
