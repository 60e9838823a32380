/**
 * Places of the panels on the sheet, which is measured in meters with y down. A place, once given,
 * stays.
 */

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

/** Rows of boxes in their order at `scale` px/m, no wider than `width` [px]. */
function shelves(boxes, scale, width) {
  const corners = [];
  let [x, y, row, widest] = [SPACE.side, SPACE.top, 0, 0];
  for (const box of boxes) {
    const w = (box.right - box.left) * scale;
    const h = (box.top - box.bottom) * scale;
    if (x > SPACE.side && x + w + SPACE.side > width) {
      x = SPACE.side;
      y += row + SPACE.below;
      row = 0;
    }
    corners.push([x, y]);
    widest = Math.max(widest, x + w + SPACE.side);
    x += w + SPACE.across;
    row = Math.max(row, h);
  }
  return { corners, width: widest, height: y + row + SPACE.below };
}

/** The largest scale [px/m] at which all boxes fit. */
function fittingScale(boxes, width, height) {
  let [low, high] = [1, 8000];
  for (let i = 0; i < 40; i++) {
    const middle = Math.sqrt(low * high);
    const size = shelves(boxes, middle, width);
    if (size.width <= width && size.height <= height) low = middle;
    else high = middle;
  }
  return low;
}

function placesOf(panels, boxes, rows, scale, below) {
  return panels.map((panel, i) => {
    const [x, y] = rows.corners[i];
    return [panel.id, { x: x / scale - boxes[i].left, y: below + y / scale + boxes[i].top }];
  });
}

/**
 * Arranges panels in rows for a window of this size [px]: `{places, scale, width, height}` in
 * meters and px/m.
 */
export function arrange(panels, width, height) {
  const boxes = panels.map(boxOf);
  const scale = fittingScale(boxes, width, height);
  const rows = shelves(boxes, scale, width);
  return {
    places: new Map(placesOf(panels, boxes, rows, scale, 0)),
    scale, width: rows.width / scale, height: rows.height / scale,
  };
}

/** Adds panels that have no place yet, in rows below the others. */
export function extend(arrangement, panels) {
  const { places, scale, width, height } = arrangement;
  const added = panels.filter((panel) => !places.has(panel.id));
  if (added.length === 0) return arrangement;
  const boxes = added.map(boxOf);
  const rows = shelves(boxes, scale, width * scale);
  return {
    places: new Map([...places, ...placesOf(added, boxes, rows, scale, height)]),
    scale, width: Math.max(width, rows.width / scale), height: height + rows.height / scale,
  };
}

/** A point of the pattern [m, y up] on the sheet. */
export const onSheet = (place, [x, y]) => [x + place.x, place.y - y];

/** A point of the sheet in the pattern's coordinates. */
export const onPanel = (place, [x, y]) => [x - place.x, place.y - y];

/** The box of a panel on the sheet: `{left, right, top, bottom}`, y down. */
export function sheetBox(panel, place) {
  const box = boxOf(panel);
  return { left: box.left + place.x, right: box.right + place.x, top: place.y - box.top, bottom: place.y - box.bottom };
}
