/** Rail, splitter, drawer and full screen: what is shown, kept for the next visit. */

import { byId, isDialogOpen, isTyping } from "./dom.js";
import { state, update, watch } from "./state.js";

const STORE = "seamster.layout";
/** Below this width [px] the rail lies over the work, and the garment stands above the pattern. */
const NARROW_PX = 1000;
/** Share of the work that the pattern takes [%]. */
const SPLIT = { usual: 48, least: 20, most: 80, step: 2 };

const isNarrow = () => innerWidth < NARROW_PX;

function kept() {
  try {
    return JSON.parse(localStorage.getItem(STORE)) ?? {};
  } catch {
    return {};
  }
}

/** Keeps the layout; the rail as it is in a wide window, since a narrow one folds it anyway. */
function keep({ split, rail }) {
  try {
    localStorage.setItem(STORE, JSON.stringify({ split, rail: isNarrow() ? kept().rail : rail }));
  } catch {
    // Without a store the layout is the usual one next time.
  }
}

const change = (patch) => update({ layout: { ...state.layout, ...patch } });

/** Opens one of the drawer's pages, `seams`, `report` or `fits`. */
const openDrawer = (page) => change({ drawer: page });

/** Opens the rail. */
export const openRail = () => change({ rail: true });

const toggleFull = (pane) => change({ full: state.layout.full === pane ? null : pane });

const toggleRail = () => change({ rail: !state.layout.rail });

const setSplit = (split) => change({ split: Math.min(SPLIT.most, Math.max(SPLIT.least, split)) });

function apply() {
  const { rail, split, drawer, full } = state.layout;
  byId("main").dataset.rail = rail ? "open" : "folded";
  byId("rail-toggle").setAttribute("aria-expanded", String(rail));
  byId("panes").dataset.full = full ?? "none";
  for (const button of document.querySelectorAll("button[data-full]")) {
    button.setAttribute("aria-pressed", String(button.dataset.full === full));
  }
  byId("work").style.setProperty("--split", `${split}%`);
  byId("splitter").setAttribute("aria-valuenow", String(Math.round(split)));
  byId("splitter").setAttribute("aria-orientation", isNarrow() ? "horizontal" : "vertical");
  byId("drawer").dataset.open = drawer ?? "none";
  byId("seam-list").hidden = drawer !== "seams";
  byId("report-panel").hidden = drawer !== "report";
  byId("fits-panel").hidden = drawer !== "fits";
  for (const button of document.querySelectorAll("[data-drawer]")) {
    button.setAttribute("aria-expanded", String(button.dataset.drawer === drawer));
  }
  keep(state.layout);
}

/** The share at a pointer: the pattern is on the left, on narrow windows below. */
function splitAt(event) {
  const box = byId("panes").getBoundingClientRect();
  return isNarrow()
    ? (100 * (box.bottom - event.clientY)) / box.height
    : (100 * (event.clientX - box.left)) / box.width;
}

function startSplitter() {
  const splitter = byId("splitter");
  splitter.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    splitter.setPointerCapture(event.pointerId);
  });
  splitter.addEventListener("pointermove", (event) => {
    if (splitter.hasPointerCapture(event.pointerId)) setSplit(splitAt(event));
  });
  splitter.addEventListener("dblclick", () => setSplit(SPLIT.usual));
  const steps = { ArrowLeft: -SPLIT.step, ArrowRight: SPLIT.step, ArrowUp: SPLIT.step, ArrowDown: -SPLIT.step };
  splitter.addEventListener("keydown", (event) => {
    if (!(event.key in steps)) return;
    event.preventDefault();
    setSplit(state.layout.split + steps[event.key]);
  });
}

const KEYS = { 2: () => toggleFull("pattern"), 3: () => toggleFull("garment"), b: toggleRail };

function startKeys() {
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || isTyping(event.target) || isDialogOpen()) return;
    if (isNarrow() && state.layout.rail) toggleRail();
  });
  // Letters are keys in the work alone: those who speak to the page may say any anywhere else.
  byId("work").addEventListener("keydown", (event) => {
    if (isTyping(event.target) || event.ctrlKey || event.metaKey || event.altKey || isDialogOpen()) return;
    KEYS[event.key.toLowerCase()]?.();
  });
}

export function startLayout() {
  const { split = SPLIT.usual, rail = true } = kept();
  update({ layout: { split, rail: rail && !isNarrow(), drawer: null, full: null } });
  byId("rail-toggle").addEventListener("click", toggleRail);
  for (const button of document.querySelectorAll("button[data-full]")) {
    button.addEventListener("click", () => toggleFull(button.dataset.full));
  }
  for (const button of document.querySelectorAll("[data-drawer]")) {
    const page = button.dataset.drawer;
    button.addEventListener("click", () => openDrawer(state.layout.drawer === page ? null : page));
  }
  startSplitter();
  startKeys();
  let narrow = isNarrow();
  addEventListener("resize", () => {
    if (isNarrow() !== narrow) change({ rail: !isNarrow() && (kept().rail ?? true) });
    narrow = isNarrow();
  });
  watch(["layout"], apply);
}
