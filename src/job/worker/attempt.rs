//! One attempt at a fit: begun in its record, run, ended in its record.

use super::ending::{Ending, Files};
use super::running::{Stop, StopFlag};
use super::{PAUSE, Shared};
use crate::fit::{Garment, Outcome};
use crate::job::queue::{Changed, change, garment_key, results};
use crate::job::record::{Failure, FitRecord, Status};
use crate::job::store::{Lease, Notice, StoreError};
use crate::progress::Progress;
use jiff::Timestamp;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// The shortest time between two reports of progress within a stage: a person cannot read faster.
const PROGRESS_EVERY: Duration = Duration::from_millis(100);

impl Shared {
    /// Runs the fit that a lease is for, and ends the lease.
    pub(super) fn run(&self, lease: Lease) {
        let flag = self.running.begin(lease);
        if let Err(error) = self.attempt(lease, &flag) {
            tracing::error!(%error, fit = %lease.fit, "the fit goes back to the queue");
            // Nothing would be gained by trying again at once.
            self.bell.wait(self.bell.heard(), PAUSE);
        }
        self.running.end(&lease);
        if let Err(error) = self.queue.store.end(&lease) {
            tracing::error!(%error, fit = %lease.fit, "its lease is not ended and runs out");
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
        let ran = self.sew(&record, flag, &mut progress);
        let ending = Ending::of(ran, flag.reason());
        let ending = match &ending.files {
            Some(files) => match self.store(&record, files) {
                Ok(()) => ending,
                Err(error) => {
                    let failure = Failure::new("fit/storage", error.to_string());
                    Ending::failed(failure)
                }
            },
            None => ending,
        };
        self.end(&record, ending, progress)
    }

    /// Writes into the record that the fit runs, or that it will not. `None`: it has come to its end already.
    fn begin(&self, lease: Lease) -> Result<Option<Box<FitRecord>>, StoreError> {
        let limit = self.queue.limits.attempts;
        let changed = change(&*self.queue.store, lease.fit, |record| {
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
                    "fit/abandoned",
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

    /// Tells everyone who follows the fit of the change.
    fn told(&self, changed: Changed) -> Option<Box<FitRecord>> {
        match changed {
            Changed::Yes(record) => {
                let notice = Notice::Status(record.clone());
                self.queue.store.publish(notice);
                Some(record)
            }
            Changed::No => None,
        }
    }

    /// Runs the fit; a panic is a failure of this fit only.
    fn sew(
        &self,
        record: &FitRecord,
        flag: &StopFlag,
        latest: &mut Progress,
    ) -> Result<Outcome, Failure> {
        let garment = self.garment(record)?;
        let mut told: Option<Instant> = None;
        let mut tell = |progress: Progress| {
            let progress = finite(progress);
            if progress.cpu_s > self.queue.limits.fit_cpu_s {
                flag.raise(Stop::TimeLimit);
            }
            let is_news = progress.stage != latest.stage
                || told.is_none_or(|told| told.elapsed() >= PROGRESS_EVERY);
            latest.clone_from(&progress);
            if is_news {
                told = Some(Instant::now());
                self.queue.store.publish(Notice::Progress {
                    fit: record.id,
                    attempt: record.attempts,
                    progress,
                });
            }
        };
        let run = AssertUnwindSafe(|| self.runner.run(garment, &flag.cancel, &mut tell));
        match catch_unwind(run) {
            Ok(ran) => ran.map_err(Failure::from),
            Err(panic) => Err(panicked(&*panic)),
        }
    }

    fn garment(&self, record: &FitRecord) -> Result<Garment, Failure> {
        let storage = |detail: String| Failure::new("fit/storage", detail);
        let bytes = self.queue.blobs.get(&garment_key(record.id));
        let bytes = bytes.map_err(|error| storage(error.to_string()))?;
        let bytes = bytes.ok_or_else(|| storage("its garment is gone".to_owned()))?;
        serde_json::from_slice(&bytes)
            .map_err(|error| storage(format!("its garment cannot be read: {error}")))
    }

    fn store(&self, record: &FitRecord, files: &Files) -> Result<(), StoreError> {
        files.iter().try_for_each(|(file, bytes)| {
            let key = file.key(record.id, record.attempts);
            self.queue.blobs.put(&key, bytes)
        })
    }

    /// Writes the ending into the record, unless the fit is no longer this attempt's, and removes files that nothing names.
    fn end(&self, begun: &FitRecord, ending: Ending, progress: Progress) -> Result<(), StoreError> {
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

fn panicked(panic: &(dyn Any + Send)) -> Failure {
    let text = panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied());
    tracing::error!(panic = text, "a fit panicked");
    Failure::new(
        "fit/panicked",
        "the program has a defect that this garment brings out; its log says where",
    )
}
