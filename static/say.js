/** The line over the panes: what was done, what is wrong. It is read out. */

import { byId } from "./dom.js";
import { makersText } from "./makers_words.js";

const NOTHING = { text: "", tone: false };

let said = NOTHING; // what was said last
let verdict = NOTHING; // the verdict on it

function show() {
  const status = byId("status");
  const shown = makersText([said.text, verdict.text].filter(Boolean).join(" "));
  const tone = verdict.tone || said.tone;
  status.firstElementChild.textContent = shown;
  status.title = shown;
  status.classList.toggle("bad", tone === true || tone === "bad");
  status.classList.toggle("warn", tone === "warn");
  status.classList.toggle("good", tone === "good");
}

/** Says something to everyone; `tone` is "good", "warn" for what is doubtful, "bad" or true. */
export function say(text, tone = false) {
  said = { text, tone };
  verdict = NOTHING;
  show();
}

/** Says what nobody asked for, before all that was said last. */
export function sayBefore(text) {
  said = { ...said, text: [text, said.text].filter(Boolean).join(" ") };
  show();
}

/** Says a verdict, which may come late: what was said last stays before it. */
export function sayVerdict(text, tone) {
  verdict = { text, tone };
  show();
}

/** Forgets what was said last, which the next verdict is not about. */
export function forgetSaid() {
  said = verdict = NOTHING;
}
