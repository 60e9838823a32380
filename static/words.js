/** Numbers and faults as a person reads them. */

import { el } from "./dom.js";

/** A length of cloth in centimetres. */
export const centimetres = (metres) => `${(metres * 100).toFixed(1)} cm`;

/** A small distance: micrometres, millimetres or centimetres, two significant digits. */
export function distance(metres) {
  const size = Math.abs(metres);
  if (size === 0) return "0 mm";
  if (size < 1e-5) return "less than 0.01 mm";
  if (size < 0.1) return `${Number((metres * 1000).toPrecision(2))} mm`;
  return `${(metres * 100).toFixed(0)} cm`;
}

export function seconds(value) {
  if (value < 10) return `${value.toFixed(1)} s`;
  if (value < 120) return `${value.toFixed(0)} s`;
  return `${(value / 60).toFixed(1)} min`;
}

export const percent = (share) => `${(share * 100).toFixed(share < 0.1 ? 1 : 0)} %`;

export const scientific = (value) => (value === 0 ? "0" : value.toExponential(1));

export const plural = (count, word) => `${count.toLocaleString("en")} ${word}${count === 1 ? "" : "s"}`;

/** One fault or warning with its place and what to do. */
export function faultItem(fault, kind = "fault") {
  return el("div", { class: kind },
    el("strong", {}, fault.detail || fault.code), " ",
    fault.fix && el("span", { class: "fix" }, fault.fix),
    (fault.pointer || fault.code) && el("div", {}, el("code", {}, [fault.code, fault.pointer].filter(Boolean).join(" at "))));
}

/** Everything a failed call has to say. */
export function problemItems(error) {
  const faults = error.faults ?? [];
  if (faults.length) return faults.map((fault) => faultItem(fault));
  return [faultItem({ detail: error.message })];
}
