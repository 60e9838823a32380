/**
 * A seam in full: faults with what puts them right, its name, parts of edges in numbers, options.
 */

import { el } from "./dom.js";
import { edgesOf, lengthOf, lengthOfSide, runsOf, wayOf } from "./outline.js";
import { panelOf, panelsShown } from "./panels.js";
import { drawnWay, sideName } from "./run_names.js";
import { say } from "./say.js";
import { changeSeam, changeSeams, renameSeam } from "./seams.js";
import { state } from "./state.js";
import { suggestionOf } from "./suggest.js";
import { centimeters, faultItem, percent, plural, sentence } from "./words.js";

/** Sides that differ in length by more than this share are no pair, whatever else is mended. */
const HOPELESS = 0.6;

function isHopeless(seam) {
  const panels = new Map(panelsShown().map((panel) => [panel.id, panel]));
  const [a, b] = [seam.a, seam.b].map((side) => lengthOfSide(panels, side));
  return a > 0 && b > 0 && Math.abs(a - b) / Math.min(a, b) > HOPELESS;
}

/** The seam that the service would have instead, if that differs. */
function correctionOf(seam) {
  if (isHopeless(seam)) return null;
  const other = state.check?.corrected.find((one) => one.id === seam.id);
  const sides = ({ a, b, match, gather, layered, allow_twist }) =>
    JSON.stringify([runsOf(a), runsOf(b), match ?? "as_picked", !!gather, !!layered, !!allow_twist].map(withoutDirection));
  return other && sides(other) !== sides(seam) ? other : null;
}

const withoutDirection = (part) =>
  Array.isArray(part) ? part.map(({ panel, from, to }) => [panel, from, to]) : part;

/** The name, which can be changed. */
function nameField(seam) {
  const change = (event) => {
    if (!renameSeam(seam.id, event.target.value)) event.target.value = seam.id;
  };
  return el("label", { class: "inline" }, "Name ",
    el("input", { type: "text", value: seam.id, maxlength: 80, "data-key": `name ${seam.id}`, onchange: change }));
}

/**
 * The one edge that a side runs along, with the stretch of it [m] from its first corner; null where
 * it is not one.
 */
function stretchOf(side) {
  const [run, ...others] = runsOf(side);
  const panel = panelOf(run.panel);
  const covered = panel && others.length === 0 ? edgesOf(panel, run) : [];
  if (covered.length !== 1) return null;
  const [{ edge, from, to }] = covered;
  const length = lengthOf(panel.edges[edge].points);
  return { run, panel, edge: panel.edges[edge], length, from: from * length, to: to * length };
}

/** A place at a length along an edge: its corner at either end. */
function placeAlong({ edge, length }, at) {
  if (at < 5e-4) return edge.from;
  if (at > length - 5e-4) return edge.to;
  return { edge: edge.index, at: Number((at / length).toFixed(4)) };
}

/** Fields for the part of its edge that a side takes, in centimeters from the first corner. */
function partFields(seam, side, title) {
  const found = stretchOf(seam[side]);
  if (!found) return null;
  const { run, panel, edge, length } = found;
  const set = (patch) => {
    const { from, to } = { ...found, ...patch };
    if (!(from >= 0 && to <= length + 5e-4 && to - from > 1e-3)) return false;
    const ends = [placeAlong(found, from), placeAlong(found, to)];
    const way = wayOf(panel, run);
    const [start, end] = way === "ccw" ? ends.reverse() : ends;
    changeSeam(seam.id, { [side]: { panel: panel.id, from: start, to: end, direction: way } }, `the part of ${seam.id}`);
    say(`${title} of ${seam.id}: ${centimeters(to - from)} of ${centimeters(length)}.`);
    return true;
  };
  const field = (name, label) => {
    const value = Number((found[name] * 100).toFixed(1));
    const change = (event) => {
      if (!set({ [name]: Math.min(length, event.target.valueAsNumber / 100) })) event.target.value = value;
    };
    return el("label", { class: "inline" }, label,
      el("input", { type: "number", min: 0, max: Number((length * 100).toFixed(1)), step: 0.1, value, "data-key": `${side} ${name} ${seam.id}`, "aria-label": `${title} ${label}, cm from corner ${edge.from}`, onchange: change }));
  };
  return el("div", { class: "options" }, el("span", {}, `${title}: edge ${edge.index} of ${panel.name},`), field("from", "from"), field("to", "to"), el("span", {}, `of ${centimeters(length)}`));
}

