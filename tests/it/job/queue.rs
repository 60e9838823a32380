//! Fits and studies on the queue and their workers, with a runner that does what the test says
//! instead of sewing.

#![expect(
    clippy::unwrap_used,
    reason = "a failure is a failed test, in its helpers too"
)]

use super::counted_renewals::CountedRenewals;
use jiff::Timestamp;
use seamster::config::Limits;
use seamster::fault::{Fault, Faults, SeamCode};
use seamster::fit::{FitOutcome, Garment};
use seamster::job::{
    FileBlobs, IdempotencyKey, JobEvent, JobEventKind, JobEvents, JobKind, JobOutcome, JobRecord,
    JobRequest, JobStatus, JobStore, ManualClock, NewJob, PageRequest, ProcessDeath, Queue,
    QueueError, ResultFile, RunError, Runner, SqliteStore, WorkerPool,
};
use seamster::progress::{CancelToken, Progress};
use seamster::solver::{DrapeReport, Shortcoming, Verdict};
use seamster::study::{Study, StudyRequest};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::sleep;
use std::time::{Duration, Instant};
use uuid::Uuid;

/// Far more than anything here takes on a busy machine.
const TIMEOUT: Duration = Duration::from_secs(60);
/// Duration of a lease by a clock that only the test moves. Workers look for lost notices a fifth
/// of it apart: too late for [`TIMEOUT`], so that what ends in time was told by a notice.
const LEASE: Duration = Duration::from_secs(600);

/// Does what the garment's default fabric says.
#[derive(Clone, Default)]
struct Script {
    begun: Arc<AtomicUsize>,
    /// Raised when what does not hear of a cancellation is to end.
    released: CancelToken,
}

