//! What a job is asked as, what it comes to, and where both are kept.

use super::record::{Failure, JobKind};
use crate::fit::{Garment, Outcome};
use crate::study::{Study, StudyAsked};
use serde::Serialize;
use serde_json::Result;
use uuid::Uuid;

/// What is asked of a worker: complete in itself, as `fit::prepare` and `study::prepare` leave it.
#[derive(Clone, Debug)]
pub enum Work {
    /// A garment to be sewn and draped.
    Fit(Box<Garment>),
    /// A garment to be studied.
    Study(Box<StudyAsked>),
}

impl Work {
    /// Its kind.
    pub fn kind(&self) -> JobKind {
        match self {
            Self::Fit(_) => JobKind::Fit,
            Self::Study(_) => JobKind::Study,
        }
    }

    /// As it is kept.
    pub(super) fn json(&self) -> Result<Vec<u8>> {
        match self {
            Self::Fit(garment) => serde_json::to_vec(garment),
            Self::Study(asked) => serde_json::to_vec(asked),
        }
    }

    /// Reads what was kept.
    pub(super) fn read(kind: JobKind, json: &[u8]) -> Result<Self> {
        Ok(match kind {
            JobKind::Fit => Self::Fit(serde_json::from_slice(json)?),
            JobKind::Study => Self::Study(serde_json::from_slice(json)?),
        })
    }
}

/// What a job comes to.
#[derive(Clone, Debug)]
pub enum Done {
    /// A garment sewn and draped, or as far as it came.
    Fit(Box<Outcome>),
    /// A study, or as far as it came.
    Study(Box<Study>),
}

impl Done {
    /// Whether it was stopped by the cancel token.
    pub(super) fn is_canceled(&self) -> bool {
        match self {
            Self::Fit(outcome) => outcome.canceled,
            Self::Study(study) => study.canceled,
        }
    }

    /// Why it is no success, though it ran to its end.
    pub(super) fn failure(&self) -> Option<Failure> {
        let failure = |why, detail: &str| Failure::new(self.kind(), why, detail);
        match self {
            Self::Fit(outcome) if outcome.report.converged => None,
            Self::Fit(outcome) => Some(failure("not_converged", &outcome.report.why)),
            Self::Study(study) if !study.runs.is_empty() => None,
            Self::Study(study) => {
                let because = study.left_out.first().map(|left| left.because.as_str());
                Some(failure("nothing_ran", because.unwrap_or("no run was made")))
            }
        }
    }

    /// What is kept of it. Other formats are made of these when they are asked for.
    pub(super) fn files(&self) -> Result<Files> {
        fn json(value: &impl Serialize) -> Result<Vec<u8>> {
            serde_json::to_vec(value)
        }
        Ok(match self {
            Self::Fit(outcome) => vec![
                (ResultFile::Mesh, json(&outcome.mesh)?),
                (ResultFile::Report, json(&outcome.report)?),
            ],
            Self::Study(study) => vec![(ResultFile::Report, json(study)?)],
        })
    }

    pub(super) fn kind(&self) -> JobKind {
        match self {
            Self::Fit(_) => JobKind::Fit,
            Self::Study(_) => JobKind::Study,
        }
    }
}

/// The files of a result.
pub(super) type Files = Vec<(ResultFile, Vec<u8>)>;

/// A file that a job leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultFile {
    /// Of a fit, `export::GarmentMesh`.
    Mesh,
    /// Of a fit, `solver::Report`; of a study, `study::Study`.
    Report,
}

impl ResultFile {
    pub(super) fn key(self, job: Uuid, attempt: u32) -> String {
        let name = match self {
            Self::Mesh => "mesh",
            Self::Report => "report",
        };
        format!("{}/{name}.json", results(job, attempt))
    }
}

/// Where one attempt of a job leaves its files.
pub(super) fn results(job: Uuid, attempt: u32) -> String {
    format!("results/{job}/{attempt}")
}

/// The folder of what a job was asked as.
pub(super) fn asked_folder(kind: JobKind, job: Uuid) -> String {
    match kind {
        JobKind::Fit => format!("garments/{job}"),
        JobKind::Study => format!("studies/{job}"),
    }
}

/// What a job was asked as.
pub(super) fn asked_key(kind: JobKind, job: Uuid) -> String {
    let name = match kind {
        JobKind::Fit => "garment",
        JobKind::Study => "study",
    };
    format!("{}/{name}.json", asked_folder(kind, job))
}
