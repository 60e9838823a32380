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

/** Replaces the children of `parent`; the focus stays on the element with the same `data-key`. */
export function replaceChildren(parent, ...children) {
  const focused = parent.contains(document.activeElement) ? document.activeElement.dataset.key : undefined;
  parent.replaceChildren(...children.flat(Infinity).filter(Boolean));
  if (focused === undefined) return;
  parent.querySelector(`[data-key="${CSS.escape(focused)}"]`)?.focus({ preventScroll: true });
}

let edited = null; // the field whose text is typed and not yet taken
const waiting = new Map(); // host -> what paints it

const isTextField = (target) => target.matches?.("textarea, input:not([type=checkbox], [type=file])");

function endEdit() {
  edited = null;
  const paints = [...waiting.values()];
  waiting.clear();
  for (const paint of paints) paint();
}

// A change is heard here after the field's own listener took it.
document.addEventListener("input", ({ target }) => { edited = isTextField(target) ? target : null; });
document.addEventListener("change", endEdit);
document.addEventListener("focusout", endEdit);

/** Calls `paint`, which replaces what is in `host`; not before a text that is typed there is done. */
export function paintWhenFree(host, paint) {
  if (edited?.isConnected && host.contains(edited)) waiting.set(host, paint);
  else paint();
}

/**
 * Options of a select from `[value, label]` pairs, keeping what was chosen where it still exists.
 */
export function setOptions(select, pairs, chosen) {
  select.replaceChildren(...pairs.map(([value, label]) => el("option", { value, selected: value === chosen }, label)));
}
