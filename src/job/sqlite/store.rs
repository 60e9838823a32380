//! The `SQLite` file, its lock, and how it is read and written.

use super::leases::Leases;
use super::rows::ListedJob;
use super::{rows, schema};
use crate::job::clock::{Clock, SystemClock};
use crate::job::record::JobRecord;
use crate::job::status::JobStatus;
use crate::job::store::{JobNotice, StoreError};
use rusqlite::{Connection, OpenFlags, Params, Row, Transaction, TransactionBehavior};
use std::collections::HashSet;
use std::fs::{File, TryLockError};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use uuid::Uuid;

/// Duration of a lease that is not renewed: far above any stall of a busy machine.
const LEASE: Duration = Duration::from_secs(30);

/// The reason why a folder or a file cannot be used.
type Cause = Box<dyn std::error::Error + Send + Sync>;

/// Records, queue and documents in one `SQLite` file, for one process.
///
/// Leases live in memory: whatever the file says is running when it is opened was left behind by a
/// process that died, and goes back to the queue. A lock on the folder keeps a second process out.
pub struct SqliteStore {
    connection: Mutex<Connection>,
    file: PathBuf,
    /// Device and number of the file that was opened.
    place: (u64, u64),
    pub(super) leases: Leases,
    pub(super) listeners: Mutex<Vec<Sender<JobNotice>>>,
    /// Jobs whose unreadable records have been logged.
    unreadable: Mutex<HashSet<Uuid>>,
    _lock: File,
}

impl SqliteStore {
    /// Opens `seamster.db` in a folder, which is made if it is not there.
    ///
    /// # Errors
    /// If it cannot be used, or another process uses it.
    pub fn open(folder: &Path) -> Result<Self, StoreError> {
        Self::open_with_leases(folder, LEASE, Arc::new(SystemClock::default()))
    }

    /// Opens the store as [`SqliteStore::open`] does, with leases that last `lease` by `clock`.
    ///
    /// # Errors
    /// If it cannot be used, or another process uses it.
    pub fn open_with_leases(
        folder: &Path,
        lease: Duration,
        clock: Arc<dyn Clock>,
    ) -> Result<Self, StoreError> {
        let failed = |cause: Cause| StoreError::new(format!("opening {}", folder.display()), cause);
        let lock = lock_folder(folder).map_err(failed)?;
        let file = folder.join("seamster.db");
        let connection = schema::open_database(&file).map_err(failed)?;
        let place = file_place(&file).map_err(|cause| failed(cause.into()))?;
        let store = Self {
            connection: Mutex::new(connection),
            file,
            place,
            leases: Leases::new(lease, clock),
            listeners: Mutex::default(),
            unreadable: Mutex::default(),
            _lock: lock,
        };
        store.requeue_running()?;
        Ok(store)
    }

    /// Checks that the file is still where it was opened: what is written to one that was removed
    /// is lost.
    pub(super) fn check_place(&self) -> Result<(), StoreError> {
        let doing = || format!("looking at {}", self.file.display());
        let place = file_place(&self.file).map_err(|cause| StoreError::new(doing(), cause))?;
        if place == self.place {
            return Ok(());
        }
        let cause = "it is another file than the one that was opened";
        Err(StoreError::new(doing(), cause))
    }

    /// Reads a row of each table by a connection of its own, which has nothing in its memory yet.
    pub(super) fn check_file(&self) -> Result<(), StoreError> {
        self.check_place()?;
        let doing = "reading the database file";
        let checked = Connection::open_with_flags(&self.file, OpenFlags::SQLITE_OPEN_READ_ONLY)
            .and_then(|connection| {
                for table in ["jobs", "keys", "documents"] {
                    let query = format!("SELECT count(*) FROM (SELECT 1 FROM {table} LIMIT 1)");
                    connection.query_row(&query, [], |row| row.get::<_, i64>(0))?;
                }
                Ok(())
            });
        checked.map_err(|cause| store_error(doing, cause))
    }

