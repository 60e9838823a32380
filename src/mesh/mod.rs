//! From panels to a [`ClothMesh`]: boundary points equal on both sides of a seam, constrained Delaunay inside.

use crate::config::Limits;
use crate::fault::{Fault, Faults};
use crate::pattern::Pattern;
use crate::progress::CancelToken;
use crate::seam::SeamSet;
use std::ops::Range;

/// All panels of a garment as triangles, with the stitches between them.
#[derive(Clone, Debug, PartialEq)]
pub struct ClothMesh {
    /// Rest position of each vertex in its panel's pattern coordinates \[m\]; `#V`.
    pub uv: Vec<[f64; 2]>,
    /// Vertex indices, counter-clockwise in pattern coordinates; `#T`.
    pub triangles: Vec<[usize; 3]>,
    /// The part of the mesh that each panel is, in the pattern's order.
    pub panels: Vec<PanelRange>,
    /// Point pairs that are sewn together; grouped by seam, in order along it. No vertex pair occurs twice.
    pub stitches: Vec<Stitch>,
}

/// The part of a mesh that one panel is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PanelRange {
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its triangles.
    pub triangles: Range<usize>,
    /// The vertex at each corner of the panel.
    pub corners: Vec<usize>,
}

/// One point pair of a seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stitch {
    /// Index of the seam.
    pub seam: usize,
    /// Order of sewing, from the seam.
    pub stage: u32,
    /// Vertex on side A.
    pub a: usize,
    /// Vertex on side B.
    pub b: usize,
}

/// Meshes every panel with edges of about `edge_length` \[m\].
///
/// # Errors
/// Panels too small or too fine for `limits`, named by `/panels/<id>`; a raised `cancel`.
pub fn triangulate(
    _pattern: &Pattern,
    _seams: &SeamSet,
    _edge_length: f64,
    _limits: &Limits,
    _cancel: &CancelToken,
) -> Result<ClothMesh, Faults> {
    Err(Fault::new("mesh/unsupported", "", "not yet").into())
}
