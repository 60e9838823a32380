//! Wakes idle workers; a signal between looking for work and waiting is not missed.

use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// A counter of signals that threads can wait on.
#[derive(Default)]
pub(super) struct WakeSignal {
    generation: Mutex<u64>,
    changed: Condvar,
}

impl WakeSignal {
    /// Returns the number of signals so far; to be read before looking for work.
    pub(super) fn generation(&self) -> u64 {
        *self
            .generation
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// Wakes every thread that waits.
    pub(super) fn notify_all(&self) {
        *self
            .generation
            .lock()
            .unwrap_or_else(PoisonError::into_inner) += 1;
        self.changed.notify_all();
    }

    /// Waits for a signal later than generation `seen`, at most `timeout`.
    pub(super) fn wait(&self, seen: u64, timeout: Duration) {
        let generation = self
            .generation
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let waited = self
            .changed
            .wait_timeout_while(generation, timeout, |generation| *generation == seen);
        drop(waited);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Instant;

    #[test]
    fn signal_before_the_wait_is_not_missed() {
        let signal = WakeSignal::default();
        let seen = signal.generation();
        signal.notify_all();
        let start = Instant::now();
        signal.wait(seen, Duration::from_secs(60));
        assert!(start.elapsed() < Duration::from_secs(30));
    }
}
