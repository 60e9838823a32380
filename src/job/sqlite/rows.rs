//! Rows of the tables `jobs` and `keys`: read, written, counted.

use crate::job::failure::JobFailure;
use crate::job::kind::JobKind;
use crate::job::record::JobRecord;
use crate::job::status::JobStatus;
use crate::job::store::{IdempotencyKey, NewJob, StoreError, Submitted};
use jiff::Timestamp;
use rusqlite::{Connection, OptionalExtension, Row, params};
use serde_json::Value;
use uuid::Uuid;

/// Reads a record from the columns `record` and `revision`.
pub(super) fn job_record(row: &Row<'_>) -> rusqlite::Result<JobRecord> {
    let text: String = row.get(0)?;
    let mut record: JobRecord = serde_json::from_str(&text).map_err(unreadable)?;
    record.revision = row.get::<_, i64>(1)?.cast_unsigned();
    Ok(record)
}

/// The id of a job, and its record if that can be read.
pub(super) type ListedJob = (Uuid, rusqlite::Result<JobRecord>);

/// Reads the id of a job from the column after its record, and the record.
pub(super) fn listed_job(row: &Row<'_>) -> rusqlite::Result<ListedJob> {
    Ok((Uuid::from_bytes(row.get(2)?), job_record(row)))
}

/// Returns all jobs of a status.
pub(super) fn jobs_of_status(
    connection: &Connection,
    status: JobStatus,
) -> rusqlite::Result<Vec<ListedJob>> {
    connection
        .prepare("SELECT record, revision, id FROM jobs WHERE status = ?1")?
        .query_map([status.as_str()], listed_job)?
        .collect()
}

/// Writes a record if its revision is still the stored one, and returns the next revision.
pub(super) fn update_job(
    connection: &Connection,
    record: &JobRecord,
) -> rusqlite::Result<Option<u64>> {
    let changed = connection
        .prepare_cached(
            "UPDATE jobs SET status = ?2, record = ?3, revision = revision + 1
             WHERE id = ?1 AND revision = ?4",
        )?
        .execute(params![
            record.id.as_bytes(),
            record.status.as_str(),
            record_json(record)?,
            record.revision.cast_signed(),
        ])?;
    Ok((changed == 1).then_some(record.revision + 1))
}

/// Writes that a job that has not ended has failed for `cause`, and returns its record, in which
/// what cannot be read is as in a new one. Returns `None` if there is no such job.
pub(super) fn fail_job(
    connection: &Connection,
    id: Uuid,
    cause: &StoreError,
) -> rusqlite::Result<Option<JobRecord>> {
    let found = connection
        .prepare_cached(
            "SELECT kind, revision, record FROM jobs
             WHERE id = ?1 AND status IN ('queued', 'running')",
        )?
        .query_row([id.as_bytes()], |row| {
            let text: String = row.get(2).unwrap_or_default();
            Ok((row.get::<_, String>(0)?, row.get::<_, i64>(1)?, text))
        })
        .optional()?;
    let Some((word, revision, text)) = found else {
        return Ok(None);
    };
    let mut kinds = JobKind::ALL.into_iter();
    let Some(kind) = kinds.find(|kind| kind.as_str() == word) else {
        return Ok(None);
    };
    let blank = JobRecord::queued(kind, id, submitted_at(id));
    let mut record = JobRecord {
        id,
        kind,
        status: JobStatus::Failed,
        finished_at: Some(Timestamp::now()),
        error: Some(JobFailure::storage(kind, cause)),
        revision: revision.cast_unsigned(),
        ..readable_part(&text, blank)
    };
    let written = update_job(connection, &record)?;
    record.revision = written.unwrap_or(record.revision);
    Ok(written.map(|_| record))
}

/// Returns the record that a text holds; what of it cannot be read is as in `blank`.
fn readable_part(text: &str, blank: JobRecord) -> JobRecord {
    let Ok(Value::Object(fields)) = serde_json::from_str(text) else {
        return blank;
    };
    fields.into_iter().fold(blank, |record, (name, value)| {
        with_field(&record, name, value).unwrap_or(record)
    })
}

