/**
 * Marks over the cloth, of one size at every zoom: marks, seams, labels in the order of their
 * importance.
 */

import { leftOut } from "../panels.js";
import { state } from "../state.js";
import { suggestionOf } from "../suggest.js";
import { sheetBox } from "./arrangement.js";
import { cornerDots, cornerLabels, drawMarks, edgeLabels, grainArrow, nameLabel } from "./drawing.js";
import { touch } from "./labels.js";
import { badgesOf, drawSeam, drawSide } from "./seam_marks.js";
import { toScreen } from "./view.js";

const ofEach = (scene, draw) =>
  scene.all.flatMap((panel) => draw(panel, scene.maps.get(panel.id), state.view.k) ?? []);

const numberOf = (seam, index) => state.numbers[seam.id] ?? index + 1;

/** Seams in pixels, the selected one last, then the first side. */
function seamMarks(scene) {
  const { garment, check, picked, selected } = state;
  const findings = check?.seams ?? [];
  const marks = garment.seams.map((seam, index) => {
    const finding = findings[index]?.id === seam.id ? findings[index] : null;
    const isSelected = seam.id === selected;
    return drawSeam(scene, seam, {
      number: numberOf(seam, index), selected: isSelected, proposed: suggestionOf(seam) !== null, dim: Boolean(picked) || (selected !== null && !isSelected),
      bad: finding?.ok === false, reversed: finding?.reversed,
    });
  });
  marks.sort((a, b) => a.classList.contains("selected") - b.classList.contains("selected"));
  if (picked) marks.push(drawSide(scene, picked, "pending"));
  const offered = state.offers.flatMap(({ a, b }) => [a, b]).map((side) => drawSide(scene, side, "offer-mark"));
  return [...offered, ...marks];
}

/** Marks of the panels and seams. */
export const marksOf = (scene) =>
  [...ofEach(scene, drawMarks), ...ofEach(scene, grainArrow), ...seamMarks(scene), ...ofEach(scene, cornerDots)];

/** The boxes of the panels in pixels, about their middles. */
const screenBoxes = ({ all, arrangement }) => all.map((panel) => {
  const { left, right, top, bottom } = sheetBox(panel, arrangement.places.get(panel.id));
  const { k } = state.view;
  const [x, y] = toScreen(state.view, [(left + right) / 2, (top + bottom) / 2]);
  return { x, y, width: k * (right - left), height: k * (bottom - top) };
});

/** The name of a panel below it, where no panel is. */
function besidePanels(name, boxes) {
  const places = name.places.filter((place) => !boxes.some((box) => touch(place, box)));
  return { ...name, places };
}

/** Labels in the order in which they take their places. */
export function labelsOf(scene) {
  const { k } = state.view;
  const spare = new Set(leftOut());
  const badges = state.garment.seams.map((seam, index) => ({ seam, labels: badgesOf(scene, seam, numberOf(seam, index)) }));
  const badgesWhere = (test) => badges.filter(test).flatMap(({ labels }) => labels);
  const names = ofEach(scene, (panel, map) => [nameLabel(panel, map, k, { spare: spare.has(panel.id), start: scene.start })]);
  const boxes = screenBoxes(scene);
  return [
    ...badgesWhere(({ seam }) => seam.id === state.selected),
    ...names.filter((name) => !name.yields),
    ...badgesWhere(({ seam }) => seam.id !== state.selected),
    ...names.filter((name) => name.yields).map((name) => besidePanels(name, boxes)),
    ...ofEach(scene, cornerLabels),
    ...ofEach(scene, edgeLabels),
  ];
}
