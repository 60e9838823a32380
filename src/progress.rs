//! What a long computation shares with whoever asked for it: how far it is, and whether to stop.

use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use utoipa::ToSchema;

/// Asks a computation to stop; a cheap handle, every clone of it means the same flag.
#[derive(Clone, Debug, Default)]
pub struct CancelToken(Arc<AtomicBool>);

impl CancelToken {
    /// A flag that is not raised.
    pub fn new() -> Self {
        Self::default()
    }

    /// Raises the flag for good.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the flag was raised. Kernels poll this every iteration.
    pub fn is_canceled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// How far a fit or a study is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Progress {
    /// What runs now, of a fit: `mesh`, `assemble`, `sew`, `drape` or `export`; of a study, in words.
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
