//! Progress and cancellation of a long computation.

use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use utoipa::ToSchema;

/// A request to stop a computation; a cheap handle, every clone of it is the same flag.
#[derive(Clone, Debug, Default)]
pub struct CancelToken(Arc<AtomicBool>);

impl CancelToken {
    /// Creates a token that is not canceled.
    pub fn new() -> Self {
        Self::default()
    }

    /// Cancels, for good.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Returns true once the token was canceled. Kernels poll this every iteration.
    pub fn is_canceled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Progress of a fit or a study.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Progress {
    /// Present stage; of a fit: `mesh`, `assemble`, `sew`, `drape` or `export`; of a study, in
    /// words.
    pub stage: String,
    /// Share of the whole done, 0 to 1; an estimate that never falls.
    pub fraction: f64,
    /// Mesh level, 0 = coarsest.
    pub level: u32,
    /// Residual r of the last iteration, dimensionless (see `solver::residual`).
    pub residual: Option<f64>,
    /// Largest distance between the two points of any stitch \[m\].
    pub seam_gap_m: Option<f64>,
    /// CPU time so far \[s\].
    pub cpu_s: f64,
}

impl Progress {
    /// Replaces infinities, which JSON does not have: text that held one could not be read again.
    #[must_use]
    pub fn finite(mut self) -> Self {
        for value in [&mut self.fraction, &mut self.cpu_s] {
            if !value.is_finite() {
                *value = 0.0;
            }
        }
        for value in [&mut self.residual, &mut self.seam_gap_m] {
            *value = value.filter(|value| value.is_finite());
        }
        self
    }
}