impl Runner for Script {
    fn run(
        &self,
        work: JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, Faults> {
        self.begun.fetch_add(1, Ordering::SeqCst);
        let (kind, mut good, mut canceled) = (work.kind(), true, false);
        let mut failed = None;
        let garment = match work {
            JobRequest::Fit(garment) => *garment,
            JobRequest::Study(asked) => asked.garment,
        };
        match garment.default_fabric.as_str() {
            "refuse" => return Err(Fault::new(SeamCode::Twisted, "/seams/0", "it is").into()),
            "panic" => panic!("as told"),
            "diverge" => good = false,
            "cross" => failed = Some(Shortcoming::Crossings),
            "sink" => failed = Some(Shortcoming::Body),
            "count" => (1..=1_000).for_each(|step| progress(at(f64::from(step) / 1_000.0, 0.0))),
            "wait" => canceled = wait(cancel, progress, 0.0),
            "burn" => canceled = wait(cancel, progress, 1e9),
            "infinite" => progress(at(f64::NAN, f64::INFINITY)),
            "deaf" => {
                wait(&self.released, &mut |_| {}, 0.0);
            }
            _ => {}
        }
        let mut outcome = done(kind, good, canceled);
        if let (JobOutcome::Fit(fit), Some(failed)) = (&mut outcome, failed) {
            fit.report.good = Some(Verdict {
                ok: false,
                failed: vec![failed, Shortcoming::Gap],
                because: vec!["as told".to_owned(), "and a gap".to_owned()],
            });
        }
        Ok(outcome)
    }
}

fn done(kind: JobKind, good: bool, canceled: bool) -> JobOutcome {
    match kind {
        JobKind::Fit => JobOutcome::Fit(Box::new(FitOutcome {
            canceled,
            ..outcome(good)
        })),
        JobKind::Study => JobOutcome::Study(Box::new(study(good, canceled))),
    }
}

/// A study of one run, or of none.
fn study(good: bool, canceled: bool) -> Study {
    let run = serde_json::json!({
        "method": "newton", "used": "newton", "tolerance": 1e-3, "step_s": null, "edge_length_m": 0.02, "vertices": 9,
        "cpu_s": 0.5, "error_m": 1e-5, "error_certain": true, "estimate_m": null, "estimate_valid": false,
        "energy_j": 1.0, "residual": 1e-4, "minimum": 0, "minimum_energy_j": 1.0, "same_as_reference": true,
        "steps": 7, "converged": true, "why": "as told",
    });
    let study = serde_json::json!({
        "schema": "seamster/study/1", "want": "drape", "membrane": "continuum", "start": "flat", "meshes": [],
        "runs": if good { vec![run] } else { vec![] }, "orders": [], "stability": [], "recommendation": "none",
        "notes": [], "left_out": [{"what": "all", "because": "as told"}], "complete": false, "canceled": canceled,
        "cpu_s": 0.5, "version": "0",
    });
    serde_json::from_value(study).unwrap()
}

/// Polls the flag as a solver does; says whether it was raised before a long time had passed.
fn wait(cancel: &CancelToken, progress: &mut dyn FnMut(Progress), cpu_s: f64) -> bool {
    let deadline = Instant::now() + TIMEOUT;
    while Instant::now() < deadline {
        progress(at(0.5, cpu_s));
        if cancel.is_canceled() {
            return true;
        }
        sleep(Duration::from_millis(5));
    }
    false
}

fn at(fraction: f64, cpu_s: f64) -> Progress {
    Progress {
        stage: "drape".to_owned(),
        fraction,
        cpu_s,
        ..Progress::default()
    }
}

fn outcome(converged: bool) -> FitOutcome {
    FitOutcome {
        mesh: Default::default(),
        report: DrapeReport {
            converged,
            why: "as told".to_owned(),
            ..DrapeReport::default()
        },
        canceled: false,
    }
}

fn garment(does: &str) -> Garment {
    let garment = serde_json::json!({
        "pattern": Uuid::nil(), "seams": "suggest", "default_fabric": does,
    });
    serde_json::from_value(garment).unwrap()
}

fn work(kind: JobKind, does: &str) -> JobRequest {
    match kind {
        JobKind::Fit => JobRequest::Fit(Box::new(garment(does))),
        JobKind::Study => JobRequest::Study(Box::new(study_request(does))),
    }
}

fn study_request(does: &str) -> StudyRequest {
    serde_json::from_value(serde_json::json!({"garment": garment(does)})).unwrap()
}

fn open_with(folder: &Path, limits: Limits) -> Arc<Queue> {
    let store = Arc::new(open_store(folder, LEASE, &ManualClock::default()));
    let blobs = Arc::new(FileBlobs::open(&folder.join("blobs")).unwrap());
    Queue::new(store.clone(), store, blobs, limits).unwrap()
}

fn open(folder: &Path) -> Arc<Queue> {
    open_with(folder, Limits::default())
}

/// Opens the store of a folder as soon as a pool that was shut down has let go of it.
fn open_store(folder: &Path, lease: Duration, clock: &ManualClock) -> SqliteStore {
    let deadline = Instant::now() + TIMEOUT;
    loop {
        match SqliteStore::open_with_leases(folder, lease, Arc::new(clock.clone())) {
            Ok(store) => return store,
            Err(error) => assert!(Instant::now() < deadline, "{error}"),
        }
        sleep(Duration::from_millis(5));
    }
}

fn start(queue: &Arc<Queue>, count: usize) -> WorkerPool {
    WorkerPool::start(queue, Script::default(), count).unwrap()
}

fn submit(queue: &Queue, does: &str) -> Uuid {
    submit_as(JobKind::Fit, queue, does)
}

fn submit_as(kind: JobKind, queue: &Queue, does: &str) -> Uuid {
    queue.submit(&work(kind, does), None).unwrap().id
}

fn get(queue: &Queue, id: Uuid) -> JobRecord {
    let mut found = JobKind::ALL
        .iter()
        .filter_map(|kind| queue.job(*kind, id).unwrap());
    found.next().expect("it was submitted")
}

fn wait_for(queue: &Queue, id: Uuid, is_there: impl Fn(&JobRecord) -> bool) -> JobRecord {
    wait_until(&format!("job {id} as expected"), || {
        is_there(&get(queue, id))
    });
    get(queue, id)
}

fn wait_until(what: &str, is_so: impl Fn() -> bool) {
    let deadline = Instant::now() + TIMEOUT;
    while !is_so() {
        assert!(Instant::now() < deadline, "{what}: not in {TIMEOUT:?}");
        sleep(Duration::from_millis(5));
    }
}

fn finished(queue: &Queue, id: Uuid) -> JobRecord {
    wait_for(queue, id, |record| record.status.is_final())
}

fn running(queue: &Queue, id: Uuid) -> JobRecord {
    wait_for(queue, id, |record| {
        record.status == JobStatus::Running && record.progress.fraction > 0.0
    })
}

fn error_code(record: &JobRecord) -> &str {
    record
        .error
        .as_ref()
        .map_or("", |error| error.code.as_str())
}

/// All events from after `after` to the last.
fn events(queue: &Queue, id: Uuid, after: Option<u64>) -> Vec<JobEvent> {
    let events = queue.events(JobKind::Fit, id, after).unwrap();
    collected(events.expect("it was submitted"))
}

/// Every event up to the end of the stream.
fn collected(mut events: JobEvents) -> Vec<JobEvent> {
    let mut runtime = tokio::runtime::Builder::new_current_thread();
    let collect = async {
        let mut all = Vec::new();
        while let Some(event) = events.next().await {
            all.push(event);
        }
        all
    };
    let within = async { tokio::time::timeout(TIMEOUT, collect).await };
    let runtime = runtime.enable_time().build().unwrap();
    runtime.block_on(within).expect("it ends")
}

#[test]
fn converged_fit_succeeds_and_leaves_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let id = submit(&queue, "sew");
    assert_eq!(get(&queue, id).status, JobStatus::Queued);
    let pool = start(&queue, 1);
    let record = finished(&queue, id);
    assert_eq!((record.status, record.attempts), (JobStatus::Succeeded, 1));
    assert!(record.created_at <= record.started_at.unwrap());
    assert!(record.started_at <= record.finished_at);
    let report = queue.file(&record, ResultFile::Report).unwrap().unwrap();
    let report: DrapeReport = serde_json::from_slice(&report).unwrap();
    assert_eq!(report, outcome(true).report);
    assert!(queue.file(&record, ResultFile::Mesh).unwrap().is_some());
    let kept: Garment =
        serde_json::from_slice(&queue.request(JobKind::Fit, id).unwrap().unwrap()).unwrap();
    assert_eq!(kept, garment("sew"));
    pool.shutdown(TIMEOUT);
}

