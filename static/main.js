/**
 * Puts the parts of the page together. Read on: state.js, history.js, files.js, panels.js,
 * sheet/sheet.js, picking.js, suggest.js, fit.js, stage/stage.js.
 */

import { startAddress } from "./address.js";
import { startCheck } from "./check.js";
import { startSwatches } from "./fabric/swatches.js";
import { openFromAddress } from "./files.js";
import { showFit, startFit } from "./fit.js";
import { startGallery } from "./gallery/gallery.js";
import { startHistory } from "./history.js";
import { startKeeping } from "./keeping.js";
import { startLayout } from "./layout.js";
import { startPanelList } from "./panel_list.js";
import { select, selectSeam, startPicking } from "./picking.js";
import { say, sayBefore } from "./say.js";
import { startReading } from "./reading.js";
import { startRecent } from "./recent.js";
import { startSeamList } from "./seam_list.js";
import { loadFabrics, startSettings } from "./settings.js";
import { fitPanelById } from "./sheet/moving.js";
import { startSheet } from "./sheet/sheet.js";
import { stagePicture, startStage } from "./stage/stage.js";
import { startSuggest } from "./suggest.js";
import { startToken } from "./token.js";

startToken();
startLayout();
startHistory(showFit);
startReading();
startRecent(showFit);
startSettings();
startSwatches();
startPanelList(fitPanelById);
startSheet({ select, selectSeam });
startPicking();
startCheck();
startSeamList();
startSuggest();
startStage();
startFit();
startGallery(showFit, stagePicture);
startAddress(() => openFromAddress(null, showFit));

try {
  const { draft, notice } = await startKeeping();
  await Promise.all([loadFabrics(), openFromAddress(draft, showFit)]);
  if (notice() !== null) sayBefore(notice());
} catch (problem) {
  say(problem.message, true);
}
