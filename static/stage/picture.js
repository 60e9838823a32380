/** Pictures of the stage: what is seen, with the name of the garment and the verdict on it. */

import { stopsOf } from "./palette.js";

const MARGIN = 12;
const LINE = 20;
/** The bar of colors of a legend [px]. */
const BAR = { width: 200, height: 10 };

function paper(width, height) {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [Math.round(width), Math.round(height)];
  const pen = canvas.getContext("2d");
  const style = getComputedStyle(document.documentElement);
  const ground = pen.createLinearGradient(0, 0, 0, canvas.height);
  for (const [i, name] of ["--stage-top", "--stage-bottom"].entries()) ground.addColorStop(i, style.getPropertyValue(name).trim());
  pen.fillStyle = ground;
  pen.fillRect(0, 0, canvas.width, canvas.height);
  return { canvas, pen, ink: style.getPropertyValue("--ink").trim() };
}

const asBlob = (canvas, type) => new Promise((done) => { canvas.toBlob(done, type, 0.85); });

/** Draws the colors of a legend and their ends at a height. */
function drawBar(pen, { scale, ticks: [least, most] }, y) {
  const colors = pen.createLinearGradient(MARGIN, 0, MARGIN + BAR.width, 0);
  const stops = stopsOf(scale);
  for (const [i, color] of stops.entries()) colors.addColorStop(i / (stops.length - 1), color);
  const ink = pen.fillStyle;
  pen.fillStyle = colors;
  pen.fillRect(MARGIN, y - BAR.height, BAR.width, BAR.height);
  pen.fillStyle = ink;
  pen.fillText(`${least} to ${most}`, MARGIN + BAR.width + 8, y);
}

/** What the stage shows, as PNG, with lines of text and the legend of a map below left. */
export async function pictureOf(viewer, { clientWidth, clientHeight }, lines, legend) {
  const scale = Math.min(2, devicePixelRatio);
  const { canvas, pen, ink } = paper(clientWidth * scale, clientHeight * scale);
  viewer.drawOnto(pen);
  pen.scale(scale, scale);
  pen.fillStyle = ink;
  pen.font = "13px system-ui, sans-serif";
  const all = [...lines, ...legend?.lines ?? []];
  for (const [i, line] of [...all].reverse().entries()) pen.fillText(line, MARGIN, clientHeight - MARGIN - i * LINE);
  if (legend) drawBar(pen, legend, clientHeight - MARGIN - all.length * LINE);
  return asBlob(canvas, "image/png");
}

/** The whole, small, whatever is seen. */
export function thumbnailOf(viewer, width, height) {
  const { canvas, pen } = paper(width, height);
  viewer.drawWholeOnto(pen);
  return asBlob(canvas, "image/webp");
}
