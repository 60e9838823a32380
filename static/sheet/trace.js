/** Part of an outline by a drag along it: from place to place, caught by corners and notches. */

import { lengthOf } from "../outline.js";

const wrap = (value, count) => ((value % count) + count) % count;

/** Way along the outline to a position, which is edge index plus fraction [m]. */
function arcAt(panel, position) {
  const edge = Math.floor(wrap(position, panel.edges.length));
  const before = panel.edges.slice(0, edge).reduce((sum, one) => sum + lengthOf(one.points), 0);
  return before + (wrap(position, panel.edges.length) - edge) * lengthOf(panel.edges[edge].points);
}

/** The place at a position: a corner or a notch within `reach` [m], else a point of an edge. */
function placeAt(panel, position, reach) {
  const total = arcAt(panel, panel.edges.length - 1e-9);
  const here = arcAt(panel, position);
  const marks = [
    ...panel.corners.map((_, index) => ({ place: index, arc: arcAt(panel, index) })),
    ...(panel.notches ?? []).map((notch, index) => ({ place: { notch: index }, arc: arcAt(panel, notch.edge + notch.at) })),
  ];
  const away = (arc) => Math.min(Math.abs(arc - here), total - Math.abs(arc - here));
  const [caught] = marks.filter(({ arc }) => away(arc) <= reach).sort((a, b) => away(a.arc) - away(b.arc));
  if (caught) return caught.place;
  const at = wrap(position, panel.edges.length);
  const edge = Math.floor(at);
  return { edge, at: Number((at - edge).toFixed(4)) };
}

/** A drag that begins at a point of an edge. */
export const beginTrace = ({ panel, edge, fraction }) => ({ panel, start: edge.index + fraction, moved: 0 });

/** The drag gone on to a point of the same outline, by the shorter way from where it was. */
export function advance(trace, { edge, fraction }) {
  const count = trace.panel.edges.length;
  const step = wrap(edge.index + fraction - (trace.start + trace.moved) + count / 2, count) - count / 2;
  return { ...trace, moved: trace.moved + step };
}

/** The run of a drag, or null where it has no length. */
export function tracedRun({ panel, start, moved }, reach) {
  const [from, to] = [placeAt(panel, start, reach), placeAt(panel, start + moved, reach)];
  if (JSON.stringify(from) === JSON.stringify(to) || Math.abs(moved) >= panel.edges.length) return null;
  return { panel: panel.id, from, to, direction: moved >= 0 ? "cw" : "ccw" };
}
