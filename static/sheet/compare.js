/** Comparison of two sides of a seam by length, in words and as a grade of color. */

/** Differences up to these are no difference, ease, much ease [m or share of the first side]. */
const SAME_M = 0.002;
const SAME = 0.01;
const EASED = 0.08;
const GATHERED = 0.25;

const cm = (meters) => (meters * 100).toFixed(1);

/** The grade: `same`, `ease`, `much` or `no`. */
export function gradeOf(first, second) {
  const difference = Math.abs(second - first);
  if (difference <= Math.max(SAME_M, SAME * first)) return "same";
  const share = difference / Math.min(first, second);
  if (share <= EASED) return "ease";
  return share <= GATHERED ? "much" : "no";
}

const WORDS = {
  same: () => "they match",
  ease: (longer) => `a little ${longer}`,
  much: (longer) => `much ${longer}, to be gathered`,
  no: (longer) => `far ${longer}, hardly a pair`,
};

/** `42.0 : 45.5 cm, +3.5 cm (8 %)`. */
export function differenceText(first, second) {
  const difference = second - first;
  const sign = difference < 0 ? "−" : "+";
  return `${cm(first)} : ${cm(second)} cm, ${sign}${cm(Math.abs(difference))} cm (${Math.round((Math.abs(difference) / first) * 100)} %)`;
}

/** The difference in words. */
export const gradeText = (first, second) => WORDS[gradeOf(first, second)](second > first ? "longer" : "shorter");

/** Likeness of two sides by length: 1 is equal, 0 is hardly a pair. */
export const likeness = (first, second) => Math.max(0, 1 - Math.abs(second - first) / Math.max(first, second, 1e-9) / 0.04);
