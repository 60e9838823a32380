/** Gestures of mouse, pen, fingers and the space bar on the sheet, in pixels of its window. */

import { isTyping } from "../dom.js";

/** A pointer that moved less than this [px] has clicked. */
const CLICK_PX = 4;
/** Zoom for each pixel of a wheel, and for each of a pinch on a touchpad. */
const WHEEL = 0.0016;
const PINCH = 0.01;
const LINE_PX = 16;

/** True where the space bar writes or presses. */
const takesSpace = (target) => isTyping(target) || Boolean(target.matches?.("button, a, summary"));

function wheelFactor(event) {
  const pixels = event.deltaY * (event.deltaMode === 1 ? LINE_PX : 1);
  return Math.exp(-pixels * (event.ctrlKey ? PINCH : WHEEL));
}

const middleOf = ([a, b]) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
const spread = ([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Follows the space bar: with it held a drag moves the sheet. */
function followSpace(host) {
  const space = { held: false, used: false };
  const letGo = () => {
    space.held = false;
    host.classList.remove("grab");
  };
  document.addEventListener("keydown", (event) => {
    if (event.key !== " " || takesSpace(event.target)) return;
    if (event.target !== document.body && !host.contains(event.target)) return;
    event.preventDefault();
    if (!event.repeat) Object.assign(space, { held: true, used: false });
    host.classList.add("grab");
  });
  document.addEventListener("keyup", (event) => {
    if (event.key === " ") letGo();
  });
  // The key may be let go in another window.
  addEventListener("blur", letGo);
  return space;
}

/**
 * Tells `on` of gestures: `pick(point, event)`, `hover(point or null, event)`, `pan(shift)`,
 * `zoom(point, factor)`, `fit(point)`, `trace(phase, point)` of a drag along an edge;
 * `on.isFree(point)` tells if a drag from there moves the sheet. Returns the state of the space
 * bar.
 */
export function startGestures(host, on) {
  const space = followSpace(host);
  const down = new Map(); // pointer id -> where it is
  let drag = null; // {start, pans, moved}
  let last = [0, 0];

  const pointOf = (event) => {
    const box = host.getBoundingClientRect();
    return [event.clientX - box.left - host.clientLeft, event.clientY - box.top - host.clientTop];
  };

  const press = (event) => {
    if (event.button > 1) return;
    const at = pointOf(event);
    last = at;
    down.set(event.pointerId, at);
    if (event.button === 1) event.preventDefault();
    const byTool = event.button === 1 || space.held;
    drag = { start: at, moved: down.size > 1, held: byTool, pans: byTool || event.pointerType === "touch" || on.isFree(at) };
    if (space.held) space.used = true;
  };

  const pinch = (before, after) => {
    const [from, to] = [middleOf(before), middleOf(after)];
    on.pan([to[0] - from[0], to[1] - from[1]]);
    on.zoom(to, spread(after) / Math.max(1, spread(before)));
  };

  const move = (event) => {
    const at = pointOf(event);
    if (event.pointerType === "mouse" && event.buttons === 0) release(event);
    if (!down.has(event.pointerId)) return on.hover(at, event);
    const before = [...down.values()];
    const from = down.get(event.pointerId);
    down.set(event.pointerId, at);
    if (down.size === 2) return pinch(before, [...down.values()]);
    const far = Math.hypot(at[0] - drag.start[0], at[1] - drag.start[1]) >= CLICK_PX;
    if (!drag.moved && !far) return undefined;
    if (!drag.moved) {
      drag.moved = true;
      host.setPointerCapture(event.pointerId);
      host.classList.toggle("grabbing", drag.pans);
      if (drag.pans) on.pan([at[0] - drag.start[0], at[1] - drag.start[1]]);
      on.hover(null, event);
      if (drag.pans) return undefined;
      on.trace("begin", drag.start);
    }
    if (drag.pans) on.pan([at[0] - from[0], at[1] - from[1]]);
    else on.trace("move", at);
    return undefined;
  };

  const release = (event) => {
    if (down.has(event.pointerId)) last = pointOf(event);
    if (down.has(event.pointerId) && drag.moved && !drag.pans) on.trace(event.type === "pointerup" ? "end" : "cancel", last, event);
    down.delete(event.pointerId);
    host.classList.remove("grabbing");
  };

  host.addEventListener("pointerdown", press);
  host.addEventListener("pointermove", move);
  // A pointer may be let go outside of the sheet.
  addEventListener("pointerup", release);
  addEventListener("pointercancel", release);
  host.addEventListener("pointerleave", (event) => on.hover(null, event));
  host.addEventListener("click", (event) => {
    // Assistive technology clicks without a place; the second of a double click fits the panel.
    if (event.detail === 0) on.pick(null, event);
    else if (event.detail === 1 && drag && !drag.moved && !drag.held) on.pick(last, event);
  });
  host.addEventListener("dblclick", (event) => on.fit(pointOf(event)));
  host.addEventListener("wheel", (event) => {
    event.preventDefault();
    on.zoom(pointOf(event), wheelFactor(event));
  }, { passive: false });
  return space;
}
