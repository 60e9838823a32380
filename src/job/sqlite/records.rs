//! The records of jobs and their queue.

use super::{SqliteStore, unreadable};
use crate::job::record::{JobKind, JobRecord, Status};
use crate::job::store::{
    Counts, IdempotencyKey, JobStore, Lease, NewJob, Notice, Page, PageAsked, StoreError, Submitted,
};
use rusqlite::types::Value;
use rusqlite::{Connection, OptionalExtension, Row, params, params_from_iter};
use std::sync::PoisonError;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use uuid::Uuid;

impl JobStore for SqliteStore {
    fn submit(&self, job: &NewJob<'_>) -> Result<Submitted, StoreError> {
        let submitted = self.write("putting a job on the queue", |transaction| {
            if let Some(known) = job
                .key
                .map(|key| known(transaction, key))
                .transpose()?
                .flatten()
            {
                return Ok(known);
            }
            let waiting = waiting(transaction)?;
            if usize::try_from(waiting).is_ok_and(|waiting| waiting >= job.queue_limit) {
                return Ok(Submitted::Full);
            }
            insert(transaction, job)?;
            Ok(Submitted::New)
        })?;
        if submitted == Submitted::New {
            self.publish(Notice::Queued);
        }
        Ok(submitted)
    }

    fn submitted(&self, key: &IdempotencyKey) -> Result<Option<Submitted>, StoreError> {
        known(&self.connection(), key)
            .map_err(|cause| StoreError::new("looking for an idempotency key", cause))
    }

    fn job(&self, id: Uuid) -> Result<Option<JobRecord>, StoreError> {
        let query = "SELECT record, revision FROM jobs WHERE id = ?1";
        let mut found = self.read("reading a job", (query, [id.as_bytes()]), record)?;
        Ok(found.pop())
    }

    fn replace(&self, record: &JobRecord) -> Result<Option<u64>, StoreError> {
        self.write("writing a job", |transaction| update(transaction, record))
    }

    fn jobs(&self, kind: JobKind, page: &PageAsked) -> Result<Page<JobRecord>, StoreError> {
        let mut query = "SELECT record, revision FROM jobs WHERE kind = ?1 AND id < ?2".to_owned();
        let mut values: Vec<Value> = vec![kind.as_str().to_owned().into(), before(page)];
        if let Some(status) = page.status {
            query.push_str(" AND status = ?3");
            values.push(status.as_str().to_owned().into());
        }
        query.push_str(&format!(" ORDER BY id DESC LIMIT {}", one_more(page)));
        let found = self.read("listing jobs", (&query, params_from_iter(values)), record)?;
        Ok(cut(found, page, |record| record.id))
    }

    fn counts(&self, kind: JobKind) -> Result<Counts, StoreError> {
        let connection = self.connection();
        let mut counts = Counts::default();
        for status in Status::ALL {
            counts.by_status[status as usize] = count(&connection, kind, status)
                .map_err(|cause| StoreError::new("counting jobs", cause))?;
        }
        Ok(counts)
    }

    fn lease_time(&self) -> Duration {
        self.leases.time
    }

