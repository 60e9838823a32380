//! The threads of a pool: started, woken, stopped.

use super::active_runs::{ActiveRuns, StopReason};
use super::attempt;
use super::context::{RETRY_DELAY, WorkerContext};
use super::run_permits::RunPermits;
use super::runner::Runner;
use super::wake_signal::WakeSignal;
use crate::job::queue::Queue;
use crate::job::store::{JobNotice, StoreError};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

/// Time after which an idle worker looks at the queue without a notice: notices may get lost, and
/// leases run out without one.
const POLL_INTERVAL: Duration = Duration::from_secs(5);
/// Renewals in the time of one lease.
const RENEWALS: u32 = 5;
/// Stack of a worker \[bytes\]: nested factorizations and a deep bounding-volume tree fit many
/// times.
const STACK: usize = 16 << 20;

/// Threads that take jobs from a queue and run them, one at a time each.
///
/// Beside the workers, one thread renews the leases, and one hears of cancellations; work on the
/// workers cannot hold them up.
pub struct WorkerPool {
    context: Arc<WorkerContext>,
    workers: Vec<JoinHandle<()>>,
    helpers: Vec<JoinHandle<()>>,
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
        let context = Arc::new(WorkerContext {
            queue: Arc::clone(queue),
            runner: Box::new(runner),
            active_runs: ActiveRuns::default(),
            run_permits: RunPermits::default(),
            wake_signal: WakeSignal::default(),
        });
        // Listens before any worker looks at the queue, so that no cancellation is missed.
        let notices = queue.store.listen();
        let listen = move |context: &WorkerContext| handle_notices(context, &notices);
        let helpers = vec![
            spawn("leases", &context, renew_leases)?,
            spawn("notices", &context, listen)?,
        ];
        let workers = (0..count)
            .map(|index| spawn(&format!("worker-{index}"), &context, run_jobs))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            context,
            workers,
            helpers,
        })
    }

    /// Stops taking jobs, gives running ones back to the queue and waits for the workers, at most
    /// `patience`.
    ///
    /// A run that does not stop in that time is left behind: the next start finds its job.
    pub fn shutdown(self, patience: Duration) {
        self.context.active_runs.close();
        self.context.wake_signal.notify_all();
        // Wakes the thread that listens.
        self.context.queue.store.publish(JobNotice::Queued);
        let deadline = Instant::now() + patience;
        while is_any_alive(&self.workers) || is_any_alive(&self.helpers) {
            if Instant::now() > deadline {
                tracing::warn!("a job did not stop in time and is left behind");
                return;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

fn is_any_alive(threads: &[JoinHandle<()>]) -> bool {
    threads.iter().any(|thread| !thread.is_finished())
}

fn spawn(
    name: &str,
    context: &Arc<WorkerContext>,
    work: impl FnOnce(&WorkerContext) + Send + 'static,
) -> Result<JoinHandle<()>, StoreError> {
    let context = Arc::clone(context);
    Builder::new()
        .name(name.to_owned())
        .stack_size(STACK)
        .spawn(move || work(&context))
        .map_err(|cause| StoreError::new("starting a thread", cause))
}

/// Takes jobs one after the other until the pool is shut down.
fn run_jobs(context: &WorkerContext) {
    loop {
        // Read before the queue: a job that comes after the look at the queue still wakes this
        // worker.
        let seen = context.wake_signal.generation();
        if context.active_runs.is_closed() {
            return;
        }
        match context.queue.store.claim() {
            Ok(Some(lease)) => attempt::run(context, lease),
            Ok(None) => context.wake_signal.wait(seen, POLL_INTERVAL),
            Err(error) => {
                tracing::error!(%error, "the queue cannot be read");
                context.wake_signal.wait(seen, RETRY_DELAY);
            }
        }
    }
}

/// Renews the leases of all runs until the last one has ended. Also finds a cancellation whose
/// notice was lost.
fn renew_leases(context: &WorkerContext) {
    let store = &context.queue.store;
    let interval = store.lease_time() / RENEWALS;
    while !context.active_runs.is_finished() {
        for lease in context.active_runs.leases() {
            match store.renew(&lease) {
                Ok(true) => {}
                Ok(false) => context.active_runs.stop(lease.job, StopReason::LeaseLost),
                Err(error) => {
                    tracing::error!(%error, job = %lease.job, "its lease is not renewed");
                }
            }
            if let Ok(Some(record)) = store.job(lease.job)
                && record.cancel_requested
            {
                context.active_runs.stop(lease.job, StopReason::Canceled);
            }
        }
        context.active_runs.wait_for_change(interval);
    }
}

/// Wakes workers and stops runs as notices tell.
fn handle_notices(context: &WorkerContext, notices: &Receiver<JobNotice>) {
    while !context.active_runs.is_closed() {
        match notices.recv_timeout(POLL_INTERVAL) {
            Ok(JobNotice::Queued) => context.wake_signal.notify_all(),
            Ok(JobNotice::Cancel(job)) => context.active_runs.stop(job, StopReason::Canceled),
            Ok(_) | Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}
