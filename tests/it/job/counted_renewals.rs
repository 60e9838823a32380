//! A store that counts how often leases are renewed, so that a test can wait for it.

use seamster::job::{
    IdempotencyKey, JobCounts, JobKind, JobNotice, JobRecord, JobStore, Lease, NewJob, Page,
    PageRequest, SqliteStore, StoreError, Submitted,
};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::Receiver;
use std::time::Duration;
use uuid::Uuid;

/// A store that does as the one inside does, and counts renewals.
pub(super) struct CountedRenewals {
    store: Arc<SqliteStore>,
    renewals: AtomicUsize,
}

impl CountedRenewals {
    pub(super) fn new(store: Arc<SqliteStore>) -> Self {
        Self {
            store,
            renewals: AtomicUsize::new(0),
        }
    }

    /// Number of renewals so far.
    pub(super) fn renewals(&self) -> usize {
        self.renewals.load(Ordering::SeqCst)
    }
}

impl JobStore for CountedRenewals {
    fn submit(&self, job: &NewJob<'_>) -> Result<Submitted, StoreError> {
        self.store.submit(job)
    }

    fn submitted(&self, key: &IdempotencyKey) -> Result<Option<Submitted>, StoreError> {
        self.store.submitted(key)
    }

    fn job(&self, id: Uuid) -> Result<Option<JobRecord>, StoreError> {
        self.store.job(id)
    }

    fn replace(&self, record: &JobRecord) -> Result<Option<u64>, StoreError> {
        self.store.replace(record)
    }

    fn fail(&self, id: Uuid, cause: &StoreError) -> Result<Option<JobRecord>, StoreError> {
        self.store.fail(id, cause)
    }

    fn jobs(&self, kind: JobKind, page: &PageRequest) -> Result<Page<JobRecord>, StoreError> {
        self.store.jobs(kind, page)
    }

    fn counts(&self, kind: JobKind) -> Result<JobCounts, StoreError> {
        self.store.counts(kind)
    }

    fn lease_time(&self) -> Duration {
        self.store.lease_time()
    }

    fn claim(&self) -> Result<Option<Lease>, StoreError> {
        self.store.claim()
    }

    fn renew(&self, lease: &Lease) -> Result<bool, StoreError> {
        let renewed = self.store.renew(lease);
        self.renewals.fetch_add(1, Ordering::SeqCst);
        renewed
    }

    fn end(&self, lease: &Lease) -> Result<(), StoreError> {
        self.store.end(lease)
    }

    fn probe(&self) -> Result<(), StoreError> {
        self.store.probe()
    }

    fn listen(&self) -> Receiver<JobNotice> {
        self.store.listen()
    }

    fn publish(&self, notice: JobNotice) {
        self.store.publish(notice);
    }
}
