/** Puts the parts of the page together. Read on: state.js, files.js, panels.js, sheet/sheet.js, picking.js, suggest.js, fit.js, viewer.js. */

import { openFromHash, startFiles } from "./files.js";
import { showFit, startFit } from "./fit.js";
import { startLayout } from "./layout.js";
import { letGo, say, select, startPicking } from "./picking.js";
import { startSeamList } from "./seam_list.js";
import { loadFabrics, startSettings } from "./settings.js";
import { startSheet } from "./sheet/sheet.js";
import { startStage } from "./stage.js";
import { startSuggest } from "./suggest.js";
import { startToken } from "./token.js";

startToken();
startLayout();
startFiles();
startSettings();
startSheet(select, letGo);
startPicking();
startSeamList();
startSuggest();
startStage();
startFit();

try {
  await loadFabrics();
  await openFromHash(showFit);
} catch (problem) {
  say(problem.message, true);
}
