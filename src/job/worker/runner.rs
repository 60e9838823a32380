//! The work that is done for a job: the one place of this module that calls `fit` and `study`.

use crate::config::Limits;
use crate::fault::Faults;
use crate::fit;
use crate::job::catalogue::Catalogue;
use crate::job::clock::thread_cpu_s;
use crate::job::request::JobRequest;
use crate::job::result::JobOutcome;
use crate::progress::{CancelToken, Progress};
use crate::solver::Context;
use crate::study;
use std::sync::Arc;

/// Does the work of jobs.
pub trait Runner: Send + Sync + 'static {
    /// Does what is requested, polling `cancel` at least ten times a second.
    ///
    /// The outcome is of the same kind as the request.
    ///
    /// # Errors
    /// The faults that keep it from being done.
    fn run(
        &self,
        request: JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, Faults>;
}

/// The runner of the service: sews, drapes and studies garments.
pub struct SolverRunner {
    /// Patterns, avatars and fabrics that garments refer to.
    pub catalogue: Arc<Catalogue>,
    /// Bounds on the work.
    pub limits: Limits,
}

impl Runner for SolverRunner {
    fn run(
        &self,
        request: JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, Faults> {
        let (library, limits) = (&*self.catalogue, &self.limits);
        let began = thread_cpu_s();
        let mut context = Context {
            cpu_s: &|| thread_cpu_s() - began,
            cancel,
            progress,
            limits,
        };
        match request {
            JobRequest::Fit(garment) => {
                let resolved = fit::resolve(*garment, library, limits)?;
                let resolved = resolved.with_bodies(library.bodies());
                let outcome = fit::run(&resolved, &mut context)?;
                Ok(JobOutcome::Fit(Box::new(outcome)))
            }
            JobRequest::Study(request) => {
                let resolved = study::resolve(*request, library, limits)?;
                let resolved = resolved.with_bodies(library.bodies());
                let study = study::run(&resolved, &mut context)?;
                Ok(JobOutcome::Study(Box::new(study)))
            }
        }
    }
}
