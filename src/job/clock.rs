//! Clocks: the CPU time of a job, and the time by which leases run out.

use rustix::time::{ClockId, clock_gettime};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Monotonic time by which leases run out.
pub trait Clock: Send + Sync {
    /// Returns the time since a fixed moment.
    fn now(&self) -> Duration;
}

/// The monotonic clock of the machine.
#[derive(Clone, Copy, Debug)]
pub struct SystemClock {
    start: Instant,
}

impl Default for SystemClock {
    fn default() -> Self {
        Self {
            start: Instant::now(),
        }
    }
}

impl Clock for SystemClock {
    fn now(&self) -> Duration {
        self.start.elapsed()
    }
}

/// A clock that stands still until a test moves it; its clones show the same time.
#[derive(Clone, Debug, Default)]
pub struct ManualClock {
    now: Arc<Mutex<Duration>>,
}

impl ManualClock {
    /// Moves the clock on.
    pub fn advance(&self, time: Duration) {
        *self.now.lock().unwrap_or_else(PoisonError::into_inner) += time;
    }
}

impl Clock for ManualClock {
    fn now(&self) -> Duration {
        *self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns the CPU time that this thread has used \[s\]: unlike the time of day it does not depend
/// on what else the machine does.
pub fn thread_cpu_s() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::try_from(time)
        .expect("a thread has used no negative time")
        .as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;

    #[test]
    fn work_counts_and_sleep_does_not() {
        let (began, clock) = (thread_cpu_s(), Instant::now());
        std::thread::sleep(Duration::from_millis(200));
        let slept = thread_cpu_s() - began;
        assert!(slept < 0.1 * clock.elapsed().as_secs_f64());
        let sum = (0..20_000_000_u64).fold(0, |sum, n| black_box(sum ^ n));
        black_box(sum);
        assert!(thread_cpu_s() - began > slept + 1e-3);
    }
}
