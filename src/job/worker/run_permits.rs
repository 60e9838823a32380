//! Permits to run: no job runs beside one that has a process of its own.

use super::active_runs::StopFlag;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Time between two looks at whether a job that waits for its permit was asked to stop.
const POLL_INTERVAL: Duration = Duration::from_millis(50);

/// The permits of a pool: one for a job in a process of its own, or any number for the others.
#[derive(Default)]
pub(super) struct RunPermits {
    usage: Mutex<PermitUsage>,
    changed: Condvar,
}

/// The permits that are out, and those that are waited for.
#[derive(Default)]
struct PermitUsage {
    shared: usize,
    isolated_running: bool,
    isolated_waiting: usize,
}

impl PermitUsage {
    /// Returns true if a job may run now. One in a process of its own that waits goes first, else
    /// others that come and go would keep it waiting for ever.
    fn is_free(&self, is_isolated: bool) -> bool {
        if is_isolated {
            !self.isolated_running && self.shared == 0
        } else {
            !self.isolated_running && self.isolated_waiting == 0
        }
    }
}

impl RunPermits {
    /// Waits until a job may run, alone if it is isolated. Returns `None` once it is asked to stop.
    pub(super) fn acquire(&self, is_isolated: bool, flag: &StopFlag) -> Option<RunPermit<'_>> {
        let mut usage = self.lock();
        usage.isolated_waiting += usize::from(is_isolated);
        while !usage.is_free(is_isolated) && flag.reason().is_none() {
            let waited = self.changed.wait_timeout(usage, POLL_INTERVAL);
            usage = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        usage.isolated_waiting -= usize::from(is_isolated);
        if flag.reason().is_some() {
            // Others that would have waited for it to run.
            self.changed.notify_all();
            return None;
        }
        if is_isolated {
            usage.isolated_running = true;
        } else {
            usage.shared += 1;
        }
        Some(RunPermit {
            permits: self,
            is_isolated,
        })
    }

    fn lock(&self) -> MutexGuard<'_, PermitUsage> {
        self.usage.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The permit of a job to run, until it is dropped.
pub(super) struct RunPermit<'a> {
    permits: &'a RunPermits,
    is_isolated: bool,
}

impl Drop for RunPermit<'_> {
    fn drop(&mut self) {
        let mut usage = self.permits.lock();
        if self.is_isolated {
            usage.isolated_running = false;
        } else {
            usage.shared -= 1;
        }
        self.permits.changed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::store::Lease;
    use crate::job::worker::active_runs::{ActiveRuns, StopReason};
    use std::sync::mpsc::channel;
    use std::thread::{scope, sleep};
    use std::time::Instant;
    use uuid::Uuid;

    /// Far more than a thread takes to begin on a busy machine.
    const TIMEOUT: Duration = Duration::from_secs(60);

    fn acquire(permits: &RunPermits, is_isolated: bool) -> RunPermit<'_> {
        let permit = permits.acquire(is_isolated, &StopFlag::default());
        permit.expect("nobody asks it to stop")
    }

    fn wait_until(is_so: impl Fn() -> bool) {
        let deadline = Instant::now() + TIMEOUT;
        while !is_so() {
            assert!(Instant::now() < deadline, "not in {TIMEOUT:?}");
            sleep(Duration::from_millis(1));
        }
    }

    #[test]
    fn an_isolated_job_runs_alone_and_before_those_that_come_later() {
        let permits = RunPermits::default();
        let shared = [acquire(&permits, false), acquire(&permits, false)];
        scope(|scope| {
            let isolated = scope.spawn(|| acquire(&permits, true));
            wait_until(|| permits.lock().isolated_waiting == 1);
            assert!(!permits.lock().is_free(true), "two others run");
            assert!(!permits.lock().is_free(false), "it goes first");
            drop(shared);
            let isolated = isolated.join().unwrap();
            assert!(!permits.lock().is_free(true), "one runs");
            assert!(!permits.lock().is_free(false), "it runs alone");
            drop(isolated);
        });
        assert!(permits.lock().is_free(true) && permits.lock().is_free(false));
    }

    /// Asserts that a job that waits for the permit of another one waits no more once `stop` asks
    /// it to stop.
    fn assert_stops_waiting(is_isolated: bool, stop: impl FnOnce(&ActiveRuns, Uuid)) {
        let (permits, runs) = (RunPermits::default(), ActiveRuns::default());
        let other = acquire(&permits, true);
        let lease = Lease {
            job: Uuid::now_v7(),
            token: Uuid::now_v7(),
        };
        let flag = runs.register(lease);
        let (sender, receiver) = channel();
        scope(|scope| {
            let permits = &permits;
            scope.spawn(move || sender.send(permits.acquire(is_isolated, &flag).is_some()));
            let waited = receiver.recv_timeout(Duration::from_millis(200));
            stop(&runs, lease.job);
            let ended = receiver.recv_timeout(TIMEOUT);
            // Before any assertion: the thread must end for the test to fail.
            drop(other);
            assert!(waited.is_err(), "it waits");
            assert_eq!(ended, Ok(false));
        });
        let usage = permits.lock();
        assert!(
            usage.is_free(true) && usage.is_free(false),
            "nothing is left of it"
        );
    }

    #[test]
    fn a_canceled_job_waits_no_longer() {
        for is_isolated in [false, true] {
            assert_stops_waiting(is_isolated, |runs, job| {
                runs.stop(job, StopReason::Canceled);
            });
        }
    }

    #[test]
    fn at_shutdown_no_job_waits_any_longer() {
        for is_isolated in [false, true] {
            assert_stops_waiting(is_isolated, |runs, _| runs.close());
        }
    }
}
