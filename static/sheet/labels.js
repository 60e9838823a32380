/**
 * Labels that never lie on each other: each takes the first of its places that is free, or none.
 */

const pen = document.createElement("canvas").getContext("2d");
const widths = new Map();

/** Width of a text in the page's typeface [px]; `font` as in CSS without the family. */
export function textWidth(text, font) {
  const key = `${font} ${text}`;
  if (!widths.has(key)) {
    pen.font = `${font} ${getComputedStyle(document.body).fontFamily}`;
    widths.set(key, pen.measureText(text).width);
  }
  return widths.get(key);
}

export const touch = (a, b) =>
  Math.abs(a.x - b.x) * 2 < a.width + b.width && Math.abs(a.y - b.y) * 2 < a.height + b.height;

/**
 * Places labels in the order of the list, the most important first. A label is `{places, draw}`:
 * boxes `{x, y, width, height}` about their middles, and a function that paints it in one of them.
 */
export function placeLabels(labels, { width, height }) {
  const taken = [];
  const isSeen = (box) =>
    box.x * 2 > box.width && box.y * 2 > box.height && (width - box.x) * 2 > box.width && (height - box.y) * 2 > box.height;
  return labels.flatMap(({ places, draw }) => {
    const free = places.find((box) => isSeen(box) && !taken.some((other) => touch(box, other)));
    if (!free) return [];
    taken.push(free);
    return [draw(free)];
  });
}
