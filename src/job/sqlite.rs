//! Records, queue and documents in one `SQLite` file, for one process.

use super::store::{DocumentKind, Documents, Page, PageAsked, StoreError};
use super::{Counts, FitRecord, IdempotencyKey, JobStore, Lease, NewFit, Notice, Submitted};
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use uuid::Uuid;

/// Records, queue and documents in one `SQLite` file, for one process.
pub struct SqliteStore {}

impl SqliteStore {
    /// Opens `seamster.db` in a folder, which is made if it is not there.
    ///
    /// # Errors
    /// If it cannot be used, or another process uses it.
    pub fn open(_folder: &Path) -> Result<Self, StoreError> {
        Ok(Self {})
    }
}

fn not_yet<T>() -> Result<T, StoreError> {
    Err(StoreError::new("opening", "not yet"))
}

impl JobStore for SqliteStore {
    fn submit(&self, _fit: &NewFit<'_>) -> Result<Submitted, StoreError> {
        not_yet()
    }
    fn submitted(&self, _key: &IdempotencyKey) -> Result<Option<Submitted>, StoreError> {
        not_yet()
    }
    fn fit(&self, _id: Uuid) -> Result<Option<FitRecord>, StoreError> {
        not_yet()
    }
    fn replace(&self, _record: &FitRecord) -> Result<Option<u64>, StoreError> {
        not_yet()
    }
    fn fits(&self, _page: &PageAsked) -> Result<Page<FitRecord>, StoreError> {
        not_yet()
    }
    fn counts(&self) -> Result<Counts, StoreError> {
        not_yet()
    }
    fn claim(&self) -> Result<Option<Lease>, StoreError> {
        not_yet()
    }
    fn renew(&self, _lease: &Lease) -> Result<bool, StoreError> {
        not_yet()
    }
    fn end(&self, _lease: &Lease) -> Result<(), StoreError> {
        not_yet()
    }
    fn listen(&self) -> Receiver<Notice> {
        channel().1
    }
    fn publish(&self, _notice: Notice) {}
}

impl Documents for SqliteStore {
    fn put(&self, _kind: DocumentKind, _id: Uuid, _body: &[u8]) -> Result<(), StoreError> {
        not_yet()
    }
    fn get(&self, _kind: DocumentKind, _id: Uuid) -> Result<Option<Vec<u8>>, StoreError> {
        not_yet()
    }
    fn delete(&self, _kind: DocumentKind, _id: Uuid) -> Result<bool, StoreError> {
        not_yet()
    }
    fn list(
        &self,
        _kind: DocumentKind,
        _page: &PageAsked,
    ) -> Result<Page<(Uuid, Vec<u8>)>, StoreError> {
        not_yet()
    }
}
