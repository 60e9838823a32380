/** Ids of mirrored copies, which are those of their sources with a mark. */

const MARK = "~mirror";

/** The id of a panel's mirrored copy. */
export const mirrorOf = (id) => id + MARK;

/** True for the id of a mirrored copy. */
export const isMirrorId = (id) => id.endsWith(MARK);

/** The id of the panel that is drawn: its own, or that of the source of a mirrored copy. */
export const sourceOf = (id) => (isMirrorId(id) ? id.slice(0, -MARK.length) : id);
