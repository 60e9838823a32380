//! Outcome of one run: a line of `target/bench.jsonl`.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// One run. Errors are RMS over the vertices.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct BenchLine {
    pub(crate) scene: String,
    pub(crate) method: String,
    pub(crate) membrane: String,
    /// Options of the solver beyond its defaults.
    pub(crate) setting: Value,
    pub(crate) vertices: usize,
    /// CPU time from the scene to the report, all threads; the median where a short run was
    /// repeated \[s\].
    pub(crate) cpu_s: f64,
    pub(crate) wall_s: f64,
    pub(crate) threads: usize,
    /// Distance from the reference that continues from the stopped shape, or that reference's own
    /// error estimate where it is larger: a shape at the round-off floor is its own reference. None
    /// with friction \[m\].
    pub(crate) error_m: Option<f64>,
    pub(crate) residual: f64,
    pub(crate) estimate_m: Option<f64>,
    /// True if the solver calls its estimate valid.
    pub(crate) estimate_valid: bool,
    pub(crate) gap_m: f64,
    pub(crate) penetration_m: f64,
    pub(crate) strain_max: f64,
    /// Of all terms, height against the start: the lower, the better a minimum was found. Rest
    /// shapes are not unique \[J\].
    pub(crate) energy_j: f64,
    pub(crate) memory_peak_bytes: u64,
    /// On all levels; 0 for explicit steps.
    pub(crate) newton_iterations: usize,
    pub(crate) converged: bool,
    /// Reason for stopping.
    pub(crate) why: String,
    /// Distance of the reference from the stopped shape \[m\].
    pub(crate) reference_moved_m: Option<f64>,
    /// Residual of the reference over the round-off floor.
    pub(crate) reference_floors: Option<f64>,
    /// Distance between the reference and that of a second method, where that was looked for and
    /// came to rest \[m\].
    pub(crate) reference_apart_m: Option<f64>,
}

impl BenchLine {
    /// Returns true if it is the result of the same run.
    pub(crate) fn same_run(&self, other: &Self) -> bool {
        self.scene == other.scene
            && self.method == other.method
            && self.membrane == other.membrane
            && self.setting == other.setting
    }
}
