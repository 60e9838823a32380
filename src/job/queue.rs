//! Submits, finds, lists, cancels and follows jobs: what the service is built on. All calls but those of [`Events`] block.

use super::blobs::{Blobs, FileBlobs};
use super::catalogue::Catalogue;
use super::feed::{Event, Events, Feeds};
use super::record::{JobKind, JobRecord, Status};
use super::sqlite::SqliteStore;
use super::store::{
    Counts, Documents, IdempotencyKey, JobStore, NewJob, Notice, Page, PageAsked, StoreError,
    Submitted,
};
use super::work::{ResultFile, Work, asked_folder, asked_key};
use crate::config::{Config, Limits};
use jiff::Timestamp;
use std::sync::Arc;
use uuid::Uuid;

/// Why a job was not put on the queue.
#[derive(Debug, thiserror::Error)]
pub enum QueueError {
    /// Try again later.
    #[error("the queue is full: {0} jobs wait already")]
    Full(usize),
    /// The same key with another request.
    #[error("this Idempotency-Key was used before for another request")]
    KeyReused(JobKind),
    /// The service is at fault.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// The jobs of a service. Those of one kind are not found as the other.
pub struct Queue {
    pub(super) store: Arc<dyn JobStore>,
    pub(super) blobs: Arc<dyn Blobs>,
    pub(super) limits: Limits,
    catalogue: Arc<Catalogue>,
    feeds: Arc<Feeds>,
}

impl Queue {
    /// Opens the store that the settings name, in their data folder.
    ///
    /// # Errors
    /// If the folder cannot be used, or another process uses it.
    pub fn open(config: &Config) -> Result<Arc<Self>, StoreError> {
        let store = Arc::new(SqliteStore::open(&config.data)?);
        let blobs = Arc::new(FileBlobs::open(&config.data.join("blobs"))?);
        Self::new(store.clone(), store, blobs, config.limits.clone())
    }

    /// The jobs of a store.
    ///
    /// # Errors
    /// If no thread can be started.
    pub fn new(
        store: Arc<dyn JobStore>,
        documents: Arc<dyn Documents>,
        blobs: Arc<dyn Blobs>,
        limits: Limits,
    ) -> Result<Arc<Self>, StoreError> {
        let feeds = Arc::new(Feeds::default());
        let (notices, told) = (store.listen(), Arc::clone(&feeds));
        // Ends when the store is dropped.
        std::thread::Builder::new()
            .name("feeds".to_owned())
            .spawn(move || notices.iter().for_each(|notice| told.tell(notice)))
            .map_err(|cause| StoreError::new("starting a thread", cause))?;
        Ok(Arc::new(Self {
            store,
            blobs,
            limits,
            catalogue: Arc::new(Catalogue::new(documents)),
            feeds,
        }))
    }

    /// Stored patterns, avatars and fabrics.
    pub fn catalogue(&self) -> &Arc<Catalogue> {
        &self.catalogue
    }

    /// Bounds on what one input may ask for.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// The job that the same request was submitted as before, if it was.
    ///
    /// # Errors
    /// If the key was used for another request, or nothing could be read.
    pub fn submitted(
        &self,
        kind: JobKind,
        key: &IdempotencyKey,
    ) -> Result<Option<JobRecord>, QueueError> {
        match self.store.submitted(key)? {
            Some(Submitted::Same(id)) => self.same(kind, id).map(Some),
            Some(Submitted::KeyReused) => Err(QueueError::KeyReused(kind)),
            _ => Ok(None),
        }
    }

    /// The job that a key stands for. A request for another kind of job is another request.
    fn same(&self, kind: JobKind, id: Uuid) -> Result<JobRecord, QueueError> {
        self.job(kind, id)?.ok_or(QueueError::KeyReused(kind))
    }

    /// Puts work on the queue.
    ///
    /// # Errors
    /// If the queue is full, the key was used for another request, or nothing could be written.
    pub fn submit(
        &self,
        work: &Work,
        key: Option<&IdempotencyKey>,
    ) -> Result<JobRecord, QueueError> {
        let kind = work.kind();
        let record = JobRecord::queued(kind, Uuid::now_v7(), Timestamp::now());
        let body = work
            .json()
            .map_err(|cause| StoreError::new("writing what is asked", cause))?;
        self.blobs.put(&asked_key(kind, record.id), &body)?;
        let submitted = self.store.submit(&NewJob {
            record: &record,
            key,
            queue_limit: self.limits.queued_jobs,
        });
        if !matches!(submitted, Ok(Submitted::New)) {
            self.blobs.delete(&asked_folder(kind, record.id))?;
        }
        match submitted? {
            Submitted::New => {
                self.store.publish(Notice::Status(Box::new(record.clone())));
                Ok(record)
            }
            Submitted::Same(id) => self.same(kind, id),
            Submitted::KeyReused => Err(QueueError::KeyReused(kind)),
            Submitted::Full => Err(QueueError::Full(self.limits.queued_jobs)),
        }
    }

