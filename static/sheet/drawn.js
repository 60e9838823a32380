/** The sheet as it is drawn now, for all that paint it, point at it or move it. */

import { byId } from "../dom.js";
import { state } from "../state.js";
import { onPanel, onSheet } from "./arrangement.js";
import { keyOf } from "./edges.js";
import { toScreen, toSheet } from "./view.js";

/**
 * `sheet` is `{all, panels, boxes, arrangement, start, size}` and `layers` is `{cloth, marks,
 * labels, hover}`; both are null before there is a pattern.
 */
export const drawn = { sheet: null, layers: null };

export const host = () => byId("sheet");

export const sizeNow = () => ({ width: host().clientWidth, height: host().clientHeight });

/** The path of an edge. */
export const pathFor = (panel, edge) => drawn.layers.cloth.querySelector(`[data-key="${CSS.escape(keyOf(panel, edge))}"]`);

export const placeOf = (panel) => drawn.sheet.arrangement.places.get(panel.id);

/** Maps between a panel and the window in the view of now. */
export function mapOf(panel) {
  const { view } = state;
  const place = placeOf(panel);
  return {
    point: (at) => toScreen(view, onSheet(place, at)),
    back: (at) => onPanel(place, toSheet(view, at)),
  };
}

/** The sheet with the maps of its panels, as the painters of seams need it. */
export const scene = () => ({ ...drawn.sheet, maps: new Map(drawn.sheet.all.map((panel) => [panel.id, mapOf(panel)])) });
