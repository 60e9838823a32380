//! What one case came to: a line of `target/stability.jsonl`.

use serde::{Deserialize, Serialize};

/// One case. Energies in joules.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Line {
    pub(crate) case: String,
    pub(crate) method: String,
    pub(crate) vertices: usize,
    /// What was expected, in words.
    pub(crate) expected: String,
    /// `converged`, `not converged`, `refused`, or what should never be: `panicked`, `did not end`.
    pub(crate) came_to: String,
    /// The reason in the report.
    pub(crate) why: String,
    pub(crate) cpu_s: f64,
    pub(crate) within_s: f64,
    /// r at the end; of a drape only.
    pub(crate) residual: Option<f64>,
    pub(crate) newton_iterations: u64,
    pub(crate) steps: u64,
    /// The rungs of the ladder that were taken.
    pub(crate) ladder: Vec<String>,
    /// Energy at the end.
    pub(crate) energy_j: f64,
    /// What it was after sewing, or what theory lets it be at most.
    pub(crate) energy_most_j: Option<f64>,
    /// Why the energy was not compared, where it was not.
    pub(crate) energy_unbounded: Option<String>,
    /// The estimate of the error \[m\], and the distance to the shape that the stopped one leads to at the round-off floor \[m\].
    pub(crate) estimate_m: Option<f64>,
    pub(crate) estimate_valid: bool,
    pub(crate) error_m: Option<f64>,
    pub(crate) strain_max: f64,
    pub(crate) gap_m: f64,
    pub(crate) penetration_m: f64,
    pub(crate) memory_peak_bytes: u64,
    /// Faults that are known: failures of the solver, for which the case stands.
    #[serde(default)]
    pub(crate) known: Vec<String>,
    /// All else that is not as it must be; empty is good.
    pub(crate) faults: Vec<String>,
}
