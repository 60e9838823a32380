//! One attempt at a job: begun in its record, run, ended in its record.

use super::active_runs::{StopFlag, StopReason};
use super::context::{RETRY_DELAY, WorkerContext};
use super::run_result::{RunFailure, RunResult};
use super::runner::RunError;
use crate::job::failure::JobFailure;
use crate::job::kind::JobKind;
use crate::job::queue::{RecordUpdate, update_record};
use crate::job::record::JobRecord;
use crate::job::request::{JobRequest, request_key};
use crate::job::result::{JobOutcome, ResultFiles, attempt_folder};
use crate::job::status::JobStatus;
use crate::job::store::{JobNotice, Lease, StoreError};
use crate::progress::Progress;
use jiff::Timestamp;
use std::any::Any;
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use uuid::Uuid;

/// Shortest time between two reports of progress within a stage: a person cannot read faster.
const PROGRESS_INTERVAL: Duration = Duration::from_millis(100);

/// Time between two lines of the log while the store does not answer.
const TELL_INTERVAL: Duration = Duration::from_secs(60);

/// CPU time after which a study is stopped from outside, over its limit: it keeps to the limit
/// itself, run by run.
const STUDY_GRACE: f64 = 1.25;

/// Runs the job that a lease is for, and ends the lease.
pub(super) fn run(context: &WorkerContext, lease: Lease) {
    let flag = context.active_runs.register(lease);
    if let Err(error) = attempt(context, lease, &flag)
        && !mark_failed(context, lease, &flag, &error)
    {
        tracing::error!(%error, job = %lease.job, "the job goes back to the queue");
        // Nothing would be gained by trying again at once.
        let signal = &context.wake_signal;
        signal.wait(signal.generation(), RETRY_DELAY);
    }
    context.active_runs.remove(&lease);
    if let Err(error) = context.queue.store.end(&lease) {
        tracing::error!(%error, job = %lease.job, "its lease is not ended and runs out");
    }
}

/// Writes that the job has failed, if trying again cannot help; returns false if it goes back to
/// the queue.
fn mark_failed(context: &WorkerContext, lease: Lease, flag: &StopFlag, error: &StoreError) -> bool {
    if error.is_passing() || flag.reason() == Some(StopReason::LeaseLost) {
        return false;
    }
    let store = &context.queue.store;
    match store.fail(lease.job, error) {
        Ok(Some(record)) => {
            store.publish(JobNotice::Status(Box::new(record)));
            true
        }
        Ok(None) => false,
        Err(error) => {
            tracing::error!(%error, job = %lease.job, "its failure cannot be written");
            false
        }
    }
}

fn attempt(context: &WorkerContext, lease: Lease, flag: &StopFlag) -> Result<(), StoreError> {
    let Some(record) = context.queue.store.job(lease.job)? else {
        return Ok(());
    };
    if record.status.is_final() {
        return Ok(());
    }
    let key = request_key(record.kind, record.id);
    // Before the record says that it runs: if the service dies, a job that only waits for another
    // to end is not suspect. While the store keeps it waiting it has no permit and holds nobody up.
    let ready = || {
        let permit = context.run_permits.acquire(record.isolated, flag);
        let read = |permit| Ok((permit, context.queue.blobs.get(&key)?));
        permit.map(read).transpose()
    };
    let Ok(Some((permit, request))) = patiently(context, flag, record.id, ready)? else {
        return end_waiting(context, lease, flag);
    };
    let Some(record) = begin(context, lease)? else {
        return Ok(());
    };
    if record.status.is_final() {
        return Ok(());
    }
    let mut progress = Progress::default();
    // Parsed only after the record says that it runs, so that a request that crashes the service is
    // suspect.
    let mut result = match parse_request(&record, request) {
        Ok(request) => {
            let ran = run_request(context, &record, flag, request, &mut progress);
            RunResult::of(
                record.kind,
                ran,
                (flag.reason(), context.queue.limits.crashes),
            )
        }
        Err(failure) => RunResult::failed(failure),
    };
    drop(permit);
    if let Some(files) = &result.files {
        let store = || store_files(context, &record, files);
        if let Err(stop) = patiently(context, flag, record.id, store)? {
            result = RunResult::stopped(stop);
        }
    }
    let write = || end(context, &record, &result, &progress);
    // If it was asked to stop, the record stays as it is: the next start finds that it ran.
    let _ = patiently(context, flag, record.id, write)?;
    Ok(())
}

