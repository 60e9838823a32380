/** The tape in use: its first click is its beginning, the second its end. */

import { byId } from "../dom.js";
import { state, update, watch } from "../state.js";
import { drawn, host, placeOf } from "./drawn.js";
import { edgeAt, forgetHover } from "./pointing.js";
import { caughtPoint, drawTape } from "./tape.js";
import { toSheet } from "./view.js";

function pointOf(at) {
  const found = edgeAt(at);
  return found ? caughtPoint(found, placeOf(found.panel), state.view) : toSheet(state.view, at);
}

/** Lays the tape with a click. */
export function measure(at) {
  if (!drawn.sheet) return;
  const point = pointOf(at);
  const { from, to } = state.tape;
  update({ tape: from && !to ? { from, to: point } : { from: point, to: null } });
}

/** Paints the tape from its beginning to the pointer, until it has its end. */
export function stretch(at) {
  const isOpen = at !== null && drawn.sheet && !state.tape.to;
  drawn.layers?.hover.replaceChildren(...(isOpen ? drawTape(state.tape.from, pointOf(at), state.view) : []));
}

/** The tape that lies, painted. */
export const laidTape = () => (state.tape?.to ? drawTape(state.tape.from, state.tape.to, state.view) : []);

const toggle = () => update({ tape: state.tape ? null : { from: null, to: null } });

function drawTool() {
  byId("tape").setAttribute("aria-pressed", String(state.tape !== null));
  host().classList.toggle("measuring", state.tape !== null);
  // The open tape is painted in the layer of the edge under the pointer.
  forgetHover();
}

/** Puts the tool to work, by its button and by its key on the sheet. */
export function startMeasuring() {
  byId("tape").addEventListener("click", toggle);
  host().addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "t" && !event.ctrlKey && !event.metaKey && !event.altKey) toggle();
  });
  watch(["tape"], drawTool);
}
