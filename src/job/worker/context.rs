//! The state that the threads of a pool share.

use super::active_runs::ActiveRuns;
use super::run_permits::RunPermits;
use super::runner::Runner;
use super::wake_signal::WakeSignal;
use crate::job::queue::Queue;
use std::sync::Arc;
use std::time::Duration;

/// Wait of a worker after the store failed.
pub(super) const RETRY_DELAY: Duration = Duration::from_secs(1);

/// The state that the threads of a pool share.
pub(super) struct WorkerContext {
    /// The queue that jobs are taken from.
    pub(super) queue: Arc<Queue>,
    /// The work done for a job.
    pub(super) runner: Box<dyn Runner>,
    /// The runs of this process.
    pub(super) active_runs: ActiveRuns,
    /// A permit for each job that runs.
    pub(super) run_permits: RunPermits,
    /// Wakes idle workers.
    pub(super) wake_signal: WakeSignal,
}