/// Ends the attempt of a job that was asked to stop before it began.
fn end_waiting(context: &WorkerContext, lease: Lease, flag: &StopFlag) -> Result<(), StoreError> {
    if flag.reason() == Some(StopReason::Canceled) {
        // Its record asks for it and becomes that of a canceled job.
        begin(context, lease)?;
    }
    Ok(())
}

/// Does `work` until it succeeds or the run is asked to stop, and returns the reason for that: the
/// disk may be full for a while, or no file can be opened. What was solved meanwhile is kept.
///
/// # Errors
/// If trying again cannot help.
fn patiently<T>(
    context: &WorkerContext,
    flag: &StopFlag,
    job: Uuid,
    work: impl Fn() -> Result<T, StoreError>,
) -> Result<Result<T, StopReason>, StoreError> {
    let mut told: Option<Instant> = None;
    loop {
        let error = match work() {
            Ok(value) => return Ok(Ok(value)),
            Err(error) if error.is_passing() => error,
            Err(error) => return Err(error),
        };
        if told.is_none_or(|at| at.elapsed() >= TELL_INTERVAL) {
            tracing::error!(%error, %job, "waiting for the store");
            told = Some(Instant::now());
        }
        match flag.reason() {
            Some(stop @ (StopReason::Canceled | StopReason::LeaseLost)) => return Ok(Err(stop)),
            _ if context.active_runs.is_closed() => return Ok(Err(StopReason::Shutdown)),
            _ => {}
        }
        let signal = &context.wake_signal;
        signal.wait(signal.generation(), RETRY_DELAY);
    }
}

/// Writes into the record that the job runs, or that it will not. Returns `None` if the job has
/// ended already.
fn begin(context: &WorkerContext, lease: Lease) -> Result<Option<Box<JobRecord>>, StoreError> {
    let service_deaths = context.queue.limits.service_deaths;
    let update = update_record(&*context.queue.store, lease.job, |record| {
        if record.status.is_final() {
            return false;
        }
        if record.cancel_requested {
            record.status = JobStatus::Canceled;
            record.finished_at = Some(Timestamp::now());
        } else if record.service_deaths >= service_deaths {
            let failure = JobFailure::abandoned_by_service(record.kind, record.service_deaths);
            record.status = JobStatus::Failed;
            record.error = Some(failure);
            record.finished_at = Some(Timestamp::now());
        } else {
            record.status = JobStatus::Running;
            record.started_at = Some(Timestamp::now());
            record.attempts += 1;
        }
        true
    })?;
    Ok(published(context, update))
}

/// Publishes the change of a record, and returns the record after it.
fn published(context: &WorkerContext, update: RecordUpdate) -> Option<Box<JobRecord>> {
    match update {
        RecordUpdate::Changed(record) => {
            let notice = JobNotice::Status(record.clone());
            context.queue.store.publish(notice);
            Some(record)
        }
        RecordUpdate::Unchanged => None,
    }
}

/// Runs the job; a panic is a failure of this job only, and so is the death of its own process.
fn run_request(
    context: &WorkerContext,
    record: &JobRecord,
    flag: &StopFlag,
    request: JobRequest,
    latest: &mut Progress,
) -> Result<JobOutcome, RunFailure> {
    let cpu_limit_s = cpu_limit_s(context, record.kind);
    let mut published: Option<Instant> = None;
    let mut on_progress = |progress: Progress| {
        let progress = progress.finite();
        if progress.cpu_s > cpu_limit_s {
            flag.raise(StopReason::TimeLimit);
        }
        let is_due = published.is_none_or(|at| at.elapsed() >= PROGRESS_INTERVAL);
        let is_news = progress.stage != latest.stage || is_due;
        latest.clone_from(&progress);
        if is_news {
            published = Some(Instant::now());
            context.queue.store.publish(JobNotice::Progress {
                job: record.id,
                attempt: record.attempts,
                progress,
            });
        }
    };
    let ran = if record.isolated {
        run_isolated(context, flag, &request, &mut on_progress)
    } else {
        let run = || context.runner.run(request, &flag.cancel, &mut on_progress);
        catch_unwind(AssertUnwindSafe(run)).map(|ran| ran.map_err(RunError::Refused))
    };
    match ran {
        Ok(ran) => ran.map_err(|error| run_failure(record.kind, error)),
        Err(panic) => Err(panic_failure(record.kind, &*panic).into()),
    }
}

