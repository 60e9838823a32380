/**
 * The stage: brings result and body to the 3D view, which loads only when there is something to
 * show.
 */

import { call, postJson } from "../api.js";
import { byId } from "../dom.js";
import { lookOf } from "../fabric/looks.js";
import { fileStem, save } from "../files.js";
import { state, update, watch } from "../state.js";
import { captionLines, startCaption } from "./caption.js";
import { crossingPlaces } from "./crossings.js";
import { legendOnPicture, startFitViews } from "./fit_views.js";
import { startPlaceButtons } from "./place_button.js";
import { startProbe } from "./probe.js";

/** Size of the pictures in the gallery [px]. */
const THUMBNAIL = { width: 264, height: 330 };

let viewer = null;
let opening = null; // the promise of the viewer
let shownBody = "";
let shows = 0;

const note = (text) => {
  byId("stage-note").textContent = text;
  byId("stage-note").hidden = !text;
};

async function loadViewer() {
  try {
    const { Viewer } = await import("./viewer.js");
    viewer = new Viewer(byId("stage"));
    viewer.setBodyVisible(byId("show-body").checked);
    startProbe(viewer, viewer.canvas);
  } catch (error) {
    opening = null;
    note(`The garment cannot be shown here: ${error.message}. The downloads work all the same.`);
  }
  return viewer;
}

/** The one viewer, or null where there can be none. */
const openViewer = () => (opening ??= loadViewer());

/** The mesh of the body that a garment names: a dress form is made again from its measurements. */
async function bodyMesh(avatar, signal) {
  if (!avatar) return null;
  const id = typeof avatar === "string" ? avatar : avatar.form ? (await postJson("/v1/avatars", avatar, { signal })).id : null;
  if (!id) return null;
  return (await call(`/v1/avatars/${encodeURIComponent(id)}/mesh`, { signal, headers: { Accept: "model/gltf-binary" } })).arrayBuffer();
}

/** Marks what crosses, and what a person asks to see. */
function drawMarks() {
  const isShown = state.shape !== null && state.shape === state.fit?.id;
  viewer?.mark({ ...crossingPlaces(isShown ? state.report : null), lit: state.lit?.points ?? [] }, state.lit ?? {});
}

/** Shows the shape of a fit on its body. */
export async function showOutcome(fitId, avatar, signal) {
  const mine = ++shows;
  const key = JSON.stringify(avatar);
  const [view, garment, body] = await Promise.all([
    openViewer(),
    call(`/v1/fits/${encodeURIComponent(fitId)}/mesh.glb`, { signal }).then((response) => response.arrayBuffer()),
    key === shownBody ? undefined : bodyMesh(avatar, signal),
  ]);
  if (!view) return;
  const [shape, figure] = await Promise.all([view.read(garment), body ? view.read(body) : null]);
  if (mine !== shows || signal.aborted) return;
  if (body !== undefined) view.showBody(figure);
  view.showGarment(shape, lookOf);
  shownBody = key;
  update({ shape: fitId, lit: null });
  note("");
}

async function downloadPicture() {
  const { pictureOf } = await import("./picture.js");
  save(await pictureOf(viewer, byId("stage"), [state.pattern.name, ...captionLines()], legendOnPicture()), `${fileStem()}.png`);
}

/** A small picture of the whole on the stage; null where there is no viewer. */
export async function stagePicture() {
  if (!viewer) return null;
  const { thumbnailOf } = await import("./picture.js");
  return thumbnailOf(viewer, THUMBNAIL.width, THUMBNAIL.height);
}

function drawTools() {
  for (const button of document.querySelectorAll("[data-view], #picture")) button.disabled = state.shape === null;
}

export function startStage() {
  for (const button of document.querySelectorAll("[data-view]")) {
    button.addEventListener("click", () => viewer?.look(button.dataset.view));
  }
  byId("picture").addEventListener("click", downloadPicture);
  byId("show-body").addEventListener("change", (event) => viewer?.setBodyVisible(event.target.checked));
  watch(["pattern"], () => {
    if (state.fit) return;
    shows += 1;
    viewer?.clear();
    update({ shape: null });
    note("The garment appears here.");
  });
  watch(["shape"], drawTools);
  watch(["fabrics", "garment", "colors"], () => viewer?.restyle(lookOf));
  watch(["shape", "fit", "report", "lit"], drawMarks);
  startFitViews((map) => viewer?.showMap(map) ?? null);
  startPlaceButtons();
  startCaption();
}