#[test]
fn study_succeeds_and_leaves_its_report() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let id = submit_as(JobKind::Study, &queue, "sew");
    let pool = start(&queue, 1);
    let record = finished(&queue, id);
    assert_eq!((record.status, record.attempts), (JobStatus::Succeeded, 1));
    let report = queue.file(&record, ResultFile::Report).unwrap().unwrap();
    let report: Study = serde_json::from_slice(&report).unwrap();
    assert_eq!(report, study(true, false));
    assert_eq!(queue.file(&record, ResultFile::Mesh).unwrap(), None);
    let kept = queue.request(JobKind::Study, id).unwrap().unwrap();
    assert_eq!(
        serde_json::from_slice::<StudyRequest>(&kept).unwrap(),
        study_request("sew")
    );
    pool.shutdown(TIMEOUT);
}

#[test]
fn failed_studies_say_why_in_codes_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    for (does, code, has_report) in [
        ("diverge", "study/nothing_ran", true),
        ("refuse", "study/refused", false),
        ("panic", "study/panicked", false),
        ("burn", "study/time_limit", true),
    ] {
        let record = finished(&queue, submit_as(JobKind::Study, &queue, does));
        assert_eq!(
            (record.status, error_code(&record)),
            (JobStatus::Failed, code)
        );
        let report = queue.file(&record, ResultFile::Report).unwrap();
        assert_eq!(report.is_some(), has_report, "{does}");
    }
    pool.shutdown(TIMEOUT);
}

#[test]
fn running_study_is_canceled_by_a_notice() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let id = submit_as(JobKind::Study, &queue, "wait");
    running(&queue, id);
    queue.cancel(JobKind::Study, id).unwrap().unwrap();
    let record = finished(&queue, id);
    assert_eq!((record.status, record.result), (JobStatus::Canceled, None));
    pool.shutdown(TIMEOUT);
}

/// A fit may use as much CPU time as a fit may, however much a study may use.
#[test]
fn each_kind_has_its_own_limit_of_cpu_time() {
    let limits = Limits {
        fit_cpu_s: 1e10,
        ..Limits::default()
    };
    let folder = tempfile::tempdir().unwrap();
    let queue = open_with(folder.path(), limits);
    let pool = start(&queue, 1);
    let study = submit_as(JobKind::Study, &queue, "burn");
    assert_eq!(error_code(&finished(&queue, study)), "study/time_limit");
    let fit = submit(&queue, "burn");
    running(&queue, fit);
    queue.cancel(JobKind::Fit, fit).unwrap();
    assert_eq!(finished(&queue, fit).status, JobStatus::Canceled);
    pool.shutdown(TIMEOUT);
}

#[test]
fn jobs_of_one_kind_are_not_found_as_the_other() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    for (own, other) in [
        (JobKind::Fit, JobKind::Study),
        (JobKind::Study, JobKind::Fit),
    ] {
        let id = submit_as(own, &queue, "sew");
        assert!(queue.job(own, id).unwrap().is_some());
        assert_eq!(queue.job(other, id).unwrap(), None);
        assert!(queue.events(other, id, None).unwrap().is_none());
        assert_eq!(queue.request(other, id).unwrap(), None);
        assert_eq!(queue.cancel(other, id).unwrap(), None);
        assert_eq!(get(&queue, id).status, JobStatus::Queued);
    }
    let page = PageRequest {
        limit: 10,
        ..PageRequest::default()
    };
    for kind in JobKind::ALL {
        let found = queue.jobs(kind, &page).unwrap().items;
        let kinds: Vec<_> = found.iter().map(|record| record.kind).collect();
        assert_eq!(kinds, [kind]);
    }
}

#[test]
fn fit_that_does_not_converge_fails_and_keeps_its_shape() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let record = finished(&queue, submit(&queue, "diverge"));
    assert_eq!(record.status, JobStatus::Failed);
    assert_eq!(error_code(&record), "fit/not_converged");
    assert_eq!(record.error.as_ref().unwrap().detail, "as told");
    assert!(queue.file(&record, ResultFile::Mesh).unwrap().is_some());
    assert!(queue.file(&record, ResultFile::Report).unwrap().is_some());
    pool.shutdown(TIMEOUT);
}

#[test]
fn fit_that_is_not_good_fails_by_its_first_fault_and_keeps_its_shape() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    for (does, code) in [("cross", "fit/crossings"), ("sink", "fit/body")] {
        let record = finished(&queue, submit(&queue, does));
        assert_eq!(record.status, JobStatus::Failed);
        assert_eq!(error_code(&record), code);
        let detail = &record.error.as_ref().unwrap().detail;
        assert_eq!(detail, "as told; and a gap");
        assert!(queue.file(&record, ResultFile::Mesh).unwrap().is_some());
        assert!(queue.file(&record, ResultFile::Report).unwrap().is_some());
    }
    pool.shutdown(TIMEOUT);
}

#[test]
fn faults_of_the_garment_are_all_in_the_record() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let record = finished(&queue, submit(&queue, "refuse"));
    assert_eq!(record.status, JobStatus::Failed);
    let error = record.error.unwrap();
    assert_eq!(error.code, "fit/refused");
    assert_eq!(error.errors[0].pointer, "/seams/0");
    pool.shutdown(TIMEOUT);
}

