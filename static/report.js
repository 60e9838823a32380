/** The report in words: what to trust and what not. */

import { el } from "./dom.js";
import { makersText } from "./makers_words.js";
import { panelName } from "./run_names.js";
import { crossingPlaces } from "./stage/crossings.js";
import { placeButton } from "./stage/place_button.js";
import { centimeters, distance, percent, plural, scientific, seconds, sentence } from "./words.js";

/** A finding; with `place` it has a button that lights it. */
const finding = (kind, text, place) => el("li", { class: kind },
  el("span", {}, makersText(text), place && [" ", placeButton(text, "Show", place, { label: `Show on the garment: ${text}` })]));

const CLOSED_M = 1e-3;
const INSIDE_M = 1e-3;
/** Warnings of a run that are shown; the downloaded report has all. */
const MOST_WARNINGS = 6;

/** The reason for its stop, with the residual unless that is said already. */
function reason(report) {
  const why = sentence(report.why || "Stopped");
  return why.includes("r = ") ? why : `${why} Residual ${scientific(report.residual)}.`;
}

/** The sentence of the verdict on a fault, if it has that. */
const fault = (report, kind) => report.good?.because[report.good.failed.indexOf(kind)];

function closing(report) {
  const gap = report.seam_gap_max_m;
  if (report.good) {
    const why = fault(report, "gap");
    return why ? finding("bad", sentence(why)) : finding("good", `All seams are closed: the widest gap is ${distance(gap)}.`);
  }
  return Number.isFinite(gap) && gap < CLOSED_M
    ? finding("good", `All seams are closed: the widest gap is ${distance(gap)}.`)
    : finding("bad", `Seams stay open: the widest gap is ${distance(gap)}.`);
}

function inside(report) {
  const depth = report.penetration_max_m;
  if (!Number.isFinite(depth)) return finding("bad", "How deep cloth is inside the body is not known.");
  // Counted crossings say it already.
  if (depth <= 0) return report.body_intersections == null ? finding("good", "No cloth is inside the body.") : null;
  return finding(depth < INSIDE_M ? "good" : "bad", `The deepest cloth is ${distance(depth)} inside the body.`);
}

function layers(report) {
  const area = report.layers_wrong_area_m2;
  if (area == null) return null;
  const failed = report.good?.failed?.includes("layers");
  return finding(failed ? "bad" : "good", area > 0 ? `Layers lie in the wrong order on ${(area * 1e4).toFixed(0)} cm².` : "Layers lie in their order.");
}

function precision(report) {
  const parts = [];
  if (report.error_estimate_valid && report.error_estimate_m != null) parts.push(`${distance(report.error_estimate_m)} from the exact rest shape of this mesh`);
  if (report.mesh_error_m != null) parts.push(`${distance(report.mesh_error_m)} from that of a finer mesh`);
  return parts.length ? finding("plain", `Estimated error: ${parts.join(", ")}.`) : null;
}

/** The places of faults, as far as the report has them. */
function placesOf(report) {
  const { cloth, body } = crossingPlaces(report);
  const strains = (report.maps ?? []).filter(({ name }) => name === "strain_warp" || name === "strain_weft").flatMap(({ panels }) => panels);
  const largest = strains.reduce((a, b) => (a && a.max >= b.max ? a : b), null);
  return { crossings: cloth, body, strain: largest ? [largest.max_at_m] : [] };
}

/**
 * Crossings of cloth with cloth and with the body, where they were counted; faults with the
 * sentence of the verdict.
 */
function crossings(report) {
  const { self_intersections: pairs, body_intersections: onBody } = report;
  const items = [];
  const places = placesOf(report);
  for (const kind of ["crossings", "body", "strain"]) {
    const why = fault(report, kind);
    if (why) items.push(finding("bad", sentence(why), places[kind].length > 0 && { points: places[kind] }));
    else if (kind === "crossings" && pairs > 0) items.push(finding("plain", `${plural(pairs, "pair")} of triangles cross, as self-contact is off.`));
    else if (kind === "crossings" && pairs === 0) items.push(finding("good", "No cloth passes through cloth."));
    else if (kind === "body" && onBody != null) items.push(finding("good", "No cloth passes through the body."));
  }
  return items;
}

/** The verdict in a sentence, with `good` for a good one. */
export function verdictOf(report, status) {
  if (!report.converged) {
    return { good: false, text: status === "canceled" ? "Stopped before it came to rest." : "The garment did not come to rest." };
  }
  if (!report.good) return { good: true, text: "The garment came to rest." };
  return report.good.ok
    ? { good: true, text: "The garment came to rest, and nothing is wrong with it." }
    : { good: false, text: "The garment came to rest, but it is not right." };
}

/** The verdict with the first reason against it. */
export function verdictText(report, status) {
  const { text } = verdictOf(report, status);
  const because = report.good?.because?.[0];
  return because && report.converged ? `${text} ${sentence(because)}` : text;
}

/** An opening, what it goes round, and true if that is what it was placed round. */
function opening(one) {
  const isRight = one.placed_round === one.goes_round;
  const where = `${centimeters(one.length_m)} round, ${centimeters(one.height_m)} above the floor`;
  const text = isRight
    ? `The opening of ${one.panels.map(panelName).join(", ")} goes round ${one.goes_round}: ${where}.`
    : `The opening of ${one.panels.map(panelName).join(", ")} was placed round ${one.placed_round}, but goes round ${one.goes_round}.`;
  return finding(isRight ? "good" : "bad", text, { opening: one });
}

/** The way the body carries the garment, if that is judged, with its openings. */
function support(worn) {
  const kind = worn.ok === null ? "plain" : worn.ok ? "good" : "bad";
  const text = sentence(`${worn.ok === false ? "Not worn" : "Worn"}: ${worn.because}`);
  return [finding(kind, text), ...(worn.openings ?? []).map(opening)];
}

/** The summary; `canceled` where the fit was stopped. */
export function reportSummary(report, status) {
  const { good, text } = verdictOf(report, status);
  const worn = report.worn ?? { ok: null, because: "not stated" };
  const items = [closing(report), ...crossings(report), inside(report), layers(report), ...support(worn),
    ...(report.warnings ?? []).slice(0, MOST_WARNINGS).map(({ detail }) => finding("plain", sentence(detail))),
    finding("plain", `Largest strain ${percent(report.strain_max)}.`)];
  const figures = [
    finding(report.converged ? "good" : "bad", reason(report)),
    precision(report),
    finding("plain", `${seconds(report.cpu_s.total)} of computing, ${plural(report.vertices, "vertex", "vertices")}, ${plural(report.stitches, "stitch", "stitches")}, method ${report.method}.`),
  ];
  return [
    el("p", { class: `verdict ${good ? "good" : "bad"}` }, text),
    el("ul", { class: "findings" }, items.filter(Boolean)),
    el("details", {}, el("summary", {}, "Details of the computation"), el("ul", { class: "findings" }, figures.filter(Boolean))),
  ];
}
