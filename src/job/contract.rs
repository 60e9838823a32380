//! What every [`JobStore`] must keep, as tests that each implementation runs.

use super::record::{FitRecord, Status};
use super::store::{
    DocumentKind, Documents, IdempotencyKey, JobStore, Lease, NewFit, Notice, PageAsked, Submitted,
};
use jiff::Timestamp;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};
use uuid::Uuid;

/// Longer than any test.
const LONG: Duration = Duration::from_secs(600);
/// Short enough to wait for.
const SHORT: Duration = Duration::from_millis(300);
const NO_LIMIT: usize = usize::MAX;

/// Runs every test. `open(space, lease)` opens the store named `space`: the same name finds what was there, once
/// the store opened before is dropped.
pub(super) fn store_contract(open: impl Fn(&str, Duration) -> Arc<dyn JobStore>) {
    submitted_fit_is_found(&*open("found", LONG));
    stale_revision_changes_nothing(&*open("stale", LONG));
    concurrent_changes_are_all_kept(&open("concurrent", LONG));
    oldest_fit_is_claimed_first_and_once(&*open("oldest", LONG));
    concurrent_claims_differ(&open("claims", LONG));
    lease_that_is_not_renewed_runs_out(&*open("lease", SHORT));
    renewed_lease_lasts(&*open("renewed", SHORT));
    ended_lease_hands_out_again_unless_final(&*open("ended", LONG));
    lost_lease_cannot_end_the_next(&*open("lost", SHORT));
    same_key_is_the_same_fit(&*open("key", LONG));
    concurrent_submissions_of_one_key_are_one_fit(&open("keys", LONG));
    full_queue_refuses(&*open("full", LONG));
    pages_are_newest_first_and_whole(&*open("pages", LONG));
    notices_reach_all_who_listen(&*open("notices", LONG));
    what_ran_when_the_process_died_is_handed_out_again(&open);
}

fn submit(store: &dyn JobStore) -> Uuid {
    let record = FitRecord::queued(Uuid::now_v7(), Timestamp::now());
    assert_eq!(put(store, &record, None, NO_LIMIT), Submitted::New);
    record.id
}

fn put(
    store: &dyn JobStore,
    record: &FitRecord,
    key: Option<&IdempotencyKey>,
    queue_limit: usize,
) -> Submitted {
    store
        .submit(&NewFit {
            record,
            key,
            queue_limit,
        })
        .unwrap()
}

fn get(store: &dyn JobStore, id: Uuid) -> FitRecord {
    store.fit(id).unwrap().expect("it was submitted")
}

fn set_status(store: &dyn JobStore, id: Uuid, status: Status) {
    let mut record = get(store, id);
    record.status = status;
    assert!(store.replace(&record).unwrap().is_some());
}

fn claim(store: &dyn JobStore) -> Option<Lease> {
    store.claim().unwrap()
}

fn submitted_fit_is_found(store: &dyn JobStore) {
    let record = FitRecord::queued(Uuid::now_v7(), Timestamp::now());
    assert_eq!(put(store, &record, None, NO_LIMIT), Submitted::New);
    let found = get(store, record.id);
    assert_eq!(
        FitRecord {
            revision: record.revision,
            ..found
        },
        record
    );
    assert_eq!(store.fit(Uuid::now_v7()).unwrap(), None);
}

fn stale_revision_changes_nothing(store: &dyn JobStore) {
    let id = submit(store);
    let stale = get(store, id);
    let mut record = stale.clone();
    record.attempts = 1;
    let revision = store.replace(&record).unwrap().expect("nobody was faster");
    assert_eq!(get(store, id).revision, revision);
    assert_eq!(store.replace(&stale).unwrap(), None);
    assert_eq!(get(store, id).attempts, 1);
    let unknown = FitRecord::queued(Uuid::now_v7(), Timestamp::now());
    assert_eq!(store.replace(&unknown).unwrap(), None);
    assert_eq!(store.fit(unknown.id).unwrap(), None);
}

fn concurrent_changes_are_all_kept(store: &Arc<dyn JobStore>) {
    let id = submit(&**store);
    let add_one = |store: &dyn JobStore| loop {
        let mut record = get(store, id);
        record.attempts += 1;
        if store.replace(&record).unwrap().is_some() {
            return;
        }
    };
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| (0..10).for_each(|_| add_one(&**store)));
        }
    });
    assert_eq!(get(&**store, id).attempts, 40);
}

