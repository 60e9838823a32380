/** Names of panels that have to fit beside their neighbors'. */

import { textWidth } from "./labels.js";

export const NAME_FONT = "650 13px";

/** The beginning that all names share, up to a separator, as the style's number. */
export function commonStart(names) {
  if (names.length < 2) return "";
  let size = 0;
  while (names.every((name) => name.length > size + 1 && name[size] === names[0][size])) size += 1;
  const start = names[0].slice(0, size);
  return start.slice(0, Math.max(start.lastIndexOf(" "), start.lastIndexOf("-"), start.lastIndexOf("_"), -1) + 1);
}

/**
 * The name as far as it has room [px]: whole, without the common start, or with a gap in its
 * middle.
 */
export function shortName(name, room, start) {
  const fits = (text) => textWidth(text, NAME_FONT) <= room;
  if (fits(name)) return name;
  const own = name.slice(start.length);
  if (fits(own)) return own;
  for (let size = own.length - 2; size >= 2; size--) {
    const head = Math.ceil(size / 2);
    const text = `${own.slice(0, head).trimEnd()}…${own.slice(own.length - (size - head)).trimStart()}`;
    if (fits(text)) return text;
  }
  return "";
}
