/**
 * The service's sentences in a maker's words: fields of the page instead of options of the
 * interface.
 */

const FIELD = { units: "Units", size: "Size", encoding: "Letters of names", outlines: "Outlines inside others", notches: "Notches drawn into outlines", unfold: "Pieces on the fold" };

/** Options and what stands for them, the special before the general. */
const RULES = [
  [/\s*\((units|size|encoding|outlines|notches|unfold)=[^)]*\)/g, (_, name) => ` (the field “${FIELD[name]}” changes it)`],
  [/say the units( of the file)? with units=[a-z|]+/g, "choose the units of the file"],
  [/correct units_in_meter, or /g, ""],
  [/units=(\w+) would/g, "read in $1 it would"],
  [/;?\s*`panels\.<id>\.face` chooses/g, "; the panel’s field “Face” changes it"],
  [/set `match` to `auto`/g, "let the ends be found"],
  [/set `gather`/g, "choose “Gather”"],
  [/set `layered` on `([^`]+)`/g, "choose “Over another seam” for $1"],
  [/as `allow_twist` allows/g, "as “Twist on purpose” allows"],
  [/leave `direction` out, or swap `from` and `to`/g, "pick the edge again from its other end"],
  [/set (?:its )?`face`( of .+?)? to `(up|down)`/g, "set the field “Face”$1 to “$2”"],
  [/, or to `auto`/g, ", or to “found”"],
  [/side a of/g, "the first side of"],
  [/side b of/g, "the second side of"],
  [/side b\b/g, "the second side"],
  [/ \(root of the mean square\)/g, ""],
  [/`([^`]*)`/g, "$1"],
];

/** A sentence of the service for a maker. */
export const makersText = (text) => RULES.reduce((said, [pattern, instead]) => said.replace(pattern, instead), text);
