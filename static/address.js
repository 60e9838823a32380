/** The address of the page: `#pattern=…&fit=…`, which shows the same to the same owner. */

import { fitId, state, watch } from "./state.js";

export const fromAddress = () => Object.fromEntries(new URLSearchParams(location.hash.slice(1)));

function keep() {
  const parts = {};
  if (state.pattern?.stored) parts.pattern = state.pattern.id;
  const fit = fitId();
  if (fit) parts.fit = fit;
  const hash = new URLSearchParams(parts).toString();
  if (hash !== location.hash.slice(1)) history.replaceState(null, "", hash ? `#${hash}` : location.pathname);
}

/** The address of a fit, for whoever has the same access to the service. */
export const linkTo = (fit) => `${location.origin}${location.pathname}#${new URLSearchParams({ fit: fit.id })}`;

/** True if the address names what is shown. */
function isShown() {
  const { pattern, fit } = fromAddress();
  return fit ? fit === fitId() : !pattern || pattern === state.pattern?.id;
}

/** Keeps the address up to date; `onOther()` is called when a person enters another one. */
export function startAddress(onOther) {
  addEventListener("hashchange", () => { if (!isShown()) onOther(); });
  watch(["pattern", "fit", "pendingFitId"], () => state.pattern && keep());
}
