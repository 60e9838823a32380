//! Fits and studies queued, stored and run by workers.
//!
//! A job is handed out at least once and takes effect once: every attempt writes its files under a
//! key of its own (`results/<job>/<attempt>`), and the record names the winner by compare-and-set.
//! One queue holds both kinds.
//!
//! - [`JobRecord`]: the state of one job. [`JobRequest`], [`JobOutcome`]: its input and its output.
//! - [`JobStore`], [`Documents`], [`Blobs`]: interfaces of storage; [`SqliteStore`] and
//!   [`FileBlobs`] keep all in one folder.
//! - [`Catalogue`]: stored patterns, avatars and fabrics.
//! - [`Queue`]: submits, finds, lists, cancels and follows jobs; the service is built on it.
//! - [`WorkerPool`]: threads that take jobs from the store and run them by a [`Runner`];
//!   [`run_child`] and [`follow_child`]: both ends of a run in a process of its own.

mod blobs;
mod catalogue;
mod clock;
#[cfg(test)]
mod contract;
#[cfg(test)]
mod documents_contract;
mod events;
mod failure;
mod kind;
mod library;
mod process_death;
mod queue;
mod record;
mod request;
mod result;
mod sqlite;
mod status;
mod store;
mod worker;

pub use blobs::{Blobs, FileBlobs};
pub use catalogue::{AvatarRecord, AvatarRequest, BodyFile, Catalogue, Stored};
pub use clock::{Clock, ManualClock, SystemClock, thread_cpu_s};
pub use events::{JobEvent, JobEventKind, JobEvents};
pub use failure::JobFailure;
pub use kind::JobKind;
pub use process_death::ProcessDeath;
pub use queue::{Queue, QueueError};
pub use record::JobRecord;
pub use request::JobRequest;
pub use result::{JobOutcome, ResultFile};
pub use sqlite::SqliteStore;
pub use status::JobStatus;
pub use store::{
    DocumentKind, Documents, IdempotencyKey, JobCounts, JobNotice, JobStore, Lease, NewJob, Page,
    PageRequest, StoreError, Submitted,
};
pub use worker::{RunError, Runner, SolverRunner, WorkerPool, follow_child, run_child};
