//! The tables, and how those of an older version are brought up to date.

use rusqlite::Connection;
use std::path::Path;

/// Version of the tables below.
const VERSION: i64 = 2;

/// Ids are stored as 16 bytes, so that they sort by time.
const CREATE_TABLES: &str = "
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

/// Changes to the tables of version 1, which had fits only.
const MIGRATE_FROM_1: &str = "
    ALTER TABLE fits RENAME TO jobs;
    ALTER TABLE jobs ADD COLUMN kind TEXT NOT NULL DEFAULT 'fit';
    ALTER TABLE keys RENAME COLUMN fit TO job;
    DROP INDEX fits_by_status;
";

/// One for the queue, one for lists of a kind, and one for those of a status and for counts.
const CREATE_INDICES: &str = "
    CREATE INDEX jobs_by_status ON jobs (status, id);
    CREATE INDEX jobs_by_kind ON jobs (kind, id);
    CREATE INDEX jobs_by_kind_and_status ON jobs (kind, status, id);
    PRAGMA user_version = 2;
";

/// Opens a database file, creates its tables or brings them up to date.
///
/// # Errors
/// If the file cannot be used, or a newer program made its tables.
pub(super) fn open_database(
    file: &Path,
) -> Result<Connection, Box<dyn std::error::Error + Send + Sync>> {
    let mut connection = Connection::open(file)?;
    connection.pragma_update(None, "journal_mode", "WAL")?;
    // FULL, since a job that was accepted must survive a power cut too; one flush per change is
    // nothing beside a job.
    connection.pragma_update(None, "synchronous", "FULL")?;
    let version: i64 = connection.pragma_query_value(None, "user_version", |row| row.get(0))?;
    let tables = match version {
        0 => CREATE_TABLES,
        1 => MIGRATE_FROM_1,
        VERSION => return Ok(connection),
        _ => {
            return Err(format!("its version is {version}, this program knows {VERSION}").into());
        }
    };
    let transaction = connection.transaction()?;
    transaction.execute_batch(tables)?;
    transaction.execute_batch(CREATE_INDICES)?;
    transaction.commit()?;
    Ok(connection)
}
