//! The records of fits and their queue.

use super::{SqliteStore, unreadable};
use crate::job::record::{FitRecord, Status};
use crate::job::store::{
    Counts, IdempotencyKey, JobStore, Lease, NewFit, Notice, Page, PageAsked, StoreError, Submitted,
};
use rusqlite::types::Value;
use rusqlite::{Connection, OptionalExtension, Row, params, params_from_iter};
use std::sync::PoisonError;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use uuid::Uuid;

impl JobStore for SqliteStore {
    fn submit(&self, fit: &NewFit<'_>) -> Result<Submitted, StoreError> {
        let submitted = self.write("putting a fit on the queue", |transaction| {
            if let Some(known) = fit
                .key
                .map(|key| known(transaction, key))
                .transpose()?
                .flatten()
            {
                return Ok(known);
            }
            let waiting = count(transaction, Status::Queued)?;
            if usize::try_from(waiting).is_ok_and(|waiting| waiting >= fit.queue_limit) {
                return Ok(Submitted::Full);
            }
            insert(transaction, fit)?;
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

    fn fit(&self, id: Uuid) -> Result<Option<FitRecord>, StoreError> {
        let query = "SELECT record, revision FROM fits WHERE id = ?1";
        let mut found = self.read("reading a fit", (query, [id.as_bytes()]), record)?;
        Ok(found.pop())
    }

    fn replace(&self, record: &FitRecord) -> Result<Option<u64>, StoreError> {
        self.write("writing a fit", |transaction| update(transaction, record))
    }

    fn fits(&self, page: &PageAsked) -> Result<Page<FitRecord>, StoreError> {
        let mut query = "SELECT record, revision FROM fits WHERE id < ?1".to_owned();
        let mut values: Vec<Value> = vec![before(page)];
        if let Some(status) = page.status {
            query.push_str(" AND status = ?2");
            values.push(status.as_str().to_owned().into());
        }
        query.push_str(&format!(" ORDER BY id DESC LIMIT {}", one_more(page)));
        let found = self.read("listing fits", (&query, params_from_iter(values)), record)?;
        Ok(cut(found, page, |record| record.id))
    }

    fn counts(&self) -> Result<Counts, StoreError> {
        let connection = self.connection();
        let mut counts = Counts::default();
        for status in Status::ALL {
            counts.by_status[status as usize] = count(&connection, status)
                .map_err(|cause| StoreError::new("counting fits", cause))?;
        }
        Ok(counts)
    }

    fn lease_time(&self) -> Duration {
        self.leases.time
    }

    fn claim(&self) -> Result<Option<Lease>, StoreError> {
        let query = "SELECT id FROM fits WHERE status IN ('queued', 'running') ORDER BY id";
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
                .fit(lease.fit)?
                .is_some_and(|fit| !fit.status.is_final())
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
) -> rusqlite::Result<Vec<FitRecord>> {
    connection
        .prepare("SELECT record, revision FROM fits WHERE status = ?1")?
        .query_map([status.as_str()], record)?
        .collect()
}

/// Writes a record if its revision is still the stored one, and returns the next.
pub(super) fn update(connection: &Connection, record: &FitRecord) -> rusqlite::Result<Option<u64>> {
    let changed = connection
        .prepare_cached(
            "UPDATE fits SET status = ?2, record = ?3, revision = revision + 1 WHERE id = ?1 AND revision = ?4",
        )?
        .execute(params![
            record.id.as_bytes(),
            record.status.as_str(),
            json(record)?,
            record.revision.cast_signed(),
        ])?;
    Ok((changed == 1).then_some(record.revision + 1))
}

fn insert(connection: &Connection, fit: &NewFit<'_>) -> rusqlite::Result<()> {
    let record = fit.record;
    connection.execute(
        "INSERT INTO fits (id, status, revision, record) VALUES (?1, ?2, 0, ?3)",
        params![record.id.as_bytes(), record.status.as_str(), json(record)?],
    )?;
    if let Some(key) = fit.key {
        connection.execute(
            "INSERT INTO keys (key, digest, fit) VALUES (?1, ?2, ?3)",
            params![key.key, key.digest, record.id.as_bytes()],
        )?;
    }
    Ok(())
}

fn known(connection: &Connection, key: &IdempotencyKey) -> rusqlite::Result<Option<Submitted>> {
    let found = connection
        .prepare_cached("SELECT digest, fit FROM keys WHERE key = ?1")?
        .query_row([&key.key], |row| {
            Ok((row.get::<_, [u8; 32]>(0)?, Uuid::from_bytes(row.get(1)?)))
        })
        .optional()?;
    Ok(found.map(|(digest, fit)| {
        if digest == key.digest {
            Submitted::Same(fit)
        } else {
            Submitted::KeyReused
        }
    }))
}

fn count(connection: &Connection, status: Status) -> rusqlite::Result<u64> {
    let count: i64 = connection
        .prepare_cached("SELECT count(*) FROM fits WHERE status = ?1")?
        .query_row([status.as_str()], |row| row.get(0))?;
    Ok(count.unsigned_abs())
}

fn record(row: &Row<'_>) -> rusqlite::Result<FitRecord> {
    let text: String = row.get(0)?;
    let mut record: FitRecord = serde_json::from_str(&text).map_err(unreadable)?;
    record.revision = row.get::<_, i64>(1)?.cast_unsigned();
    Ok(record)
}

fn json(record: &FitRecord) -> rusqlite::Result<String> {
    serde_json::to_string(record)
        .map_err(|cause| rusqlite::Error::ToSqlConversionFailure(Box::new(cause)))
}
