/** What a result was sewn from, to tell when it is out of date. */

import { leftOut } from "./panels.js";
import { state } from "./state.js";

/** All that a result depends on, as text. */
export const asText = () => JSON.stringify([state.pattern?.id, state.garment, leftOut()]);

/** True if nothing changed since the shown fit was run. */
export const isUpToDate = () => state.ran === asText();
