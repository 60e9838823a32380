//! The contract of [`JobStore`], as tests that each implementation runs.

use super::clock::ManualClock;
use super::kind::JobKind;
use super::record::JobRecord;
use super::status::JobStatus;
use super::store::{IdempotencyKey, JobNotice, JobStore, Lease, NewJob, PageRequest, Submitted};
use jiff::Timestamp;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::thread;
use std::time::Duration;
use uuid::Uuid;

/// Far more than a notice takes on a busy machine.
const NOTICE_TIMEOUT: Duration = Duration::from_secs(60);
const NO_LIMIT: usize = usize::MAX;

/// Runs every test, for each kind of job.
///
/// `open(space)` opens the store named `space`, whose leases run out by `clock`: the same name
/// finds what was there, once the store opened before is dropped.
pub(super) fn store_contract(clock: &ManualClock, open: impl Fn(&str) -> Arc<dyn JobStore>) {
    for kind in JobKind::ALL {
        let open = |space: &str| open(&format!("{}-{space}", kind.as_str()));
        contract_of_one_kind(kind, clock, &open);
    }
    kinds_share_the_queue_and_no_list(&*open("kinds"));
}

fn contract_of_one_kind(
    kind: JobKind,
    clock: &ManualClock,
    open: &impl Fn(&str) -> Arc<dyn JobStore>,
) {
    submitted_job_is_found(kind, &*open("found"));
    stale_revision_changes_nothing(kind, &*open("stale"));
    concurrent_changes_are_all_kept(kind, &open("concurrent"));
    oldest_job_is_claimed_first_and_once(kind, &*open("oldest"));
    concurrent_claims_differ(kind, &open("claims"));
    lease_that_is_not_renewed_runs_out(kind, clock, &*open("lease"));
    renewed_lease_lasts(kind, clock, &*open("renewed"));
    ended_lease_hands_out_again_unless_final(kind, &*open("ended"));
    lost_lease_cannot_end_the_next(kind, clock, &*open("lost"));
    same_key_is_the_same_job(kind, &*open("key"));
    concurrent_submissions_of_one_key_are_one_job(kind, &open("keys"));
    full_queue_refuses(kind, &*open("full"));
    pages_are_newest_first_and_whole(kind, &*open("pages"));
    notices_reach_all_who_listen(kind, &*open("notices"));
    what_ran_when_the_process_died_is_handed_out_again(kind, clock, open);
}

fn new(kind: JobKind) -> JobRecord {
    JobRecord::queued(kind, Uuid::now_v7(), Timestamp::now())
}

fn submit(kind: JobKind, store: &dyn JobStore) -> Uuid {
    let record = new(kind);
    assert_eq!(put(store, &record, None, NO_LIMIT), Submitted::New);
    record.id
}

fn put(
    store: &dyn JobStore,
    record: &JobRecord,
    key: Option<&IdempotencyKey>,
    queue_limit: usize,
) -> Submitted {
    store
        .submit(&NewJob {
            record,
            key,
            queue_limit,
        })
        .unwrap()
}

fn get(store: &dyn JobStore, id: Uuid) -> JobRecord {
    store.job(id).unwrap().expect("it was submitted")
}

fn set_status(store: &dyn JobStore, id: Uuid, status: JobStatus) {
    let mut record = get(store, id);
    record.status = status;
    assert!(store.replace(&record).unwrap().is_some());
}

fn claim(store: &dyn JobStore) -> Option<Lease> {
    store.claim().unwrap()
}

fn submitted_job_is_found(kind: JobKind, store: &dyn JobStore) {
    let record = new(kind);
    assert_eq!(put(store, &record, None, NO_LIMIT), Submitted::New);
    let found = get(store, record.id);
    assert_eq!(
        JobRecord {
            revision: record.revision,
            ..found
        },
        record
    );
    assert_eq!(store.job(Uuid::now_v7()).unwrap(), None);
}

fn stale_revision_changes_nothing(kind: JobKind, store: &dyn JobStore) {
    let id = submit(kind, store);
    let stale = get(store, id);
    let mut record = stale.clone();
    record.attempts = 1;
    let revision = store.replace(&record).unwrap().expect("nobody was faster");
    assert_eq!(get(store, id).revision, revision);
    assert_eq!(store.replace(&stale).unwrap(), None);
    assert_eq!(get(store, id).attempts, 1);
    let unknown = new(kind);
    assert_eq!(store.replace(&unknown).unwrap(), None);
    assert_eq!(store.job(unknown.id).unwrap(), None);
}

