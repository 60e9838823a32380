/**
 * Scales of color, alike in the light and in the dark: ordered by lightness, and told apart by
 * those who see no red or no green.
 */

/** From little to much: dark blue over green to yellow (viridis). */
const SEQUENCE = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];
/** From compressed over nothing to stretched: blue, white, orange. */
const DIVERGING = ["#0b3c7d", "#2a6cb0", "#6aa3d5", "#b5d2ea", "#f4f3f0", "#f6d2a9", "#ec9f55", "#c9661a", "#7f3305"];
/** Above the end of a scale that has one. */
export const OVER = "#d7263d";

const STOPS = { sequence: SEQUENCE, diverging: DIVERGING };

/** The colors of a scale at equal distances. */
export const stopsOf = (scale) => STOPS[scale];

export const gradientOf = (scale) => `linear-gradient(to right, ${STOPS[scale].join(", ")})`;

const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

/** A scale as `count` colors, four bytes each. */
export function colorsOf(scale, count) {
  const stops = STOPS[scale].map(channels);
  const bytes = new Uint8Array(4 * count);
  for (let i = 0; i < count; i++) {
    const at = (i / (count - 1)) * (stops.length - 1);
    const [from, share] = [Math.min(Math.floor(at), stops.length - 2), at - Math.min(Math.floor(at), stops.length - 2)];
    const color = stops[from].map((one, k) => one + share * (stops[from + 1][k] - one));
    bytes.set([...color, 255], 4 * i);
  }
  return bytes;
}
