/** Names and states of the edges on the sheet: sewn, picked, likely partners of the first side. */

import { edgesOf, runsOf } from "../outline.js";
import { leftOut, titleOf } from "../panels.js";
import { state } from "../state.js";
import { differenceText, gradeText, likeness } from "./compare.js";
import { edgeLabel } from "./drawing.js";
import { firstLengths } from "./tag.js";

/** Most edges that are shown as likely partners. */
const PARTNERS = 5;

/** The name of an edge on the page. */
export const keyOf = (panel, edge) => `edge ${panel.id} ${edge.index}`;

/** Names of the seams that each edge is in, by key. */
function seamsByEdge(sheet) {
  const found = new Map();
  for (const seam of state.garment.seams) {
    for (const run of [...runsOf(seam.a), ...runsOf(seam.b)]) {
      const panel = sheet.panels.get(run.panel);
      if (!panel) continue;
      for (const { edge } of edgesOf(panel, run)) {
        const key = keyOf(panel, { index: edge });
        found.set(key, [...new Set([...(found.get(key) ?? []), seam.id])]);
      }
    }
  }
  return found;
}

/** Edges that are not sewn and about as long as the first side, the likeliest first. */
function partners(sheet, seams, firstLength) {
  if (!state.picked) return new Set();
  const rated = sheet.all.flatMap((panel) => panel.edges.map((edge) => {
    const length = firstLength(panel, edge);
    const key = keyOf(panel, edge);
    return { key, rate: length === null || seams.has(key) ? 0 : likeness(length, edge.length_m) };
  }));
  const likely = rated.filter(({ rate }) => rate > 0).sort((a, b) => b.rate - a.rate);
  return new Set(likely.slice(0, PARTNERS).map(({ key }) => key));
}

/** Words for an edge beside the first side. */
function comparison(length, edge) {
  return length === null ? "" : `; ${differenceText(length, edge.length_m)}: ${gradeText(length, edge.length_m)}`;
}

/** Brings names and states of the edges up to date, in place. */
export function refreshEdges(cloth, sheet) {
  const seams = seamsByEdge(sheet);
  const firstLength = firstLengths(state.picked, sheet.panels);
  const likely = partners(sheet, seams, firstLength);
  const spare = new Set(leftOut());
  const pickedEdges = new Set((state.picked ? runsOf(state.picked) : []).flatMap((run) => {
    const panel = sheet.panels.get(run.panel);
    return panel ? edgesOf(panel, run).map(({ edge }) => keyOf(panel, { index: edge })) : [];
  }));
  for (const group of cloth.children) {
    const panel = sheet.panels.get(group.dataset.of);
    group.classList.toggle("spare", spare.has(panel.id));
    group.setAttribute("aria-label", `Panel ${titleOf(panel)}${spare.has(panel.id) ? ", left out" : ""}`);
    for (const path of group.querySelectorAll(".edge")) {
      const edge = panel.edges[path.dataset.edge];
      const { key } = path.dataset;
      path.setAttribute("aria-label", edgeLabel(panel, edge, seams.get(key) ?? []) + comparison(firstLength(panel, edge), edge));
      path.setAttribute("aria-pressed", String(pickedEdges.has(key)));
      path.classList.toggle("likely", likely.has(key));
    }
  }
}