/// Returns a record with one field as it is stored.
fn with_field(record: &JobRecord, name: String, value: Value) -> serde_json::Result<JobRecord> {
    let mut fields = serde_json::to_value(record)?;
    fields[name] = value;
    serde_json::from_value(fields)
}

/// Returns the time of submission of a job, which its id tells.
fn submitted_at(id: Uuid) -> Timestamp {
    let told = id.get_timestamp().map(|time| time.to_unix());
    let time = told.and_then(|(seconds, nanoseconds)| {
        let nanoseconds = i32::try_from(nanoseconds).ok()?;
        Timestamp::new(seconds.cast_signed(), nanoseconds).ok()
    });
    time.unwrap_or_else(Timestamp::now)
}

/// Inserts a job, and the idempotency key that it was submitted with.
pub(super) fn insert_job(connection: &Connection, job: &NewJob<'_>) -> rusqlite::Result<()> {
    let record = job.record;
    connection.execute(
        "INSERT INTO jobs (id, kind, status, revision, record) VALUES (?1, ?2, ?3, 0, ?4)",
        params![
            record.id.as_bytes(),
            record.kind.as_str(),
            record.status.as_str(),
            record_json(record)?
        ],
    )?;
    if let Some(key) = job.key {
        connection.execute(
            "INSERT OR REPLACE INTO keys (key, digest, job) VALUES (?1, ?2, ?3)",
            params![key.key, key.digest, record.id.as_bytes()],
        )?;
    }
    Ok(())
}

/// Returns the job that an idempotency key stands for, or that the key was used for another
/// request. A job that failed by no fault of its request has lost its key: sent again, it runs
/// again.
pub(super) fn job_of_key(
    connection: &Connection,
    key: &IdempotencyKey,
) -> rusqlite::Result<Option<Submitted>> {
    let found = connection
        .prepare_cached("SELECT digest, job FROM keys WHERE key = ?1")?
        .query_row([&key.key], |row| {
            Ok((row.get::<_, [u8; 32]>(0)?, Uuid::from_bytes(row.get(1)?)))
        })
        .optional()?;
    let Some((digest, job)) = found else {
        return Ok(None);
    };
    if digest != key.digest {
        return Ok(Some(Submitted::KeyReused));
    }
    let record = connection
        .prepare_cached("SELECT record, revision FROM jobs WHERE id = ?1")?
        .query_row([job.as_bytes()], job_record)
        .optional()?;
    let error = record.and_then(|record| record.error);
    let is_kept = !error.is_some_and(|error| error.is_internal());
    Ok(is_kept.then_some(Submitted::Same(job)))
}

/// Counts the jobs of all kinds that wait.
pub(super) fn count_queued(connection: &Connection) -> rusqlite::Result<u64> {
    JobKind::ALL.iter().try_fold(0, |sum, kind| {
        Ok(sum + count_jobs(connection, *kind, JobStatus::Queued)?)
    })
}

/// Counts the jobs of a kind and a status.
pub(super) fn count_jobs(
    connection: &Connection,
    kind: JobKind,
    status: JobStatus,
) -> rusqlite::Result<u64> {
    let count: i64 = connection
        .prepare_cached("SELECT count(*) FROM jobs WHERE kind = ?1 AND status = ?2")?
        .query_row([kind.as_str(), status.as_str()], |row| row.get(0))?;
    Ok(count.unsigned_abs())
}

fn record_json(record: &JobRecord) -> rusqlite::Result<String> {
    serde_json::to_string(record)
        .map_err(|cause| rusqlite::Error::ToSqlConversionFailure(Box::new(cause)))
}

/// The error of a row that holds a record this program does not know.
fn unreadable(cause: serde_json::Error) -> rusqlite::Error {
    rusqlite::Error::FromSqlConversionFailure(0, rusqlite::types::Type::Text, Box::new(cause))
}
