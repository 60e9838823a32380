//! Checked seams, and how finely their two sides are divided.

use super::{Face, Stretch};

/// A checked seam. Built only by [`check`](super::check()).
#[derive(Clone, Debug, PartialEq)]
pub struct Seam {
    /// The client's name for it.
    pub id: String,
    /// Order of sewing: lower stages are sewn first.
    pub stage: u32,
    /// Stretches of side A and side B that meet point to point, in order along the seam from `from`
    /// of A.
    ///
    /// The two of a pair get equally many points, evenly by arc length, so that ease and gathers
    /// spread evenly between matched notches: the start of the one meets the start of the other.
    /// Each pair begins on either side where the one before it ends, at a corner or inside an edge,
    /// or where the next run of that side begins. No stretch is empty. Fractions at corners are
    /// exactly 0 and 1.
    pub matched: Vec<[Stretch; 2]>,
}

/// Checked seams with the faces they were checked for.
#[derive(Clone, Debug, PartialEq)]
pub struct SeamSet {
    /// The seams, in the order requested.
    pub seams: Vec<Seam>,
    /// The face of each panel, by index in the pattern.
    pub faces: Vec<Face>,
}

/// Number of mesh edges along two matched stretches of these lengths \[m\]: enough that neither
/// side's are longer than `edge_length`.
pub fn division_count(length_a: f64, length_b: f64, edge_length: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a length over a positive length, both bounded by Limits"
    )]
    let count = (length_a.max(length_b) / edge_length - 1e-9).ceil() as usize;
    count.max(1)
}
