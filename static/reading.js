/** Facts of the pattern and of the reading of its file, with fields to read it in another way. */

import { byId, el, replaceChildren, setOptions } from "./dom.js";
import { openFile, openSample, readAgain, saveGarment } from "./files.js";
import { state, watch } from "./state.js";
import { faultItem } from "./words.js";

/** The parameters of the import, each with a field of its own. */
const FIELDS = ["units", "size", "outlines", "notches", "darts", "unfold", "encoding"];
const ALLOWANCE = { none: "none", unknown: "not stated", sew_line: "sew line used" };

const chosen = () => Object.fromEntries(FIELDS.map((name) => [name, byId(`import-${name}`).value]));

function drawFacts() {
  const { pattern, reading } = state;
  byId("save-garment").disabled = !pattern;
  for (const name of FIELDS) byId(`import-${name}`).disabled = pattern !== null && !reading.file;
  if (!pattern) {
    byId("pattern-facts").replaceChildren();
    return;
  }
  const { source } = pattern;
  const rows = [["Name", pattern.name], ["Panels", String(pattern.panels.length)], ["Units", source.units],
    source.sample_size && ["Size", source.sample_size], ALLOWANCE[source.allowance] && ["Seam allowance", ALLOWANCE[source.allowance]]].filter(Boolean);
  replaceChildren(byId("pattern-facts"),
    el("dl", { class: "facts" }, rows.flatMap(([term, value]) => [el("dt", {}, term), el("dd", {}, value)])),
    pattern.warnings?.length > 0 && el("div", { class: "warnings" }, pattern.warnings.map((one) => faultItem(one, "warning"))));
  setOptions(byId("import-size"), [["", "Sample"], ...(source.sizes ?? []).map((size) => [size, size])], reading.options.size ?? "");
  for (const name of FIELDS) byId(`import-${name}`).value = reading.options[name] ?? "";
}

/** A file can be dropped anywhere on the page. */
function startDrop() {
  const hint = el("p", { class: "dropping", hidden: true }, "Drop the file to open it");
  document.body.append(hint);
  let depth = 0;
  const hasFile = (event) => event.dataTransfer?.types.includes("Files");
  document.addEventListener("dragenter", (event) => {
    if (!hasFile(event)) return;
    depth += 1;
    hint.hidden = false;
  });
  document.addEventListener("dragover", (event) => hasFile(event) && event.preventDefault());
  document.addEventListener("dragleave", () => {
    depth = Math.max(0, depth - 1);
    hint.hidden = depth === 0;
  });
  document.addEventListener("drop", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    depth = 0;
    hint.hidden = true;
    const [file] = event.dataTransfer.files;
    if (file) openFile(file);
  });
}

export function startReading() {
  for (const button of document.querySelectorAll("[data-sample]")) {
    button.addEventListener("click", () => openSample(button.dataset.sample));
  }
  byId("save-garment").addEventListener("click", saveGarment);
  byId("open-file").addEventListener("change", (event) => {
    const [file] = event.target.files;
    event.target.value = "";
    if (file) openFile(file);
  });
  for (const name of FIELDS) byId(`import-${name}`).addEventListener("change", async () => {
      await readAgain(chosen());
      drawFacts();
    });
  startDrop();
  watch(["pattern", "reading"], drawFacts);
}
