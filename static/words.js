/** Numbers and faults as a person reads them. */

import { el } from "./dom.js";
import { makersText } from "./makers_words.js";
import { state } from "./state.js";

/** A length of cloth in centimeters. */
export const centimeters = (meters) => `${(meters * 100).toFixed(1)} cm`;

/** A small distance: micrometers, millimeters or centimeters, two significant digits. */
export function distance(meters) {
  if (!Number.isFinite(meters)) return "unknown";
  const size = Math.abs(meters);
  if (size === 0) return "0 mm";
  if (size < 1e-5) return "less than 0.01 mm";
  if (size < 0.1) return `${Number((meters * 1000).toPrecision(2))} mm`;
  return `${(meters * 100).toFixed(0)} cm`;
}

export function seconds(value) {
  if (!Number.isFinite(value)) return "unknown time";
  if (value < 10) return `${value.toFixed(1)} s`;
  if (value < 120) return `${value.toFixed(0)} s`;
  return `${(value / 60).toFixed(1)} min`;
}

export const percent = (share) => (Number.isFinite(share) ? `${(share * 100).toFixed(share < 0.1 ? 1 : 0)} %` : "unknown");

export const scientific = (value) => (Number.isFinite(value) ? value.toExponential(1) : "unknown");

export const plural = (count, word, many = `${word}s`) => `${count.toLocaleString("en")} ${count === 1 ? word : many}`;

/** A message with a capital first and a stop last. */
export const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1) + (/[.!?…]$/.test(text) ? "" : ".");

/** The part of the garment that a pointer of the service names: `{id, text}`, or null. */
function partAt(pointer) {
  const seam = /^\/seams\/(\d+)(?:\/([ab]))?/.exec(pointer);
  if (seam) {
    const id = state.garment.seams[seam[1]]?.id;
    const side = { a: ", first side", b: ", second side" }[seam[2]] ?? "";
    return id === undefined ? null : { id, text: `Seam ${id}${side}` };
  }
  const panel = /^\/panels\/([^/]+)/.exec(pointer);
  if (!panel) return null;
  const id = panel[1].replaceAll("~1", "/").replaceAll("~0", "~");
  return { id, text: `Panel ${id}` };
}

/** The sentence of a fault, with the part that it is about where it does not name that itself. */
function factOf(fault) {
  const detail = makersText(fault.detail || fault.code);
  const part = fault.pointer ? partAt(fault.pointer) : null;
  return part && !detail.includes(part.id) ? `${part.text}: ${sentence(detail)}` : sentence(detail);
}

/** One fault or warning with what to do; code and place in the data are behind "Details". */
export function faultItem(fault, kind = "fault") {
  const code = [fault.code, fault.pointer].filter(Boolean).join(" at ");
  return el("div", { class: kind },
    el(kind === "fault" ? "strong" : "span", {}, factOf(fault)), " ",
    fault.fix && el("span", { class: "fix" }, sentence(makersText(fault.fix))),
    code && el("details", { class: "code" }, el("summary", {}, "Details"), el("code", {}, code)));
}

/** Everything a failed call has to say. */
export function problemItems(error) {
  const faults = error.faults ?? [];
  if (faults.length) return faults.map((fault) => faultItem(fault));
  return [faultItem({ detail: error.message })];
}
