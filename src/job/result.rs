//! The outcome of a job, the files that are kept of it, and their keys.

use super::failure::JobFailure;
use super::kind::JobKind;
use crate::fit::FitOutcome;
use crate::study::Study;
use serde::Serialize;
use serde_json::Result;
use uuid::Uuid;

/// The outcome of a job.
#[derive(Clone, Debug)]
pub enum JobOutcome {
    /// A garment sewn and draped, or as far as it came.
    Fit(Box<FitOutcome>),
    /// A study, or as far as it came.
    Study(Box<Study>),
}

impl JobOutcome {
    /// Returns its kind.
    pub(super) fn kind(&self) -> JobKind {
        match self {
            Self::Fit(_) => JobKind::Fit,
            Self::Study(_) => JobKind::Study,
        }
    }

    /// Returns true if the run was stopped by its cancel token.
    pub(super) fn is_canceled(&self) -> bool {
        match self {
            Self::Fit(outcome) => outcome.canceled,
            Self::Study(study) => study.canceled,
        }
    }

    /// Returns why it is no success, though the run came to its end.
    pub(super) fn failure(&self) -> Option<JobFailure> {
        match self {
            Self::Fit(outcome) if outcome.report.converged => {
                JobFailure::not_good(outcome.report.good.as_ref()?)
            }
            Self::Fit(outcome) => Some(JobFailure::not_converged(&outcome.report.why)),
            Self::Study(study) if !study.runs.is_empty() => None,
            Self::Study(study) => {
                let first = study.left_out.first();
                let reason = first.map(|run| run.because.as_str());
                Some(JobFailure::nothing_ran(reason))
            }
        }
    }

    /// Writes the files that are kept. Other formats are made of these on request.
    pub(super) fn files(&self) -> Result<ResultFiles> {
        Ok(match self {
            Self::Fit(outcome) => vec![
                (ResultFile::Mesh, json(&outcome.mesh)?),
                (ResultFile::Report, json(&outcome.report)?),
            ],
            Self::Study(study) => vec![(ResultFile::Report, json(study)?)],
        })
    }
}

fn json(value: &impl Serialize) -> Result<Vec<u8>> {
    serde_json::to_vec(value)
}

/// The files of a result.
pub(super) type ResultFiles = Vec<(ResultFile, Vec<u8>)>;

/// A file that a job leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultFile {
    /// Of a fit, `export::GarmentMesh`.
    Mesh,
    /// Of a fit, `solver::DrapeReport`; of a study, `study::Study`.
    Report,
}

impl ResultFile {
    /// Returns the key of the file of one attempt.
    pub(super) fn key(self, job: Uuid, attempt: u32) -> String {
        let name = match self {
            Self::Mesh => "mesh",
            Self::Report => "report",
        };
        format!("{}/{name}.json", attempt_folder(job, attempt))
    }
}

/// Returns the folder of the files of one attempt.
pub(super) fn attempt_folder(job: Uuid, attempt: u32) -> String {
    format!("results/{job}/{attempt}")
}