fn concurrent_changes_are_all_kept(kind: JobKind, store: &Arc<dyn JobStore>) {
    let id = submit(kind, &**store);
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

fn oldest_job_is_claimed_first_and_once(kind: JobKind, store: &dyn JobStore) {
    assert_eq!(claim(store), None);
    let jobs = [
        submit(kind, store),
        submit(kind, store),
        submit(kind, store),
    ];
    set_status(store, jobs[1], JobStatus::Canceled);
    assert_eq!(claim(store).map(|lease| lease.job), Some(jobs[0]));
    set_status(store, jobs[0], JobStatus::Running);
    assert_eq!(claim(store).map(|lease| lease.job), Some(jobs[2]));
    assert_eq!(claim(store), None);
}

fn concurrent_claims_differ(kind: JobKind, store: &Arc<dyn JobStore>) {
    let jobs: BTreeSet<Uuid> = (0..20).map(|_| submit(kind, &**store)).collect();
    let claimed: Vec<Uuid> = thread::scope(|scope| {
        let workers: Vec<_> = (0..4)
            .map(|_| {
                scope.spawn(|| {
                    let jobs = std::iter::from_fn(|| claim(&**store));
                    jobs.map(|lease| lease.job).collect::<Vec<_>>()
                })
            })
            .collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap())
            .collect()
    });
    assert_eq!(claimed.len(), 20);
    assert_eq!(claimed.into_iter().collect::<BTreeSet<_>>(), jobs);
}

fn lease_that_is_not_renewed_runs_out(kind: JobKind, clock: &ManualClock, store: &dyn JobStore) {
    let id = submit(kind, store);
    let first = claim(store).expect("one waits");
    set_status(store, id, JobStatus::Running);
    clock.advance(store.lease_time());
    let second = claim(store).expect("its lease ran out");
    assert_eq!(second.job, id);
    assert!(!store.renew(&first).unwrap());
    assert!(store.renew(&second).unwrap());
}

fn renewed_lease_lasts(kind: JobKind, clock: &ManualClock, store: &dyn JobStore) {
    submit(kind, store);
    let lease = claim(store).expect("one waits");
    let almost = store.lease_time() - Duration::from_millis(1);
    for _ in 0..3 {
        clock.advance(almost);
        assert_eq!(claim(store), None);
        assert!(store.renew(&lease).unwrap());
    }
}

fn ended_lease_hands_out_again_unless_final(kind: JobKind, store: &dyn JobStore) {
    let id = submit(kind, store);
    let lease = claim(store).expect("one waits");
    let notices = store.listen();
    store.end(&lease).unwrap();
    assert_eq!(notices.recv_timeout(NOTICE_TIMEOUT), Ok(JobNotice::Queued));
    let lease = claim(store).expect("it was given back");
    assert_eq!(lease.job, id);
    set_status(store, id, JobStatus::Succeeded);
    store.end(&lease).unwrap();
    assert_eq!(claim(store), None);
}

fn lost_lease_cannot_end_the_next(kind: JobKind, clock: &ManualClock, store: &dyn JobStore) {
    submit(kind, store);
    let first = claim(store).expect("one waits");
    clock.advance(store.lease_time());
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

fn same_key_is_the_same_job(kind: JobKind, store: &dyn JobStore) {
    let (first, a) = (new(kind), key("a", 1));
    assert_eq!(store.submitted(&a).unwrap(), None);
    assert_eq!(put(store, &first, Some(&a), NO_LIMIT), Submitted::New);
    let same = Submitted::Same(first.id);
    assert_eq!(put(store, &new(kind), Some(&a), NO_LIMIT), same);
    assert_eq!(store.submitted(&a).unwrap(), Some(same));
    let other = key("a", 2);
    let reused = Submitted::KeyReused;
    assert_eq!(put(store, &new(kind), Some(&other), NO_LIMIT), reused);
    assert_eq!(store.submitted(&other).unwrap(), Some(reused));
    let b = key("b", 1);
    assert_eq!(put(store, &new(kind), Some(&b), NO_LIMIT), Submitted::New);
    assert_eq!(store.counts(kind).unwrap().of(JobStatus::Queued), 2);
}

fn concurrent_submissions_of_one_key_are_one_job(kind: JobKind, store: &Arc<dyn JobStore>) {
    let key = key("once", 1);
    thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let record = new(kind);
                put(&**store, &record, Some(&key), NO_LIMIT)
            });
        }
    });
    assert_eq!(store.counts(kind).unwrap().of(JobStatus::Queued), 1);
}

