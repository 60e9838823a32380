//! The reason why a job failed, in a code and a sentence.

use super::kind::JobKind;
use crate::fault::{Fault, Faults};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// The reason why a job failed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[schema(as = Failure)]
pub struct JobFailure {
    /// For a client to act on, of a fit: `fit/not_converged`, `fit/refused`, `fit/time_limit`, `fit/panicked`,
    /// `fit/abandoned` or `fit/storage`; of a study: `study/nothing_ran` and, but for the first, the same with `study`.
    pub code: String,
    /// Sentence for a person on what happened.
    pub detail: String,
    /// Every fault, where faults of the input were the reason.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<Fault>,
}

impl JobFailure {
    fn new(kind: JobKind, reason: &str, detail: impl Into<String>) -> Self {
        Self {
            code: format!("{}/{reason}", kind.as_str()),
            detail: detail.into(),
            errors: Vec::new(),
        }
    }

    /// Returns the failure of a job whose input has faults.
    pub(super) fn refused(kind: JobKind, faults: Faults) -> Self {
        Self {
            errors: faults.0.clone(),
            ..Self::new(kind, "refused", faults.to_string())
        }
    }

    /// Returns the failure of a fit that did not converge, for the reason that its report gives.
    pub(super) fn not_converged(reason: &str) -> Self {
        Self::new(JobKind::Fit, "not_converged", reason)
    }

    /// Returns the failure of a study without a run, for the reason why the first was left out.
    pub(super) fn nothing_ran(reason: Option<&str>) -> Self {
        let detail = reason.unwrap_or("no run was made");
        Self::new(JobKind::Study, "nothing_ran", detail)
    }

    /// Returns the failure of a job that used its CPU time.
    pub(super) fn time_limit(kind: JobKind) -> Self {
        let word = kind.as_str();
        let detail = format!(
            "it used all the CPU time that one {word} may use; a coarser mesh or a larger tolerance takes less"
        );
        Self::new(kind, "time_limit", detail)
    }

    /// Returns the failure of a job whose request or result could not be read or written.
    pub(super) fn storage(kind: JobKind, detail: impl Into<String>) -> Self {
        Self::new(kind, "storage", detail)
    }

    /// Returns the failure of a job whose processes died `deaths` times.
    pub(super) fn abandoned(kind: JobKind, deaths: u32) -> Self {
        let detail = format!("the process that ran it died {deaths} times; it is not begun again");
        Self::new(kind, "abandoned", detail)
    }

    /// Returns the failure of a job that panicked.
    pub(super) fn panicked(kind: JobKind) -> Self {
        let detail = "the program has a defect that this garment brings out; its log says where";
        Self::new(kind, "panicked", detail)
    }
}
