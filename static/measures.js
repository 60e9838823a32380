/** Girths of the cloth and the body, and the room between them. */

import { el } from "./dom.js";
import { placeButton } from "./stage/place_button.js";
import { centimeters, sentence } from "./words.js";

const signed = (meters) => (meters > 0 ? "+" : "") + centimeters(meters);

/** The room at a place in a word. */
const roomWord = (ease) => (ease < -0.005 ? "stretched" : ease < 0.01 ? "close" : "");

const title = (at) => sentence(at).slice(0, -1);

const row = (girth) => el("tr", {},
  el("th", { scope: "row" }, placeButton(`girth ${girth.at}`, title(girth.at), { girth })),
  el("td", {}, centimeters(girth.cloth_m)), el("td", {}, centimeters(girth.body_m)),
  el("td", {}, signed(girth.ease_m), " ", el("small", {}, roomWord(girth.ease_m))));

/** The table of girths; words where there are none. */
export function girthTable({ girths }) {
  if (girths.length === 0) return el("p", { class: "note" }, "No girths: the cloth is closed round the body nowhere.");
  const heads = ["Girth", "Garment", "Body", "Ease"].map((text) => el("th", { scope: "col" }, text));
  return el("table", { class: "figures" }, el("thead", {}, el("tr", {}, heads)), el("tbody", {}, girths.map(row)));
}
