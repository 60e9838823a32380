//! Who may run which fit, in memory: the store serves one process.

use crate::job::store::Lease;
use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use uuid::Uuid;

/// The live leases, each until a moment.
pub(super) struct Leases {
    pub(super) time: Duration,
    by_fit: Mutex<HashMap<Uuid, (Uuid, Instant)>>,
}

impl Leases {
    pub(super) fn lasting(time: Duration) -> Self {
        Self {
            time,
            by_fit: Mutex::default(),
        }
    }

    /// Leases the first of `fits` that nobody has a live lease on.
    pub(super) fn take(&self, fits: impl IntoIterator<Item = Uuid>) -> Option<Lease> {
        let mut by_fit = self.lock();
        let now = Instant::now();
        by_fit.retain(|_, (_, until)| *until > now);
        let fit = fits.into_iter().find(|fit| !by_fit.contains_key(fit))?;
        let token = Uuid::now_v7();
        by_fit.insert(fit, (token, now + self.time));
        Some(Lease { fit, token })
    }

    /// Makes a live lease last longer; says whether it was live.
    pub(super) fn renew(&self, lease: &Lease) -> bool {
        let now = Instant::now();
        match self.lock().get_mut(&lease.fit) {
            Some((token, until)) if *token == lease.token && *until > now => {
                *until = now + self.time;
                true
            }
            _ => false,
        }
    }

    /// Ends a lease; says whether it was still there.
    pub(super) fn end(&self, lease: &Lease) -> bool {
        let mut by_fit = self.lock();
        let is_there = by_fit
            .get(&lease.fit)
            .is_some_and(|(token, _)| *token == lease.token);
        if is_there {
            by_fit.remove(&lease.fit);
        }
        is_there
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<Uuid, (Uuid, Instant)>> {
        self.by_fit.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