#[test]
fn panic_is_a_failed_fit_and_the_worker_lives() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let panics = submit(&queue, "panic");
    let next = submit(&queue, "sew");
    let record = finished(&queue, panics);
    assert_eq!(record.status, JobStatus::Failed);
    assert_eq!((error_code(&record), record.attempts), ("fit/panicked", 1));
    assert_eq!(finished(&queue, next).status, JobStatus::Succeeded);
    pool.shutdown(TIMEOUT);
}

#[test]
fn numbers_that_are_not_finite_do_not_spoil_the_record() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let record = finished(&queue, submit(&queue, "infinite"));
    assert!(record.progress.fraction.is_finite());
    pool.shutdown(TIMEOUT);
}

#[test]
fn running_fit_is_canceled_by_a_notice() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let id = submit(&queue, "wait");
    running(&queue, id);
    assert!(
        queue
            .cancel(JobKind::Fit, id)
            .unwrap()
            .unwrap()
            .cancel_requested
    );
    let record = finished(&queue, id);
    assert_eq!((record.status, record.result), (JobStatus::Canceled, None));
    // Asking again changes nothing.
    assert_eq!(queue.cancel(JobKind::Fit, id).unwrap(), Some(record));
    assert_eq!(queue.cancel(JobKind::Fit, Uuid::now_v7()).unwrap(), None);
    pool.shutdown(TIMEOUT);
}

#[test]
fn queued_fit_is_canceled_at_once_and_never_run() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let id = submit(&queue, "sew");
    let record = queue.cancel(JobKind::Fit, id).unwrap().unwrap();
    assert_eq!(record.status, JobStatus::Canceled);
    assert!(record.finished_at.is_some());
    let script = Script::default();
    let pool = WorkerPool::start(&queue, script.clone(), 1).unwrap();
    finished(&queue, submit(&queue, "sew"));
    assert_eq!(script.begun.load(Ordering::SeqCst), 1);
    assert_eq!(get(&queue, id), record);
    pool.shutdown(TIMEOUT);
}

#[test]
fn fit_that_ends_by_itself_after_it_was_canceled_is_canceled() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let script = Script::default();
    let pool = WorkerPool::start(&queue, script.clone(), 1).unwrap();
    let id = submit(&queue, "deaf");
    wait_for(&queue, id, |record| record.status == JobStatus::Running);
    queue.cancel(JobKind::Fit, id).unwrap();
    script.released.cancel();
    let record = finished(&queue, id);
    assert_eq!((record.status, record.result), (JobStatus::Canceled, None));
    pool.shutdown(TIMEOUT);
}

#[test]
fn cpu_time_limit_stops_the_fit_and_keeps_its_shape() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let record = finished(&queue, submit(&queue, "burn"));
    assert_eq!(record.status, JobStatus::Failed);
    assert_eq!(error_code(&record), "fit/time_limit");
    assert!(queue.file(&record, ResultFile::Mesh).unwrap().is_some());
    pool.shutdown(TIMEOUT);
}

#[test]
fn shutdown_gives_running_fits_back_and_does_not_count_it() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let id = submit(&queue, "wait");
    for attempts in 1..=3 {
        // One worker: another might take the job up again before it hears of the end.
        let pool = start(&queue, 1);
        running(&queue, id);
        pool.shutdown(TIMEOUT);
        let record = get(&queue, id);
        assert_eq!(record.status, JobStatus::Queued);
        assert_eq!((record.attempts, record.released), (attempts, attempts));
        assert!(!record.isolated);
        assert_eq!(record.started_at, None);
    }
}

/// Leaves a fit as a process that was killed leaves it: claimed, its record running, nothing given
/// back.
fn die_while_running(kind: JobKind, folder: &Path, does: &str) -> Uuid {
    let id = submit_as(kind, &open(folder), does);
    begin_and_die(&open_store(folder, LEASE, &ManualClock::default()), id);
    id
}

fn begin_and_die(store: &SqliteStore, id: Uuid) {
    store.claim().unwrap().expect("it waits");
    let mut record = store.job(id).unwrap().expect("it was submitted");
    record.status = JobStatus::Running;
    record.attempts += 1;
    store
        .replace(&record)
        .unwrap()
        .expect("nobody else is there");
}

#[test]
fn job_of_a_process_that_died_runs_again() {
    for kind in JobKind::ALL {
        let folder = tempfile::tempdir().unwrap();
        let id = die_while_running(kind, folder.path(), "sew");
        let queue = open(folder.path());
        let pool = start(&queue, 1);
        let record = finished(&queue, id);
        assert_eq!((record.status, record.attempts), (JobStatus::Succeeded, 2));
        assert_eq!(record.result, Some(2));
        pool.shutdown(TIMEOUT);
    }
}

#[test]
fn a_few_deaths_of_the_service_do_not_count() {
    for kind in JobKind::ALL {
        let folder = tempfile::tempdir().unwrap();
        let id = die_while_running(kind, folder.path(), "sew");
        for _ in 0..7 {
            begin_and_die(
                &open_store(folder.path(), LEASE, &ManualClock::default()),
                id,
            );
        }
        let queue = open(folder.path());
        let pool = start(&queue, 1);
        let record = finished(&queue, id);
        assert_eq!((record.status, record.attempts), (JobStatus::Succeeded, 9));
        pool.shutdown(TIMEOUT);
    }
}