/** The way the correction would change the seam, in words. */
function correctionText(seam, other) {
  const parts = [];
  if (sideName(seam.a) !== sideName(other.a)) parts.push(sideName(other.a));
  if (sideName(seam.b) !== sideName(other.b)) parts.push(sideName(other.b));
  if (other.gather && !seam.gather) parts.push("gathered");
  if (other.layered && !seam.layered) parts.push("layered");
  if (other.match && other.match !== seam.match) parts.push(other.match === "auto" ? "ends found" : "ends as picked");
  return parts.join(", ") || "other order";
}

function correction(seam) {
  const other = correctionOf(seam);
  if (!other) return null;
  const use = () => {
    changeSeams(state.garment.seams.map((one) => (one.id === seam.id ? other : one)), `correcting ${seam.id}`, { selected: seam.id });
    say(`Seam ${seam.id} corrected.`);
  };
  return el("button", { type: "button", class: "small", "data-key": `correct ${seam.id}`, onclick: use },
    `Use the correction: ${correctionText(seam, other)}`);
}

function checkbox(seam, field, text) {
  const flip = (event) => changeSeam(seam.id, { [field]: event.target.checked });
  return el("label", { class: "check" },
    el("input", { type: "checkbox", checked: !!seam[field], "data-key": `${field} ${seam.id}`, onchange: flip }), text);
}

function options(seam) {
  const setStage = (event) => {
    const stage = Math.max(0, Math.round(Number(event.target.value)) || 0);
    changeSeam(seam.id, { stage });
  };
  const setMatch = (event) => changeSeam(seam.id, { match: event.target.value });
  const match = seam.match ?? "as_picked";
  return el("div", { class: "options" },
    el("label", { class: "inline" }, "Sewn in step ",
      el("input", { type: "number", min: 0, max: 99, step: 1, value: seam.stage ?? 0, "data-key": `stage ${seam.id}`, onchange: setStage })),
    el("label", { class: "inline" }, "Ends",
      el("select", { "data-key": `match ${seam.id}`, onchange: setMatch },
        el("option", { value: "as_picked", selected: match === "as_picked" }, "as picked"),
        el("option", { value: "auto", selected: match === "auto" }, "found"))),
    checkbox(seam, "gather", "Gather"),
    checkbox(seam, "layered", "Over another seam"),
    checkbox(seam, "allow_twist", "Twist on purpose"));
}

/** The confidence of the service in a seam that it suggested, with the reason. */
function reason(seam) {
  const found = suggestionOf(seam);
  return found && el("p", { class: "note" }, `Suggested, ${percent(found.confidence)} sure: ${sentence(found.because)}`);
}

/** The way of a side in words, by what the check says of its numbers. */
const wayText = (side, way) => (way ? drawnWay(panelOf(runsOf(side)[0].panel), way) : "either way");

export function seamDetails(seam, finding) {
  const ways = finding?.ok && `${plural(finding.stitch_count, "stitch", "stitches")}; ${centimeters(finding.length_a_m)} on ${centimeters(finding.length_b_m)}; ${wayText(seam.a, finding.direction_a)} with ${wayText(seam.b, finding.direction_b)}${finding.reversed ? ", the second side turned" : ""}.`;
  return el("div", { class: "more" },
    (finding?.errors ?? []).map((fault) => faultItem(fault)),
    correction(seam),
    reason(seam),
    (finding?.warnings ?? []).map((warning) => faultItem(warning, "warning")),
    ways && el("p", { class: "note" }, ways),
    nameField(seam),
    partFields(seam, "a", "First side"),
    partFields(seam, "b", "Second side"),
    options(seam));
}
