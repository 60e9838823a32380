//! Fits queued, stored and run by workers.
//!
//! A fit is handed out at least once and takes effect once: every attempt writes its files under a key of its
//! own (`results/<fit>/<attempt>`), and the record names the winner by compare-and-set.
//!
//! - [`FitRecord`]: what is known about one fit.
//! - [`JobStore`], [`Documents`], [`Blobs`]: what has to be kept, as interfaces; [`SqliteStore`] and [`FileBlobs`] keep it in one folder.
//! - [`Catalogue`]: stored patterns, avatars and fabrics.
//! - [`Queue`]: submits, finds, lists, cancels and follows fits; what the service is built on.
//! - [`WorkerPool`]: threads that take fits from the store and run them by a [`Runner`].

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
mod worker;

pub use blobs::{Blobs, FileBlobs};
pub use catalogue::{AvatarRecord, Catalogue, Stored};
pub use clock::thread_cpu_s;
pub use feed::{Event, EventKind, Events};
pub use queue::{Queue, QueueError, ResultFile};
pub use record::{Failure, FitRecord, Status};
pub use sqlite::SqliteStore;
pub use store::{
    Counts, DocumentKind, Documents, IdempotencyKey, JobStore, Lease, NewFit, Notice, Page,
    PageAsked, StoreError, Submitted,
};
pub use worker::{Runner, Sewing, WorkerPool};