    fn claim(&self) -> Result<Option<Lease>, StoreError> {
        let query = "SELECT id FROM jobs WHERE status IN ('queued', 'running') ORDER BY id";
        let open = self.read("looking at the queue", (query, []), |row| {
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
            self.publish(Notice::Queued);
        }
        Ok(())
    }

    fn listen(&self) -> Receiver<Notice> {
        let (sender, receiver) = channel();
        let listeners = self.listeners.lock();
        listeners
            .unwrap_or_else(PoisonError::into_inner)
            .push(sender);
        receiver
    }

    fn publish(&self, notice: Notice) {
        let listeners = self.listeners.lock();
        listeners
            .unwrap_or_else(PoisonError::into_inner)
            .retain(|listener| listener.send(notice.clone()).is_ok());
    }
}

/// The smallest id that a page does not reach.
pub(super) fn before(page: &PageAsked) -> Value {
    let id = page.after.unwrap_or(Uuid::max());
    id.as_bytes().to_vec().into()
}

/// A row more than the page holds tells whether there is a next page.
pub(super) fn one_more(page: &PageAsked) -> i64 {
    i64::try_from(page.limit).map_or(i64::MAX, |limit| limit.saturating_add(1))
}

pub(super) fn cut<T>(mut items: Vec<T>, page: &PageAsked, id: impl Fn(&T) -> Uuid) -> Page<T> {
    let is_more = items.len() > page.limit;
    items.truncate(page.limit);
    let last = items.last().map(id);
    Page {
        next: last.filter(|_| is_more),
        items,
    }
}

pub(super) fn of_status(
    connection: &Connection,
    status: Status,
) -> rusqlite::Result<Vec<JobRecord>> {
    connection
        .prepare("SELECT record, revision FROM jobs WHERE status = ?1")?
        .query_map([status.as_str()], record)?
        .collect()
}

/// Writes a record if its revision is still the stored one, and returns the next.
pub(super) fn update(connection: &Connection, record: &JobRecord) -> rusqlite::Result<Option<u64>> {
    let changed = connection
        .prepare_cached(
            "UPDATE jobs SET status = ?2, record = ?3, revision = revision + 1 WHERE id = ?1 AND revision = ?4",
        )?
        .execute(params![
            record.id.as_bytes(),
            record.status.as_str(),
            json(record)?,
            record.revision.cast_signed(),
        ])?;
    Ok((changed == 1).then_some(record.revision + 1))
}

fn insert(connection: &Connection, job: &NewJob<'_>) -> rusqlite::Result<()> {
    let record = job.record;
    connection.execute(
        "INSERT INTO jobs (id, kind, status, revision, record) VALUES (?1, ?2, ?3, 0, ?4)",
        params![
            record.id.as_bytes(),
            record.kind.as_str(),
            record.status.as_str(),
            json(record)?
        ],
    )?;
    if let Some(key) = job.key {
        connection.execute(
            "INSERT INTO keys (key, digest, job) VALUES (?1, ?2, ?3)",
            params![key.key, key.digest, record.id.as_bytes()],
        )?;
    }
    Ok(())
}

fn known(connection: &Connection, key: &IdempotencyKey) -> rusqlite::Result<Option<Submitted>> {
    let found = connection
        .prepare_cached("SELECT digest, job FROM keys WHERE key = ?1")?
        .query_row([&key.key], |row| {
            Ok((row.get::<_, [u8; 32]>(0)?, Uuid::from_bytes(row.get(1)?)))
        })
        .optional()?;
    Ok(found.map(|(digest, job)| {
        if digest == key.digest {
            Submitted::Same(job)
        } else {
            Submitted::KeyReused
        }
    }))
}

/// How many jobs of all kinds wait.
fn waiting(connection: &Connection) -> rusqlite::Result<u64> {
    JobKind::ALL.iter().try_fold(0, |sum, kind| {
        Ok(sum + count(connection, *kind, Status::Queued)?)
    })
}

fn count(connection: &Connection, kind: JobKind, status: Status) -> rusqlite::Result<u64> {
    let count: i64 = connection
        .prepare_cached("SELECT count(*) FROM jobs WHERE kind = ?1 AND status = ?2")?
        .query_row([kind.as_str(), status.as_str()], |row| row.get(0))?;
    Ok(count.unsigned_abs())
}

fn record(row: &Row<'_>) -> rusqlite::Result<JobRecord> {
    let text: String = row.get(0)?;
    let mut record: JobRecord = serde_json::from_str(&text).map_err(unreadable)?;
    record.revision = row.get::<_, i64>(1)?.cast_unsigned();
    Ok(record)
}

fn json(record: &JobRecord) -> rusqlite::Result<String> {
    serde_json::to_string(record)
        .map_err(|cause| rusqlite::Error::ToSqlConversionFailure(Box::new(cause)))
}
