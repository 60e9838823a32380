/** Fabric of all panels, measurements of the dress form, fineness of the mesh. */

import { call, getJson } from "./api.js";
import { byId, commitEdit, el, paintWhenFree, replaceChildren, setOptions } from "./dom.js";
import { changeGarment } from "./history.js";
import { say } from "./say.js";
import { DEFAULT_FORM, state, update, watch } from "./state.js";
import { plural, problemItems } from "./words.js";

/** Measurements in the order in which they are asked, with what a person may have [cm]. */
const MEASURES = [
  ["height_m", "Height", 140, 210],
  ["bust_m", "Bust", 70, 150],
  ["waist_m", "Waist", 50, 150],
  ["hip_m", "Hip", 70, 160],
];

/** The libraries come as a map by id or as a list with ids. */
function asMap(fabrics) {
  const list = fabrics.fabrics ?? fabrics.items ?? fabrics;
  return Array.isArray(list) ? Object.fromEntries(list.map(({ id, ...fabric }) => [id, fabric])) : list;
}

export async function loadFabrics() {
  update({ fabrics: asMap(await getJson("/v1/fabrics")) });
}

/** Fetches the fabrics where they could not be had before, as before a token was given. */
function loadFabricsLate() {
  if (state.pattern && Object.keys(state.fabrics).length === 0) loadFabrics().catch(() => {});
}

/** Fabrics of the service and of the garment by id. */
export const allFabrics = () => ({ ...state.fabrics, ...state.garment.fabrics });

/** Fabrics by id with their names, for a select. */
export const fabricOptions = () => Object.entries(allFabrics()).map(([id, fabric]) => [id, fabric.name ?? id]);

function drawFabric() {
  const id = state.garment.default_fabric;
  const options = fabricOptions();
  if (!options.some(([known]) => known === id)) options.unshift([id, id]);
  setOptions(byId("default-fabric"), options, id);
  const fabric = allFabrics()[id];
  byId("fabric-note").textContent = fabric?.density_kg_m2 ? `${(fabric.density_kg_m2 * 1000).toFixed(0)} g/m²` : "";
}

const formNow = () => ({ ...DEFAULT_FORM, ...state.garment.avatar?.form });

const inCentimeters = (meters) => Number((meters * 100).toFixed(2));

function measure([field, text, least, most]) {
  const change = ({ target }) => {
    if (!target.checkValidity() || target.value === "") {
      const value = inCentimeters(formNow()[field]);
      target.value = value;
      say(`${text} is between ${least} and ${most} cm; it stays at ${value} cm.`, true);
      return;
    }
    changeGarment({ avatar: { form: { ...formNow(), [field]: Number((target.valueAsNumber / 100).toFixed(4)) } } }, `the ${text.toLowerCase()}`);
  };
  return el("label", {}, `${text}, cm`,
    el("input", { type: "number", min: least, max: most, step: 0.5, value: inCentimeters(formNow()[field]), "data-key": field, onchange: change }));
}

function drawBody() {
  const form = Boolean(state.garment.avatar?.form);
  byId("measures").hidden = !form;
  byId("other-body").hidden = form;
  if (form) paintWhenFree(byId("measures"), () => replaceChildren(byId("measures"), MEASURES.map(measure)));
}

let uploads = 0;

/**
 * Sends the file of a body, which then is the garment's; its faults and remarks are shown beside
 * it.
 */
export async function uploadBody(file) {
  const note = byId("body-note");
  const mine = ++uploads;
  const { pattern } = state;
  note.textContent = "Reading the body…";
  try {
    const body = new FormData();
    body.append("file", file, file.name);
    const avatar = await (await call("/v1/avatars", { method: "POST", body })).json();
    if (mine !== uploads) return;
    if (state.pattern !== pattern) {
      note.textContent = `${file.name} was read, but another pattern was opened meanwhile. Choose the file again for this one.`;
      return;
    }
    commitEdit();
    changeGarment({ avatar: avatar.id }, `the body ${file.name}`);
    const { bust_m: bust, waist_m: waist, hip_m: hip } = avatar.girths;
    const girths = [["bust", bust], ["waist", waist], ["hip", hip]].map(([name, girth]) => `${name} ${(girth * 100).toFixed(1)} cm`);
    const remarks = avatar.file.warnings.map((warning) => el("li", {}, warning.detail));
    replaceChildren(note, [`${file.name}: ${plural(avatar.file.triangle_count, "triangle")}, ${girths.join(", ")}.`, el("ul", {}, ...remarks)]);
  } catch (problem) {
    if (mine === uploads) replaceChildren(note, [el("ul", {}, ...problemItems(problem))]);
  }
}

function drawMesh() {
  const value = String(state.garment.simulate?.edge_length_m ?? 0.012);
  const select = byId("edge-length");
  if (![...select.options].some((option) => option.value === value)) {
    select.append(el("option", { value }, `${Number(value) * 1000} mm`));
  }
  select.value = value;
}

export function startSettings() {
  byId("default-fabric").addEventListener("change", (event) => changeGarment({ default_fabric: event.target.value }, "the fabric"));
  byId("use-form").addEventListener("click", () => changeGarment({ avatar: { form: { ...DEFAULT_FORM } } }, "the dress form"));
  byId("body-file").addEventListener("change", async (event) => {
    const [file] = event.target.files;
    if (file) await uploadBody(file);
    event.target.value = "";
  });
  byId("edge-length").addEventListener("change", (event) =>
    changeGarment({ simulate: { ...state.garment.simulate, edge_length_m: Number(event.target.value) } }, "the mesh"));
  watch(["fabrics", "garment"], drawFabric);
  watch(["pattern"], loadFabricsLate);
  watch(["garment"], drawBody);
  watch(["garment"], drawMesh);
}