    /// What is known about a job of this kind, its latest progress included.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn job(&self, kind: JobKind, id: Uuid) -> Result<Option<JobRecord>, StoreError> {
        let found = self.stored(kind, id)?;
        Ok(found.map(|record| self.with_progress(record)))
    }

    fn stored(&self, kind: JobKind, id: Uuid) -> Result<Option<JobRecord>, StoreError> {
        Ok(self.store.job(id)?.filter(|record| record.kind == kind))
    }

    /// Jobs of a kind, newest first.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn jobs(&self, kind: JobKind, page: &PageAsked) -> Result<Page<JobRecord>, StoreError> {
        let page = self.store.jobs(kind, page)?;
        let items = page.items.into_iter();
        Ok(Page {
            items: items.map(|record| self.with_progress(record)).collect(),
            next: page.next,
        })
    }

    fn with_progress(&self, mut record: JobRecord) -> JobRecord {
        if let Some(progress) = self.feeds.latest(&record) {
            record.progress = progress;
        }
        record
    }

    /// Asks a job to stop, and returns what is then known about it: canceled at once if it waited, soon if it runs,
    /// unchanged if it has ended. `None` if there is no such job.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn cancel(&self, kind: JobKind, id: Uuid) -> Result<Option<JobRecord>, StoreError> {
        let changed = change(&*self.store, id, |record| {
            match record.status {
                _ if record.kind != kind => return false,
                Status::Queued => {
                    record.status = Status::Canceled;
                    record.finished_at = Some(Timestamp::now());
                }
                Status::Running if !record.cancel_requested => {}
                _ => return false,
            }
            record.cancel_requested = true;
            true
        })?;
        match changed {
            Changed::Yes(record) if record.status.is_final() => {
                self.store.publish(Notice::Status(record));
            }
            Changed::Yes(_) => self.store.publish(Notice::Cancel(id)),
            Changed::No => {}
        }
        self.job(kind, id)
    }

    /// The events of a job after event `after`, or from the first one kept. `None` if there is no such job.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn events(
        &self,
        kind: JobKind,
        id: Uuid,
        after: Option<u64>,
    ) -> Result<Option<Events>, StoreError> {
        // Followed before the record is read, so that an end that comes between the two is not missed.
        let events = self.feeds.follow(id, after);
        Ok(self.stored(kind, id)?.map(|record| {
            if !record.status.is_final() {
                return events.or_now(record, after);
            }
            let last = Event::last(record);
            Events::of((after < Some(last.id)).then_some(last))
        }))
    }

    /// What a job was asked as, complete in itself, in JSON. `None` if there is no such job.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn asked(&self, kind: JobKind, id: Uuid) -> Result<Option<Vec<u8>>, StoreError> {
        self.blobs.get(&asked_key(kind, id))
    }

    /// A file that a job left, in JSON. `None` while there is none.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn file(
        &self,
        record: &JobRecord,
        file: ResultFile,
    ) -> Result<Option<Vec<u8>>, StoreError> {
        match record.result {
            Some(attempt) => self.blobs.get(&file.key(record.id, attempt)),
            None => Ok(None),
        }
    }

    /// How many jobs of a kind there are of each status. Fails where the store cannot serve: the readiness probe.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn counts(&self, kind: JobKind) -> Result<Counts, StoreError> {
        self.store.counts(kind)
    }

    /// Ends the events of everyone who follows a job, so that open connections can end: for shutdown.
    pub fn close(&self) {
        self.feeds.close();
    }
}

/// Whether a record was changed.
pub(super) enum Changed {
    /// It is this now.
    Yes(Box<JobRecord>),
    /// There is none, or it was not to be changed.
    No,
}

/// Changes a record by compare-and-set, again until nobody was faster. `edit` says whether it wants the change.
///
/// # Errors
/// If nothing could be written.
pub(super) fn change(
    store: &dyn JobStore,
    id: Uuid,
    mut edit: impl FnMut(&mut JobRecord) -> bool,
) -> Result<Changed, StoreError> {
    loop {
        let Some(mut record) = store.job(id)? else {
            return Ok(Changed::No);
        };
        if !edit(&mut record) {
            return Ok(Changed::No);
        }
        if let Some(revision) = store.replace(&record)? {
            record.revision = revision;
            return Ok(Changed::Yes(Box::new(record)));
        }
    }
}
