//! What all calls share.

use super::forms::Forms;
use super::guard::Guard;
use super::metrics::Metrics;
use super::problem::Problem;
use crate::config::{Config, Limits};
use crate::job::{Catalogue, Queue};
use std::ops::Deref;
use std::sync::Arc;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// Connections that follow a job or wait for one, at most.
const FOLLOWERS: usize = 256;

/// A cheap handle on what all calls share.
#[derive(Clone)]
pub(super) struct App(Arc<Shared>);

/// What all calls share.
pub(super) struct Shared {
    /// Fits and studies.
    pub(super) queue: Arc<Queue>,
    /// Who may call.
    pub(super) guard: Guard,
    /// What was counted.
    pub(super) metrics: Metrics,
    /// Dress forms made lately.
    pub(super) forms: Forms,
    /// A seat for each computation that a call may wait for.
    seats: Arc<Semaphore>,
    followers: Arc<Semaphore>,
}

impl Deref for App {
    type Target = Shared;

    fn deref(&self) -> &Shared {
        &self.0
    }
}

impl Shared {
    /// Stored patterns, avatars and fabrics.
    pub(super) fn catalogue(&self) -> &Catalogue {
        self.queue.catalogue()
    }

    /// Bounds on what one input may ask for.
    pub(super) fn limits(&self) -> &Limits {
        self.queue.limits()
    }
}

impl App {
    pub(super) fn new(config: &Config, queue: Arc<Queue>) -> Self {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        Self(Arc::new(Shared {
            queue,
            guard: Guard::new(&config.hosts, &config.tokens),
            metrics: Metrics::default(),
            forms: Forms::default(),
            seats: Arc::new(Semaphore::new(cores)),
            followers: Arc::new(Semaphore::new(FOLLOWERS)),
        }))
    }

    /// Reads or writes the store, on a thread that may block.
    pub(super) async fn blocking<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Shared) -> T + Send + 'static,
    ) -> Result<T, Problem> {
        let shared = Arc::clone(&self.0);
        tokio::task::spawn_blocking(move || work(&shared))
            .await
            .map_err(Problem::internal)
    }

    /// Computes something, once one of as many seats as there are cores is free.
    pub(super) async fn heavy<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Shared) -> T + Send + 'static,
    ) -> Result<T, Problem> {
        let seat = Arc::clone(&self.0.seats).acquire_owned().await;
        // The seat goes with the work: a call that is given up leaves its work running.
        self.blocking(move |shared| {
            let _seat = seat;
            work(shared)
        })
        .await
    }

    /// A place among those who follow a job, while there is one.
    pub(super) fn follower(&self) -> Option<OwnedSemaphorePermit> {
        Arc::clone(&self.0.followers).try_acquire_owned().ok()
    }
}
