/** Pictures of the stage: what is seen, with the name of the garment and the verdict on it. */

const MARGIN = 12;
const LINE = 20;

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

/** What the stage shows, as PNG, with lines of text below left. */
export async function pictureOf(viewer, { clientWidth, clientHeight }, lines) {
  const scale = Math.min(2, devicePixelRatio);
  const { canvas, pen, ink } = paper(clientWidth * scale, clientHeight * scale);
  viewer.drawOnto(pen);
  pen.scale(scale, scale);
  pen.fillStyle = ink;
  pen.font = "13px system-ui, sans-serif";
  for (const [i, line] of [...lines].reverse().entries()) pen.fillText(line, MARGIN, clientHeight - MARGIN - i * LINE);
  return asBlob(canvas, "image/png");
}

/** The whole, small, whatever is seen. */
export function thumbnailOf(viewer, width, height) {
  const { canvas, pen } = paper(width, height);
  viewer.drawWholeOnto(pen);
  return asBlob(canvas, "image/webp");
}
