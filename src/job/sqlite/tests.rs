//! Tests of the `SQLite` store: the contracts, the lock, old files, durability.

use super::SqliteStore;
use crate::job::clock::ManualClock;
use crate::job::contract::store_contract;
use crate::job::documents_contract::documents_contract;
use crate::job::kind::JobKind;
use crate::job::record::JobRecord;
use crate::job::status::JobStatus;
use crate::job::store::{
    DocumentKind, Documents, IdempotencyKey, JobStore, NewJob, PageRequest, StoreError, Submitted,
};
use jiff::Timestamp;
use rusqlite::Connection;
use std::fs::File;
use std::sync::{Arc, Mutex};
use std::time::Duration;
use uuid::Uuid;

#[test]
fn contract_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let clock = ManualClock::default();
    store_contract(&clock, |space| {
        let folder = folder.path().join(space);
        let lease = Duration::from_secs(30);
        Arc::new(SqliteStore::open_with_leases(&folder, lease, Arc::new(clock.clone())).unwrap())
    });
    documents_contract(&SqliteStore::open(folder.path()).unwrap());
}

#[test]
fn second_process_is_kept_out() {
    let folder = tempfile::tempdir().unwrap();
    let first = SqliteStore::open(folder.path()).unwrap();
    let error = SqliteStore::open(folder.path())
        .err()
        .expect("it is in use");
    assert!(error.to_string().contains("another process"), "{error}");
    drop(first);
    SqliteStore::open(folder.path()).unwrap();
}

#[test]
fn tables_of_another_version_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    drop(SqliteStore::open(folder.path()).unwrap());
    let connection = Connection::open(folder.path().join("seamster.db")).unwrap();
    connection.pragma_update(None, "user_version", 99).unwrap();
    drop(connection);
    assert!(SqliteStore::open(folder.path()).is_err());
}

/// The tables as version 1 made them, with a fit that ran, one that had ended, and the key of the
/// first.
const VERSION_1: &str = "
    CREATE TABLE fits (
        id BLOB PRIMARY KEY,
        status TEXT NOT NULL,
        revision INTEGER NOT NULL,
        record TEXT NOT NULL
    ) WITHOUT ROWID;
    CREATE INDEX fits_by_status ON fits (status, id);
    CREATE TABLE keys (
        key TEXT PRIMARY KEY,
        digest BLOB NOT NULL,
        fit BLOB NOT NULL
    ) WITHOUT ROWID;
    CREATE TABLE documents (
        kind TEXT NOT NULL,
        id BLOB NOT NULL,
        body BLOB NOT NULL,
        PRIMARY KEY (kind, id)
    );
    INSERT INTO fits VALUES (x'019a0000000070008000000000000001', 'running', 1, '{
        \"id\": \"019a0000-0000-7000-8000-000000000001\", \"status\": \"running\",
        \"created_at\": \"2026-01-01T00:00:00Z\", \"started_at\": \"2026-01-01T00:00:01Z\", \"finished_at\": null,
        \"attempts\": 1, \"released\": 0, \"error\": null, \"result\": null, \"cancel_requested\": false,
        \"progress\": {\"stage\": \"sew\", \"fraction\": 0.1, \"level\": 0, \"residual\": null, \"seam_gap_m\": null, \"cpu_s\": 1.0}
    }');
    INSERT INTO fits VALUES (x'019a0000000070008000000000000002', 'succeeded', 2, '{
        \"id\": \"019a0000-0000-7000-8000-000000000002\", \"status\": \"succeeded\",
        \"created_at\": \"2026-01-01T00:00:00Z\", \"started_at\": \"2026-01-01T00:00:01Z\",
        \"finished_at\": \"2026-01-01T00:00:02Z\", \"attempts\": 1, \"released\": 0, \"error\": null, \"result\": 1,
        \"cancel_requested\": false,
        \"progress\": {\"stage\": \"export\", \"fraction\": 1.0, \"level\": 0, \"residual\": null, \"seam_gap_m\": null, \"cpu_s\": 1.0}
    }');
    INSERT INTO keys VALUES ('monday', zeroblob(32), x'019a0000000070008000000000000001');
    INSERT INTO documents VALUES ('fabric', x'019a0000000070008000000000000003', x'7B7D');
    PRAGMA user_version = 1;
";

#[test]
fn a_folder_of_before_there_were_studies_opens() {
    let folder = tempfile::tempdir().unwrap();
    let connection = Connection::open(folder.path().join("seamster.db")).unwrap();
    connection.execute_batch(VERSION_1).unwrap();
    drop(connection);
    // A second time finds the tables as the first left them.
    for _ in 0..2 {
        let store = SqliteStore::open(folder.path()).unwrap();
        let page = PageRequest {
            limit: 9,
            ..PageRequest::default()
        };
        let fits = store.jobs(JobKind::Fit, &page).unwrap().items;
        let found: Vec<_> = fits.iter().map(|fit| (fit.kind, fit.status)).collect();
        // What ran when the process ended waits again.
        let expected = [JobStatus::Succeeded, JobStatus::Queued].map(|one| (JobKind::Fit, one));
        assert_eq!(found, expected);
        assert_eq!(store.jobs(JobKind::Study, &page).unwrap().items, []);
        let key = IdempotencyKey {
            key: "monday".to_owned(),
            digest: [0; 32],
        };
        let same = Submitted::Same(fits[1].id);
        assert_eq!(store.submitted(&key).unwrap(), Some(same));
        assert_eq!(
            store.claim().unwrap().map(|lease| lease.job),
            Some(fits[1].id)
        );
        let fabric = Uuid::from_u128(0x019a_0000_0000_7000_8000_0000_0000_0003);
        assert!(store.get(DocumentKind::Fabric, fabric).unwrap().is_some());
    }
}

