//! The interfaces of storage: one implementation is a folder of one machine, another may be a
//! cluster.
//!
//! All calls block; async code makes them from a blocking thread.

use super::kind::JobKind;
use super::record::JobRecord;
use super::status::JobStatus;
use crate::progress::Progress;
use std::sync::mpsc::Receiver;
use std::time::Duration;
use uuid::Uuid;

/// A failed operation of a store: the disk is full, the server is gone.
#[derive(Debug, thiserror::Error)]
#[error("{doing}: {cause}")]
pub struct StoreError {
    /// The operation that failed.
    pub doing: String,
    /// The reason.
    #[source]
    pub cause: Box<dyn std::error::Error + Send + Sync>,
    is_of_data: bool,
}

impl StoreError {
    /// Creates an error of an operation.
    pub fn new(
        doing: impl Into<String>,
        cause: impl Into<Box<dyn std::error::Error + Send + Sync>>,
    ) -> Self {
        Self {
            doing: doing.into(),
            cause: cause.into(),
            is_of_data: false,
        }
    }

    /// Creates the error of data that is not there or cannot be read: the same each time.
    pub fn of_data(
        doing: impl Into<String>,
        cause: impl Into<Box<dyn std::error::Error + Send + Sync>>,
    ) -> Self {
        Self {
            is_of_data: true,
            ..Self::new(doing, cause)
        }
    }

    /// Returns true if the machine is at fault, so that the same may succeed later: the disk is
    /// full, no file can be opened.
    pub fn is_passing(&self) -> bool {
        !self.is_of_data
    }
}

/// A key by which a repeated request means the same job.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IdempotencyKey {
    /// The text that the client chose.
    pub key: String,
    /// SHA-256 of the request.
    pub digest: [u8; 32],
}

/// A job to be put on the queue.
#[derive(Clone, Debug)]
pub struct NewJob<'a> {
    /// Its record, queued.
    pub record: &'a JobRecord,
    /// The key by which a repeated request means the same job.
    pub key: Option<&'a IdempotencyKey>,
    /// The most jobs of all kinds that may wait, this one included.
    pub queue_limit: usize,
}

/// The result of a submission.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Submitted {
    /// It is on the queue.
    New,
    /// The same request was submitted before, as this job.
    Same(Uuid),
    /// The key was used before for another request.
    KeyReused,
    /// Too many jobs wait.
    Full,
}

/// The right to run one job for a while; renewed until the run ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lease {
    /// The job.
    pub job: Uuid,
    /// Token that distinguishes this lease from any other of the same job.
    pub token: Uuid,
}

/// A notice of a store to all listeners. Notices may get lost; records are the truth.
#[derive(Clone, Debug, PartialEq)]
pub enum JobNotice {
    /// A job can be claimed.
    Queued,
    /// This job was canceled.
    Cancel(Uuid),
    /// The status of this job has changed.
    Status(Box<JobRecord>),
    /// A job has come further.
    Progress {
        /// The job.
        job: Uuid,
        /// The attempt.
        attempt: u32,
        /// Its progress.
        progress: Progress,
    },
}

/// Number of jobs of a kind by status.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct JobCounts {
    /// Jobs by status, in the order of [`JobStatus::ALL`].
    pub by_status: [u64; 5],
}

impl JobCounts {
    /// Returns the number of jobs of a status.
    pub fn of(&self, status: JobStatus) -> u64 {
        self.by_status[status as usize]
    }
}

/// A request for a part of a list, newest first.
#[derive(Clone, Copy, Debug, Default)]
pub struct PageRequest {
    /// The most items wanted.
    pub limit: usize,
    /// The last id of the page before.
    pub after: Option<Uuid>,
    /// Only jobs of this status; other lists have none.
    pub status: Option<JobStatus>,
}

/// A part of a list, newest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Page<T> {
    /// The items.
    pub items: Vec<T>,
    /// `after` of the next page, if there is one.
    pub next: Option<Uuid>,
}

