//! Threads that take jobs from the store and run them.

mod attempt;
mod bell;
mod ending;
mod runner;
mod running;

pub use runner::{Runner, Sewing};

use super::queue::Queue;
use super::store::{Notice, StoreError};
use bell::Bell;
use running::{Running, Stop};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

/// How often an idle worker looks at the queue unasked: notices may get lost, and leases run out without one.
const POLL: Duration = Duration::from_secs(5);
/// How long a worker waits after the store failed.
const PAUSE: Duration = Duration::from_secs(1);
/// Renewals in the time of one lease.
const RENEWALS: u32 = 5;
/// Stack of a worker \[bytes\]: nested factorisations and a deep bounding-volume tree fit many times.
const STACK: usize = 16 << 20;

/// Threads that take jobs from a queue and run them, one at a time each.
///
/// Beside the workers, one thread renews the leases, and one hears of cancelling; work on the workers cannot hold them up.
pub struct WorkerPool {
    shared: Arc<Shared>,
    workers: Vec<JoinHandle<()>>,
    helpers: Vec<JoinHandle<()>>,
}

/// What the threads of a pool share.
struct Shared {
    queue: Arc<Queue>,
    runner: Box<dyn Runner>,
    running: Running,
    bell: Bell,
}

impl WorkerPool {
    /// Starts `count` workers.
    ///
    /// # Errors
    /// If no thread can be started.
    pub fn start(
        queue: &Arc<Queue>,
        runner: impl Runner,
        count: usize,
    ) -> Result<Self, StoreError> {
        let shared = Arc::new(Shared {
            queue: Arc::clone(queue),
            runner: Box::new(runner),
            running: Running::default(),
            bell: Bell::default(),
        });
        // Listens before any worker looks at the queue, so that no cancelling is missed.
        let notices = queue.store.listen();
        let helpers = vec![
            spawn("leases", &shared, Shared::renew_leases)?,
            spawn("notices", &shared, move |shared| shared.hear(&notices))?,
        ];
        let workers = (0..count)
            .map(|index| spawn(&format!("worker-{index}"), &shared, Shared::work))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            shared,
            workers,
            helpers,
        })
    }

    /// Stops taking jobs, gives running ones back to the queue and waits for the workers, at most `patience`.
    ///
    /// A run that does not stop in that time is left behind: the next start finds its job.
    pub fn shutdown(self, patience: Duration) {
        self.shared.running.close();
        self.shared.bell.ring();
        // Wakes the thread that listens.
        self.shared.queue.store.publish(Notice::Queued);
        let deadline = Instant::now() + patience;
        let is_busy = |threads: &[JoinHandle<()>]| threads.iter().any(|one| !one.is_finished());
        while is_busy(&self.workers) || is_busy(&self.helpers) {
            if Instant::now() > deadline {
                tracing::warn!("a job did not stop in time and is left behind");
                return;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

fn spawn(
    name: &str,
    shared: &Arc<Shared>,
    work: impl FnOnce(&Shared) + Send + 'static,
) -> Result<JoinHandle<()>, StoreError> {
    let shared = Arc::clone(shared);
    Builder::new()
        .name(name.to_owned())
        .stack_size(STACK)
        .spawn(move || work(&shared))
        .map_err(|cause| StoreError::new("starting a thread", cause))
}

impl Shared {
    /// Takes jobs one after the other until the pool is shut down.
    fn work(&self) {
        loop {
            // Before the queue is looked at: a job that comes after that look still wakes this worker.
            let heard = self.bell.heard();
            if self.running.is_closed() {
                return;
            }
            match self.queue.store.claim() {
                Ok(Some(lease)) => self.run(lease),
                Ok(None) => self.bell.wait(heard, POLL),
                Err(error) => {
                    tracing::error!(%error, "the queue cannot be read");
                    self.bell.wait(heard, PAUSE);
                }
            }
        }
    }

    /// Renews the leases of what runs. Also finds a cancelling whose notice was lost.
    fn renew_leases(&self) {
        let store = &self.queue.store;
        let between = store.lease_time() / RENEWALS;
        while !self.running.is_idle_and_closed() {
            for lease in self.running.leases() {
                match store.renew(&lease) {
                    Ok(true) => {}
                    Ok(false) => self.running.stop(lease.job, Stop::Lost),
                    Err(error) => {
                        tracing::error!(%error, job = %lease.job, "its lease is not renewed");
                    }
                }
                if let Ok(Some(record)) = store.job(lease.job)
                    && record.cancel_requested
                {
                    self.running.stop(lease.job, Stop::Canceled);
                }
            }
            self.running.wait_for_change(between);
        }
    }

    /// Wakes workers and stops runs as notices tell.
    fn hear(&self, notices: &Receiver<Notice>) {
        while !self.running.is_closed() {
            match notices.recv_timeout(POLL) {
                Ok(Notice::Queued) => self.bell.ring(),
                Ok(Notice::Cancel(job)) => self.running.stop(job, Stop::Canceled),
                Ok(_) | Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
    }
}
