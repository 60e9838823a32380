//! Wakes sleeping workers; a ring between looking and sleeping is not missed.

use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

#[derive(Default)]
pub(super) struct Bell {
    rings: Mutex<u64>,
    rung: Condvar,
}

impl Bell {
    /// How often it was rung; to be asked before looking for work.
    pub(super) fn heard(&self) -> u64 {
        *self.rings.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn ring(&self) {
        *self.rings.lock().unwrap_or_else(PoisonError::into_inner) += 1;
        self.rung.notify_all();
    }

    /// Sleeps until it was rung more often than `heard`, at most `time`.
    pub(super) fn wait(&self, heard: u64, time: Duration) {
        let rings = self.rings.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self
            .rung
            .wait_timeout_while(rings, time, |rings| *rings == heard);
        drop(waited);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Instant;

    #[test]
    fn ring_before_the_wait_is_not_missed() {
        let bell = Bell::default();
        let heard = bell.heard();
        bell.ring();
        let start = Instant::now();
        bell.wait(heard, Duration::from_secs(60));
        assert!(start.elapsed() < Duration::from_secs(30));
    }
}
