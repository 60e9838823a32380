//! From seam pairs as asked to checked [`Seam`]s: which point meets which, which face of each panel is out.

mod check;
mod chords;
mod colour;
mod correct;
mod cycle;
mod direction;
mod ease;
mod faces;
mod finding;
mod marks;
mod matching;
mod misfaced;
mod order;
mod overlap;
mod parity;
mod place;
mod routed;
mod runs;
pub mod suggest;
mod track;
mod twist;
mod way;

pub use crate::pattern::Face;
pub use check::{Starts, ToCheck, check, check_placed};
pub use finding::{SeamCheck, SeamFinding};
pub use marks::{Mark, MatchedMarks};

use routed::Routed;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A checked seam. Built only by [`check`].
#[derive(Clone, Debug, PartialEq)]
pub struct Seam {
    /// The client's name for it.
    pub id: String,
    /// Order of sewing: lower stages are sewn first.
    pub stage: u32,
    /// Stretches of side A and side B that meet point to point, in order along the seam from `from` of A.
    ///
    /// The two of a pair get equally many points, evenly by arc length, so that ease and gathers spread evenly between
    /// matched notches: the start of the one meets the start of the other.
    /// Each pair begins on either side where the one before it ends, at a corner or inside an edge, or where the next run of
    /// that side begins. No stretch is empty. Fractions at corners are exactly 0 and 1.
    pub matched: Vec<[Stretch; 2]>,
}

/// A part of one edge, with the way along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Index of the panel in the pattern.
    pub panel: usize,
    /// What of the panel it lies on.
    pub track: Track,
    /// Index of the edge in that track; 0 on internal lines.
    pub edge: usize,
    /// Where it begins: fraction of the edge's arc length, in the order of corners. Above `to` when the way goes against the edge.
    pub from: f64,
    /// Where it ends, likewise.
    pub to: f64,
}

/// What of a panel a stretch lies on: a row of edges numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Track {
    /// The outline.
    Outline,
    /// A hole, by index.
    Hole(usize),
    /// An internal line, by index. It counts as one edge, from its first point to its last.
    Line(usize),
}

/// Which side of a panel's cloth is out, as asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum FaceAsked {
    /// Found from the seams.
    #[default]
    Auto,
    /// The side that the drawing shows is out.
    Up,
    /// The side that the drawing shows is in.
    Down,
}

/// Checked seams with the faces they were checked for.
#[derive(Clone, Debug, PartialEq)]
pub struct SeamSet {
    /// The seams, in the order asked.
    pub seams: Vec<Seam>,
    /// The face of each panel, by index in the pattern.
    pub faces: Vec<Face>,
}

/// Number of mesh edges along two matched stretches of these lengths \[m\]: enough that neither side's are longer than `edge_length`.
pub fn division_count(length_a: f64, length_b: f64, edge_length: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a length over a positive length, both bounded by Limits"
    )]
    let count = (length_a.max(length_b) / edge_length - 1e-9).ceil() as usize;
    count.max(1)
}
