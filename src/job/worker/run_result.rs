//! The end of a run, and the record of its job after it.

use super::active_runs::StopReason;
use crate::job::failure::JobFailure;
use crate::job::kind::JobKind;
use crate::job::process_death::ProcessDeath;
use crate::job::record::JobRecord;
use crate::job::result::{JobOutcome, ResultFiles};
use crate::job::status::JobStatus;
use jiff::Timestamp;

/// The reason why a run left no outcome.
pub(super) enum RunFailure {
    /// The job has failed.
    Failed(JobFailure),
    /// Its own process died.
    Died(ProcessDeath),
}

impl From<JobFailure> for RunFailure {
    fn from(failure: JobFailure) -> Self {
        Self::Failed(failure)
    }
}

/// The end of a run.
pub(super) struct RunResult {
    /// Files to keep.
    pub(super) files: Option<ResultFiles>,
    end: RunEnd,
}

enum RunEnd {
    Succeeded,
    Failed(JobFailure),
    Canceled,
    /// Its own process died; the job goes back to the queue, or has failed if that was the last
    /// death that is borne.
    Crashed {
        death: ProcessDeath,
        limit: u32,
    },
    /// The job goes back to the queue.
    Released,
    /// Another worker has the job.
    LeaseLost,
}

impl RunResult {
    /// Decides the end of a run that came to `ran`, having been stopped for `stop`; its own process
    /// may die `limit` times, if nobody asked it to end.
    pub(super) fn of(
        kind: JobKind,
        ran: Result<JobOutcome, RunFailure>,
        (stop, limit): (Option<StopReason>, u32),
    ) -> Self {
        let is_whole = ran.as_ref().is_ok_and(|outcome| !outcome.is_canceled());
        match (stop, ran) {
            (Some(StopReason::Canceled), _) => Self::without_files(RunEnd::Canceled),
            (Some(StopReason::LeaseLost), _) => Self::without_files(RunEnd::LeaseLost),
            (Some(StopReason::Shutdown), _) if !is_whole => Self::without_files(RunEnd::Released),
            (Some(StopReason::TimeLimit), Err(_)) => Self::failed(JobFailure::time_limit(kind)),
            (_, Err(RunFailure::Failed(failure))) => Self::failed(failure),
            (_, Err(RunFailure::Died(death))) => {
                Self::without_files(RunEnd::Crashed { death, limit })
            }
            (stop, Ok(outcome)) => Self::of_outcome(&outcome, stop),
        }
    }

    /// Returns the end of a run whose result could not be kept before it was asked to stop.
    pub(super) fn stopped(stop: StopReason) -> Self {
        Self::without_files(match stop {
            StopReason::Canceled => RunEnd::Canceled,
            StopReason::LeaseLost => RunEnd::LeaseLost,
            StopReason::Shutdown | StopReason::TimeLimit => RunEnd::Released,
        })
    }

    /// Returns the end of a run that left nothing.
    pub(super) fn failed(failure: JobFailure) -> Self {
        Self::without_files(RunEnd::Failed(failure))
    }

    fn without_files(end: RunEnd) -> Self {
        Self { files: None, end }
    }

    fn of_outcome(outcome: &JobOutcome, stop: Option<StopReason>) -> Self {
        let is_late = stop == Some(StopReason::TimeLimit) && outcome.is_canceled();
        let failure = if is_late {
            Some(JobFailure::time_limit(outcome.kind()))
        } else {
            outcome.failure()
        };
        match outcome.files() {
            Ok(files) => Self {
                files: Some(files),
                end: failure.map_or(RunEnd::Succeeded, RunEnd::Failed),
            },
            Err(error) => Self::failed(JobFailure::storage(outcome.kind(), error)),
        }
    }

    /// Returns true if another worker has the job, so that its record must not be changed.
    pub(super) fn is_lease_lost(&self) -> bool {
        matches!(self.end, RunEnd::LeaseLost)
    }

    /// Changes the record of a running job into that of the job after the run.
    pub(super) fn write(&self, record: &mut JobRecord) {
        record.error = None;
        record.finished_at = Some(Timestamp::now());
        match &self.end {
            _ if record.cancel_requested => record.status = JobStatus::Canceled,
            RunEnd::Succeeded => record.status = JobStatus::Succeeded,
            RunEnd::Failed(failure) => {
                record.status = JobStatus::Failed;
                record.error = Some(failure.clone());
            }
            RunEnd::Canceled => record.status = JobStatus::Canceled,
            RunEnd::Crashed { death, limit } => {
                record.crashes += 1;
                if record.crashes >= *limit {
                    record.status = JobStatus::Failed;
                    let failure = JobFailure::abandoned(record.kind, record.crashes, *death);
                    record.error = Some(failure);
                } else {
                    give_back(record);
                }
            }
            RunEnd::Released | RunEnd::LeaseLost => {
                record.released += 1;
                give_back(record);
            }
        }
        let has_result = matches!(record.status, JobStatus::Succeeded | JobStatus::Failed);
        record.result = (has_result && self.files.is_some()).then_some(record.attempts);
    }
}

/// Puts a job back on the queue.
fn give_back(record: &mut JobRecord) {
    record.status = JobStatus::Queued;
    record.started_at = None;
    record.finished_at = None;
}
