/** Puts panels side by side on the sheet, as large as they fit. */

/** Space around panels [px]: room for badges and corner numbers, below also for names. */
const SPACE = { side: 42, across: 60, top: 36, below: 52 };

export function boxOf(panel) {
  const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (const edge of panel.edges) {
    for (const [x, y] of edge.points) {
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x);
      box.bottom = Math.min(box.bottom, y);
      box.top = Math.max(box.top, y);
    }
  }
  return box;
}

/** Rows of boxes in their order at `scale` px/m, no wider than `width`. */
function shelves(boxes, scale, width) {
  const places = [];
  let [x, y, row, widest] = [SPACE.side, SPACE.top, 0, 0];
  for (const box of boxes) {
    const w = (box.right - box.left) * scale;
    const h = (box.top - box.bottom) * scale;
    if (x > SPACE.side && x + w + SPACE.side > width) {
      x = SPACE.side;
      y += row + SPACE.below;
      row = 0;
    }
    places.push({ x, y });
    widest = Math.max(widest, x + w + SPACE.side);
    x += w + SPACE.across;
    row = Math.max(row, h);
  }
  return { places, width: widest, height: y + row + SPACE.below };
}

/** The largest scale [px/m] at which all panels fit, times `zoom`, and a map from pattern to sheet for each panel. */
export function layOut(panels, width, height, zoom) {
  const boxes = panels.map(boxOf);
  let [low, high] = [1, 8000];
  for (let i = 0; i < 40; i++) {
    const middle = Math.sqrt(low * high);
    const size = shelves(boxes, middle, width);
    if (size.width <= width && size.height <= height) low = middle;
    else high = middle;
  }
  const scale = low * zoom;
  const found = shelves(boxes, scale, width * zoom);
  const shift = [Math.max(0, (width - found.width) / 2), Math.max(0, (height - found.height) / 2)];
  const maps = new Map(panels.map((panel, i) => {
    const { x, y } = found.places[i];
    const box = boxes[i];
    return [panel.id, {
      point: ([px, py]) => [shift[0] + x + (px - box.left) * scale, shift[1] + y + (box.top - py) * scale],
      back: ([sx, sy]) => [(sx - shift[0] - x) / scale + box.left, box.top - (sy - shift[1] - y) / scale],
    }];
  }));
  return { scale, maps, width: Math.max(width, found.width), height: Math.max(height, found.height) };
}
