//! One attempt at a job: begun in its record, run, ended in its record.

use super::ending::Ending;
use super::running::{Stop, StopFlag};
use super::{PAUSE, Shared};
use crate::job::queue::{Changed, change};
use crate::job::record::{Failure, JobKind, JobRecord, Status};
use crate::job::store::{Lease, Notice, StoreError};
use crate::job::work::{Done, Files, Work, asked_key, results};
use crate::progress::Progress;
use jiff::Timestamp;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// The shortest time between two reports of progress within a stage: a person cannot read faster.
const PROGRESS_EVERY: Duration = Duration::from_millis(100);

/// CPU time of a study after which it is stopped from outside, over its limit: it keeps to the limit itself, run by run.
const STUDY_GRACE: f64 = 1.25;

impl Shared {
    /// Runs the job that a lease is for, and ends the lease.
    pub(super) fn run(&self, lease: Lease) {
        let flag = self.running.begin(lease);
        if let Err(error) = self.attempt(lease, &flag) {
            tracing::error!(%error, job = %lease.job, "the job goes back to the queue");
            // Nothing would be gained by trying again at once.
            self.bell.wait(self.bell.heard(), PAUSE);
        }
        self.running.end(&lease);
        if let Err(error) = self.queue.store.end(&lease) {
            tracing::error!(%error, job = %lease.job, "its lease is not ended and runs out");
        }
    }

    fn attempt(&self, lease: Lease, flag: &StopFlag) -> Result<(), StoreError> {
        let Some(record) = self.begin(lease)? else {
            return Ok(());
        };
        if record.status.is_final() {
            return Ok(());
        }
        let mut progress = Progress::default();
        let ran = self.done(&record, flag, &mut progress);
        let ending = Ending::of(record.kind, ran, flag.reason());
        let ending = match &ending.files {
            Some(files) => match self.store(&record, files) {
                Ok(()) => ending,
                Err(error) => {
                    let failure = Failure::new(record.kind, "storage", error.to_string());
                    Ending::failed(failure)
                }
            },
            None => ending,
        };
        self.end(&record, ending, progress)
    }

    /// Writes into the record that the job runs, or that it will not. `None`: it has come to its end already.
    fn begin(&self, lease: Lease) -> Result<Option<Box<JobRecord>>, StoreError> {
        let limit = self.queue.limits.attempts;
        let changed = change(&*self.queue.store, lease.job, |record| {
            let deaths = record.attempts.saturating_sub(record.released);
            if record.status.is_final() {
                return false;
            }
            if record.cancel_requested {
                record.status = Status::Canceled;
                record.finished_at = Some(Timestamp::now());
            } else if deaths > limit {
                record.status = Status::Failed;
                record.finished_at = Some(Timestamp::now());
                record.error = Some(Failure::new(
                    record.kind,
                    "abandoned",
                    format!("the process that ran it died {deaths} times; it is not begun again"),
                ));
            } else {
                record.status = Status::Running;
                record.started_at = Some(Timestamp::now());
                record.attempts += 1;
            }
            true
        })?;
        Ok(self.told(changed))
    }

    /// Tells everyone who follows the job of the change.
    fn told(&self, changed: Changed) -> Option<Box<JobRecord>> {
        match changed {
            Changed::Yes(record) => {
                let notice = Notice::Status(record.clone());
                self.queue.store.publish(notice);
                Some(record)
            }
            Changed::No => None,
        }
    }

    /// Runs the job; a panic is a failure of this job only.
    fn done(
        &self,
        record: &JobRecord,
        flag: &StopFlag,
        latest: &mut Progress,
    ) -> Result<Done, Failure> {
        let work = self.asked(record)?;
        let most_cpu_s = self.most_cpu_s(record.kind);
        let mut told: Option<Instant> = None;
        let mut tell = |progress: Progress| {
            let progress = finite(progress);
            if progress.cpu_s > most_cpu_s {
                flag.raise(Stop::TimeLimit);
            }
            let is_news = progress.stage != latest.stage
                || told.is_none_or(|told| told.elapsed() >= PROGRESS_EVERY);
            latest.clone_from(&progress);
            if is_news {
                told = Some(Instant::now());
                self.queue.store.publish(Notice::Progress {
                    job: record.id,
                    attempt: record.attempts,
                    progress,
                });
            }
        };
        let run = AssertUnwindSafe(|| self.runner.run(work, &flag.cancel, &mut tell));
        match catch_unwind(run) {
            Ok(ran) => ran.map_err(|faults| Failure::refused(record.kind, faults)),
            Err(panic) => Err(panicked(record.kind, &*panic)),
        }
    }

    fn most_cpu_s(&self, kind: JobKind) -> f64 {
        match kind {
            JobKind::Fit => self.queue.limits.fit_cpu_s,
            JobKind::Study => self.queue.limits.study_cpu_s * STUDY_GRACE,
        }
    }

    fn asked(&self, record: &JobRecord) -> Result<Work, Failure> {
        let storage = |detail: String| Failure::new(record.kind, "storage", detail);
        let bytes = self.queue.blobs.get(&asked_key(record.kind, record.id));
        let bytes = bytes.map_err(|error| storage(error.to_string()))?;
        let bytes = bytes.ok_or_else(|| storage("what was asked is gone".to_owned()))?;
        Work::read(record.kind, &bytes)
            .map_err(|error| storage(format!("what was asked cannot be read: {error}")))
    }

    fn store(&self, record: &JobRecord, files: &Files) -> Result<(), StoreError> {
        files.iter().try_for_each(|(file, bytes)| {
            let key = file.key(record.id, record.attempts);
            self.queue.blobs.put(&key, bytes)
        })
    }

    /// Writes the ending into the record, unless the job is no longer this attempt's, and removes files that nothing names.
    fn end(&self, begun: &JobRecord, ending: Ending, progress: Progress) -> Result<(), StoreError> {
        let changed = change(&*self.queue.store, begun.id, |record| {
            let is_ours = record.status == Status::Running
                && record.attempts == begun.attempts
                && !ending.is_lost();
            if is_ours {
                ending.write(record);
                record.progress.clone_from(&progress);
            }
            is_ours
        })?;
        let winner = self.told(changed).map(|record| record.result);
        let own = (winner.flatten() != Some(begun.attempts)).then_some(begun.attempts);
        let earlier = if winner.is_some() {
            1..begun.attempts
        } else {
            0..0
        };
        for attempt in earlier.chain(own) {
            if let Err(error) = self.queue.blobs.delete(&results(begun.id, attempt)) {
                tracing::warn!(%error, "files of a lost attempt stay behind");
            }
        }
        Ok(())
    }
}

/// JSON has no infinities: a record that held one could not be read again.
fn finite(mut progress: Progress) -> Progress {
    for value in [&mut progress.fraction, &mut progress.cpu_s] {
        if !value.is_finite() {
            *value = 0.0;
        }
    }
    for value in [&mut progress.residual, &mut progress.seam_gap_m] {
        *value = value.filter(|value| value.is_finite());
    }
    progress
}

fn panicked(kind: JobKind, panic: &(dyn Any + Send)) -> Failure {
    let text = panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied());
    tracing::error!(panic = text, "a {} panicked", kind.as_str());
    Failure::new(
        kind,
        "panicked",
        "the program has a defect that this garment brings out; its log says where",
    )
}
