/** The line over the panes: what was done, what is wrong. It is read out. */

import { byId } from "./dom.js";
import { makersText } from "./makers_words.js";

let done = ""; // the last change in words, until its check answers

/** Says something to everyone; `tone` is "good", "warn" for what is doubtful, "bad" or true. */
export function say(text, tone = false) {
  const status = byId("status");
  const said = makersText(text);
  status.firstElementChild.textContent = said;
  status.title = said;
  status.classList.toggle("bad", tone === true || tone === "bad");
  status.classList.toggle("warn", tone === "warn");
  status.classList.toggle("good", tone === "good");
}

/** Says what was changed; the verdict of the check is added to it. */
export function act(text) {
  done = text;
  say(text);
}

/** The last change in words, once. */
export function takeDone() {
  const text = done;
  done = "";
  return text;
}
