//! What a worker does with a garment.

use crate::config::Limits;
use crate::fault::Faults;
use crate::fit::{self, Garment, Outcome};
use crate::job::catalogue::Catalogue;
use crate::job::clock::thread_cpu_s;
use crate::progress::{CancelToken, Progress};
use crate::solver::Context;
use std::sync::Arc;

/// What a worker does with a garment.
pub trait Runner: Send + Sync + 'static {
    /// Sews and drapes it, polling `cancel` at least ten times a second.
    ///
    /// # Errors
    /// The faults that keep it from being sewn.
    fn run(
        &self,
        garment: Garment,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Outcome, Faults>;
}

/// The real runner.
pub struct Sewing {
    /// What garments may refer to.
    pub catalogue: Arc<Catalogue>,
    /// Bounds on the work.
    pub limits: Limits,
}

impl Runner for Sewing {
    fn run(
        &self,
        garment: Garment,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Outcome, Faults> {
        let prepared = fit::prepare(garment, &*self.catalogue, &self.limits)?;
        let began = thread_cpu_s();
        let mut context = Context {
            cpu_s: &|| thread_cpu_s() - began,
            cancel,
            progress,
            limits: &self.limits,
        };
        fit::run(&prepared, &mut context)
    }
}
