/** Numbers and faults as a person reads them. */

import { el } from "./dom.js";

/** A length of cloth in centimetres. */
export const centimetres = (metres) => `${(metres * 100).toFixed(1)} cm`;

/** A small distance: micrometres, millimetres or centimetres, two significant digits. */
export function distance(metres) {
  if (!Number.isFinite(metres)) return "unknown";
  const size = Math.abs(metres);
  if (size === 0) return "0 mm";
  if (size < 1e-5) return "less than 0.01 mm";
  if (size < 0.1) return `${Number((metres * 1000).toPrecision(2))} mm`;
  return `${(metres * 100).toFixed(0)} cm`;
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

/** One fault or warning with its place and what to do. */
export function faultItem(fault, kind = "fault") {
  return el("div", { class: kind },
    el(kind === "fault" ? "strong" : "span", {}, sentence(fault.detail || fault.code)), " ",
    fault.fix && el("span", { class: "fix" }, sentence(fault.fix)),
    (fault.pointer || fault.code) && el("div", {}, el("code", {}, [fault.code, fault.pointer].filter(Boolean).join(" at "))));
}

/** Everything a failed call has to say. */
export function problemItems(error) {
  const faults = error.faults ?? [];
  if (faults.length) return faults.map((fault) => faultItem(fault));
  return [faultItem({ detail: error.message })];
}
