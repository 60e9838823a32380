//! The work that is done for a job: the one place of this module that calls `fit` and `study`.

use crate::config::Limits;
use crate::fault::Faults;
use crate::fit::{self, AssetLibrary};
use crate::job::clock::thread_cpu_s;
use crate::job::process_death::ProcessDeath;
use crate::job::queue::Queue;
use crate::job::request::JobRequest;
use crate::job::result::JobOutcome;
use crate::progress::{CancelToken, Progress};
use crate::scene::AvatarCache;
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

    /// Does as [`Runner::run`] in a process of its own, which it ends if `cancel` was raised and
    /// nothing follows. Without such processes, in this one.
    ///
    /// # Errors
    /// The faults that keep it from being done, or how the process died.
    fn run_isolated(
        &self,
        request: &JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, RunError> {
        self.run(request.clone(), cancel, progress)
            .map_err(RunError::Refused)
    }
}

/// The reason why a run in a process of its own left no result.
#[derive(Clone, Debug)]
pub enum RunError {
    /// The request has faults.
    Refused(Faults),
    /// It panicked.
    Panicked,
    /// Its process died.
    Died(ProcessDeath),
    /// Its process told what cannot be read.
    Protocol(String),
    /// No process could be started.
    NotStarted(String),
}

/// Sews, drapes and studies garments.
pub struct SolverRunner {
    /// Patterns, avatars and fabrics that garments refer to.
    pub assets: Arc<dyn AssetLibrary + Send>,
    /// Bodies made before.
    pub bodies: Arc<AvatarCache>,
    /// Bounds on the work.
    pub limits: Limits,
}

impl SolverRunner {
    /// Creates the runner of the jobs of a queue.
    pub fn of(queue: &Queue) -> Self {
        let catalogue = queue.catalogue();
        Self {
            assets: Arc::clone(catalogue) as Arc<dyn AssetLibrary + Send>,
            bodies: Arc::clone(catalogue.bodies()),
            limits: queue.limits().clone(),
        }
    }
}

impl Runner for SolverRunner {
    fn run(
        &self,
        request: JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, Faults> {
        let (library, limits) = (&*self.assets, &self.limits);
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
                let resolved = resolved.with_bodies(&self.bodies);
                let outcome = fit::run(&resolved, &mut context)?;
                Ok(JobOutcome::Fit(Box::new(outcome)))
            }
            JobRequest::Study(request) => {
                let resolved = study::resolve(*request, library, limits)?;
                let resolved = resolved.with_bodies(&self.bodies);
                let study = study::run(&resolved, &mut context)?;
                Ok(JobOutcome::Study(Box::new(study)))
            }
        }
    }
}