/// Records of jobs and their queue, one for all kinds.
///
/// Records are the truth, changed by compare-and-set. The queue only hands out ids: at least once,
/// oldest first, each under a lease that runs out unless it is renewed. `contract::store_contract`
/// states what every implementation must keep.
pub trait JobStore: Send + Sync {
    /// Puts a job on the queue, all or nothing, and sends [`JobNotice::Queued`].
    ///
    /// # Errors
    /// If nothing could be written.
    fn submit(&self, job: &NewJob<'_>) -> Result<Submitted, StoreError>;

    /// Returns the job that a key stands for, or [`Submitted::KeyReused`]; `None` if the key is
    /// new.
    ///
    /// # Errors
    /// If nothing could be read.
    fn submitted(&self, key: &IdempotencyKey) -> Result<Option<Submitted>, StoreError>;

    /// Returns the record of a job.
    ///
    /// # Errors
    /// If nothing could be read.
    fn job(&self, id: Uuid) -> Result<Option<JobRecord>, StoreError>;

    /// Replaces a record if its revision is still `record.revision`. Returns the new revision, or
    /// `None` if it had changed.
    ///
    /// # Errors
    /// If nothing could be written.
    fn replace(&self, record: &JobRecord) -> Result<Option<u64>, StoreError>;

    /// Writes that a job that has not ended has failed for `cause`, and returns its record; what
    /// of that cannot be read is as in a new one. `None` if there is no such job.
    ///
    /// # Errors
    /// If nothing could be written.
    fn fail(&self, id: Uuid, cause: &StoreError) -> Result<Option<JobRecord>, StoreError>;

    /// Returns the records of a kind, newest first. One that cannot be read is left out.
    ///
    /// # Errors
    /// If nothing could be read.
    fn jobs(&self, kind: JobKind, page: &PageRequest) -> Result<Page<JobRecord>, StoreError>;

    /// Counts the jobs of a kind by status.
    ///
    /// # Errors
    /// If nothing could be read.
    fn counts(&self, kind: JobKind) -> Result<JobCounts, StoreError>;

    /// Returns the duration of a lease that is not renewed.
    fn lease_time(&self) -> Duration;

    /// Leases the oldest job, of whatever kind this program knows, that is not final and that
    /// nobody has a live lease on.
    ///
    /// # Errors
    /// If nothing could be read.
    fn claim(&self) -> Result<Option<Lease>, StoreError>;

    /// Extends a lease. Returns false if it has run out: the run must stop.
    ///
    /// # Errors
    /// If the store does not answer; the lease may still be live.
    fn renew(&self, lease: &Lease) -> Result<bool, StoreError>;

    /// Ends a lease. If the job is not final by now it is handed out again at once, and
    /// [`JobNotice::Queued`] is sent.
    ///
    /// # Errors
    /// If the store does not answer; the lease runs out by itself.
    fn end(&self, lease: &Lease) -> Result<(), StoreError>;

    /// Checks that the store can be used now: reads from where the data is, not from memory.
    ///
    /// # Errors
    /// If it cannot be used.
    fn probe(&self) -> Result<(), StoreError>;

    /// Listens to notices from now on, those of this process included.
    fn listen(&self) -> Receiver<JobNotice>;

    /// Sends a notice to all listeners.
    fn publish(&self, notice: JobNotice);
}

/// The kind of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DocumentKind {
    /// A pattern.
    Pattern,
    /// An avatar.
    Avatar,
    /// A fabric.
    Fabric,
    /// The surface of an avatar, by its content.
    Body,
}

/// Small documents by id, written once. Ids are `UUIDv7`, so that newest first is the order of ids,
/// falling.
pub trait Documents: Send + Sync {
    /// Stores a document.
    ///
    /// # Errors
    /// If nothing could be written.
    fn put(&self, kind: DocumentKind, id: Uuid, body: &[u8]) -> Result<(), StoreError>;

    /// Finds a document.
    ///
    /// # Errors
    /// If nothing could be read.
    fn get(&self, kind: DocumentKind, id: Uuid) -> Result<Option<Vec<u8>>, StoreError>;

    /// Removes a document; returns true if it was there.
    ///
    /// # Errors
    /// If nothing could be written.
    fn delete(&self, kind: DocumentKind, id: Uuid) -> Result<bool, StoreError>;

    /// Returns documents, newest first.
    ///
    /// # Errors
    /// If nothing could be read.
    fn list(
        &self,
        kind: DocumentKind,
        page: &PageRequest,
    ) -> Result<Page<(Uuid, Vec<u8>)>, StoreError>;
}
