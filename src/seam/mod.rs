//! From seam pairs as asked to checked [`Seam`]s: which point meets which, which face of each panel is out.

use crate::config::Limits;
use crate::fault::{Fault, Faults, Warning};
use crate::pattern::{Direction, Pattern, SeamPair};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// A checked seam. Built only by [`check`].
#[derive(Clone, Debug, PartialEq)]
pub struct Seam {
    /// The client's name for it.
    pub id: String,
    /// Order of sewing: lower stages are sewn first.
    pub stage: u32,
    /// Stretches of side A and side B that meet point to point, in order along the seam. The two of a pair get equally many points.
    pub matched: Vec<[Stretch; 2]>,
}

/// A part of one edge, with the way along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Index of the panel in the pattern.
    pub panel: usize,
    /// Index of the edge in the panel's outline.
    pub edge: usize,
    /// Where it begins: fraction of the edge's arc length, clockwise. Above `to` when the way goes against the edge.
    pub from: f64,
    /// Where it ends, likewise.
    pub to: f64,
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

/// Which side of a panel's cloth is out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Face {
    /// The side that the drawing shows.
    Up,
    /// The other one.
    Down,
}

/// What was found about a set of seams: the answer of `seams/check`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SeamCheck {
    /// Whether all of them can be sewn.
    pub ok: bool,
    /// The face of each panel, by id.
    pub faces: BTreeMap<String, Face>,
    /// Each seam as asked, in order.
    pub seams: Vec<SeamFinding>,
    /// For seams that could be corrected: how.
    pub corrected: Vec<SeamPair>,
}

/// What was found about one seam.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SeamFinding {
    /// The client's name for it.
    pub id: String,
    /// Whether it can be sewn.
    pub ok: bool,
    /// Stitches it would get at the mesh edge length asked for.
    pub stitch_count: usize,
    /// Arc length of side A \[m\].
    pub length_a_m: f64,
    /// Arc length of side B \[m\].
    pub length_b_m: f64,
    /// Longer over shorter, less 1.
    pub ease: f64,
    /// Longer less shorter \[m\].
    pub ease_m: f64,
    /// Way of the first run of A.
    pub direction_a: Option<Direction>,
    /// Way of the first run of B, as sewn.
    pub direction_b: Option<Direction>,
    /// Whether the order of B was reversed (`match: auto`).
    pub reversed: bool,
    /// What keeps it from being sewn.
    pub errors: Vec<Fault>,
    /// What a user should know.
    pub warnings: Vec<Warning>,
}

/// Checked seams with the faces they were checked for.
#[derive(Clone, Debug, PartialEq)]
pub struct SeamSet {
    /// The seams, in the order asked.
    pub seams: Vec<Seam>,
    /// The face of each panel, by index in the pattern.
    pub faces: Vec<Face>,
}

/// Checks `pairs` against `pattern`.
///
/// `faces` holds what was asked for each panel, by id (absent: auto); `edge_length` \[m\] is the mesh edge length
/// that stitch counts are stated for. Pointers are `/seams/<i>/...`. The findings always cover every seam;
/// the [`SeamSet`] is there only when all are right.
///
/// # Errors
/// Every fault of every seam at once, in the second part.
pub fn check(
    _pattern: &Pattern,
    _pairs: &[SeamPair],
    _faces: &BTreeMap<String, FaceAsked>,
    _edge_length: f64,
    _limits: &Limits,
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let check = SeamCheck {
        ok: false,
        faces: BTreeMap::new(),
        seams: vec![],
        corrected: vec![],
    };
    (
        check,
        Err(Fault::new("seam/unsupported", "/seams", "not yet").into()),
    )
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
