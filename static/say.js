/** The line over the panes: what was done, what is wrong. It is read out. */

import { byId } from "./dom.js";
import { makersText } from "./makers_words.js";

let said = { text: "", tone: false }; // what was said last, without the verdict on it

function show(text, tone) {
  const status = byId("status");
  const shown = makersText(text);
  status.firstElementChild.textContent = shown;
  status.title = shown;
  status.classList.toggle("bad", tone === true || tone === "bad");
  status.classList.toggle("warn", tone === "warn");
  status.classList.toggle("good", tone === "good");
}

/** Says something to everyone; `tone` is "good", "warn" for what is doubtful, "bad" or true. */
export function say(text, tone = false) {
  said = { text, tone };
  show(text, tone);
}

/** Says a verdict, which may come late: what was said last stays before it. */
export function sayVerdict(text, tone) {
  show([said.text, text].filter(Boolean).join(" "), tone || said.tone);
}

/** Forgets what was said last, which the next verdict is not about. */
export function forgetSaid() {
  said = { text: "", tone: false };
}
