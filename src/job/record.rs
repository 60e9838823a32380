//! What is known about one job.

use crate::fault::{Fault, Faults};
use crate::progress::Progress;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use uuid::Uuid;

/// What kind of work a job is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum JobKind {
    /// A garment sewn and draped. Records of before there were studies name no kind.
    #[default]
    Fit,
    /// A garment by many methods, settings and meshes.
    Study,
}

impl JobKind {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Fit, Self::Study];

    /// The word for it in codes and in the store.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Fit => "fit",
            Self::Study => "study",
        }
    }
}

/// What has become of a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// It waits for a worker.
    Queued,
    /// A worker has it.
    Running,
    /// Of a fit, a shape was reached and checked; a study ran to its end.
    Succeeded,
    /// It was not; what was reached may be there all the same.
    Failed,
    /// Somebody asked to stop it.
    Canceled,
}

impl Status {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Queued,
        Self::Running,
        Self::Succeeded,
        Self::Failed,
        Self::Canceled,
    ];

    /// Whether it can no longer change.
    pub fn is_final(self) -> bool {
        matches!(self, Self::Succeeded | Self::Failed | Self::Canceled)
    }

    /// The word for it in JSON.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Succeeded => "succeeded",
            Self::Failed => "failed",
            Self::Canceled => "canceled",
        }
    }
}

/// Why a job failed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct Failure {
    /// For a client to act on, of a fit: `fit/not_converged`, `fit/refused`, `fit/time_limit`, `fit/panicked`,
    /// `fit/abandoned` or `fit/storage`; of a study: `study/nothing_ran` and, but for the first, the same with `study`.
    pub code: String,
    /// What happened, in a sentence for a person.
    pub detail: String,
    /// Every fault, where faults of the input were the reason.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<Fault>,
}

impl Failure {
    /// A failure that is no fault of the input.
    pub fn new(kind: JobKind, why: &str, detail: impl Into<String>) -> Self {
        Self {
            code: format!("{}/{why}", kind.as_str()),
            detail: detail.into(),
            errors: Vec::new(),
        }
    }

    /// A failure by faults of the input.
    pub fn refused(kind: JobKind, faults: Faults) -> Self {
        Self {
            errors: faults.0.clone(),
            ..Self::new(kind, "refused", faults.to_string())
        }
    }
}

/// What is known about one job: the truth that every process sees, changed only by compare-and-set on `revision`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JobRecord {
    /// `UUIDv7`: ids sort by the time they were submitted.
    pub id: Uuid,
    /// What kind of work it is.
    #[serde(default)]
    pub kind: JobKind,
    /// What has become of it.
    pub status: Status,
    /// When it was submitted.
    pub created_at: Timestamp,
    /// When the present attempt began.
    pub started_at: Option<Timestamp>,
    /// When it came to its final status.
    pub finished_at: Option<Timestamp>,
    /// How often it was begun.
    pub attempts: u32,
    /// How many of these attempts were given back in good order, as at shutdown; they do not count against the limit.
    pub released: u32,
    /// How far it is.
    pub progress: Progress,
    /// Why it failed.
    pub error: Option<Failure>,
    /// The attempt whose files are the result; `None` while there are none.
    pub result: Option<u32>,
    /// Whether somebody asked to stop it.
    pub cancel_requested: bool,
    /// Counts the changes of this record; set by the store.
    #[serde(skip)]
    pub revision: u64,
}

impl JobRecord {
    /// A job that waits for its first worker.
    pub fn queued(kind: JobKind, id: Uuid, created_at: Timestamp) -> Self {
        Self {
            id,
            kind,
            status: Status::Queued,
            created_at,
            started_at: None,
            finished_at: None,
            attempts: 0,
            released: 0,
            progress: Progress::default(),
            error: None,
            result: None,
            cancel_requested: false,
            revision: 0,
        }
    }
}
