/** Panels, places and stretches of outlines as a person reads them. */

import { runsOf, wayOf } from "./outline.js";
import { panelOf, titleOf } from "./panels.js";
import { percent } from "./words.js";

export function panelName(id) {
  const panel = panelOf(id);
  return panel ? titleOf(panel) : id;
}

const placeName = (place) => {
  if (typeof place === "number") return String(place);
  if (place && "notch" in place) return `notch ${place.notch}`;
  if (place && "edge" in place) return `${percent(place.at)} of edge ${place.edge}`;
  return JSON.stringify(place);
};

/** `FRONT 3 → 4`. */
export const runName = (run) => `${panelName(run.panel)} ${placeName(run.from)} → ${placeName(run.to)}`;

/** The runs of a side, one after the other. */
export const sideName = (side) => runsOf(side).map(runName).join(", ");

/** A way along a panel as it is drawn: on a mirrored copy the numbers run the other way round. */
export const drawnWay = (panel, way) => ((way === "ccw") === !panel?.copy_of ? "counter-clockwise" : "clockwise");

/** The way of a run as it is drawn. */
export function clockwise(run) {
  const panel = panelOf(run.panel);
  return drawnWay(panel, wayOf(panel, run));
}