/// A runner whose own processes fail by an error, as often as it is told.
struct Dying {
    script: Script,
    failures: AtomicUsize,
    error: RunError,
}

impl Runner for Dying {
    fn run(
        &self,
        work: JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, Faults> {
        self.script.run(work, cancel, progress)
    }

    fn run_isolated(
        &self,
        work: &JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, RunError> {
        let left = self.failures.load(Ordering::SeqCst);
        if left > 0 {
            self.failures.store(left - 1, Ordering::SeqCst);
            return Err(self.error.clone());
        }
        let ran = self.run(work.clone(), cancel, progress);
        ran.map_err(RunError::Refused)
    }
}

/// The record of a job that ran when its service died, and whose own process then fails so often.
fn ended_after(failures: usize, error: RunError, kind: JobKind) -> JobRecord {
    let folder = tempfile::tempdir().unwrap();
    let id = die_while_running(kind, folder.path(), "sew");
    let limits = Limits {
        starts: 2,
        ..Limits::default()
    };
    let queue = open_with(folder.path(), limits);
    let runner = Dying {
        script: Script::default(),
        failures: failures.into(),
        error,
    };
    let pool = WorkerPool::start(&queue, runner, 1).unwrap();
    let record = finished(&queue, id);
    pool.shutdown(TIMEOUT);
    record
}

#[test]
fn a_job_whose_own_process_dies_twice_has_failed_with_the_cause() {
    for kind in JobKind::ALL {
        let death = || RunError::Died(ProcessDeath::Signal(6));
        let once = ended_after(1, death(), kind);
        assert_eq!((once.status, once.crashes), (JobStatus::Succeeded, 1));
        let twice = ended_after(2, death(), kind);
        assert_eq!((twice.status, twice.crashes), (JobStatus::Failed, 2));
        assert_eq!(error_code(&twice), format!("{}/abandoned", kind.as_str()));
        assert!(twice.error.unwrap().detail.contains("signal 6"));
    }
}

#[test]
fn a_process_that_cannot_be_started_is_tried_again_and_then_told() {
    let error = || RunError::NotStarted("no more processes".to_owned());
    let start = Instant::now();
    let once = ended_after(1, error(), JobKind::Fit);
    assert_eq!((once.status, once.attempts), (JobStatus::Succeeded, 2));
    assert!(start.elapsed() >= Duration::from_secs(1), "at once");
    for kind in JobKind::ALL {
        let never = ended_after(2, error(), kind);
        assert_eq!((never.status, never.attempts), (JobStatus::Failed, 2));
        assert_eq!(error_code(&never), format!("{}/not_started", kind.as_str()));
    }
}

#[test]
fn no_process_is_started_for_a_job_that_was_canceled_after_one_could_not_be() {
    let folder = tempfile::tempdir().unwrap();
    let id = die_while_running(JobKind::Fit, folder.path(), "sew");
    let queue = open(folder.path());
    let script = Script::default();
    let runner = Dying {
        script: script.clone(),
        failures: 1.into(),
        error: RunError::NotStarted("no more processes".to_owned()),
    };
    let pool = WorkerPool::start(&queue, runner, 1).unwrap();
    wait_for(&queue, id, |record| record.status == JobStatus::Running);
    // The first start has failed by then, and the next one is due after a second.
    sleep(Duration::from_millis(200));
    queue.cancel(JobKind::Fit, id).unwrap();
    assert_eq!(finished(&queue, id).status, JobStatus::Canceled);
    assert_eq!(script.begun.load(Ordering::SeqCst), 0);
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_process_that_tells_nonsense_has_found_a_defect() {
    let record = ended_after(
        1,
        RunError::Protocol("at column 1".to_owned()),
        JobKind::Fit,
    );
    assert_eq!((record.status, record.crashes), (JobStatus::Failed, 0));
    assert_eq!(error_code(&record), "fit/panicked");
}

#[test]
fn a_job_in_its_own_process_with_which_the_service_dies_ten_times_has_failed() {
    let folder = tempfile::tempdir().unwrap();
    let id = die_while_running(JobKind::Fit, folder.path(), "sew");
    for _ in 0..10 {
        begin_and_die(
            &open_store(folder.path(), LEASE, &ManualClock::default()),
            id,
        );
    }
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let record = finished(&queue, id);
    assert_eq!((record.status, record.attempts), (JobStatus::Failed, 11));
    assert_eq!(error_code(&record), "fit/abandoned");
    let detail = record.error.unwrap().detail;
    assert!(detail.contains("died 10 times"), "{detail}");
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_job_that_waits_for_one_in_its_own_process_is_not_suspect() {
    let folder = tempfile::tempdir().unwrap();
    let first = die_while_running(JobKind::Fit, folder.path(), "wait");
    let queue = open(folder.path());
    let pool = start(&queue, 2);
    running(&queue, first);
    let next = submit(&queue, "sew");
    for _ in 0..20 {
        assert_eq!(get(&queue, next).status, JobStatus::Queued);
        sleep(Duration::from_millis(5));
    }
    queue.cancel(JobKind::Fit, first).unwrap();
    assert_eq!(finished(&queue, next).status, JobStatus::Succeeded);
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_canceled_job_that_waits_to_run_alone_holds_nobody_up() {
    let folder = tempfile::tempdir().unwrap();
    let store = Arc::new(open_store(folder.path(), LEASE, &ManualClock::default()));
    let blobs = Arc::new(FileBlobs::open(&folder.path().join("blobs")).unwrap());
    let queue = Queue::new(store.clone(), store.clone(), blobs, Limits::default()).unwrap();
    let pool = start(&queue, 3);
    let runs = submit(&queue, "wait");
    running(&queue, runs);
    let waits = JobRecord {
        isolated: true,
        ..JobRecord::queued(JobKind::Fit, Uuid::now_v7(), Timestamp::now())
    };
    let job = NewJob {
        record: &waits,
        key: None,
        queue_limit: 9,
    };
    store.submit(&job).unwrap();
    // A worker has it by then.
    sleep(Duration::from_millis(200));
    queue.cancel(JobKind::Fit, waits.id).unwrap();
    let next = submit(&queue, "sew");
    assert_eq!(finished(&queue, next).status, JobStatus::Succeeded);
    // The first one has not ended.
    assert_eq!(get(&queue, runs).status, JobStatus::Running);
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_job_whose_request_cannot_be_read_yet_holds_nobody_up() {
    let folder = tempfile::tempdir().unwrap();
    let first = die_while_running(JobKind::Fit, folder.path(), "sew");
    let request = folder
        .path()
        .join(format!("blobs/garments/{first}/garment.json"));
    let kept = std::fs::read(&request).unwrap();
    std::fs::remove_file(&request).unwrap();
    std::fs::create_dir(&request).unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 2);
    let next = submit(&queue, "sew");
    assert_eq!(finished(&queue, next).status, JobStatus::Succeeded);
    assert_eq!(get(&queue, first).status, JobStatus::Queued);
    std::fs::remove_dir(&request).unwrap();
    std::fs::write(&request, kept).unwrap();
    assert_eq!(finished(&queue, first).status, JobStatus::Succeeded);
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_job_whose_record_cannot_be_read_has_failed_and_holds_nobody_up() {
    for kind in JobKind::ALL {
        let folder = tempfile::tempdir().unwrap();
        let lost = die_while_running(kind, folder.path(), "sew");
        let database = rusqlite::Connection::open(folder.path().join("seamster.db")).unwrap();
        let changed = database.execute("UPDATE jobs SET record = '{\"of\": \"later\"}'", []);
        assert_eq!(changed, Ok(1));
        drop(database);
        let queue = open(folder.path());
        let next = submit_as(kind, &queue, "sew");
        let page = PageRequest {
            limit: 9,
            ..PageRequest::default()
        };
        let listed = queue.jobs(kind, &page).unwrap().items;
        assert_eq!(listed.iter().map(|job| job.id).collect::<Vec<_>>(), [next]);
        let pool = start(&queue, 1);
        assert_eq!(finished(&queue, next).status, JobStatus::Succeeded);
        let record = queue.job(kind, lost).unwrap().unwrap();
        assert_eq!(record.status, JobStatus::Failed);
        assert_eq!(error_code(&record), format!("{}/storage", kind.as_str()));
        let listed = queue.jobs(kind, &page).unwrap().items;
        assert_eq!(listed.len(), 2);
        assert!(listed[1].created_at <= listed[0].created_at);
        pool.shutdown(TIMEOUT);
    }
}

#[test]
fn a_failure_that_is_not_of_the_request_is_not_kept_under_its_key() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    for (does, is_same) in [("panic", false), ("diverge", true), ("sew", true)] {
        let key = IdempotencyKey {
            key: does.to_owned(),
            digest: [1; 32],
        };
        let request = work(JobKind::Fit, does);
        let submit = || queue.submit(&request, Some(&key)).unwrap().id;
        let first = submit();
        finished(&queue, first);
        let again = submit();
        assert_eq!(again == first, is_same, "{does}");
        finished(&queue, again);
    }
    pool.shutdown(TIMEOUT);
}

#[test]
fn fit_canceled_before_its_process_died_is_canceled_at_the_next_start() {
    let folder = tempfile::tempdir().unwrap();
    let id = die_while_running(JobKind::Fit, folder.path(), "wait");
    let store = SqliteStore::open(folder.path()).unwrap();
    let mut record = store.job(id).unwrap().unwrap();
    record.cancel_requested = true;
    store.replace(&record).unwrap().unwrap();
    drop(store);
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    assert_eq!(finished(&queue, id).status, JobStatus::Canceled);
    pool.shutdown(TIMEOUT);
}

#[test]
fn long_fit_keeps_its_lease_and_runs_once() {
    let folder = tempfile::tempdir().unwrap();
    let clock = ManualClock::default();
    // The pool renews a fifth of this apart by the time of day; the lease runs out by the clock.
    let lease = Duration::from_millis(50);
    let documents = Arc::new(open_store(folder.path(), lease, &clock));
    let store = Arc::new(CountedRenewals::new(Arc::clone(&documents)));
    let blobs = Arc::new(FileBlobs::open(&folder.path().join("blobs")).unwrap());
    let queue = Queue::new(store.clone(), documents, blobs, Limits::default()).unwrap();
    let script = Script::default();
    let pool = WorkerPool::start(&queue, script.clone(), 3).unwrap();
    let id = submit(&queue, "wait");
    running(&queue, id);
    for _ in 0..5 {
        clock.advance(lease - Duration::from_millis(1));
        // The second one from here on began after the clock was moved.
        let renewals = store.renewals();
        wait_until("the lease is renewed", || store.renewals() >= renewals + 2);
    }
    // Wakes the idle workers, which find nothing to claim.
    finished(&queue, submit(&queue, "sew"));
    assert_eq!(get(&queue, id).attempts, 1);
    assert_eq!(script.begun.load(Ordering::SeqCst), 2);
    queue.cancel(JobKind::Fit, id).unwrap();
    finished(&queue, id);
    pool.shutdown(TIMEOUT);
}

#[test]
fn workers_run_as_many_fits_at_once_as_there_are() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 2);
    let fits: Vec<Uuid> = (0..3).map(|_| submit(&queue, "wait")).collect();
    running(&queue, fits[0]);
    running(&queue, fits[1]);
    assert_eq!(get(&queue, fits[2]).status, JobStatus::Queued);
    queue.cancel(JobKind::Fit, fits[0]).unwrap();
    running(&queue, fits[2]);
    pool.shutdown(TIMEOUT);
}

#[test]
fn idle_worker_hears_of_a_new_fit_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    // Without a notice a worker looks every 5 s, so that 40 jobs one after the other would take
    // three minutes.
    let start = Instant::now();
    for _ in 0..40 {
        finished(&queue, submit(&queue, "sew"));
    }
    assert!(start.elapsed() < TIMEOUT);
    pool.shutdown(TIMEOUT);
}

#[test]
fn events_are_numbered_and_end_with_the_final_status() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let id = submit(&queue, "count");
    let follower = queue.events(JobKind::Fit, id, None).unwrap().unwrap();
    let pool = start(&queue, 1);
    let all = collected(follower);
    assert!(all.windows(2).all(|pair| pair[0].id < pair[1].id));
    let mut statuses: Vec<JobStatus> = all
        .iter()
        .filter_map(|event| match &event.kind {
            JobEventKind::Status(record) => Some(record.status),
            JobEventKind::Progress(_) => None,
        })
        .collect();
    // Who begins to follow while the news of the submission is still on its way is told `queued` by
    // both.
    statuses.dedup();
    assert_eq!(
        statuses,
        [JobStatus::Queued, JobStatus::Running, JobStatus::Succeeded]
    );
    assert!(
        all.iter()
            .any(|event| matches!(event.kind, JobEventKind::Progress(_)))
    );
    // Who comes later gets the end, once.
    let late = events(&queue, id, Some(all[0].id));
    assert_eq!(late.len(), 1);
    assert!(late[0].is_last());
    assert!(events(&queue, id, Some(late[0].id)).is_empty());
    assert!(
        queue
            .events(JobKind::Fit, Uuid::now_v7(), None)
            .unwrap()
            .is_none()
    );
    pool.shutdown(TIMEOUT);
}

#[test]
fn follower_who_comes_back_gets_what_came_since() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let id = submit(&queue, "wait");
    running(&queue, id);
    let runtime = tokio::runtime::Builder::new_current_thread()
        .build()
        .unwrap();
    let mut first = queue.events(JobKind::Fit, id, None).unwrap().unwrap();
    let seen = runtime.block_on(first.next()).unwrap();
    queue.cancel(JobKind::Fit, id).unwrap();
    let rest = events(&queue, id, Some(seen.id));
    assert!(rest.iter().all(|event| event.id > seen.id));
    assert!(rest.last().unwrap().is_last());
    pool.shutdown(TIMEOUT);
}

