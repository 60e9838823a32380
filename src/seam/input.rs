//! Input of a seam check: panels, seams as requested, requested faces and start positions.

use super::Face;
use crate::config::Limits;
use crate::pattern::{Pattern, Point2, SeamPair};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// Start position in space \[m\] of a point of a panel, from the panel's index, its face and
/// pattern coordinates \[m\]; nothing where that is not known.
pub type StartPositions<'a> = &'a dyn Fn(usize, Face, Point2) -> Option<[f64; 3]>;

/// Input of a seam check.
#[derive(Clone, Copy, Debug)]
pub struct SeamCheckInput<'a> {
    /// The panels.
    pub pattern: &'a Pattern,
    /// The seams as requested.
    pub pairs: &'a [SeamPair],
    /// Requested face of each panel, by id (absent: auto).
    pub faces: &'a BTreeMap<String, FaceRequest>,
    /// Mesh edge length that stitch counts are stated for \[m\].
    pub edge_length: f64,
    /// Bounds on the request.
    pub limits: &'a Limits,
}

/// Requested outer side of a panel's cloth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
#[schema(as = FaceAsked)]
pub enum FaceRequest {
    /// Found from the seams.
    #[default]
    Auto,
    /// The side that the drawing shows is out.
    Up,
    /// The side that the drawing shows is in.
    Down,
}
