//! Submits, finds, lists, cancels and follows jobs. All calls but those of [`JobEvents`] block.

use super::blobs::{Blobs, FileBlobs};
use super::catalogue::Catalogue;
use super::events::{EventFeeds, JobEvent, JobEvents};
use super::kind::JobKind;
use super::record::JobRecord;
use super::request::{JobRequest, request_folder, request_key};
use super::result::ResultFile;
use super::sqlite::SqliteStore;
use super::status::JobStatus;
use super::store::{
    Documents, IdempotencyKey, JobCounts, JobNotice, JobStore, NewJob, Page, PageRequest,
    StoreError, Submitted,
};
use crate::config::{Config, Limits};
use jiff::Timestamp;
use std::sync::Arc;
use uuid::Uuid;

/// The reason why a job was not put on the queue.
#[derive(Debug, thiserror::Error)]
pub enum QueueError {
    /// Too many jobs wait; try again later.
    #[error("the queue is full: {0} jobs wait already")]
    Full(usize),
    /// The key was used before for another request.
    #[error("this Idempotency-Key was used before for another request")]
    KeyReused(JobKind),
    /// The store failed.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// The jobs of a service. Those of one kind are not found as the other.
pub struct Queue {
    pub(super) store: Arc<dyn JobStore>,
    pub(super) blobs: Arc<dyn Blobs>,
    pub(super) limits: Limits,
    catalogue: Arc<Catalogue>,
    feeds: Arc<EventFeeds>,
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

    /// Creates the queue of a store.
    ///
    /// # Errors
    /// If no thread can be started.
    pub fn new(
        store: Arc<dyn JobStore>,
        documents: Arc<dyn Documents>,
        blobs: Arc<dyn Blobs>,
        limits: Limits,
    ) -> Result<Arc<Self>, StoreError> {
        let feeds = Arc::new(EventFeeds::default());
        let (notices, publisher) = (store.listen(), Arc::clone(&feeds));
        // Ends when the store is dropped.
        std::thread::Builder::new()
            .name("feeds".to_owned())
            .spawn(move || notices.iter().for_each(|notice| publisher.publish(notice)))
            .map_err(|cause| StoreError::new("starting a thread", cause))?;
        Ok(Arc::new(Self {
            store,
            blobs,
            limits,
            catalogue: Arc::new(Catalogue::new(documents)),
            feeds,
        }))
    }

    /// Returns the stored patterns, avatars and fabrics.
    pub fn catalogue(&self) -> &Arc<Catalogue> {
        &self.catalogue
    }

    /// Returns the bounds on what one input may ask for.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Returns the job that the same request was submitted as before, if it was.
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

    /// Returns the job that a key stands for. A request for another kind of job is another request.
    fn same(&self, kind: JobKind, id: Uuid) -> Result<JobRecord, QueueError> {
        self.job(kind, id)?.ok_or(QueueError::KeyReused(kind))
    }

    /// Puts a request on the queue.
    ///
    /// # Errors
    /// If the queue is full, the key was used for another request, or nothing could be written.
    pub fn submit(
        &self,
        request: &JobRequest,
        key: Option<&IdempotencyKey>,
    ) -> Result<JobRecord, QueueError> {
        let kind = request.kind();
        let record = JobRecord::queued(kind, Uuid::now_v7(), Timestamp::now());
        let body = request
            .json()
            .map_err(|cause| StoreError::of_data("writing what is asked", cause))?;
        let kept = self.blobs.put(&request_key(kind, record.id), &body);
        let submitted = kept.and_then(|()| {
            self.store.submit(&NewJob {
                record: &record,
                key,
                queue_limit: self.limits.queued_jobs,
            })
        });
        if !matches!(submitted, Ok(Submitted::New)) {
            self.blobs.delete(&request_folder(kind, record.id))?;
        }
        match submitted? {
            Submitted::New => {
                self.store
                    .publish(JobNotice::Status(Box::new(record.clone())));
                Ok(record)
            }
            Submitted::Same(id) => self.same(kind, id),
            Submitted::KeyReused => Err(QueueError::KeyReused(kind)),
            Submitted::Full => Err(QueueError::Full(self.limits.queued_jobs)),
        }
    }

