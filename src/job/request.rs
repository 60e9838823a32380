//! The request of a job, and the key that it is kept under.

use super::kind::JobKind;
use crate::fit::Garment;
use crate::study::StudyRequest;
use serde_json::Result;
use uuid::Uuid;

/// A request to a worker: complete in itself, as `fit::resolve` and `study::resolve` leave it.
#[derive(Clone, Debug)]
pub enum JobRequest {
    /// A garment to be sewn and draped.
    Fit(Box<Garment>),
    /// A garment to be studied.
    Study(Box<StudyRequest>),
}

impl JobRequest {
    /// Returns its kind.
    pub fn kind(&self) -> JobKind {
        match self {
            Self::Fit(_) => JobKind::Fit,
            Self::Study(_) => JobKind::Study,
        }
    }

    /// Writes it in the form in which it is kept.
    pub(super) fn json(&self) -> Result<Vec<u8>> {
        match self {
            Self::Fit(garment) => serde_json::to_vec(garment),
            Self::Study(request) => serde_json::to_vec(request),
        }
    }

    /// Reads what [`JobRequest::json`] wrote.
    pub(super) fn read(kind: JobKind, json: &[u8]) -> Result<Self> {
        Ok(match kind {
            JobKind::Fit => Self::Fit(serde_json::from_slice(json)?),
            JobKind::Study => Self::Study(serde_json::from_slice(json)?),
        })
    }
}

/// Returns the folder of a job's request.
pub(super) fn request_folder(kind: JobKind, job: Uuid) -> String {
    match kind {
        JobKind::Fit => format!("garments/{job}"),
        JobKind::Study => format!("studies/{job}"),
    }
}

/// Returns the key of a job's request.
pub(super) fn request_key(kind: JobKind, job: Uuid) -> String {
    let name = match kind {
        JobKind::Fit => "garment",
        JobKind::Study => "study",
    };
    format!("{}/{name}.json", request_folder(kind, job))
}
