/**
 * The part of the sheet that is seen: a point of the sheet [m] lies at k·p + (x, y) on the screen
 * [px].
 */

/** Smallest and largest scale [px/m]. */
const LEAST = 20;
const MOST = 40_000;

export const toScreen = ({ x, y, k }, [px, py]) => [k * px + x, k * py + y];

export const toSheet = ({ x, y, k }, [sx, sy]) => [(sx - x) / k, (sy - y) / k];

export const panned = (view, [dx, dy]) => ({ ...view, x: view.x + dx, y: view.y + dy });

/** Zooms by a factor; the point `at` of the screen stays. */
export function zoomed(view, at, factor) {
  const k = Math.min(MOST, Math.max(LEAST, view.k * factor));
  const [px, py] = toSheet(view, at);
  return { k, x: at[0] - k * px, y: at[1] - k * py };
}

/** Shows a box of the sheet in the middle of a window, with a margin [px] around it. */
export function fitted({ left, right, top, bottom }, { width, height }, margin) {
  const room = (size) => Math.max(size - 2 * margin, size / 4);
  const k = Math.min(MOST, room(width) / Math.max(right - left, 1e-4), room(height) / Math.max(bottom - top, 1e-4));
  return { k, x: (width - k * (left + right)) / 2, y: (height - k * (top + bottom)) / 2 };
}

/** Keeps what was in the middle in the middle of a window of another size. */
export const resized = (view, before, now) => panned(view, [(now.width - before.width) / 2, (now.height - before.height) / 2]);
