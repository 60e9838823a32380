//! The turn of a job: none runs beside one that has a process of its own.

use std::sync::{PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};

/// The right of a job to run, until it is dropped.
pub(super) enum Turn<'a> {
    /// With no other job beside it.
    Isolated { _guard: RwLockWriteGuard<'a, ()> },
    /// With others beside it.
    Shared { _guard: RwLockReadGuard<'a, ()> },
}

impl<'a> Turn<'a> {
    /// Waits until a job may run.
    pub(super) fn wait(isolation: &'a RwLock<()>, is_isolated: bool) -> Self {
        // A lock whose holder panicked is as good as any: it guards no data.
        if is_isolated {
            let guard = isolation.write();
            Self::Isolated {
                _guard: guard.unwrap_or_else(PoisonError::into_inner),
            }
        } else {
            let guard = isolation.read();
            Self::Shared {
                _guard: guard.unwrap_or_else(PoisonError::into_inner),
            }
        }
    }
}
