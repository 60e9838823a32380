//! Submits, finds, lists, cancels and follows fits: what the service is built on. All calls but those of [`Events`] block.

use super::blobs::{Blobs, FileBlobs};
use super::catalogue::Catalogue;
use super::feed::{Event, Events, Feeds};
use super::record::{FitRecord, Status};
use super::sqlite::SqliteStore;
use super::store::{
    Counts, Documents, IdempotencyKey, JobStore, NewFit, Notice, Page, PageAsked, StoreError,
    Submitted,
};
use crate::config::{Config, Limits};
use crate::fit::Garment;
use jiff::Timestamp;
use std::sync::Arc;
use uuid::Uuid;

/// Why a fit was not put on the queue.
#[derive(Debug, thiserror::Error)]
pub enum QueueError {
    /// Try again later.
    #[error("the queue is full: {0} fits wait already")]
    Full(usize),
    /// The same key with another request.
    #[error("this Idempotency-Key was used before for another request")]
    KeyReused,
    /// The service is at fault.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// A file that a fit leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultFile {
    /// `export::GarmentMesh`.
    Mesh,
    /// `solver::Report`.
    Report,
}

impl ResultFile {
    pub(super) fn key(self, fit: Uuid, attempt: u32) -> String {
        let name = match self {
            Self::Mesh => "mesh",
            Self::Report => "report",
        };
        format!("{}/{name}.json", results(fit, attempt))
    }
}

/// Where one attempt of a fit leaves its files.
pub(super) fn results(fit: Uuid, attempt: u32) -> String {
    format!("results/{fit}/{attempt}")
}

/// Where the garment of a fit is.
pub(super) fn garment_key(fit: Uuid) -> String {
    format!("garments/{fit}/garment.json")
}

/// The fits of a service.
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

    /// The fits of a store.
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

    /// The fit that the same request was submitted as before, if it was.
    ///
    /// # Errors
    /// If the key was used for another request, or nothing could be read.
    pub fn submitted(&self, key: &IdempotencyKey) -> Result<Option<FitRecord>, QueueError> {
        match self.store.submitted(key)? {
            Some(Submitted::Same(id)) => Ok(self.fit(id)?),
            Some(Submitted::KeyReused) => Err(QueueError::KeyReused),
            _ => Ok(None),
        }
    }

    /// Puts a fit on the queue. The garment is complete in itself, as `fit::prepare` leaves it.
    ///
    /// # Errors
    /// If the queue is full, the key was used for another request, or nothing could be written.
    pub fn submit(
        &self,
        garment: &Garment,
        key: Option<&IdempotencyKey>,
    ) -> Result<FitRecord, QueueError> {
        let record = FitRecord::queued(Uuid::now_v7(), Timestamp::now());
        let body = serde_json::to_vec(garment)
            .map_err(|cause| StoreError::new("writing the garment", cause))?;
        self.blobs.put(&garment_key(record.id), &body)?;
        let submitted = self.store.submit(&NewFit {
            record: &record,
            key,
            queue_limit: self.limits.queued_fits,
        });
        if !matches!(submitted, Ok(Submitted::New)) {
            self.blobs.delete(&format!("garments/{}", record.id))?;
        }
        match submitted? {
            Submitted::New => {
                self.store.publish(Notice::Status(Box::new(record.clone())));
                Ok(record)
            }
            Submitted::Same(id) => {
                let same = self.fit(id)?;
                Ok(same.ok_or_else(|| StoreError::new("reading a fit", "its record is gone"))?)
            }
            Submitted::KeyReused => Err(QueueError::KeyReused),
            Submitted::Full => Err(QueueError::Full(self.limits.queued_fits)),
        }
    }

    /// What is known about a fit, its latest progress included.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn fit(&self, id: Uuid) -> Result<Option<FitRecord>, StoreError> {
        Ok(self.store.fit(id)?.map(|record| self.with_progress(record)))
    }

    /// Fits, newest first.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn fits(&self, page: &PageAsked) -> Result<Page<FitRecord>, StoreError> {
        let page = self.store.fits(page)?;
        let items = page.items.into_iter();
        Ok(Page {
            items: items.map(|record| self.with_progress(record)).collect(),
            next: page.next,
        })
    }

    fn with_progress(&self, mut record: FitRecord) -> FitRecord {
        if let Some(progress) = self.feeds.latest(&record) {
            record.progress = progress;
        }
        record
    }

    /// Asks a fit to stop, and returns what is then known about it: canceled at once if it waited, soon if it runs,
    /// unchanged if it has ended. `None` if there is no such fit.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn cancel(&self, id: Uuid) -> Result<Option<FitRecord>, StoreError> {
        let changed = change(&*self.store, id, |record| {
            match record.status {
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
        self.fit(id)
    }

    /// The events of a fit after event `after`, or from the first one kept. `None` if there is no such fit.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn events(&self, id: Uuid, after: Option<u64>) -> Result<Option<Events>, StoreError> {
        // Followed before the record is read, so that an end that comes between the two is not missed.
        let events = self.feeds.follow(id, after);
        Ok(self.store.fit(id)?.map(|record| {
            if !record.status.is_final() {
                return events.or_now(record, after);
            }
            let last = Event::last(record);
            Events::of((after < Some(last.id)).then_some(last))
        }))
    }

    /// The garment of a fit, complete in itself. `None` if there is no such fit.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn garment(&self, id: Uuid) -> Result<Option<Vec<u8>>, StoreError> {
        self.blobs.get(&garment_key(id))
    }

    /// A file that a fit left, in JSON. `None` while there is none.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn file(
        &self,
        record: &FitRecord,
        file: ResultFile,
    ) -> Result<Option<Vec<u8>>, StoreError> {
        match record.result {
            Some(attempt) => self.blobs.get(&file.key(record.id, attempt)),
            None => Ok(None),
        }
    }

    /// How many fits there are of each status. Fails where the store cannot serve: the readiness probe.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn counts(&self) -> Result<Counts, StoreError> {
        self.store.counts()
    }

    /// Ends the events of everyone who follows a fit, so that open connections can end: for shutdown.
    pub fn close(&self) {
        self.feeds.close();
    }
}

/// Whether a record was changed.
pub(super) enum Changed {
    /// It is this now.
    Yes(Box<FitRecord>),
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
    mut edit: impl FnMut(&mut FitRecord) -> bool,
) -> Result<Changed, StoreError> {
    loop {
        let Some(mut record) = store.fit(id)? else {
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
