//! What a worker does with a job.

use crate::config::Limits;
use crate::fault::Faults;
use crate::fit;
use crate::job::catalogue::Catalogue;
use crate::job::clock::thread_cpu_s;
use crate::job::work::{Done, Work};
use crate::progress::{CancelToken, Progress};
use crate::solver::Context;
use crate::study;
use std::sync::Arc;

/// What a worker does with a job.
pub trait Runner: Send + Sync + 'static {
    /// Does it, polling `cancel` at least ten times a second. What comes of it is of the same kind.
    ///
    /// # Errors
    /// The faults that keep it from being done.
    fn run(
        &self,
        work: Work,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Done, Faults>;
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
        work: Work,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Done, Faults> {
        let (library, limits) = (&*self.catalogue, &self.limits);
        let began = thread_cpu_s();
        let mut context = Context {
            cpu_s: &|| thread_cpu_s() - began,
            cancel,
            progress,
            limits,
        };
        match work {
            Work::Fit(garment) => {
                let prepared = fit::prepare(*garment, library, limits)?;
                let outcome = fit::run(&prepared, &mut context)?;
                Ok(Done::Fit(Box::new(outcome)))
            }
            Work::Study(asked) => {
                let prepared = study::prepare(*asked, library, limits)?;
                let study = study::run(&prepared, &mut context)?;
                Ok(Done::Study(Box::new(study)))
            }
        }
    }
}
