//! The reason why a job failed, in a code and a sentence.

use super::kind::JobKind;
use super::process_death::ProcessDeath;
use crate::fault::{Fault, FaultCode, Faults, FitCode, StudyCode};
use crate::solver::{Shortcoming, Verdict};
use serde::{Deserialize, Serialize};
use std::fmt::Display;
use utoipa::ToSchema;

/// The reason why a job failed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[schema(as = Failure)]
pub struct JobFailure {
    /// For a client to act on, of a fit: `fit/not_converged`, the first fault of one at rest
    /// (`fit/crossings`, `fit/body`, `fit/layers`, `fit/gap`, `fit/strain`, `fit/worn`),
    /// `fit/refused`, `fit/time_limit`, `fit/panicked`, `fit/abandoned`, `fit/not_started` or
    /// `fit/storage`; of a study: `study/nothing_ran`, and from `fit/refused` on the same with
    /// `study`.
    #[schema(value_type = String)]
    pub code: FaultCode,
    /// Sentence for a person on what happened.
    pub detail: String,
    /// Every fault, where faults of the input were the reason.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<Fault>,
}

/// The detail that clients are given of a request or a result that is lost.
const STORAGE_DETAIL: &str =
    "what the service keeps of it is gone or cannot be read; its log says why; submit it again";

impl JobFailure {
    const STORAGE: (FitCode, StudyCode) = (FitCode::Storage, StudyCode::Storage);

    fn new(code: impl Into<FaultCode>, detail: impl Into<String>) -> Self {
        Self {
            code: code.into(),
            detail: detail.into(),
            errors: Vec::new(),
        }
    }

    /// Creates the failure of a job by the code that belongs to its kind.
    fn of_kind(
        kind: JobKind,
        (fit, study): (FitCode, StudyCode),
        detail: impl Into<String>,
    ) -> Self {
        match kind {
            JobKind::Fit => Self::new(fit, detail),
            JobKind::Study => Self::new(study, detail),
        }
    }

    /// Returns the failure of a job whose input has faults.
    pub(super) fn refused(kind: JobKind, faults: Faults) -> Self {
        let codes = (FitCode::Refused, StudyCode::Refused);
        let failure = Self::of_kind(kind, codes, faults.to_string());
        Self {
            errors: faults.0,
            ..failure
        }
    }

    /// Returns the failure of a fit that did not converge, for the reason that its report gives.
    pub(super) fn not_converged(reason: &str) -> Self {
        Self::new(FitCode::NotConverged, reason)
    }

    /// Returns the failure of a fit that came to rest and is not good, named by its first fault;
    /// none if it is good or was not judged.
    pub(super) fn not_good(verdict: &Verdict) -> Option<Self> {
        let code = match verdict.failed.first()? {
            Shortcoming::Crossings => FitCode::Crossings,
            Shortcoming::Body => FitCode::Body,
            Shortcoming::Layers => FitCode::Layers,
            Shortcoming::Gap => FitCode::Gap,
            Shortcoming::Strain => FitCode::Strain,
            Shortcoming::Worn => FitCode::Worn,
        };
        Some(Self::new(code, verdict.because.join("; ")))
    }

    /// Returns the failure of a study without a run, for the reason why the first was left out.
    pub(super) fn nothing_ran(reason: Option<&str>) -> Self {
        let detail = reason.unwrap_or("no run was made");
        Self::new(StudyCode::NothingRan, detail)
    }

    /// Returns the failure of a job that used its CPU time.
    pub(super) fn time_limit(kind: JobKind) -> Self {
        let word = kind.as_str();
        let detail = format!(
            "it used all the CPU time that one {word} may use; a coarser mesh or a larger tolerance takes less"
        );
        Self::of_kind(kind, (FitCode::TimeLimit, StudyCode::TimeLimit), detail)
    }

    /// Returns the failure of a job whose stored request is gone or cannot be read, or whose result
    /// cannot be written as JSON; `cause` goes to the log only.
    pub(super) fn storage(kind: JobKind, cause: impl Display) -> Self {
        tracing::error!(%cause, "a {} cannot be read or kept", kind.as_str());
        Self::of_kind(kind, Self::STORAGE, STORAGE_DETAIL)
    }

    /// Returns the failure as clients see it. Those that an older version kept name the files of
    /// the service.
    #[must_use]
    pub fn public(mut self) -> Self {
        let (fit, study) = Self::STORAGE;
        if self.code == fit || self.code == study {
            STORAGE_DETAIL.clone_into(&mut self.detail);
        }
        self
    }

    /// Returns the failure of a job whose own processes died `deaths` times, the last for `cause`.
    pub(super) fn abandoned(kind: JobKind, deaths: u32, cause: ProcessDeath) -> Self {
        let detail = format!(
            "it ran in a process of its own, which died {deaths} times: {cause}; a coarser mesh takes less memory"
        );
        Self::of_kind(kind, (FitCode::Abandoned, StudyCode::Abandoned), detail)
    }

    /// Returns the failure of a job with which the service died `deaths` times, though it ran in a
    /// process of its own.
    pub(super) fn abandoned_by_service(kind: JobKind, deaths: u32) -> Self {
        let detail = format!(
            "it ran in a process of its own, and the service died {deaths} times meanwhile; a coarser mesh takes less memory"
        );
        Self::of_kind(kind, (FitCode::Abandoned, StudyCode::Abandoned), detail)
    }

    /// Returns the failure of a job that no process could be started for.
    pub(super) fn not_started(kind: JobKind) -> Self {
        let detail = "it is to run in a process of its own, and none could be started; the service's log says why; submit it again later";
        Self::of_kind(kind, (FitCode::NotStarted, StudyCode::NotStarted), detail)
    }

    /// Returns the failure of a job that panicked.
    pub(super) fn panicked(kind: JobKind) -> Self {
        let detail = "the program has a defect that this garment brings out; its log says where";
        Self::of_kind(kind, (FitCode::Panicked, StudyCode::Panicked), detail)
    }

    /// Returns true if the service is at fault, not the input.
    pub fn is_internal(&self) -> bool {
        let fit = [
            FitCode::Panicked,
            FitCode::Storage,
            FitCode::Abandoned,
            FitCode::NotStarted,
        ];
        let study = [
            StudyCode::Panicked,
            StudyCode::Storage,
            StudyCode::Abandoned,
            StudyCode::NotStarted,
        ];
        fit.iter().any(|code| self.code == *code) || study.iter().any(|code| self.code == *code)
    }
}
