/** The line over the panes: what was done, what is wrong. It is read out. */

import { byId } from "./dom.js";
import { makersText } from "./makers_words.js";

const NOTHING = { text: "", tone: false };
/** Tones by severity. */
const TONES = ["good", "warn", "bad"];

let notices = []; // texts that stand before what was said last
let said = NOTHING; // what was said last
let verdict = NOTHING; // the verdict on it

function show() {
  const status = byId("status");
  const shown = makersText([...notices, said.text, verdict.text].filter(Boolean).join(" "));
  const tones = [notices.length > 0 && "warn", said.tone, verdict.tone].map((tone) => (tone === true ? "bad" : tone));
  const severest = TONES.findLast((tone) => tones.includes(tone));
  status.firstElementChild.textContent = shown;
  status.title = shown;
  for (const tone of TONES) status.classList.toggle(tone, tone === severest);
}

/** Says something to everyone; `tone` is "good", "warn" for what is doubtful, "bad" or true. */
export function say(text, tone = false) {
  notices = [];
  said = { text, tone };
  verdict = NOTHING;
  show();
}

/** Shows a notice before the last message, once, until the next message. */
export function sayBefore(text) {
  if (notices.includes(text)) return;
  notices.push(text);
  show();
}

/** Says a verdict, which may come late: what was said last stays before it. */
export function sayVerdict(text, tone = false) {
  verdict = { text, tone };
  show();
}

/** Removes the last message, because the next verdict is not about it; notices and verdict stay. */
export function forgetSaid() {
  said = NOTHING;
  show();
}
