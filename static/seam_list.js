/** The list of seams: what is wrong with each, what would put it right, and its order of sewing. */

import { byId, el, paintWhenFree, replaceChildren } from "./dom.js";
import { leftOut } from "./panels.js";
import { selectSeam } from "./picking.js";
import { panelName, sideName } from "./run_names.js";
import { say } from "./say.js";
import { seamDetails } from "./seam_details.js";
import { changeSeams, deleteSeam, reverseSeam } from "./seams.js";
import { colorClass } from "./sheet/seam_marks.js";
import { state, watch } from "./state.js";
import { accept, acceptOffer, refuseOffer, suggestionOf } from "./suggest.js";
import { centimeters, distance, percent, plural, problemItems, sentence } from "./words.js";

const findingOf = (seam) => state.check?.seams.find((finding) => finding.id === seam.id);

function figures(finding) {
  if (!finding) return el("span", { class: "figures" }, "");
  if (!finding.ok) return el("span", { class: "figures bad" }, "✗ cannot be sewn");
  const ease = finding.ease_m > 0.001 ? `ease ${distance(finding.ease_m)} (${percent(finding.ease)})` : "no ease";
  return el("span", { class: "figures" }, `${finding.warnings.length ? "⚠" : "✓"} ${centimeters(finding.length_a_m)}, ${ease}`);
}

/** Seams in the order of sewing: by stage, then as listed. */
function move(seam, by) {
  const order = inOrder();
  const at = order.findIndex((one) => one.id === seam.id);
  const other = order[at + by];
  if (!other) return;
  const stage = other.stage ?? 0;
  const moved = order.filter((one) => one !== seam);
  moved.splice(at + by, 0, stage === (seam.stage ?? 0) ? seam : { ...seam, stage });
  changeSeams(moved, `the place of ${seam.id}`);
  say(`Seam ${seam.id} is now sewn as number ${at + by + 1} in order.`);
}

const inOrder = () =>
  state.garment.seams.map((seam, index) => ({ seam, index }))
    .sort((a, b) => (a.seam.stage ?? 0) - (b.seam.stage ?? 0) || a.index - b.index)
    .map(({ seam }) => seam);

const iconButton = (seam, what, sign, act, disabled = false) =>
  el("button", { type: "button", class: "small", "aria-label": `${what} ${seam.id}`, title: what, "data-key": `${what} ${seam.id}`, disabled, onclick: act }, sign);

function row(seam, at, count) {
  const finding = findingOf(seam);
  const open = seam.id === state.selected;
  const number = state.numbers[seam.id] ?? state.garment.seams.indexOf(seam) + 1;
  const classes = ["seam", colorClass(number), open && "selected", finding?.ok === false && "bad"];
  const found = suggestionOf(seam);
  return el("li", { class: classes.filter(Boolean).join(" "), "data-row": seam.id },
    el("div", { class: "row" },
      el("button", { type: "button", class: "choose", "aria-expanded": String(open), "data-key": `choose ${seam.id}`, title: found?.because, onclick: () => selectSeam(seam.id) },
        el("span", { class: "badge" }, String(number)),
        el("span", { class: "what" }, seam.id, found && [" ", el("span", { class: `tag${found.confidence < SURE ? " doubtful" : ""}` }, `suggested, ${percent(found.confidence)}`)]),
        figures(finding),
        el("small", { class: "sides" }, `${sideName(seam.a)} with ${sideName(seam.b)}`)),
      found && iconButton(seam, "Accept", "✓", () => accept([seam.id])),
      iconButton(seam, "Reverse", "⇄", () => reverseSeam(seam.id)),
      iconButton(seam, "Sew earlier", "↑", () => move(seam, -1), at === 0),
      iconButton(seam, "Sew later", "↓", () => move(seam, 1), at === count - 1),
      iconButton(seam, found ? "Refuse" : "Delete", "✕", () => deleteSeam(seam.id))),
    open && seamDetails(seam, finding));
}

/** Draws the number of seams on the drawer's handle. */
function drawCount() {
  const { seams } = state.garment;
  const bad = seams.filter((seam) => findingOf(seam)?.ok === false).length;
  byId("seam-count").textContent = bad ? `${bad} of ${seams.length} ✗` : String(seams.length);
  byId("seam-count").classList.toggle("bad", bad > 0);
}

/** Proposals above this confidence are not doubtful. */
const SURE = 0.8;

/** The number of proposals that wait to be looked at, with a button for all. */
function proposalsHead(seams) {
  const ids = seams.filter(suggestionOf).map((seam) => seam.id);
  return ids.length > 0 && el("div", { class: "head" },
    el("span", {}, `${plural(ids.length, "proposal")}, drawn dashed: sewn as they are, unless you refuse them`),
    el("button", { type: "button", class: "small", "data-key": "accept all", onclick: () => accept(ids) }, "Accept all"));
}

function offerRow(offer) {
  return el("li", { class: "seam offer", "data-row": offer.id }, el("div", { class: "row" },
    el("p", { class: "choose" }, el("span", { class: "what" }, offer.id, " ", el("span", { class: "tag doubtful" }, `offered, ${percent(offer.confidence)}`)),
      el("small", { class: "sides" }, `${sideName(offer.a)} with ${sideName(offer.b)}: ${sentence(offer.because)}`)),
    iconButton(offer, "Accept", "✓", () => acceptOffer(offer)),
    iconButton(offer, "Refuse", "✕", () => refuseOffer(offer))));
}

/** Seams that are only offered. */
const offerList = () => state.offers.length > 0 && [
  el("p", { class: "note" }, "Offered, but less than half sure, and not sewn before you accept them:"),
  el("ul", { "aria-label": "Offered seams" }, state.offers.map(offerRow)),
];

/** Panels that stay out. */
function spareNote() {
  const spare = leftOut();
  return spare.length > 0 && el("p", { class: "note" },
    `Left out when it is sewn, because no seam is suggested for them: ${spare.map(panelName).join(", ")}. Sew one on to keep it.`);
}

function draw() {
  const seams = inOrder();
  const problem = state.checkProblem;
  replaceChildren(byId("seam-list"),
    problem && el("div", { class: "faults" }, problemItems(problem)),
    spareNote(),
    proposalsHead(seams),
    state.pattern && seams.length === 0 && el("p", { class: "note" }, "No seams yet."),
    seams.length > 0 && el("ol", { "aria-label": "Seams in order of sewing" }, seams.map((seam, at) => row(seam, at, seams.length))),
    offerList());
}

export function startSeamList() {
  watch(["pattern", "garment", "suggested", "offers", "leftOut", "check", "checkProblem", "selected", "numbers"], () => paintWhenFree(byId("seam-list"), draw));
  watch(["garment", "check"], drawCount);
  watch(["selected", "check"], () => byId("seam-list").querySelector(".selected")?.scrollIntoView({ block: "nearest" }));
}
