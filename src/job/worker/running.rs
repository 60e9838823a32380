//! What runs in this process, and how to stop it.

use crate::job::store::Lease;
use crate::progress::CancelToken;
use std::collections::HashMap;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;
use uuid::Uuid;

/// Why a run is to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// Somebody asked.
    Canceled,
    /// It used its CPU time.
    TimeLimit,
    /// Its lease ran out: the job is somebody else's now.
    Lost,
    /// The service shuts down.
    Shutdown,
}

/// Asks one run to stop, and remembers the first reason.
#[derive(Clone, Debug, Default)]
pub(super) struct StopFlag {
    pub(super) cancel: CancelToken,
    reason: Arc<OnceLock<Stop>>,
}

impl StopFlag {
    pub(super) fn raise(&self, reason: Stop) {
        // Only the first reason counts.
        let _ = self.reason.set(reason);
        self.cancel.cancel();
    }

    pub(super) fn reason(&self) -> Option<Stop> {
        self.reason.get().copied()
    }
}

/// What runs in this process.
#[derive(Default)]
pub(super) struct Running {
    runs: Mutex<Runs>,
    changed: Condvar,
}

#[derive(Default)]
struct Runs {
    by_job: HashMap<Uuid, (Lease, StopFlag)>,
    closed: bool,
}

impl Running {
    /// Notes a run. To be called before the record says that it runs, so that whoever cancels it then is heard.
    pub(super) fn begin(&self, lease: Lease) -> StopFlag {
        let mut runs = self.lock();
        let flag = StopFlag::default();
        if runs.closed {
            flag.raise(Stop::Shutdown);
        }
        runs.by_job.insert(lease.job, (lease, flag.clone()));
        flag
    }

    /// Forgets a run.
    pub(super) fn end(&self, lease: &Lease) {
        let mut runs = self.lock();
        // After a lost lease another worker of this process may have the job.
        if runs
            .by_job
            .get(&lease.job)
            .is_some_and(|(one, _)| one == lease)
        {
            runs.by_job.remove(&lease.job);
        }
        self.changed.notify_all();
    }

    /// Asks the run of a job to stop, if it runs here.
    pub(super) fn stop(&self, job: Uuid, reason: Stop) {
        if let Some((_, flag)) = self.lock().by_job.get(&job) {
            flag.raise(reason);
        }
    }

    /// Asks every run to stop, those that begin later included.
    pub(super) fn close(&self) {
        let mut runs = self.lock();
        runs.closed = true;
        for (_, flag) in runs.by_job.values() {
            flag.raise(Stop::Shutdown);
        }
        self.changed.notify_all();
    }

    pub(super) fn is_closed(&self) -> bool {
        self.lock().closed
    }

    pub(super) fn is_idle_and_closed(&self) -> bool {
        let runs = self.lock();
        runs.closed && runs.by_job.is_empty()
    }

    pub(super) fn leases(&self) -> Vec<Lease> {
        self.lock()
            .by_job
            .values()
            .map(|(lease, _)| *lease)
            .collect()
    }

    /// Waits until a run ends or all are asked to stop, at most `time`.
    pub(super) fn wait_for_change(&self, time: Duration) {
        let runs = self.lock();
        if !(runs.closed && runs.by_job.is_empty()) {
            drop(self.changed.wait_timeout(runs, time));
        }
    }

    fn lock(&self) -> MutexGuard<'_, Runs> {
        self.runs.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
