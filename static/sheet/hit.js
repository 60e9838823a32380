/** The edge that is pointed at: the nearest by distance, whatever lies on top. */

function nearestOnSegment([px, py], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const t = square === 0 ? 0 : Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / square));
  return { t, distance: Math.hypot(ax + dx * t - px, ay + dy * t - py) };
}

/** Distance to a polyline and the fraction of its length where it is nearest. */
function nearestOnLine(point, line) {
  let best = { distance: Infinity, at: 0 };
  let length = 0;
  for (let i = 1; i < line.length; i++) {
    const size = Math.hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
    const { t, distance } = nearestOnSegment(point, line[i - 1], line[i]);
    if (distance < best.distance) best = { distance, at: length + t * size };
    length += size;
  }
  return { distance: best.distance, fraction: length === 0 ? 0 : best.at / length };
}

/** True if no point of the panel's box is within `reach` of the point. */
const isFar = ([x, y], { left, right, top, bottom }, reach) =>
  x < left - reach || x > right + reach || y < bottom - reach || y > top + reach;

/**
 * The nearest edge within `reach` [m]: `{panel, edge, fraction, distance}`, or null.
 * `candidates` are `{panel, box, at}` with the point in the coordinates of each panel.
 */
export function nearestEdge(candidates, reach) {
  let best = null;
  for (const { panel, box, at } of candidates) {
    if (isFar(at, box, reach)) continue;
    for (const edge of panel.edges) {
      const found = nearestOnLine(at, edge.points);
      if (found.distance <= reach && found.distance < (best?.distance ?? Infinity)) best = { panel, edge, ...found };
    }
  }
  return best;
}

/** True if a point lies inside the outline of a panel, by the even-odd rule. */
export function isInside(panel, [x, y]) {
  let inside = false;
  for (const { points } of panel.edges) {
    for (let i = 1; i < points.length; i++) {
      const [[ax, ay], [bx, by]] = [points[i - 1], points[i]];
      if ((ay > y) !== (by > y) && x < ax + ((y - ay) * (bx - ax)) / (by - ay)) inside = !inside;
    }
  }
  return inside;
}
