//! How a run ends, and what its record then says.

use super::running::Stop;
use crate::job::record::{Failure, JobKind, JobRecord, Status};
use crate::job::work::{Done, Files};
use jiff::Timestamp;

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
    /// What a run of a job of this kind that came to `ran`, having been stopped for `stop`, ends as.
    pub(super) fn of(kind: JobKind, ran: Result<Done, Failure>, stop: Option<Stop>) -> Self {
        let is_whole = ran.as_ref().is_ok_and(|done| !done.is_canceled());
        match (stop, ran) {
            (Some(Stop::Canceled), _) => Self::without_files(End::Canceled),
            (Some(Stop::Lost), _) => Self::without_files(End::Lost),
            (Some(Stop::Shutdown), _) if !is_whole => Self::without_files(End::GivenBack),
            (Some(Stop::TimeLimit), Err(_)) => Self::failed(time_limit(kind)),
            (_, Err(failure)) => Self::failed(failure),
            (stop, Ok(done)) => Self::of_done(&done, stop),
        }
    }

    pub(super) fn failed(failure: Failure) -> Self {
        Self::without_files(End::Failed(failure))
    }

    fn without_files(end: End) -> Self {
        Self { files: None, end }
    }

    fn of_done(done: &Done, stop: Option<Stop>) -> Self {
        let is_late = stop == Some(Stop::TimeLimit) && done.is_canceled();
        let failure = if is_late {
            Some(time_limit(done.kind()))
        } else {
            done.failure()
        };
        match done.files() {
            Ok(files) => Self {
                files: Some(files),
                end: failure.map_or(End::Succeeded, End::Failed),
            },
            Err(error) => Self::failed(Failure::new(done.kind(), "storage", error.to_string())),
        }
    }

    /// Whether the job is somebody else's now, so that its record is not to be touched.
    pub(super) fn is_lost(&self) -> bool {
        matches!(self.end, End::Lost)
    }

    /// Changes the record of a job that runs into what it is after this.
    pub(super) fn write(&self, record: &mut JobRecord) {
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

fn time_limit(kind: JobKind) -> Failure {
    let word = kind.as_str();
    let detail = format!(
        "it used all the CPU time that one {word} may use; a coarser mesh or a larger tolerance takes less"
    );
    Failure::new(kind, "time_limit", detail)
}
