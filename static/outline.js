/** Ways along the outlines of panels, in pattern coordinates (meters, y up, stored clockwise). */

/** The runs of one side of a seam. */
export const runsOf = (side) => (Array.isArray(side) ? side : [side]);

/** The sign of the way out of a panel: the numbers of a mirrored copy run counter-clockwise. */
export const outwards = (panel) => (panel.copy_of ? -1 : 1);

/**
 * Position of a place on the outline: edge index plus fraction; null for holes and internal lines.
 */
function position(panel, place) {
  if (typeof place === "number") return place < panel.corners.length ? place : null;
  if (place && "hole" in place) return null;
  if (place && "edge" in place) return place.edge + place.at;
  const notch = panel.notches?.[place?.notch];
  return notch ? notch.edge + notch.at : null;
}

/** `cw`, `ccw` or null where it is not plain. */
export function wayOf(panel, run) {
  if (run.direction) return run.direction;
  const count = panel.corners.length;
  if (count < 3) return null;
  if (run.to === (run.from + 1) % count) return "cw";
  if (run.from === (run.to + 1) % count) return "ccw";
  return null;
}

function part(points, from, to) {
  const total = lengthOf(points);
  const cut = [along(points, from).point];
  let done = 0;
  for (let i = 1; i < points.length; i++) {
    done += step(points, i);
    const at = done / total;
    if (at > from + 1e-9 && at < to - 1e-9) cut.push(points[i]);
  }
  cut.push(along(points, to).point);
  return cut;
}

/** Edges that a run covers, in its order: `[{edge, from, to}]` with fractions clockwise. */
export function edgesOf(panel, run) {
  const way = wayOf(panel, run);
  const count = panel.edges.length;
  let start = position(panel, way === "ccw" ? run.to : run.from);
  let end = position(panel, way === "ccw" ? run.from : run.to);
  if (way === null || start === null || end === null) return [];
  if (end <= start + 1e-9) end += count;
  const covered = [];
  while (start < end - 1e-9) {
    const edge = Math.floor(start + 1e-9);
    const stop = Math.min(edge + 1, end);
    covered.push({ edge: edge % count, from: Math.max(start - edge, 0), to: stop - edge });
    start = stop;
  }
  return way === "ccw" ? covered.reverse() : covered;
}

/** The polyline of a run in its order. */
export function runPoints(panel, run) {
  const turned = wayOf(panel, run) === "ccw";
  const points = [];
  for (const { edge, from, to } of edgesOf(panel, run)) {
    const piece = part(panel.edges[edge].points, from, to);
    points.push(...(turned ? piece.reverse() : piece).slice(points.length ? 1 : 0));
  }
  return points;
}

const step = (points, i) => Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);

export function lengthOf(points) {
  let sum = 0;
  for (let i = 1; i < points.length; i++) sum += step(points, i);
  return sum;
}

/** The point at a fraction of the arc length, and the unit tangent there. */
export function along(points, fraction) {
  let left = lengthOf(points) * fraction;
  let i = 1;
  while (i < points.length - 1 && left > step(points, i)) left -= step(points, i++);
  const size = step(points, i) || 1;
  const tangent = [(points[i][0] - points[i - 1][0]) / size, (points[i][1] - points[i - 1][1]) / size];
  return { point: [points[i - 1][0] + tangent[0] * left, points[i - 1][1] + tangent[1] * left], tangent };
}

/** Length of one side of a seam [m]; `panels` is a map by id. */
export function lengthOfSide(panels, side) {
  const lengths = runsOf(side).map((run) => {
    const panel = panels.get(run.panel);
    const points = panel ? runPoints(panel, run) : [];
    return points.length < 2 ? 0 : lengthOf(points);
  });
  return lengths.reduce((sum, length) => sum + length, 0);
}

/** The run along one edge, picked clockwise or against it. */
export function runOfEdge(panel, edge, direction) {
  const { from, to } = edge;
  return direction === "cw"
    ? { panel: panel.id, from, to, direction }
    : { panel: panel.id, from: to, to: from, direction };
}

/** The same stretch the other way; a list of runs turns as a whole. */
export function reversedSide(side) {
  const turn = (run) => ({
    ...run, from: run.to, to: run.from,
    ...(run.direction && { direction: run.direction === "cw" ? "ccw" : "cw" }),
  });
  return Array.isArray(side) ? side.map(turn).reverse() : turn(side);
}