fn submit(store: &SqliteStore, record: &JobRecord) {
    let job = NewJob {
        record,
        key: None,
        queue_limit: 9,
    };
    assert_eq!(store.submit(&job).unwrap(), Submitted::New);
}

fn fit() -> JobRecord {
    JobRecord::queued(JobKind::Fit, Uuid::now_v7(), Timestamp::now())
}

#[test]
fn a_failed_job_keeps_what_can_be_read_of_its_record() {
    let folder = tempfile::tempdir().unwrap();
    let store = SqliteStore::open(folder.path()).unwrap();
    let cause = StoreError::of_data("reading", "as told");
    for spoil in [
        "record",
        "json_set(record, '$.progress', 'none')",
        "json_set(record, '$.progress.stage', 7, '$.status', 'stuck', '$.more', 1)",
        "json_remove(record, '$.created_at')",
    ] {
        let record = JobRecord {
            attempts: 3,
            released: 1,
            isolated: true,
            started_at: Some(Timestamp::UNIX_EPOCH),
            ..fit()
        };
        submit(&store, &record);
        let spoil = format!("UPDATE jobs SET record = {spoil} WHERE id = ?1");
        let changed = store.connection().execute(&spoil, [record.id.as_bytes()]);
        assert_eq!(changed, Ok(1));
        let failed = store.fail(record.id, &cause).unwrap().unwrap();
        assert_eq!(store.job(record.id).unwrap().as_ref(), Some(&failed));
        assert!(failed.finished_at.is_some() && failed.error.is_some());
        let lost = record.created_at.duration_since(failed.created_at);
        assert!(lost.abs() < jiff::SignedDuration::from_secs(1), "{spoil}");
        let expected = JobRecord {
            status: JobStatus::Failed,
            created_at: failed.created_at,
            finished_at: failed.finished_at,
            error: failed.error.clone(),
            revision: failed.revision,
            ..record
        };
        assert_eq!(failed, expected, "{spoil}");
    }
}

#[test]
fn a_job_of_a_kind_of_a_newer_program_is_left_to_that() {
    let folder = tempfile::tempdir().unwrap();
    let newer = fit();
    {
        let store = SqliteStore::open(folder.path()).unwrap();
        submit(&store, &newer);
        let change = "UPDATE jobs SET kind = 'repair', status = 'running',
            record = json_set(record, '$.kind', 'repair', '$.status', 'running')";
        assert_eq!(store.connection().execute(change, []), Ok(1));
    }
    let store = SqliteStore::open(folder.path()).unwrap();
    let known = fit();
    submit(&store, &known);
    assert_eq!(
        store.claim().unwrap().map(|lease| lease.job),
        Some(known.id)
    );
    assert_eq!(store.claim().unwrap(), None);
    let status: String = store
        .connection()
        .query_row("SELECT status FROM jobs WHERE kind = 'repair'", [], |row| {
            row.get(0)
        })
        .unwrap();
    assert_eq!(status, "running");
}

#[test]
fn the_log_tells_of_an_unreadable_record_once() {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("log");
    let subscriber = tracing_subscriber::fmt()
        .with_writer(Mutex::new(File::create(&log).unwrap()))
        .finish();
    let store = SqliteStore::open(folder.path()).unwrap();
    submit(&store, &fit());
    submit(&store, &fit());
    let changed = store
        .connection()
        .execute("UPDATE jobs SET record = '{}'", []);
    assert_eq!(changed, Ok(2));
    let page = PageRequest {
        limit: 9,
        ..PageRequest::default()
    };
    tracing::subscriber::with_default(subscriber, || {
        for _ in 0..5 {
            assert_eq!(store.jobs(JobKind::Fit, &page).unwrap().items, []);
        }
    });
    let log = std::fs::read_to_string(log).unwrap();
    assert_eq!(log.matches("its record is left out").count(), 2, "{log}");
}

#[test]
fn accepted_jobs_survive_a_power_cut() {
    let folder = tempfile::tempdir().unwrap();
    let store = SqliteStore::open(folder.path()).unwrap();
    let pragma = |name| {
        let connection = store.connection();
        let value = connection
            .pragma_query_value(None, name, |row| row.get::<_, rusqlite::types::Value>(0));
        value.unwrap()
    };
    assert_eq!(pragma("synchronous"), rusqlite::types::Value::Integer(2));
    assert_eq!(pragma("journal_mode"), "wal".to_owned().into());
}
