/** The maps that a fit can be seen by: where their values are, their scales, units and words. */

import { panelName } from "../run_names.js";
import { percent } from "../words.js";

/** Pressure [kPa] from which cloth is felt, and from which it is uncomfortable (Denton, 1972). */
const FELT_KPA = 2;
const UNCOMFORTABLE_KPA = 6;
/** Share of what the fabric gives above which little is left to move with. */
const CLOSE = 0.5;
const WIDEST_GAP_MM = 100;
/** Strain at the end of a scale at least: less cannot be told from its error. */
const LEAST_STRAIN = 0.02;

const signed = (text, value) => (value > 0 ? `+${text}` : text);
const strainText = (value) => signed(`${(100 * value).toFixed(1)} %`, value);
const kilopascals = (value) => `${value.toFixed(value < 1 ? 2 : 1)} kPa`;
const millimeters = (value) => `${value.toFixed(value !== 0 && Math.abs(value) < 10 ? 1 : 0)} mm`;

/** The next round number: 1, 2 or 5 times a power of ten. */
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((step) => step * power).find((round) => round >= value * 0.999);
}

/** By what is stretched most: cloth that is compressed gives way and shows the end of the scale. */
const strainRange = ([, most]) => {
  const end = roundUp(Math.max(LEAST_STRAIN, most));
  return [-end, end];
};

const strain = (direction, item) => ({
  label: `Strain, ${direction}`, attribute: "_strain", item, scale: "diverging", hasOver: false,
  range: strainRange, text: strainText, what: `stretched along the ${direction}`,
  words: (most) => (most.value < 0.001 ? "The cloth is stretched nowhere." : `Stretched most: ${strainText(most.value)}${most.where}.`),
});

/** By the names that the report gives them. */
export const MAPS = {
  strain_warp: strain("warp", 0),
  strain_weft: strain("weft", 1),
  strain_share: {
    label: "Share of limit", attribute: "_strain_share", item: 0, scale: "sequence", hasOver: true,
    range: () => [0, 1], text: percent, what: "of what the fabric gives",
    words: ({ value, where }) => {
      const verdict = value > 1 ? "too tight: more cloth, or one that gives more" : value > CLOSE ? "close, little is left to move with" : "there is room to move";
      return `At most ${percent(value)} of what the fabric gives${where}: ${verdict}.`;
    },
  },
  pressure: {
    label: "Pressure", attribute: "_pressure", item: 0, scale: "sequence", hasOver: false,
    range: ([, most]) => [0, roundUp(Math.max(0.5, most))], text: kilopascals, what: "of pressure on the skin",
    words: ({ value, where }) => {
      const verdict = value > UNCOMFORTABLE_KPA ? "too tight for comfort" : value > FELT_KPA ? "felt, as a firm waistband is" : "hardly felt";
      return `Presses most with ${kilopascals(value)}${where}: ${verdict}.`;
    },
  },
  gap: {
    label: "Gap", attribute: "_gap", item: 0, scale: "sequence", hasOver: false,
    range: ([, most]) => [0, Math.min(WIDEST_GAP_MM, roundUp(Math.max(5, most)))], text: millimeters, what: "from the body",
    words: ({ value, where, zones }) => {
      const means = zones.map(({ name, mean }) => `${name} ${mean.toFixed(0)} mm`);
      return means.length ? `On average from the ${means.join(", ")}.` : `Hangs ${millimeters(value)} off at most${where}.`;
    },
  },
};

const isSamePlace = (a, b) => a.max_at_m.every((x, i) => x === b.max_at_m[i]);

/** The largest value of a summary with its place, in words for a person: `{value, where, at}`. */
function mostOf({ panels, zones }) {
  const most = panels.reduce((a, b) => (b.max > a.max ? b : a));
  const zone = zones.find((one) => isSamePlace(one, most));
  return { value: most.max, where: `, in ${panelName(most.name)}${zone ? ` at the ${zone.name}` : ""}`, at: most.max_at_m, zones };
}

/** The sentence on a map of the report and the place that it is about: `{text, at}`. */
export function wordsOn(summary) {
  const most = mostOf(summary);
  return { text: MAPS[summary.name].words(most), at: most.at };
}

/** The stated error of a map in words. */
export function errorText({ name, error }) {
  if (error == null) return "Its error is not known.";
  return `± ${MAPS[name].text(error).replace("+", "")} by the mesh`;
}
