//! Outcome of a garment of the sweep.

use serde::{Deserialize, Serialize};

/// RMS distance to the shape at rest of which it is told when it was reached \[m\].
pub(super) const NEAR: f64 = 1e-4;

/// Outcome of sewing one garment.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct SweepLine {
    pub(super) name: String,
    /// True if its seams are known, false if they were suggested.
    pub(super) true_seams: bool,
    pub(super) form: String,
    pub(super) edge_length_m: f64,
    /// Reason why there is no shape.
    pub(super) error: Option<String>,
    pub(super) vertices: usize,
    pub(super) converged: bool,
    /// True if it is good, whether or not it is at rest.
    pub(super) good: bool,
    pub(super) failed: Vec<String>,
    pub(super) because: Vec<String>,
    pub(super) residual: f64,
    pub(super) seam_gap_m: f64,
    pub(super) penetration_m: f64,
    /// Pairs of triangles of cloth that meet.
    pub(super) crossings: Option<usize>,
    pub(super) degenerate_triangles: Option<usize>,
    /// Pairs of a triangle of cloth and one of the body that meet.
    pub(super) body_crossings: Option<usize>,
    pub(super) vertices_inside: Option<usize>,
    pub(super) strain_max: f64,
    pub(super) worn: bool,
    pub(super) worn_because: String,
    pub(super) why: String,
    pub(super) newton_iterations: usize,
    pub(super) error_estimate_m: Option<f64>,
    pub(super) mesh_error_m: Option<f64>,
    /// CPU seconds of the drape after which it stayed within [`NEAR`] of the shape at rest.
    pub(super) near_cpu_s: Option<f64>,
    pub(super) cpu_s: f64,
    pub(super) memory_bytes: u64,
}
