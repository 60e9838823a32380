/** The sheet: panels as SVG, one focusable path per edge. Pointer and keyboard end in the same `select`. */

import { byId, el, replaceChildren, svg } from "./dom.js";
import { edgesOf, nearestFraction, runOfEdge, runsOf } from "./outline.js";
import { drawCorners, drawPanel, edgeLabel } from "./drawing.js";
import { leftOut, panelsShown } from "./panels.js";
import { drawRun, drawSeam } from "./seam_marks.js";
import { layOut } from "./sheet_layout.js";
import { state, update, watch } from "./state.js";

let sheet = null; // { panels, maps, scale, preview }
let select = () => {};
let letGo = () => {};
const current = new Map(); // panel id -> the edge that Tab stops at

const keyOf = (panel, edge) => `edge ${panel.id} ${edge.index}`;

/** Names of the seams that each edge is in, by key. */
function seamsByEdge(panels) {
  const found = new Map();
  for (const seam of state.garment.seams) {
    for (const run of [...runsOf(seam.a), ...runsOf(seam.b)]) {
      const panel = panels.get(run.panel);
      if (!panel) continue;
      for (const { edge } of edgesOf(panel, run)) {
        const key = keyOf(panel, { index: edge });
        found.set(key, [...new Set([...(found.get(key) ?? []), seam.id])]);
      }
    }
  }
  return found;
}

/** The end of the edge that is nearer to the pointer is where sewing begins. */
function directionAt(panel, edge, event) {
  const box = byId("sheet").querySelector("svg").getBoundingClientRect();
  const at = sheet.maps.get(panel.id).back([event.clientX - box.left, event.clientY - box.top]);
  return nearestFraction(edge.points, at) <= 0.5 ? "cw" : "ccw";
}

function preview(run) {
  sheet.preview.replaceChildren(...(run ? [drawRun(sheet, run, "preview")] : []));
}

function moveTo(panel, edge) {
  const paths = byId("sheet").querySelectorAll(`[data-panel="${CSS.escape(panel.id)}"]`);
  for (const path of paths) path.tabIndex = Number(path.dataset.edge) === edge.index ? 0 : -1;
  current.set(panel.id, edge.index);
  paths[edge.index]?.focus();
}

function onKey(panel, edge, event) {
  const count = panel.edges.length;
  const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
  if (event.key in steps) moveTo(panel, panel.edges[(edge.index + steps[event.key] + count) % count]);
  else if (event.key === "Home") moveTo(panel, panel.edges[0]);
  else if (event.key === "End") moveTo(panel, panel.edges[count - 1]);
  else if (event.key === "Enter" || event.key === " ") select(runOfEdge(panel, edge, event.shiftKey ? "ccw" : "cw"));
  else if (event.key === "Escape") letGo();
  else return;
  event.preventDefault();
}

function bindEdge(panel, edge, path, seams) {
  const key = keyOf(panel, edge);
  const picked = state.picked?.panel === panel.id && edgesOf(panel, state.picked).some((part) => part.edge === edge.index);
  Object.assign(path.dataset, { key, panel: panel.id, edge: edge.index });
  path.setAttribute("tabindex", (current.get(panel.id) ?? 0) === edge.index ? 0 : -1);
  path.setAttribute("aria-label", edgeLabel(panel, edge, seams.get(key) ?? []));
  path.setAttribute("aria-pressed", String(picked));
  path.addEventListener("click", (event) => {
    current.set(panel.id, edge.index);
    // Assistive technology clicks without a place: detail is 0.
    select(runOfEdge(panel, edge, event.detail === 0 ? "cw" : directionAt(panel, edge, event)));
  });
  path.addEventListener("pointermove", (event) => preview(runOfEdge(panel, edge, directionAt(panel, edge, event))));
  path.addEventListener("pointerleave", () => preview(null));
  path.addEventListener("keydown", (event) => onKey(panel, edge, event));
}

function overlay() {
  const { seams } = state.garment;
  const findings = state.check?.seams ?? [];
  const marks = seams.map((seam, index) => {
    const finding = findings[index]?.id === seam.id ? findings[index] : null;
    const selected = seam.id === state.selected;
    return drawSeam(sheet, seam, {
      index, selected, dim: Boolean(state.picked) || (state.selected !== null && !selected),
      bad: finding?.ok === false, reversed: finding?.reversed,
    });
  });
  marks.sort((a, b) => a.classList.contains("selected") - b.classList.contains("selected"));
  if (state.picked) marks.push(drawRun(sheet, state.picked, "pending"));
  return svg("g", { class: "overlay", "aria-hidden": "true" }, marks);
}

function draw() {
  const host = byId("sheet");
  const { pattern } = state;
  if (!pattern) {
    host.replaceChildren(el("p", { class: "empty" }, "The panels of the pattern appear here."));
    return;
  }
  const all = panelsShown();
  const spare = new Set(leftOut());
  const plan = layOut(all, host.clientWidth - 2, host.clientHeight - 2, state.zoom);
  const panels = new Map(all.map((panel) => [panel.id, panel]));
  sheet = { ...plan, panels, preview: svg("g", { class: "overlay", "aria-hidden": "true" }) };
  const seams = seamsByEdge(panels);
  const drawn = all.map((panel) => drawPanel(panel, plan.maps.get(panel.id), plan.scale, {
    bind: (path, edge) => bindEdge(panel, edge, path, seams), spare: spare.has(panel.id),
  }));
  const corners = svg("g", { "aria-hidden": "true" }, all.map((panel) => drawCorners(panel, plan.maps.get(panel.id), plan.scale)));
  // Floored: a fraction of a pixel would bring a scroll bar, which changes the size again.
  const size = { width: Math.floor(plan.width), height: Math.floor(plan.height) };
  replaceChildren(host, svg("svg", { ...size, role: "group", "aria-label": "Panels of the pattern", "aria-describedby": "keys" },
    drawn, overlay(), corners, sheet.preview));
}

/** Puts the sheet to work: `onSelect(run)` for a picked edge, `onLetGo()` for Escape. */
export function startSheet(onSelect, onLetGo) {
  select = onSelect;
  letGo = onLetGo;
  const zoomTo = (zoom) => update({ zoom: Math.min(8, Math.max(1, zoom)) });
  byId("zoom-in").addEventListener("click", () => zoomTo(state.zoom * 1.4));
  byId("zoom-out").addEventListener("click", () => zoomTo(state.zoom / 1.4));
  byId("zoom-fit").addEventListener("click", () => zoomTo(1));
  watch(["pattern", "garment", "leftOut", "check", "picked", "selected", "zoom"], draw);
  let size = "";
  new ResizeObserver(() => {
    const now = `${byId("sheet").offsetWidth} ${byId("sheet").offsetHeight}`;
    if (now !== size) draw();
    size = now;
  }).observe(byId("sheet"));
}