#[test]
fn closing_the_queue_ends_all_events() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let id = submit(&queue, "sew");
    // Followed before the queue is closed, and waited for after it.
    let follower = queue.events(JobKind::Fit, id, None).unwrap().unwrap();
    queue.close();
    assert!(!collected(follower).iter().any(JobEvent::is_last));
}

#[test]
fn full_queue_and_reused_keys_are_refused_and_leave_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let limits = Limits {
        queued_jobs: 2,
        ..Limits::default()
    };
    let queue = open_with(folder.path(), limits);
    let key = |digest| IdempotencyKey {
        key: "k".to_owned(),
        digest: [digest; 32],
    };
    let first = queue
        .submit(&work(JobKind::Fit, "sew"), Some(&key(1)))
        .unwrap();
    let same = queue
        .submit(&work(JobKind::Fit, "sew"), Some(&key(1)))
        .unwrap();
    assert_eq!(first.id, same.id);
    assert_eq!(
        queue.submitted(JobKind::Fit, &key(1)).unwrap().unwrap().id,
        first.id
    );
    let reused = queue.submit(&work(JobKind::Fit, "sew"), Some(&key(2)));
    assert!(matches!(reused, Err(QueueError::KeyReused(JobKind::Fit))));
    // The same bytes under the same key as another kind of job are another request.
    for found in [
        queue
            .submit(&work(JobKind::Study, "sew"), Some(&key(1)))
            .map(Some),
        queue.submitted(JobKind::Study, &key(1)),
    ] {
        assert!(matches!(found, Err(QueueError::KeyReused(JobKind::Study))));
    }
    submit(&queue, "sew");
    let full = queue.submit(&work(JobKind::Fit, "sew"), None);
    assert!(matches!(full, Err(QueueError::Full(2))));
    let garments = folder.path().join("blobs/garments");
    assert_eq!(std::fs::read_dir(garments).unwrap().count(), 2);
    let studies = folder.path().join("blobs/studies");
    assert_eq!(std::fs::read_dir(studies).unwrap().count(), 0);
}