fn oldest_fit_is_claimed_first_and_once(store: &dyn JobStore) {
    assert_eq!(claim(store), None);
    let fits = [submit(store), submit(store), submit(store)];
    set_status(store, fits[1], Status::Canceled);
    assert_eq!(claim(store).map(|lease| lease.fit), Some(fits[0]));
    set_status(store, fits[0], Status::Running);
    assert_eq!(claim(store).map(|lease| lease.fit), Some(fits[2]));
    assert_eq!(claim(store), None);
}

fn concurrent_claims_differ(store: &Arc<dyn JobStore>) {
    let fits: BTreeSet<Uuid> = (0..20).map(|_| submit(&**store)).collect();
    let claimed: Vec<Uuid> = thread::scope(|scope| {
        let workers: Vec<_> = (0..4)
            .map(|_| {
                scope.spawn(|| {
                    let fits = std::iter::from_fn(|| claim(&**store));
                    fits.map(|lease| lease.fit).collect::<Vec<_>>()
                })
            })
            .collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap())
            .collect()
    });
    assert_eq!(claimed.len(), 20);
    assert_eq!(claimed.into_iter().collect::<BTreeSet<_>>(), fits);
}

fn lease_that_is_not_renewed_runs_out(store: &dyn JobStore) {
    let id = submit(store);
    let first = claim(store).expect("one waits");
    set_status(store, id, Status::Running);
    thread::sleep(2 * store.lease_time());
    let second = claim(store).expect("its lease ran out");
    assert_eq!(second.fit, id);
    assert!(!store.renew(&first).unwrap());
    assert!(store.renew(&second).unwrap());
}

fn renewed_lease_lasts(store: &dyn JobStore) {
    submit(store);
    let lease = claim(store).expect("one waits");
    let start = Instant::now();
    while start.elapsed() < 3 * store.lease_time() {
        assert!(store.renew(&lease).unwrap());
        assert_eq!(claim(store), None);
        thread::sleep(store.lease_time() / 10);
    }
}

fn ended_lease_hands_out_again_unless_final(store: &dyn JobStore) {
    let id = submit(store);
    let lease = claim(store).expect("one waits");
    let notices = store.listen();
    store.end(&lease).unwrap();
    assert_eq!(
        notices.recv_timeout(Duration::from_secs(10)),
        Ok(Notice::Queued)
    );
    let lease = claim(store).expect("it was given back");
    assert_eq!(lease.fit, id);
    set_status(store, id, Status::Succeeded);
    store.end(&lease).unwrap();
    assert_eq!(claim(store), None);
}

fn lost_lease_cannot_end_the_next(store: &dyn JobStore) {
    submit(store);
    let first = claim(store).expect("one waits");
    thread::sleep(2 * store.lease_time());
    let second = claim(store).expect("its lease ran out");
    store.end(&first).unwrap();
    assert!(store.renew(&second).unwrap());
    assert_eq!(claim(store), None);
}

fn key(key: &str, digest: u8) -> IdempotencyKey {
    IdempotencyKey {
        key: key.to_owned(),
        digest: [digest; 32],
    }
}

fn same_key_is_the_same_fit(store: &dyn JobStore) {
    let new = || FitRecord::queued(Uuid::now_v7(), Timestamp::now());
    let (first, a) = (new(), key("a", 1));
    assert_eq!(store.submitted(&a).unwrap(), None);
    assert_eq!(put(store, &first, Some(&a), NO_LIMIT), Submitted::New);
    let same = Submitted::Same(first.id);
    assert_eq!(put(store, &new(), Some(&a), NO_LIMIT), same);
    assert_eq!(store.submitted(&a).unwrap(), Some(same));
    let other = key("a", 2);
    let reused = Submitted::KeyReused;
    assert_eq!(put(store, &new(), Some(&other), NO_LIMIT), reused);
    assert_eq!(store.submitted(&other).unwrap(), Some(reused));
    let b = key("b", 1);
    assert_eq!(put(store, &new(), Some(&b), NO_LIMIT), Submitted::New);
    assert_eq!(store.counts().unwrap().of(Status::Queued), 2);
}

fn concurrent_submissions_of_one_key_are_one_fit(store: &Arc<dyn JobStore>) {
    let key = key("once", 1);
    thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let record = FitRecord::queued(Uuid::now_v7(), Timestamp::now());
                put(&**store, &record, Some(&key), NO_LIMIT)
            });
        }
    });
    assert_eq!(store.counts().unwrap().of(Status::Queued), 1);
}

