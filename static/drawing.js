/** Paints one panel: cloth, marks, corners and edges with their numbers. */

import { svg } from "./dom.js";
import { along, outwards } from "./outline.js";
import { titleOf } from "./panels.js";
import { boxOf } from "./sheet_layout.js";
import { centimetres } from "./words.js";

/** SVG path data of a polyline already on the sheet. */
export const pathOf = (points, closed = false) =>
  points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("") + (closed ? "Z" : "");

const closedPath = (edges, map) => pathOf(edges.flatMap((edge) => edge.points.slice(0, -1)).map(map.point), true);

/** A point of an edge on the sheet, moved outwards by `px` (inwards where negative; the other way on a mirrored copy). */
export function beside(points, fraction, map, px) {
  const { point: [x, y], tangent: [tx, ty] } = along(points, fraction);
  const [sx, sy] = map.point([x, y]);
  return [sx - ty * px, sy - tx * px];
}

function marks(panel, map) {
  const lines = (panel.internal_lines ?? []).map((line) => svg("path", { class: "inner", d: pathOf(line.map(map.point)) }));
  if (panel.cut_line?.length) lines.push(svg("path", { class: "cut", d: pathOf(panel.cut_line.map(map.point), true) }));
  const drills = (panel.drill_holes ?? []).map((at) => {
    const [cx, cy] = map.point(at);
    return svg("circle", { class: "hole", cx, cy, r: 3 });
  });
  const notches = (panel.notches ?? []).filter((notch) => panel.edges[notch.edge]).map((notch) => {
    const points = panel.edges[notch.edge].points;
    return svg("path", { class: "notch", d: pathOf([beside(points, notch.at, map, 0), beside(points, notch.at, map, -8 * outwards(panel))]) });
  });
  return [...lines, ...drills, ...notches];
}

/** The arrow of the warp, below the panel's name. */
function grainArrow(panel, map, scale) {
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

/** Whether a panel is too small on the sheet to hold what is written into it. */
function isThin(panel, scale, least = 64) {
  const box = boxOf(panel);
  return (box.top - box.bottom) * scale < 64 || (box.right - box.left) * scale < least;
}

/** The name as far as it has room beside its neighbours'. Names of one style differ at their end. */
function shortName(panel, room) {
  const most = Math.max(3, Math.floor(room / 7.5));
  return panel.name.length <= most ? panel.name : `…${panel.name.slice(1 - most)}`;
}

function label(panel, map, scale, spare) {
  const box = boxOf(panel);
  const [x, y] = map.point([(box.left + box.right) / 2, (box.bottom + box.top) / 2]);
  if (isThin(panel, scale, 8 * panel.name.length + 84)) {
    const below = map.point([0, box.bottom])[1] + 42;
    const room = (box.right - box.left) * scale + 36;
    return [svg("text", { class: "panel-name", x, y: below }, shortName(panel, room))];
  }
  const counts = spare ? "left out" : panel.copy_of ? "mirrored copy" : panel.unfolded ? "unfolded" : "";
  return [
    svg("text", { class: "panel-name", x, y }, panel.name),
    svg("text", { class: "panel-note", x, y: y + 15 }, `${(panel.area_m2 * 1e4).toFixed(0)} cm²${counts && `, ${counts}`}`),
  ];
}

/** Corners as numbered discs; where they crowd, as dots. They lie above the seams. */
export function drawCorners(panel, map, scale) {
  const apart = isThin(panel, scale) ? 26 : 19;
  const numbered = [];
  return panel.corners.map((corner) => {
    const [cx, cy] = map.point([corner.x, corner.y]);
    const crowded = numbered.some(([x, y]) => Math.hypot(x - cx, y - cy) < apart);
    if (crowded) return svg("circle", { class: "corner", cx, cy, r: 2.5 });
    numbered.push([cx, cy]);
    return svg("g", {},
      svg("circle", { class: "corner", cx, cy, r: 8.5 }),
      svg("text", { class: "corner-number", x: cx, y: cy }, String(corner.index)));
  });
}

function edgeNumber(panel, edge, map, scale) {
  if (edge.length_m * scale < 26) return null;
  const [at, px] = isThin(panel, scale) ? [0.25, 11] : [0.5, -15];
  const [x, y] = beside(edge.points, at, map, px * outwards(panel));
  return svg("text", { class: "edge-number", x, y }, String(edge.index));
}

/** What a screen reader says of an edge. */
export function edgeLabel(panel, edge, seams) {
  const sewn = seams.length ? `, in seam ${seams.join(" and ")}` : ", not sewn";
  return `${titleOf(panel)}, edge ${edge.index}, corner ${edge.from} to ${edge.to}, ${centimetres(edge.length_m)}${sewn}`;
}

/** The whole panel; `bind(path, edge)` gives each edge its listeners and state, a `spare` panel is not sewn. */
export function drawPanel(panel, map, scale, { bind, spare }) {
  const outline = closedPath(panel.edges, map);
  const holes = (panel.holes ?? []).map((hole) => svg("path", { class: "hole", d: closedPath(hole.edges, map) }));
  const edges = panel.edges.flatMap((edge) => {
    const d = pathOf(edge.points.map(map.point));
    const path = svg("path", { class: "edge", d, role: "button" });
    bind(path, edge);
    return [path, svg("path", { class: "edge-line", d })];
  });
  const name = `Panel ${titleOf(panel)}${spare ? ", left out" : ""}`;
  return svg("g", { role: "group", class: spare && "spare", "aria-label": name },
    svg("path", { class: "cloth", d: outline }), holes, marks(panel, map),
    grainArrow(panel, map, scale), label(panel, map, scale, spare), edges,
    panel.edges.map((edge) => edgeNumber(panel, edge, map, scale)));
}