#[test]
fn list_is_newest_first_with_the_latest_progress() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let pool = start(&queue, 1);
    let (runs, waits) = (submit(&queue, "wait"), submit(&queue, "sew"));
    running(&queue, runs);
    let page = PageRequest {
        limit: 10,
        ..PageRequest::default()
    };
    let found = queue.jobs(JobKind::Fit, &page).unwrap().items;
    assert_eq!([found[0].id, found[1].id], [waits, runs]);
    assert!(found[1].progress.fraction > 0.0);
    pool.shutdown(TIMEOUT);
}

/// Stalls in the first attempt until it is released, so that another one can begin meanwhile.
#[derive(Clone, Default)]
struct Stalled {
    stalled: Arc<Mutex<bool>>,
    released: CancelToken,
}

impl Runner for Stalled {
    fn run(
        &self,
        _work: JobRequest,
        _cancel: &CancelToken,
        _progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, Faults> {
        let is_first = !std::mem::replace(&mut *self.stalled.lock().unwrap(), true);
        if is_first {
            wait(&self.released, &mut |_| {}, 0.0);
        }
        let mut outcome = outcome(true);
        outcome.report.why = format!("the first: {is_first}");
        Ok(JobOutcome::Fit(Box::new(outcome)))
    }
}

#[test]
fn attempt_that_lost_its_lease_has_no_effect() {
    let folder = tempfile::tempdir().unwrap();
    let store = Arc::new(open_store(folder.path(), LEASE, &ManualClock::default()));
    let blobs = Arc::new(FileBlobs::open(&folder.path().join("blobs")).unwrap());
    let queue = Queue::new(store.clone(), store.clone(), blobs, Limits::default()).unwrap();
    let runner = Stalled::default();
    let pool = WorkerPool::start(&queue, runner.clone(), 2).unwrap();
    let id = submit(&queue, "sew");
    let first = wait_for(&queue, id, |record| record.status == JobStatus::Running);
    // What another worker does that was given the fit meanwhile.
    let mut second = store.job(id).unwrap().unwrap();
    second.attempts += 1;
    store.replace(&second).unwrap().expect("nobody is faster");
    runner.released.cancel();
    // The first attempt ends and finds that; a third one is then free to win.
    let record = finished(&queue, id);
    assert_eq!((record.status, record.attempts), (JobStatus::Succeeded, 3));
    assert_eq!(record.result, Some(3));
    let report = queue.file(&record, ResultFile::Report).unwrap().unwrap();
    let report: DrapeReport = serde_json::from_slice(&report).unwrap();
    assert_eq!(report.why, "the first: false");
    let results = folder.path().join(format!("blobs/results/{id}"));
    assert!(!results.join(first.attempts.to_string()).exists());
    pool.shutdown(TIMEOUT);
}

/// The folder without which no file can be written.
fn disk(folder: &Path) -> std::path::PathBuf {
    folder.join("blobs").join("tmp")
}

/// A job that came to its end and could not be kept for longer than it takes to try again.
fn unkept(queue: &Arc<Queue>, folder: &Path) -> (Uuid, WorkerPool) {
    let id = submit(queue, "sew");
    std::fs::remove_dir_all(disk(folder)).unwrap();
    let pool = start(queue, 1);
    wait_for(queue, id, |record| record.status == JobStatus::Running);
    sleep(Duration::from_millis(1_500));
    let record = get(queue, id);
    assert_eq!((record.status, record.error), (JobStatus::Running, None));
    (id, pool)
}

#[test]
fn a_result_is_kept_until_it_can_be_written() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let (id, pool) = unkept(&queue, folder.path());
    std::fs::create_dir(disk(folder.path())).unwrap();
    let record = finished(&queue, id);
    assert_eq!((record.status, record.attempts), (JobStatus::Succeeded, 1));
    assert!(queue.file(&record, ResultFile::Mesh).unwrap().is_some());
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_job_whose_result_waits_for_the_disk_can_be_canceled() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let (id, pool) = unkept(&queue, folder.path());
    queue.cancel(JobKind::Fit, id).unwrap().unwrap();
    assert_eq!(finished(&queue, id).status, JobStatus::Canceled);
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_result_that_could_not_be_written_before_the_end_is_made_again() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let (id, pool) = unkept(&queue, folder.path());
    pool.shutdown(TIMEOUT);
    std::fs::create_dir(disk(folder.path())).unwrap();
    let pool = start(&queue, 1);
    let record = finished(&queue, id);
    assert_eq!((record.status, record.attempts), (JobStatus::Succeeded, 2));
    assert_eq!(record.released, 1);
    pool.shutdown(TIMEOUT);
}

#[test]
fn a_request_that_is_gone_fails_without_names_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let queue = open(folder.path());
    let id = submit(&queue, "sew");
    std::fs::remove_dir_all(folder.path().join("blobs/garments")).unwrap();
    let pool = start(&queue, 1);
    let record = finished(&queue, id);
    assert_eq!(error_code(&record), "fit/storage");
    let detail = record.error.unwrap().detail;
    assert!(!detail.contains('/'), "{detail}");
    pool.shutdown(TIMEOUT);
}
