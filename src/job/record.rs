//! What is known about one fit.

use crate::fault::{Fault, Faults};
use crate::progress::Progress;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use uuid::Uuid;

/// What has become of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// It waits for a worker.
    Queued,
    /// A worker has it.
    Running,
    /// A shape was reached and checked.
    Succeeded,
    /// No shape was reached; the best one and its report may be there all the same.
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

/// Why a fit failed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct Failure {
    /// For a client to act on: `fit/not_converged`, `fit/refused`, `fit/time_limit`, `fit/panicked`, `fit/abandoned` or `fit/storage`.
    pub code: String,
    /// What happened, in a sentence for a person.
    pub detail: String,
    /// Every fault, where faults of the input were the reason.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<Fault>,
}

impl Failure {
    /// A failure that is no fault of the input.
    pub fn new(code: &str, detail: impl Into<String>) -> Self {
        Self {
            code: code.to_owned(),
            detail: detail.into(),
            errors: Vec::new(),
        }
    }
}

impl From<Faults> for Failure {
    fn from(faults: Faults) -> Self {
        Self {
            code: "fit/refused".to_owned(),
            detail: faults.to_string(),
            errors: faults.0,
        }
    }
}

/// What is known about one fit: the truth that every process sees, changed only by compare-and-set on `revision`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FitRecord {
    /// `UUIDv7`: ids sort by the time they were submitted.
    pub id: Uuid,
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

impl FitRecord {
    /// A fit that waits for its first worker.
    pub fn queued(id: Uuid, created_at: Timestamp) -> Self {
        Self {
            id,
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
