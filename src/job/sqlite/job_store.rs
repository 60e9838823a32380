//! The queue of jobs: [`JobStore`] in `SQLite`.

use super::paging::{id_bound, into_page, row_limit};
use super::rows::{
    count_jobs, count_queued, fail_job, insert_job, job_of_key, job_record, listed_job, update_job,
};
use super::store::{SqliteStore, store_error};
use crate::job::kind::JobKind;
use crate::job::record::JobRecord;
use crate::job::status::JobStatus;
use crate::job::store::{
    IdempotencyKey, JobCounts, JobNotice, JobStore, Lease, NewJob, Page, PageRequest, StoreError,
    Submitted,
};
use rusqlite::params_from_iter;
use rusqlite::types::Value;
use std::sync::PoisonError;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use uuid::Uuid;

impl JobStore for SqliteStore {
    fn submit(&self, job: &NewJob<'_>) -> Result<Submitted, StoreError> {
        let submitted = self.write("putting a job on the queue", |transaction| {
            let known = job.key.map(|key| job_of_key(transaction, key));
            if let Some(known) = known.transpose()?.flatten() {
                return Ok(known);
            }
            let queued = count_queued(transaction)?;
            if usize::try_from(queued).is_ok_and(|queued| queued >= job.queue_limit) {
                return Ok(Submitted::Full);
            }
            insert_job(transaction, job)?;
            Ok(Submitted::New)
        })?;
        if submitted == Submitted::New {
            self.publish(JobNotice::Queued);
        }
        Ok(submitted)
    }

    fn submitted(&self, key: &IdempotencyKey) -> Result<Option<Submitted>, StoreError> {
        job_of_key(&self.connection(), key)
            .map_err(|cause| store_error("looking for an idempotency key", cause))
    }

    fn job(&self, id: Uuid) -> Result<Option<JobRecord>, StoreError> {
        let query = "SELECT record, revision FROM jobs WHERE id = ?1";
        let mut found = self.read("reading a job", (query, [id.as_bytes()]), job_record)?;
        Ok(found.pop())
    }

    fn replace(&self, record: &JobRecord) -> Result<Option<u64>, StoreError> {
        self.write("writing a job", |transaction| {
            update_job(transaction, record)
        })
    }

    fn fail(&self, id: Uuid, cause: &StoreError) -> Result<Option<JobRecord>, StoreError> {
        self.write("writing a failed job", |transaction| {
            fail_job(transaction, id, cause)
        })
    }

    fn jobs(&self, kind: JobKind, page: &PageRequest) -> Result<Page<JobRecord>, StoreError> {
        let mut query =
            "SELECT record, revision, id FROM jobs WHERE kind = ?1 AND id < ?2".to_owned();
        let mut values: Vec<Value> = vec![kind.as_str().to_owned().into(), id_bound(page)];
        if let Some(status) = page.status {
            query.push_str(" AND status = ?3");
            values.push(status.as_str().to_owned().into());
        }
        query.push_str(&format!(" ORDER BY id DESC LIMIT {}", row_limit(page)));
        let found = self.read(
            "listing jobs",
            (&query, params_from_iter(values)),
            listed_job,
        )?;
        let found = into_page(found, page, |(id, _)| *id);
        let items = found.items.into_iter();
        Ok(Page {
            items: items.filter_map(|job| self.listed_record(job)).collect(),
            next: found.next,
        })
    }

    fn counts(&self, kind: JobKind) -> Result<JobCounts, StoreError> {
        let connection = self.connection();
        let mut counts = JobCounts::default();
        for status in JobStatus::ALL {
            counts.by_status[status as usize] = count_jobs(&connection, kind, status)
                .map_err(|cause| store_error("counting jobs", cause))?;
        }
        Ok(counts)
    }

    fn lease_time(&self) -> Duration {
        self.leases.duration
    }

    fn claim(&self) -> Result<Option<Lease>, StoreError> {
        // Those of other kinds wait for the newer program that put them there.
        let kinds = JobKind::ALL.map(JobKind::as_str).join("', '");
        let query = format!(
            "SELECT id FROM jobs WHERE status IN ('queued', 'running') AND kind IN ('{kinds}')
             ORDER BY id"
        );
        let open = self.read("looking at the queue", (&query, []), |row| {
            row.get(0).map(Uuid::from_bytes)
        })?;
        Ok(self.leases.take(open))
    }

    fn renew(&self, lease: &Lease) -> Result<bool, StoreError> {
        Ok(self.leases.renew(lease))
    }

    fn end(&self, lease: &Lease) -> Result<(), StoreError> {
        if self.leases.end(lease)
            && self
                .job(lease.job)?
                .is_some_and(|job| !job.status.is_final())
        {
            self.publish(JobNotice::Queued);
        }
        Ok(())
    }

    fn probe(&self) -> Result<(), StoreError> {
        self.check_file()
    }

    fn listen(&self) -> Receiver<JobNotice> {
        let (sender, receiver) = channel();
        let listeners = self.listeners.lock();
        listeners
            .unwrap_or_else(PoisonError::into_inner)
            .push(sender);
        receiver
    }

    fn publish(&self, notice: JobNotice) {
        let listeners = self.listeners.lock();
        listeners
            .unwrap_or_else(PoisonError::into_inner)
            .retain(|listener| listener.send(notice.clone()).is_ok());
    }
}
