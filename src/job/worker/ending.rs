//! How a run ends, and what its record then says.

use super::running::Stop;
use crate::fit::Outcome;
use crate::job::queue::ResultFile;
use crate::job::record::{Failure, FitRecord, Status};
use jiff::Timestamp;
use serde::Serialize;

/// The files of a result.
pub(super) type Files = Vec<(ResultFile, Vec<u8>)>;

/// How a run ends.
pub(super) struct Ending {
    /// What is kept of it.
    pub(super) files: Option<Files>,
    end: End,
}

enum End {
    Succeeded,
    Failed(Failure),
    Canceled,
    GivenBack,
    Lost,
}

impl Ending {
    /// What a run that came to `ran`, having been stopped for `stop`, ends as.
    pub(super) fn of(ran: Result<Outcome, Failure>, stop: Option<Stop>) -> Self {
        let is_whole = ran.as_ref().is_ok_and(|outcome| !outcome.canceled);
        match (stop, ran) {
            (Some(Stop::Canceled), _) => Self::without_files(End::Canceled),
            (Some(Stop::Lost), _) => Self::without_files(End::Lost),
            (Some(Stop::Shutdown), _) if !is_whole => Self::without_files(End::GivenBack),
            (Some(Stop::TimeLimit), Err(_)) => Self::failed(time_limit()),
            (_, Err(failure)) => Self::failed(failure),
            (stop, Ok(outcome)) => Self::of_outcome(&outcome, stop),
        }
    }

    pub(super) fn failed(failure: Failure) -> Self {
        Self::without_files(End::Failed(failure))
    }

    fn without_files(end: End) -> Self {
        Self { files: None, end }
    }

    fn of_outcome(outcome: &Outcome, stop: Option<Stop>) -> Self {
        let end = match stop {
            Some(Stop::TimeLimit) if outcome.canceled => End::Failed(time_limit()),
            _ if outcome.report.converged && !outcome.canceled => End::Succeeded,
            _ => End::Failed(Failure::new("fit/not_converged", &outcome.report.why)),
        };
        match files(outcome) {
            Ok(files) => Self {
                files: Some(files),
                end,
            },
            Err(error) => Self::failed(Failure::new("fit/storage", error.to_string())),
        }
    }

    /// Whether the fit is somebody else's now, so that its record is not to be touched.
    pub(super) fn is_lost(&self) -> bool {
        matches!(self.end, End::Lost)
    }

    /// Changes the record of a fit that runs into what it is after this.
    pub(super) fn write(&self, record: &mut FitRecord) {
        record.error = None;
        record.finished_at = Some(Timestamp::now());
        match &self.end {
            _ if record.cancel_requested => record.status = Status::Canceled,
            End::Succeeded => record.status = Status::Succeeded,
            End::Failed(failure) => {
                record.status = Status::Failed;
                record.error = Some(failure.clone());
            }
            End::Canceled => record.status = Status::Canceled,
            End::GivenBack | End::Lost => {
                record.status = Status::Queued;
                record.released += 1;
                record.started_at = None;
                record.finished_at = None;
            }
        }
        let has_result = matches!(record.status, Status::Succeeded | Status::Failed);
        record.result = (has_result && self.files.is_some()).then_some(record.attempts);
    }
}

fn time_limit() -> Failure {
    Failure::new(
        "fit/time_limit",
        "it used all the CPU time that one fit may use; a coarser mesh or a larger tolerance takes less",
    )
}

fn files(outcome: &Outcome) -> serde_json::Result<Files> {
    fn json(value: &impl Serialize) -> serde_json::Result<Vec<u8>> {
        serde_json::to_vec(value)
    }
    Ok(vec![
        (ResultFile::Mesh, json(&outcome.mesh)?),
        (ResultFile::Report, json(&outcome.report)?),
    ])
}
