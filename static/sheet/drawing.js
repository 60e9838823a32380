/**
 * Paints one panel: its lines in units of the sheet, and its marks and labels in pixels of the
 * window.
 */

import { svg } from "../dom.js";
import { along, outwards } from "../outline.js";
import { titleOf } from "../panels.js";
import { centimeters } from "../words.js";
import { boxOf, onSheet } from "./arrangement.js";
import { textWidth } from "./labels.js";
import { NAME_FONT, shortName } from "./names.js";

/** SVG path data of a polyline in pixels; of one on the sheet with more digits. */
export const pathOf = (points, closed = false, digits = 1) =>
  points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(digits)} ${y.toFixed(digits)}`).join("") + (closed ? "Z" : "");

const SHEET_DIGITS = 5;
const NOTE_FONT = "400 11px";
const ROW_PX = 15;

/** Edges that are shorter on the screen [px] have no number. */
const NUMBERED_EDGE_PX = 44;
/** Panels that are smaller on the screen [px] have no numbers at their corners. */
const NUMBERED_PANEL_PX = 80;
const DISC_PX = 17;
/** Panels that are narrower on the screen [px] have no numbers at their edges. */
const NUMBERED_WIDTH_PX = 48;
/** Distances below a panel at which its name may stand [px]. */
const NAME_BELOW_PX = [24, 38, 52];

/**
 * A point of an edge in pixels, moved outwards by `px` (inwards where negative; the other way on a
 * mirrored copy).
 */
export function beside(points, fraction, map, px) {
  const { point: [x, y], tangent: [tx, ty] } = along(points, fraction);
  const [sx, sy] = map.point([x, y]);
  return [sx - ty * px, sy - tx * px];
}

/** Words for an edge, for screen readers. */
export function edgeLabel(panel, edge, seams) {
  const sewn = seams.length ? `, in seam ${seams.join(" and ")}` : ", not sewn";
  return `${titleOf(panel)}, edge ${edge.index}, corner ${edge.from} to ${edge.to}, ${centimeters(edge.length_m)}${sewn}`;
}

/** Cloth, holes, lines and edges of a panel on the sheet; `bind(path, edge)` readies each edge. */
export function drawPanel(panel, place, bind) {
  const line = (points, closed) => pathOf(points.map((point) => onSheet(place, point)), closed, SHEET_DIGITS);
  const ring = (edges) => line(edges.flatMap((edge) => edge.points.slice(0, -1)), true);
  const edges = panel.edges.flatMap((edge) => {
    const d = line(edge.points);
    const path = svg("path", { class: "edge", d, role: "button" });
    bind(path, edge);
    return [path, svg("path", { class: "edge-line", d })];
  });
  return svg("g", { role: "group", "data-of": panel.id },
    svg("path", { class: "cloth", d: ring(panel.edges) }),
    (panel.holes ?? []).map((hole) => svg("path", { class: "hole", d: ring(hole.edges) })),
    (panel.internal_lines ?? []).map((points) => svg("path", { class: "inner", d: line(points) })),
    panel.cut_line?.length > 0 && svg("path", { class: "cut", d: line(panel.cut_line, true) }),
    edges);
}

/** Notches and drill holes, of one size at every zoom. */
export function drawMarks(panel, map) {
  const drills = (panel.drill_holes ?? []).map((at) => {
    const [cx, cy] = map.point(at);
    return svg("circle", { class: "hole", cx, cy, r: 3 });
  });
  const notches = (panel.notches ?? []).filter((notch) => panel.edges[notch.edge]).map((notch) => {
    const { points } = panel.edges[notch.edge];
    return svg("path", { class: "notch", d: pathOf([beside(points, notch.at, map, 0), beside(points, notch.at, map, -8 * outwards(panel))]) });
  });
  return [...drills, ...notches];
}

/** The arrow of the warp, below the panel's name. */
export function grainArrow(panel, map, scale) {
  const box = boxOf(panel);
  const top = (box.bottom + box.top) / 2 - 24 / scale;
  const size = Math.min(28 / scale, (box.right - box.left) / 5, (top - box.bottom - 26 / scale) / 2);
  if (size * scale < 8) return null;
  const angle = ((panel.grain?.angle_deg ?? 90) * Math.PI) / 180;
  const middle = [(box.left + box.right) / 2, top - size];
  const [x0, y0] = map.point([middle[0] - Math.cos(angle) * size, middle[1] - Math.sin(angle) * size]);
  const [x1, y1] = map.point([middle[0] + Math.cos(angle) * size, middle[1] + Math.sin(angle) * size]);
  const [ux, uy] = [(x1 - x0) / Math.hypot(x1 - x0, y1 - y0), (y1 - y0) / Math.hypot(x1 - x0, y1 - y0)];
  const head = (x, y, s) => `M${x - s * (ux * 6 - uy * 4)} ${y - s * (uy * 6 + ux * 4)}L${x} ${y}L${x - s * (ux * 6 + uy * 4)} ${y - s * (uy * 6 - ux * 4)}`;
  return svg("path", { class: "grain", d: `M${x0} ${y0}L${x1} ${y1}${head(x1, y1, 1)}${head(x0, y0, -1)}` });
}

const noteOf = (panel, spare) => {
  const kind = spare ? "left out" : panel.copy_of ? "mirrored copy" : panel.unfolded ? "unfolded" : "";
  return `${(panel.area_m2 * 1e4).toFixed(0)} cm²${kind && `, ${kind}`}`;
};

/** The name inside the panel with a note, where both have room. */
function innerName(panel, { width, height, x, middle }, spare) {
  const note = noteOf(panel, spare);
  const inner = Math.max(textWidth(panel.name, NAME_FONT), textWidth(note, NOTE_FONT));
  if (width <= inner + 84 || height <= 64) return null;
  const draw = ({ y }) => svg("g", { class: "label" },
    svg("text", { class: "panel-name", x, y: y - ROW_PX / 2 }, panel.name),
    svg("text", { class: "panel-note", x, y: y + ROW_PX / 2 + 1 }, note));
  return { places: [{ x, y: middle, width: inner + 6, height: 2 * ROW_PX + 2 }], draw };
}

/**
 * The panel's name: in its middle, else below it, as much of it as has room; there it yields to
 * numbers of seams.
 */
export function nameLabel(panel, map, scale, { spare, start }) {
  const box = boxOf(panel);
  const [width, height] = [(box.right - box.left) * scale, (box.top - box.bottom) * scale];
  const [x, middle] = map.point([(box.left + box.right) / 2, (box.bottom + box.top) / 2]);
  const inside = innerName(panel, { width, height, x, middle }, spare);
  if (inside) return inside;
  const texts = new Set([panel.name, shortName(panel.name, width + 50, start), shortName(panel.name, Math.max(width, 40), start)]);
  const places = [...texts].filter(Boolean).flatMap((text) => NAME_BELOW_PX.map((down) => (
    { text, x, y: middle + height / 2 + down, width: textWidth(text, NAME_FONT) + 8, height: ROW_PX + 2 })));
  return { places, yields: true, draw: ({ text, y }) => svg("text", { class: "panel-name label", x, y }, text) };
}

/** Dots at the corners, which lie below their numbers. */
export const cornerDots = (panel, map) => panel.corners.map((corner) => {
  const [cx, cy] = map.point([corner.x, corner.y]);
  return svg("circle", { class: "corner", cx, cy, r: 2.5 });
});

/** Numbers of the corners as discs. */
export function cornerLabels(panel, map, scale) {
  const box = boxOf(panel);
  if (Math.max(box.right - box.left, box.top - box.bottom) * scale < NUMBERED_PANEL_PX) return [];
  return panel.corners.map((corner) => {
    const [x, y] = map.point([corner.x, corner.y]);
    const draw = () => svg("g", { class: "label" },
      svg("circle", { class: "corner", cx: x, cy: y, r: DISC_PX / 2 }),
      svg("text", { class: "corner-number", x, y }, String(corner.index)));
    return { places: [{ x, y, width: DISC_PX, height: DISC_PX }], draw };
  });
}

/** Numbers of the edges inside the panel. */
export function edgeLabels(panel, map, scale) {
  const box = boxOf(panel);
  if (Math.min(box.right - box.left, box.top - box.bottom) * scale < NUMBERED_WIDTH_PX) return [];
  return panel.edges.filter((edge) => edge.length_m * scale >= NUMBERED_EDGE_PX).map((edge) => {
    const places = [0.5, 0.3, 0.7].map((at) => {
      const [x, y] = beside(edge.points, at, map, -14 * outwards(panel));
      return { x, y, width: 16, height: 14 };
    });
    const draw = ({ x, y }) => svg("text", { class: "edge-number label", x, y }, String(edge.index));
    return { places, draw };
  });
}