    /// Returns the record of a job of this kind, its latest progress included.
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

    /// Returns the jobs of a kind, newest first.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn jobs(&self, kind: JobKind, page: &PageRequest) -> Result<Page<JobRecord>, StoreError> {
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

    /// Asks a job to stop, and returns its record after that: canceled at once if it waited, soon
    /// if it runs, unchanged if it has ended. `None` if there is no such job.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn cancel(&self, kind: JobKind, id: Uuid) -> Result<Option<JobRecord>, StoreError> {
        let changed = update_record(&*self.store, id, |record| {
            match record.status {
                _ if record.kind != kind => return false,
                JobStatus::Queued => {
                    record.status = JobStatus::Canceled;
                    record.finished_at = Some(Timestamp::now());
                }
                JobStatus::Running if !record.cancel_requested => {}
                _ => return false,
            }
            record.cancel_requested = true;
            true
        })?;
        if let RecordUpdate::Changed(record) = changed {
            // Of one that is queued too: a worker may have it and wait for another job to end.
            self.store.publish(JobNotice::Cancel(id));
            if record.status.is_final() {
                self.store.publish(JobNotice::Status(record));
            }
        }
        self.job(kind, id)
    }

    /// Returns the events of a job after event `after`, or from the first one kept. `None` if there
    /// is no such job.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn events(
        &self,
        kind: JobKind,
        id: Uuid,
        after: Option<u64>,
    ) -> Result<Option<JobEvents>, StoreError> {
        // Followed before the record is read, so that an end that comes between the two is not
        // missed.
        let events = self.feeds.follow(id, after);
        Ok(self.stored(kind, id)?.map(|record| {
            if !record.status.is_final() {
                return events.or_current(record, after);
            }
            let last = JobEvent::last(record);
            JobEvents::of((after < Some(last.id)).then_some(last))
        }))
    }

    /// Returns the request of a job, complete in itself, in JSON. `None` if there is no such job.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn request(&self, kind: JobKind, id: Uuid) -> Result<Option<Vec<u8>>, StoreError> {
        self.blobs.get(&request_key(kind, id))
    }

    /// Returns a file that a job left, in JSON. `None` while there is none.
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

    /// Checks that jobs can be kept and found now: the readiness probe. A full queue is no reason
    /// against it.
    ///
    /// # Errors
    /// If nothing could be written or read.
    pub fn probe(&self) -> Result<(), StoreError> {
        self.blobs.probe()?;
        self.store.probe()
    }

    /// Counts the jobs of a kind by status.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn counts(&self, kind: JobKind) -> Result<JobCounts, StoreError> {
        self.store.counts(kind)
    }

    /// Ends the events of everyone who follows a job, so that open connections can end: for
    /// shutdown.
    pub fn close(&self) {
        self.feeds.close();
    }
}

/// The result of an update of a record.
pub(super) enum RecordUpdate {
    /// The record after the change.
    Changed(Box<JobRecord>),
    /// There is no such record, or the edit did not want to change it.
    Unchanged,
}

/// Changes a record by compare-and-set, repeated until nobody was faster. `edit` returns false to
/// leave it as it is.
///
/// # Errors
/// If nothing could be written.
pub(super) fn update_record(
    store: &dyn JobStore,
    id: Uuid,
    mut edit: impl FnMut(&mut JobRecord) -> bool,
) -> Result<RecordUpdate, StoreError> {
    loop {
        let Some(mut record) = store.job(id)? else {
            return Ok(RecordUpdate::Unchanged);
        };
        if !edit(&mut record) {
            return Ok(RecordUpdate::Unchanged);
        }
        if let Some(revision) = store.replace(&record)? {
            record.revision = revision;
            return Ok(RecordUpdate::Changed(Box::new(record)));
        }
    }
}