    /// Locks the connection.
    pub(super) fn connection(&self) -> MutexGuard<'_, Connection> {
        // A panic while it was held rolled its transaction back: the connection is sound.
        self.connection
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs `work` in a transaction that is written whole or not at all.
    pub(super) fn write<T>(
        &self,
        doing: &str,
        work: impl FnOnce(&Transaction<'_>) -> rusqlite::Result<T>,
    ) -> Result<T, StoreError> {
        self.check_place()?;
        let mut connection = self.connection();
        let written = connection
            .transaction_with_behavior(TransactionBehavior::Immediate)
            .and_then(|transaction| {
                let value = work(&transaction)?;
                transaction.commit()?;
                Ok(value)
            });
        written.map_err(|cause| store_error(doing, cause))
    }

    /// Returns the rows that a query finds.
    pub(super) fn read<T>(
        &self,
        doing: &str,
        (query, params): (&str, impl Params),
        row: impl FnMut(&Row<'_>) -> rusqlite::Result<T>,
    ) -> Result<Vec<T>, StoreError> {
        let connection = self.connection();
        let found = connection
            .prepare_cached(query)
            .and_then(|mut statement| statement.query_map(params, row)?.collect());
        found.map_err(|cause| store_error(doing, cause))
    }

    /// Returns the record of a listed job, unless it cannot be read: the log tells of that once,
    /// since lists are read every few seconds.
    pub(super) fn listed_record(&self, (id, record): ListedJob) -> Option<JobRecord> {
        let tell = |cause: &rusqlite::Error| {
            let unreadable = self.unreadable.lock();
            let mut unreadable = unreadable.unwrap_or_else(PoisonError::into_inner);
            if unreadable.insert(id) {
                tracing::error!(%cause, job = %id, "its record is left out of lists");
            }
        };
        record.inspect_err(tell).ok()
    }

    /// Puts the jobs that a process was running when it died back on the queue.
    fn requeue_running(&self) -> Result<(), StoreError> {
        self.write("requeueing jobs", |transaction| {
            let running = rows::jobs_of_status(transaction, JobStatus::Running)?;
            // One that cannot be read is told of by the attempt to run it.
            for mut record in running.into_iter().filter_map(|(_, record)| record.ok()) {
                record.status = JobStatus::Queued;
                record.started_at = None;
                record.service_deaths += u32::from(record.isolated);
                record.isolated = true;
                rows::update_job(transaction, &record)?;
            }
            Ok(())
        })
    }
}

/// Returns the error of a call of `SQLite`: one of data, unless the machine is at fault.
pub(super) fn store_error(doing: &str, cause: rusqlite::Error) -> StoreError {
    use rusqlite::ErrorCode as Code;
    let is_passing = matches!(
        cause.sqlite_error_code(),
        Some(
            Code::CannotOpen
                | Code::DatabaseBusy
                | Code::DatabaseLocked
                | Code::DiskFull
                | Code::OutOfMemory
                | Code::PermissionDenied
                | Code::ReadOnly
                | Code::SystemIoFailure
        )
    );
    if is_passing {
        StoreError::new(doing, cause)
    } else {
        StoreError::of_data(doing, cause)
    }
}

/// Returns the device and the number of a file: two names of one file have the same.
fn file_place(file: &Path) -> std::io::Result<(u64, u64)> {
    let metadata = std::fs::metadata(file)?;
    Ok((metadata.dev(), metadata.ino()))
}

/// Takes the lock that keeps a second process out; the system drops it when this process ends,
/// however it ends.
fn lock_folder(folder: &Path) -> Result<File, Cause> {
    std::fs::create_dir_all(folder)?;
    let lock = File::create(folder.join("lock"))?;
    match lock.try_lock() {
        Ok(()) => Ok(lock),
        Err(TryLockError::WouldBlock) => Err("another process uses this folder".into()),
        Err(TryLockError::Error(cause)) => Err(cause.into()),
    }
}
