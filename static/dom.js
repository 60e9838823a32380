/**
 * Small helpers to build elements. Text goes in as text nodes only: names from files are never
 * parsed as markup.
 */

const SVG = "http://www.w3.org/2000/svg";

export const byId = (id) => document.getElementById(id);

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (name === "value" || name === "checked" || name === "selected" || name === "disabled") node[name] = value;
    else node.setAttribute(name, value === true ? "" : String(value));
  }
  node.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return node;
}

/** An HTML element; attributes named `on…` are listeners. */
export const el = (name, attributes = {}, ...children) => fill(document.createElement(name), attributes, children);

/** An SVG element. */
export const svg = (name, attributes = {}, ...children) => fill(document.createElementNS(SVG, name), attributes, children);

const rowsOf = (parent) => [...parent.querySelectorAll("[data-row]")];

/** The place of the focus in `parent`: key, row and number of the row; null where it is not. */
function focusIn(parent) {
  const focused = document.activeElement;
  if (focused === parent || !parent.contains(focused)) return null;
  const row = focused.closest("[data-row]");
  return { key: focused.dataset.key, row: row?.dataset.row, at: rowsOf(parent).indexOf(row) };
}

/** The element to go on from: the same, else the first of its row or of the row in its place. */
function successorOf(parent, { key, row, at }) {
  const same = key !== undefined && parent.querySelector(`[data-key="${CSS.escape(key)}"]:not(:disabled)`);
  if (same) return same;
  const rows = rowsOf(parent);
  const next = rows.find((one) => one.dataset.row === row) ?? rows[Math.min(at, rows.length - 1)] ?? parent;
  return next.querySelector("[data-key]:not(:disabled)");
}

/**
 * Replaces the children of `parent`. A focus in it stays on the element with the same `data-key`;
 * where that is gone, it goes on in the same `data-row` or its neighbor, and never to the top of
 * the page.
 */
export function replaceChildren(parent, ...children) {
  const focus = focusIn(parent);
  parent.replaceChildren(...children.flat(Infinity).filter(Boolean));
  if (focus === null) return;
  const successor = successorOf(parent, focus) ?? parent;
  if (successor === parent) parent.tabIndex = -1;
  successor.focus({ preventScroll: true });
}

let edited = null; // the field whose text is typed and not yet taken
let pressed = null; // the element that a pointer or the space bar is held down on
const waiting = new Map(); // host -> what paints it

const isTextField = (target) => target.matches?.("textarea, input:not([type=checkbox], [type=file])");

const isBusy = (host) => [edited, pressed].some((one) => one?.isConnected && host.contains(one));

/** Calls `paint`, which replaces what is in `host`, once nothing is typed or held down there. */
export function paintWhenFree(host, paint) {
  waiting.delete(host);
  if (isBusy(host)) waiting.set(host, paint);
  else paint();
}

/** Takes the text that is being typed, before something else takes the place of what it is for. */
export const commitEdit = () => edited?.blur();

function paintWaiting() {
  for (const [host, paint] of [...waiting]) paintWhenFree(host, paint);
}

/** Ends the edit once the focus has arrived at the field that it is on its way to. */
function endEdit() {
  if (edited === null) return;
  setTimeout(() => {
    edited = null;
    paintWaiting();
  });
}

function press({ target }) {
  pressed = target;
}

/** Ends the press; what waits is painted after the click that it makes. */
function release() {
  if (pressed === null) return;
  pressed = null;
  setTimeout(paintWaiting);
}

document.addEventListener("input", ({ target }) => { edited = isTextField(target) ? target : null; });
document.addEventListener("change", endEdit);
document.addEventListener("focusout", endEdit);
document.addEventListener("pointerdown", press);
// Other keys act at once when they go down.
document.addEventListener("keydown", (event) => event.key === " " && press(event));
for (const type of ["pointerup", "pointercancel", "keyup", "blur"]) addEventListener(type, release);

/** True if a key that is pressed there writes or chooses. */
export const isTyping = (target) => Boolean(target.matches?.("input, select, textarea"));

/** True while a dialog is open, which keys are for. */
export const isDialogOpen = () => document.querySelector("dialog[open]") !== null;

/**
 * Options of a select from `[value, label]` pairs, keeping what was chosen where it still exists.
 */
export function setOptions(select, pairs, chosen) {
  select.replaceChildren(...pairs.map(([value, label]) => el("option", { value, selected: value === chosen }, label)));
}
