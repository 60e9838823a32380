//! The leases of jobs, in memory: the store serves one process.

use crate::job::clock::Clock;
use crate::job::store::Lease;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use uuid::Uuid;

/// Live leases by job, each with its token and its end.
pub(super) struct Leases {
    /// Duration of a lease that is not renewed.
    pub(super) duration: Duration,
    clock: Arc<dyn Clock>,
    by_job: Mutex<HashMap<Uuid, (Uuid, Duration)>>,
}

impl Leases {
    /// Creates an empty set of leases that last `duration` each by `clock`.
    pub(super) fn new(duration: Duration, clock: Arc<dyn Clock>) -> Self {
        Self {
            duration,
            clock,
            by_job: Mutex::default(),
        }
    }

    /// Leases the first of `jobs` that nobody has a live lease on.
    pub(super) fn take(&self, jobs: impl IntoIterator<Item = Uuid>) -> Option<Lease> {
        let mut by_job = self.lock();
        let now = self.clock.now();
        by_job.retain(|_, (_, until)| *until > now);
        let job = jobs.into_iter().find(|job| !by_job.contains_key(job))?;
        let token = Uuid::now_v7();
        by_job.insert(job, (token, now + self.duration));
        Some(Lease { job, token })
    }

    /// Extends a live lease; returns false if it was no longer live.
    pub(super) fn renew(&self, lease: &Lease) -> bool {
        let now = self.clock.now();
        match self.lock().get_mut(&lease.job) {
            Some((token, until)) if *token == lease.token && *until > now => {
                *until = now + self.duration;
                true
            }
            _ => false,
        }
    }

    /// Ends a lease; returns true if it was still there.
    pub(super) fn end(&self, lease: &Lease) -> bool {
        let mut by_job = self.lock();
        let is_there = by_job
            .get(&lease.job)
            .is_some_and(|(token, _)| *token == lease.token);
        if is_there {
            by_job.remove(&lease.job);
        }
        is_there
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<Uuid, (Uuid, Duration)>> {
        self.by_job.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