/// Runs the job in a process of its own. If none can be started, it tries again for a while.
fn run_isolated(
    context: &WorkerContext,
    flag: &StopFlag,
    request: &JobRequest,
    progress: &mut dyn FnMut(Progress),
) -> std::thread::Result<Result<JobOutcome, RunError>> {
    let mut tries = 0;
    loop {
        let run = || context.runner.run_isolated(request, &flag.cancel, progress);
        let ran = catch_unwind(AssertUnwindSafe(run));
        tries += 1;
        match ran {
            Ok(Err(RunError::NotStarted(cause))) if tries < context.queue.limits.starts => {
                tracing::warn!(%cause, tries, "no process can be started");
                if flag.wait(RETRY_DELAY).is_some() {
                    return Ok(Err(RunError::NotStarted(cause)));
                }
            }
            ran => return ran,
        }
    }
}

fn run_failure(kind: JobKind, error: RunError) -> RunFailure {
    match error {
        RunError::Refused(faults) => JobFailure::refused(kind, faults).into(),
        RunError::Panicked => JobFailure::panicked(kind).into(),
        RunError::Died(death) => RunFailure::Died(death),
        RunError::NotStarted(cause) => {
            tracing::error!(%cause, "no process can be started");
            JobFailure::not_started(kind).into()
        }
        RunError::Protocol(cause) => {
            tracing::error!(%cause, "the process of a {} tells what cannot be read", kind.as_str());
            JobFailure::panicked(kind).into()
        }
    }
}

fn cpu_limit_s(context: &WorkerContext, kind: JobKind) -> f64 {
    match kind {
        JobKind::Fit => context.queue.limits.fit_cpu_s,
        JobKind::Study => context.queue.limits.study_cpu_s * STUDY_GRACE,
    }
}

/// Parses the stored request of a job, or finds that it is lost.
fn parse_request(record: &JobRecord, stored: Option<Vec<u8>>) -> Result<JobRequest, JobFailure> {
    let key = request_key(record.kind, record.id);
    let lost = |why: &dyn Display| JobFailure::storage(record.kind, format_args!("{key}: {why}"));
    let bytes = stored.ok_or_else(|| lost(&"it is gone"))?;
    JobRequest::read(record.kind, &bytes).map_err(|error| lost(&error))
}

fn store_files(
    context: &WorkerContext,
    record: &JobRecord,
    files: &ResultFiles,
) -> Result<(), StoreError> {
    files.iter().try_for_each(|(file, bytes)| {
        let key = file.key(record.id, record.attempts);
        context.queue.blobs.put(&key, bytes)
    })
}

/// Writes the result into the record, unless the job is no longer this attempt's, and removes files
/// that nothing names.
fn end(
    context: &WorkerContext,
    begun: &JobRecord,
    result: &RunResult,
    progress: &Progress,
) -> Result<(), StoreError> {
    let update = update_record(&*context.queue.store, begun.id, |record| {
        let is_ours = record.status == JobStatus::Running
            && record.attempts == begun.attempts
            && !result.is_lease_lost();
        if is_ours {
            result.write(record);
            record.progress.clone_from(progress);
        }
        is_ours
    })?;
    let winner = published(context, update).map(|record| record.result);
    remove_lost_files(context, begun, winner);
    Ok(())
}

/// Removes the files of this attempt, unless it is the winner, and those of earlier ones, if the
/// record was written.
fn remove_lost_files(context: &WorkerContext, begun: &JobRecord, winner: Option<Option<u32>>) {
    let own = (winner.flatten() != Some(begun.attempts)).then_some(begun.attempts);
    let earlier = if winner.is_some() {
        1..begun.attempts
    } else {
        0..0
    };
    for attempt in earlier.chain(own) {
        let folder = attempt_folder(begun.id, attempt);
        if let Err(error) = context.queue.blobs.delete(&folder) {
            tracing::warn!(%error, "files of a lost attempt stay behind");
        }
    }
}

fn panic_failure(kind: JobKind, panic: &(dyn Any + Send)) -> JobFailure {
    let text = panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied());
    tracing::error!(panic = text, "a {} panicked", kind.as_str());
    JobFailure::panicked(kind)
}
