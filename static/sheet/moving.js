/** Moves of the view: zoom, one panel or all of them, an edge that is brought in sight. */

import { state, update } from "../state.js";
import { sheetBox } from "./arrangement.js";
import { drawn, mapOf, placeOf } from "./drawn.js";
import { fitted, panned, zoomed } from "./view.js";

/** Margin around a panel that is fitted, and around an edge that is brought to view [px]. */
const MARGIN_PX = 56;
const EDGE_MARGIN_PX = 30;
const ZOOM_STEP = 1.4;

/** Sets the view; `home` marks the one that shows all panels. */
export const setView = (view, home = false) => update({ view: { ...view, home } });

/** Shows the whole arrangement as it is. */
export function showAll() {
  const { arrangement: { width, height }, size } = drawn.sheet;
  setView(fitted({ left: 0, top: 0, right: width, bottom: height }, size, 0), true);
}

/** Shows one panel as large as it fits. */
export function fitPanel(panel) {
  setView(fitted(sheetBox(panel, placeOf(panel)), drawn.sheet.size, MARGIN_PX));
}

/** Shows the panel with an id as large as it fits. */
export function fitPanelById(id) {
  const panel = drawn.sheet?.panels.get(id);
  if (panel) fitPanel(panel);
}

export const panBy = (shift) => drawn.sheet && setView(panned(state.view, shift));

/** Zooms about a point of the window, else about its middle. */
export function zoomBy(factor, at) {
  if (!drawn.sheet) return;
  const { width, height } = drawn.sheet.size;
  setView(zoomed(state.view, at ?? [width / 2, height / 2], factor));
}

export const zoomIn = () => zoomBy(ZOOM_STEP);

export const zoomOut = () => zoomBy(1 / ZOOM_STEP);

/** Moves the sheet until the middle of an edge is seen. */
export function reveal(panel, edge) {
  const { width, height } = drawn.sheet.size;
  const middle = edge.points[Math.floor(edge.points.length / 2)];
  const [x, y] = mapOf(panel).point(middle);
  const shift = (at, size) => Math.max(EDGE_MARGIN_PX - at, 0) + Math.min(size - EDGE_MARGIN_PX - at, 0);
  const [dx, dy] = [shift(x, width), shift(y, height)];
  if (dx || dy) panBy([dx, dy]);
}
