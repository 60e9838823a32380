//! The record of one job.

use super::failure::JobFailure;
use super::kind::JobKind;
use super::status::JobStatus;
use crate::progress::Progress;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use uuid::Uuid;

/// The record of one job: the truth that every process sees, changed only by compare-and-set on
/// `revision`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JobRecord {
    /// `UUIDv7`: ids sort by the time they were submitted.
    pub id: Uuid,
    /// Its kind.
    #[serde(default)]
    pub kind: JobKind,
    /// Its status.
    pub status: JobStatus,
    /// Time of its submission.
    pub created_at: Timestamp,
    /// Begin of the present attempt.
    pub started_at: Option<Timestamp>,
    /// Time at which its status became final.
    pub finished_at: Option<Timestamp>,
    /// Number of attempts begun.
    pub attempts: u32,
    /// Number of these attempts that were given back in good order, as at shutdown.
    pub released: u32,
    /// True if the service died while it ran: from then on it runs in a process of its own, since
    /// it may be the cause.
    #[serde(default)]
    pub isolated: bool,
    /// Number of times that the service died while it ran in a process of its own.
    #[serde(default)]
    pub service_deaths: u32,
    /// Number of processes of its own that died though nobody had told them to end.
    #[serde(default)]
    pub crashes: u32,
    /// Its progress.
    pub progress: Progress,
    /// The reason why it failed.
    pub error: Option<JobFailure>,
    /// The attempt whose files are the result; `None` while there are none.
    pub result: Option<u32>,
    /// True if it was canceled, though it may still run.
    pub cancel_requested: bool,
    /// Count of the changes of this record; set by the store.
    #[serde(skip)]
    pub revision: u64,
}

impl JobRecord {
    /// Creates the record of a job that waits for its first worker.
    pub fn queued(kind: JobKind, id: Uuid, created_at: Timestamp) -> Self {
        Self {
            id,
            kind,
            status: JobStatus::Queued,
            created_at,
            started_at: None,
            finished_at: None,
            attempts: 0,
            released: 0,
            isolated: false,
            service_deaths: 0,
            crashes: 0,
            progress: Progress::default(),
            error: None,
            result: None,
            cancel_requested: false,
            revision: 0,
        }
    }
}
