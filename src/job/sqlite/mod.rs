//! Records, queue and documents in one `SQLite` file, for one process.

mod documents;
mod leases;
mod records;

use super::record::Status;
use super::store::{Notice, StoreError};
use leases::Leases;
use rusqlite::{Connection, Params, Row, Transaction, TransactionBehavior};
use std::fs::{File, TryLockError};
use std::path::Path;
use std::sync::mpsc::Sender;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How long a lease lasts unless it is renewed: far above any stall of a busy machine.
const LEASE: Duration = Duration::from_secs(30);

/// The version of the tables below.
const VERSION: i64 = 2;

/// Ids are stored as 16 bytes, so that they sort by time.
const TABLES: &str = "
    CREATE TABLE jobs (
        id BLOB PRIMARY KEY,
        kind TEXT NOT NULL,
        status TEXT NOT NULL,
        revision INTEGER NOT NULL,
        record TEXT NOT NULL
    ) WITHOUT ROWID;
    CREATE TABLE keys (
        key TEXT PRIMARY KEY,
        digest BLOB NOT NULL,
        job BLOB NOT NULL
    ) WITHOUT ROWID;
    CREATE TABLE documents (
        kind TEXT NOT NULL,
        id BLOB NOT NULL,
        body BLOB NOT NULL,
        PRIMARY KEY (kind, id)
    );
";

/// What version 1, of before there were studies, lacks.
const FROM_1: &str = "
    ALTER TABLE fits RENAME TO jobs;
    ALTER TABLE jobs ADD COLUMN kind TEXT NOT NULL DEFAULT 'fit';
    ALTER TABLE keys RENAME COLUMN fit TO job;
    DROP INDEX fits_by_status;
";

/// One for the queue, one for lists of a kind, and one for those of a status and for counts.
const INDICES: &str = "
    CREATE INDEX jobs_by_status ON jobs (status, id);
    CREATE INDEX jobs_by_kind ON jobs (kind, id);
    CREATE INDEX jobs_by_kind_and_status ON jobs (kind, status, id);
    PRAGMA user_version = 2;
";

/// Records, queue and documents in one `SQLite` file, for one process.
///
/// Leases live in memory: whatever the file says is running when it is opened was left behind by a process that died, and
/// goes back to the queue. A lock on the folder keeps a second process out.
pub struct SqliteStore {
    connection: Mutex<Connection>,
    leases: Leases,
    listeners: Mutex<Vec<Sender<Notice>>>,
    _lock: File,
}

impl SqliteStore {
    /// Opens `seamster.db` in a folder, which is made if it is not there.
    ///
    /// # Errors
    /// If it cannot be used, or another process uses it.
    pub fn open(folder: &Path) -> Result<Self, StoreError> {
        Self::open_with_lease(folder, LEASE)
    }

    /// The same, with leases that last as long as said.
    ///
    /// # Errors
    /// If it cannot be used, or another process uses it.
    pub fn open_with_lease(folder: &Path, lease: Duration) -> Result<Self, StoreError> {
        let failed = |cause| StoreError::new(format!("opening {}", folder.display()), cause);
        let lock = locked(folder).map_err(failed)?;
        let file = folder.join("seamster.db");
        let connection = opened(&file).map_err(failed)?;
        let store = Self {
            connection: Mutex::new(connection),
            leases: Leases::lasting(lease),
            listeners: Mutex::default(),
            _lock: lock,
        };
        store.requeue_running()?;
        Ok(store)
    }

    fn connection(&self) -> MutexGuard<'_, Connection> {
        // A panic while it was held rolled its transaction back: the connection is sound.
        self.connection
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs `work` in a transaction that is written whole or not at all.
    fn write<T>(
        &self,
        doing: &str,
        work: impl FnOnce(&Transaction<'_>) -> rusqlite::Result<T>,
    ) -> Result<T, StoreError> {
        let mut connection = self.connection();
        let written = connection
            .transaction_with_behavior(TransactionBehavior::Immediate)
            .and_then(|transaction| {
                let value = work(&transaction)?;
                transaction.commit()?;
                Ok(value)
            });
        written.map_err(|cause| StoreError::new(doing, cause))
    }

    /// The rows that a query finds.
    fn read<T>(
        &self,
        doing: &str,
        (query, params): (&str, impl Params),
        row: impl FnMut(&Row<'_>) -> rusqlite::Result<T>,
    ) -> Result<Vec<T>, StoreError> {
        let connection = self.connection();
        let found = connection
            .prepare_cached(query)
            .and_then(|mut statement| statement.query_map(params, row)?.collect());
        found.map_err(|cause| StoreError::new(doing, cause))
    }

    /// Puts back what a process that died was running.
    fn requeue_running(&self) -> Result<(), StoreError> {
        self.write("requeueing jobs", |transaction| {
            for mut record in records::of_status(transaction, Status::Running)? {
                record.status = Status::Queued;
                record.started_at = None;
                records::update(transaction, &record)?;
            }
            Ok(())
        })
    }
}

/// The lock that keeps a second process out; the system drops it when this process ends, however it ends.
fn locked(folder: &Path) -> Result<File, Box<dyn std::error::Error + Send + Sync>> {
    std::fs::create_dir_all(folder)?;
    let lock = File::create(folder.join("lock"))?;
    match lock.try_lock() {
        Ok(()) => Ok(lock),
        Err(TryLockError::WouldBlock) => Err("another process uses this folder".into()),
        Err(TryLockError::Error(cause)) => Err(cause.into()),
    }
}

fn opened(file: &Path) -> Result<Connection, Box<dyn std::error::Error + Send + Sync>> {
    let mut connection = Connection::open(file)?;
    connection.pragma_update(None, "journal_mode", "WAL")?;
    // FULL, since a job that was accepted must survive a power cut too; one flush per change is nothing beside a job.
    connection.pragma_update(None, "synchronous", "FULL")?;
    let version: i64 = connection.pragma_query_value(None, "user_version", |row| row.get(0))?;
    let tables = match version {
        0 => TABLES,
        1 => FROM_1,
        VERSION => return Ok(connection),
        _ => {
            return Err(format!("its version is {version}, this program knows {VERSION}").into());
        }
    };
    let transaction = connection.transaction()?;
    transaction.execute_batch(tables)?;
    transaction.execute_batch(INDICES)?;
    transaction.commit()?;
    Ok(connection)
}

/// A value that a row holds in a form that this program does not know.
fn unreadable(cause: impl std::error::Error + Send + Sync + 'static) -> rusqlite::Error {
    rusqlite::Error::FromSqlConversionFailure(0, rusqlite::types::Type::Text, Box::new(cause))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::contract::{documents_contract, store_contract};
    use crate::job::record::JobKind;
    use crate::job::store::{
        DocumentKind, Documents, IdempotencyKey, JobStore, PageAsked, Submitted,
    };
    use std::sync::Arc;
    use uuid::Uuid;

    #[test]
    fn contract_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        store_contract(|space, lease| {
            Arc::new(SqliteStore::open_with_lease(&folder.path().join(space), lease).unwrap())
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

    /// The tables as version 1 made them, with a fit that ran, one that had ended, and the key of the first.
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
            let page = PageAsked {
                limit: 9,
                ..PageAsked::default()
            };
            let fits = store.jobs(JobKind::Fit, &page).unwrap().items;
            let found: Vec<_> = fits.iter().map(|fit| (fit.kind, fit.status)).collect();
            // What ran when the process ended waits again.
            let expected = [Status::Succeeded, Status::Queued].map(|one| (JobKind::Fit, one));
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
}
