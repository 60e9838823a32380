//! The state that all handlers share.

use super::connection::ByteBudget;
use super::middleware::{AccessPolicy, RequestMetrics};
use super::readiness::Readiness;
use super::respond::Problem;
use crate::config::{Config, Limits};
use crate::job::{Catalogue, Queue};
use std::ops::Deref;
use std::sync::Arc;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// Most files of the store that are read whole at the same time; each is held in memory meanwhile.
const FILES: usize = 4;
/// Memory that one permit stands for \[bytes\].
const MEMORY_UNIT: usize = 64 << 10;

/// Returns the number of permits for so many bytes.
fn memory_units(bytes: usize) -> usize {
    bytes.div_ceil(MEMORY_UNIT)
}

/// A cheap handle on the state that all handlers share.
#[derive(Clone)]
pub(super) struct AppState(Arc<App>);

/// The state that all handlers share.
pub(super) struct App {
    /// Fits and studies.
    pub(super) queue: Arc<Queue>,
    /// The hosts and tokens that requests are accepted with.
    pub(super) access: AccessPolicy,
    /// Counts of requests.
    pub(super) metrics: RequestMetrics,
    /// The last look at the store.
    pub(super) readiness: Readiness,
    /// A permit for each computation that a request may wait for.
    compute_permits: Arc<Semaphore>,
    /// A permit for each file of the store that is read whole.
    file_permits: Arc<Semaphore>,
    /// A permit for each request that is worked on.
    request_permits: Arc<Semaphore>,
    /// Bytes of bodies in flight.
    pub(super) uploads: ByteBudget,
    /// Bytes of answers in flight.
    pub(super) answers: ByteBudget,
    /// A permit for each request that follows a job or waits for its end.
    stream_permits: Arc<Semaphore>,
    /// A permit for every [`MEMORY_UNIT`] that JSON may take while it is read.
    json_memory: Arc<Semaphore>,
}

impl Deref for AppState {
    type Target = App;

    fn deref(&self) -> &App {
        &self.0
    }
}

impl App {
    /// Returns the stored patterns, avatars and fabrics.
    pub(super) fn catalogue(&self) -> &Catalogue {
        self.queue.catalogue()
    }

    /// Returns the bounds on what one input may ask for.
    pub(super) fn limits(&self) -> &Limits {
        self.queue.limits()
    }
}

impl AppState {
    /// Creates the state of a service with these settings and this queue.
    pub(super) fn new(config: &Config, queue: Arc<Queue>) -> Self {
        let limits = queue.limits();
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        Self(Arc::new(App {
            access: AccessPolicy::new(&config.hosts, &config.tokens),
            metrics: RequestMetrics::default(),
            readiness: Readiness::default(),
            compute_permits: Arc::new(Semaphore::new(cores)),
            file_permits: Arc::new(Semaphore::new(FILES)),
            request_permits: Arc::new(Semaphore::new(limits.requests)),
            uploads: ByteBudget::new(limits.upload_bytes_in_flight),
            answers: ByteBudget::new(limits.answer_bytes_in_flight),
            stream_permits: Arc::new(Semaphore::new(limits.streams)),
            json_memory: Arc::new(Semaphore::new(memory_units(limits.json_memory_bytes))),
            queue,
        }))
    }

    /// Creates the state of a service with these bounds, in a folder of a test.
    #[cfg(test)]
    pub(super) fn of_test(folder: &std::path::Path, limits: Limits) -> Self {
        let config = Config {
            listen: ([127, 0, 0, 1], 0).into(),
            data: folder.to_owned(),
            store: crate::config::StoreKind::Sqlite,
            blobs: crate::config::BlobKind::File,
            workers: None,
            tokens: vec![],
            hosts: vec![],
            limits,
        };
        let queue = Queue::open(&config).expect("a folder of a test can be written");
        Self::new(&config, queue)
    }

    /// Runs work that reads or writes the store on a thread that may block, unless the service has
    /// as many requests as it can work on.
    pub(super) async fn run_blocking<T: Send + 'static>(
        &self,
        work: impl FnOnce(&App) -> T + Send + 'static,
    ) -> Result<T, Problem> {
        let permit = self.request_permit()?;
        self.run_unbounded(move |app| {
            let _permit = permit;
            work(app)
        })
        .await
    }

    /// Runs work on a thread that may block, however many requests there are.
    pub(super) async fn run_unbounded<T: Send + 'static>(
        &self,
        work: impl FnOnce(&App) -> T + Send + 'static,
    ) -> Result<T, Problem> {
        let app = Arc::clone(&self.0);
        // What the work logs belongs to its request.
        let span = tracing::Span::current();
        tokio::task::spawn_blocking(move || span.in_scope(|| work(&app)))
            .await
            .map_err(Problem::internal)
    }

    /// Runs a computation on a thread of its own, once one of as many permits as there are cores is
    /// free.
    pub(super) async fn run_compute<T: Send + 'static>(
        &self,
        work: impl FnOnce(&App) -> T + Send + 'static,
    ) -> Result<T, Problem> {
        self.run_permitted(&self.0.compute_permits, work).await
    }

    /// Reads a file of the store, once one of the permits to hold a whole one is free.
    pub(super) async fn run_reading<T: Send + 'static>(
        &self,
        work: impl FnOnce(&App) -> T + Send + 'static,
    ) -> Result<T, Problem> {
        self.run_permitted(&self.0.file_permits, work).await
    }

    async fn run_permitted<T: Send + 'static>(
        &self,
        permits: &Arc<Semaphore>,
        work: impl FnOnce(&App) -> T + Send + 'static,
    ) -> Result<T, Problem> {
        let request = self.request_permit()?;
        let permit = Arc::clone(permits).acquire_owned().await;
        // The permits go with the work: a request that is given up leaves its work running.
        self.run_unbounded(move |app| {
            let _permits = (request, permit);
            work(app)
        })
        .await
    }

    /// Returns a permit to work on a request, while there is one.
    fn request_permit(&self) -> Result<OwnedSemaphorePermit, Problem> {
        let permits = Arc::clone(&self.0.request_permits);
        permits
            .try_acquire_owned()
            .map_err(|_| Problem::overloaded())
    }

    /// Waits until so much memory is free for JSON that is to be read, and takes it; `bytes` are at
    /// most those of [`Limits::json_memory_bytes`].
    pub(super) async fn json_memory(&self, bytes: usize) -> Option<OwnedSemaphorePermit> {
        let units = u32::try_from(memory_units(bytes)).unwrap_or(u32::MAX);
        let permits = Arc::clone(&self.0.json_memory);
        permits.acquire_many_owned(units).await.ok()
    }

    /// Returns a permit to follow a job or to wait for one, while there is one.
    pub(super) fn stream_permit(&self) -> Option<OwnedSemaphorePermit> {
        Arc::clone(&self.0.stream_permits).try_acquire_owned().ok()
    }
}