fn full_queue_refuses(store: &dyn JobStore) {
    let known = key("known", 1);
    let record = FitRecord::queued(Uuid::now_v7(), Timestamp::now());
    assert_eq!(put(store, &record, Some(&known), 2), Submitted::New);
    submit(store);
    let late = FitRecord::queued(Uuid::now_v7(), Timestamp::now());
    assert_eq!(put(store, &late, Some(&key("late", 1)), 2), Submitted::Full);
    assert_eq!(store.fit(late.id).unwrap(), None);
    assert_eq!(store.submitted(&key("late", 1)).unwrap(), None);
    // What was accepted before is still the same fit.
    let same = Submitted::Same(record.id);
    assert_eq!(put(store, &late, Some(&known), 2), same);
    // What runs does not wait.
    set_status(store, record.id, Status::Running);
    assert_eq!(put(store, &late, None, 2), Submitted::New);
}

fn pages_are_newest_first_and_whole(store: &dyn JobStore) {
    let mut fits: Vec<Uuid> = (0..7).map(|_| submit(store)).collect();
    fits.reverse();
    for id in &fits[2..5] {
        set_status(store, *id, Status::Failed);
    }
    assert_eq!(walk(store, None), fits);
    assert_eq!(walk(store, Some(Status::Failed)), fits[2..5]);
    assert!(walk(store, Some(Status::Succeeded)).is_empty());
    let counts = store.counts().unwrap();
    assert_eq!(counts.of(Status::Queued), 4);
    assert_eq!(counts.of(Status::Failed), 3);
}

fn walk(store: &dyn JobStore, status: Option<Status>) -> Vec<Uuid> {
    let mut page = PageAsked {
        limit: 3,
        after: None,
        status,
    };
    let mut seen = Vec::new();
    loop {
        let found = store.fits(&page).unwrap();
        assert!(found.items.len() <= page.limit);
        seen.extend(found.items.iter().map(|record| record.id));
        assert_eq!(
            found.next.is_some(),
            found.items.len() == 3 && seen.len() < 7 && status.is_none()
        );
        page.after = found.next;
        if page.after.is_none() {
            return seen;
        }
    }
}

fn notices_reach_all_who_listen(store: &dyn JobStore) {
    let listeners = [store.listen(), store.listen()];
    let id = submit(store);
    store.publish(Notice::Cancel(id));
    for listener in listeners {
        let wait = Duration::from_secs(10);
        assert_eq!(listener.recv_timeout(wait), Ok(Notice::Queued));
        assert_eq!(listener.recv_timeout(wait), Ok(Notice::Cancel(id)));
    }
}

fn what_ran_when_the_process_died_is_handed_out_again(
    open: &impl Fn(&str, Duration) -> Arc<dyn JobStore>,
) {
    let store = open("died", SHORT);
    let (ran, done) = (submit(&*store), submit(&*store));
    claim(&*store).expect("one waits");
    let mut record = get(&*store, ran);
    record.status = Status::Running;
    record.attempts = 1;
    store.replace(&record).unwrap();
    set_status(&*store, done, Status::Succeeded);
    drop(store);
    let store = open("died", SHORT);
    thread::sleep(2 * store.lease_time());
    assert_eq!(claim(&*store).map(|lease| lease.fit), Some(ran));
    assert_eq!(claim(&*store), None);
    assert_eq!(get(&*store, ran).attempts, 1);
    assert_eq!(get(&*store, done).status, Status::Succeeded);
}

/// The same for [`Documents`].
pub(super) fn documents_contract(store: &dyn Documents) {
    let ids: Vec<Uuid> = (0..4).map(|_| Uuid::now_v7()).collect();
    for id in &ids {
        store
            .put(DocumentKind::Pattern, *id, id.as_bytes())
            .unwrap();
    }
    store.put(DocumentKind::Avatar, ids[0], b"body").unwrap();
    let get = |kind, id| store.get(kind, id).unwrap();
    assert_eq!(get(DocumentKind::Avatar, ids[0]), Some(b"body".to_vec()));
    assert_eq!(get(DocumentKind::Fabric, ids[0]), None);
    assert!(store.put(DocumentKind::Avatar, ids[0], b"other").is_err());
    let page = |after| PageAsked {
        limit: 3,
        after,
        status: None,
    };
    let first = store.list(DocumentKind::Pattern, &page(None)).unwrap();
    let found: Vec<Uuid> = first.items.iter().map(|(id, _)| *id).collect();
    assert_eq!(found, [ids[3], ids[2], ids[1]]);
    let second = store
        .list(DocumentKind::Pattern, &page(first.next))
        .unwrap();
    assert_eq!(second.items, [(ids[0], ids[0].as_bytes().to_vec())]);
    assert_eq!(second.next, None);
    assert!(store.delete(DocumentKind::Pattern, ids[0]).unwrap());
    assert!(!store.delete(DocumentKind::Pattern, ids[0]).unwrap());
    assert_eq!(get(DocumentKind::Pattern, ids[0]), None);
    assert!(get(DocumentKind::Avatar, ids[0]).is_some());
}
