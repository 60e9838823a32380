//! The runs of this process, and the requests to stop them.

use crate::job::store::Lease;
use crate::progress::CancelToken;
use std::collections::HashMap;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use uuid::Uuid;

/// The reason for stopping a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StopReason {
    /// Somebody canceled the job.
    Canceled,
    /// The run used its CPU time.
    TimeLimit,
    /// The lease ran out: another worker may have the job.
    LeaseLost,
    /// The service shuts down.
    Shutdown,
}

/// Asks one run to stop, and remembers the first reason.
#[derive(Clone, Debug, Default)]
pub(super) struct StopFlag {
    pub(super) cancel: CancelToken,
    first: Arc<FirstReason>,
}

/// The first reason for stopping a run, and those who wait for it.
#[derive(Debug, Default)]
struct FirstReason {
    reason: Mutex<Option<StopReason>>,
    raised: Condvar,
}

impl StopFlag {
    /// Asks the run to stop.
    pub(super) fn raise(&self, reason: StopReason) {
        self.lock().get_or_insert(reason);
        self.first.raised.notify_all();
        self.cancel.cancel();
    }

    /// Returns the first reason, if the run was asked to stop.
    pub(super) fn reason(&self) -> Option<StopReason> {
        *self.lock()
    }

    /// Waits until the run is asked to stop, at most `timeout`, and returns the first reason.
    pub(super) fn wait(&self, timeout: Duration) -> Option<StopReason> {
        let raised = &self.first.raised;
        let waited = raised.wait_timeout_while(self.lock(), timeout, |reason| reason.is_none());
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }

    fn lock(&self) -> MutexGuard<'_, Option<StopReason>> {
        let reason = self.first.reason.lock();
        reason.unwrap_or_else(PoisonError::into_inner)
    }
}

/// The runs of this process.
#[derive(Default)]
pub(super) struct ActiveRuns {
    runs: Mutex<RunTable>,
    changed: Condvar,
}

#[derive(Default)]
struct RunTable {
    by_job: HashMap<Uuid, (Lease, StopFlag)>,
    is_closed: bool,
}

impl RunTable {
    fn is_finished(&self) -> bool {
        self.is_closed && self.by_job.is_empty()
    }
}

impl ActiveRuns {
    /// Registers a run.
    ///
    /// To be called before the record says that the job runs, so that a cancellation after that is
    /// heard.
    pub(super) fn register(&self, lease: Lease) -> StopFlag {
        let mut runs = self.lock();
        let flag = StopFlag::default();
        if runs.is_closed {
            flag.raise(StopReason::Shutdown);
        }
        runs.by_job.insert(lease.job, (lease, flag.clone()));
        flag
    }

    /// Removes a run.
    pub(super) fn remove(&self, lease: &Lease) {
        let mut runs = self.lock();
        let registered = runs.by_job.get(&lease.job);
        // After a lost lease another worker of this process may have the job.
        if registered.is_some_and(|(one, _)| one == lease) {
            runs.by_job.remove(&lease.job);
        }
        self.changed.notify_all();
    }

    /// Asks the run of a job to stop, if it runs here.
    pub(super) fn stop(&self, job: Uuid, reason: StopReason) {
        if let Some((_, flag)) = self.lock().by_job.get(&job) {
            flag.raise(reason);
        }
    }

    /// Asks every run to stop, those that begin later included.
    pub(super) fn close(&self) {
        let mut runs = self.lock();
        runs.is_closed = true;
        for (_, flag) in runs.by_job.values() {
            flag.raise(StopReason::Shutdown);
        }
        self.changed.notify_all();
    }

    /// Returns true once [`ActiveRuns::close`] was called.
    pub(super) fn is_closed(&self) -> bool {
        self.lock().is_closed
    }

    /// Returns true once the pool is closed and its last run has ended.
    pub(super) fn is_finished(&self) -> bool {
        self.lock().is_finished()
    }

    /// Returns the leases of all runs.
    pub(super) fn leases(&self) -> Vec<Lease> {
        let runs = self.lock();
        runs.by_job.values().map(|(lease, _)| *lease).collect()
    }

    /// Waits until a run ends or all are asked to stop, at most `timeout`.
    pub(super) fn wait_for_change(&self, timeout: Duration) {
        let runs = self.lock();
        if !runs.is_finished() {
            drop(self.changed.wait_timeout(runs, timeout));
        }
    }

    fn lock(&self) -> MutexGuard<'_, RunTable> {
        self.runs.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
