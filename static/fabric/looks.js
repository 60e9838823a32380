/** How fabrics look: the kind of each, told by its name and figures, and its color. */

import { sourceOf } from "../mirrored.js";
import { state } from "../state.js";

/** Words of names, the special before the general. */
const WORDS = [
  ["denim", /denim|jean/i],
  ["sheer", /chiffon|organza|tulle|voile/i],
  ["leather", /leather/i],
  ["fleece", /fleece|felt|wool|melton/i],
  ["knit", /knit|jersey|rib|ponte|interlock|tricot|spandex/i],
  ["satin", /satin|silk|taffeta/i],
];
/** Cloth that gives more than this along both threads is knitted [N/m]. */
const KNIT_N_M = 1000;

/** Colors that are offered. */
export const COLORS = [
  ["White", "#f4f2ec"], ["Rose", "#c98b86"], ["Brick", "#9c4a3c"],
  ["Olive", "#7f8a5c"], ["Teal", "#3f7f84"], ["Sky", "#8fb0cf"], ["Indigo", "#35486b"], ["Charcoal", "#3c4045"],
];

/** Colors of fabrics until others are chosen. */
const USUAL = {
  "canvas-cotton": "#c9bc9f", chiffon: "#d3a5a5", "cotton-poplin": "#8fb0cf", "denim-11oz": "#3d5478", "jersey-knit": "#a9adb3",
  "leather-garment": "#6b4632", linen: "#c8b48e", organza: "#b9c6d6", "polyester-fleece": "#8a9a80", "ponte-knit": "#454d6b",
  "rib-knit": "#e3dccb", "silk-satin": "#d8c3a0",
};
const OTHERS = ["#9db08e", "#c79a86", "#b9a3c4", "#c9b37e", "#86b1ad"];

const numberOf = (text) => [...text].reduce((sum, letter) => (31 * sum + letter.codePointAt(0)) % 1009, 7);

/** The kind of a fabric: what its surface does with light. */
export function kindOf(id, fabric) {
  const named = WORDS.find(([, pattern]) => pattern.test(`${id} ${fabric?.name ?? ""}`));
  if (named) return named[0];
  const isSoft = fabric && Math.max(fabric.stretch_warp_n_m, fabric.stretch_weft_n_m) < KNIT_N_M;
  return isSoft ? "knit" : "woven";
}

/** The color of a fabric in this garment. */
export const colorOf = (id) => state.colors[id] ?? USUAL[id] ?? OTHERS[numberOf(id) % OTHERS.length];

const fabricOfId = (id) => state.garment.fabrics?.[id] ?? state.fabrics[id];

/** The fabric that a panel has now, whatever the shown shape was sewn of. */
export function fabricIdOf(panel) {
  const { panels, default_fabric: usual } = state.garment;
  return panels[panel]?.fabric ?? panels[sourceOf(panel)]?.fabric ?? usual;
}

/** Kind and color of a panel: `{kind, color}`. */
export function lookOf(panel) {
  const id = fabricIdOf(panel);
  return { kind: kindOf(id, fabricOfId(id)), color: colorOf(id) };
}
