/** Asks once for the access token when the service wants one. */

import { setTokenPrompt } from "./api.js";
import { byId } from "./dom.js";

function ask(refused) {
  const dialog = byId("token-dialog");
  byId("token-why").textContent = refused
    ? "The service refused this token. Enter another one."
    : "This service asks for a token. It is kept until you close the tab.";
  byId("token").value = "";
  return new Promise((answer) => {
    const done = () => {
      dialog.removeEventListener("close", done);
      answer(dialog.returnValue === "ok" ? byId("token").value.trim() || null : null);
      byId("token").value = "";
    };
    dialog.returnValue = "";
    dialog.addEventListener("close", done);
    dialog.showModal();
  });
}

export function startToken() {
  byId("token-cancel").addEventListener("click", () => byId("token-dialog").close(""));
  setTokenPrompt(ask);
}
