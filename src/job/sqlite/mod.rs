//! Job records, the queue and documents in one `SQLite` file, for one process.

mod documents;
mod job_store;
mod leases;
mod paging;
mod rows;
mod schema;
mod store;
#[cfg(test)]
mod tests;

pub use store::SqliteStore;