fn full_queue_refuses(kind: JobKind, store: &dyn JobStore) {
    let known = key("known", 1);
    let record = new(kind);
    assert_eq!(put(store, &record, Some(&known), 2), Submitted::New);
    submit(kind, store);
    let late = new(kind);
    assert_eq!(put(store, &late, Some(&key("late", 1)), 2), Submitted::Full);
    assert_eq!(store.job(late.id).unwrap(), None);
    assert_eq!(store.submitted(&key("late", 1)).unwrap(), None);
    // What was accepted before is still the same job.
    let same = Submitted::Same(record.id);
    assert_eq!(put(store, &late, Some(&known), 2), same);
    // What runs does not wait.
    set_status(store, record.id, JobStatus::Running);
    assert_eq!(put(store, &late, None, 2), Submitted::New);
}

fn pages_are_newest_first_and_whole(kind: JobKind, store: &dyn JobStore) {
    let mut jobs: Vec<Uuid> = (0..7).map(|_| submit(kind, store)).collect();
    jobs.reverse();
    for id in &jobs[2..5] {
        set_status(store, *id, JobStatus::Failed);
    }
    assert_eq!(walk(kind, store, None), jobs);
    assert_eq!(walk(kind, store, Some(JobStatus::Failed)), jobs[2..5]);
    assert!(walk(kind, store, Some(JobStatus::Succeeded)).is_empty());
    let counts = store.counts(kind).unwrap();
    assert_eq!(counts.of(JobStatus::Queued), 4);
    assert_eq!(counts.of(JobStatus::Failed), 3);
}

fn walk(kind: JobKind, store: &dyn JobStore, status: Option<JobStatus>) -> Vec<Uuid> {
    let mut page = PageRequest {
        limit: 3,
        after: None,
        status,
    };
    let mut seen = Vec::new();
    loop {
        let found = store.jobs(kind, &page).unwrap();
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

fn notices_reach_all_who_listen(kind: JobKind, store: &dyn JobStore) {
    let listeners = [store.listen(), store.listen()];
    let id = submit(kind, store);
    store.publish(JobNotice::Cancel(id));
    for listener in listeners {
        assert_eq!(listener.recv_timeout(NOTICE_TIMEOUT), Ok(JobNotice::Queued));
        assert_eq!(
            listener.recv_timeout(NOTICE_TIMEOUT),
            Ok(JobNotice::Cancel(id))
        );
    }
}

fn what_ran_when_the_process_died_is_handed_out_again(
    kind: JobKind,
    clock: &ManualClock,
    open: &impl Fn(&str) -> Arc<dyn JobStore>,
) {
    let store = open("died");
    let (ran, done) = (submit(kind, &*store), submit(kind, &*store));
    claim(&*store).expect("one waits");
    let mut record = get(&*store, ran);
    record.status = JobStatus::Running;
    record.attempts = 1;
    store.replace(&record).unwrap();
    set_status(&*store, done, JobStatus::Succeeded);
    drop(store);
    let store = open("died");
    clock.advance(store.lease_time());
    assert_eq!(claim(&*store).map(|lease| lease.job), Some(ran));
    assert_eq!(claim(&*store), None);
    assert_eq!(get(&*store, ran).attempts, 1);
    assert_eq!(get(&*store, done).status, JobStatus::Succeeded);
}

fn kinds_share_the_queue_and_no_list(store: &dyn JobStore) {
    let [fit, study] = JobKind::ALL.map(new);
    let key = key("one", 1);
    assert_eq!(put(store, &study, Some(&key), 2), Submitted::New);
    assert_eq!(put(store, &fit, None, 2), Submitted::New);
    for kind in JobKind::ALL {
        assert_eq!(put(store, &new(kind), None, 2), Submitted::Full);
        let same = Submitted::Same(study.id);
        assert_eq!(put(store, &new(kind), Some(&key), 2), same);
    }
    for (kind, record) in [(JobKind::Fit, &fit), (JobKind::Study, &study)] {
        assert_eq!(get(store, record.id).kind, kind);
        let page = PageRequest {
            limit: 9,
            ..PageRequest::default()
        };
        let listed = |status| {
            let page = PageRequest { status, ..page };
            let found = store.jobs(kind, &page).unwrap().items;
            found.into_iter().map(|job| job.id).collect::<Vec<_>>()
        };
        assert_eq!(listed(None), [record.id]);
        assert_eq!(listed(Some(JobStatus::Queued)), [record.id]);
        assert_eq!(store.counts(kind).unwrap().of(JobStatus::Queued), 1);
    }
    // Each is made before the next, so their ids sort as they stand in `ALL`.
    assert_eq!(claim(store).map(|lease| lease.job), Some(fit.id));
    assert_eq!(claim(store).map(|lease| lease.job), Some(study.id));
    set_status(store, study.id, JobStatus::Succeeded);
    assert_eq!(
        store.counts(JobKind::Fit).unwrap().of(JobStatus::Succeeded),
        0
    );
}
