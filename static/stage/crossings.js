/** Places where cloth crosses cloth or the body, as a report has them. */

/** The mark of each kind: triangles without area are of cloth that crosses itself. */
const MARKS = { cloth: "cloth", degenerate: "cloth", body: "body", inside_body: "body" };

/** Crossings of a report by their mark: `{cloth: [[x, y, z]…], body: […]}`. */
export function crossingPlaces(report) {
  const places = { cloth: [], body: [] };
  for (const { kind, at } of report?.intersections ?? []) places[MARKS[kind] ?? "cloth"].push(at);
  return places;
}
