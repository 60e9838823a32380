//! Fits and studies queued, stored and run by workers.
//!
//! A job is handed out at least once and takes effect once: every attempt writes its files under a key of its
//! own (`results/<job>/<attempt>`), and the record names the winner by compare-and-set. One queue holds both kinds.
//!
//! - [`JobRecord`]: what is known about one job. [`Work`], [`Done`]: what it is asked as, and what it comes to.
//! - [`JobStore`], [`Documents`], [`Blobs`]: what has to be kept, as interfaces; [`SqliteStore`] and [`FileBlobs`] keep it in one folder.
//! - [`Catalogue`]: stored patterns, avatars and fabrics.
//! - [`Queue`]: submits, finds, lists, cancels and follows jobs; what the service is built on.
//! - [`WorkerPool`]: threads that take jobs from the store and run them by a [`Runner`].

mod blobs;
mod catalogue;
mod clock;
#[cfg(test)]
mod contract;
mod feed;
mod queue;
mod record;
mod sqlite;
mod store;
mod work;
mod worker;

pub use blobs::{Blobs, FileBlobs};
pub use catalogue::{AvatarRecord, Catalogue, Stored};
pub use clock::thread_cpu_s;
pub use feed::{Event, EventKind, Events};
pub use queue::{Queue, QueueError};
pub use record::{Failure, JobKind, JobRecord, Status};
pub use sqlite::SqliteStore;
pub use store::{
    Counts, DocumentKind, Documents, IdempotencyKey, JobStore, Lease, NewJob, Notice, Page,
    PageAsked, StoreError, Submitted,
};
pub use work::{Done, ResultFile, Work};
pub use worker::{Runner, Sewing, WorkerPool};
