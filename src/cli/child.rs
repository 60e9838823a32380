//! Jobs in processes of their own: the command `run-job`, and the runner of `serve` that starts it.

use super::exit::fail;
use rustix::process::{Resource, Rlimit, Signal, set_parent_process_death_signal, setrlimit};
use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::fit::ShippedAssets;
use seamster::job::{
    self, JobOutcome, JobRequest, ProcessDeath, RunError, Runner, SolverRunner, follow_child,
};
use seamster::progress::{CancelToken, Progress};
use std::io::{self, BufRead, BufReader};
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, ChildStderr, Command, ExitCode, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// Time after which a process that was asked to end is ended.
const GRACE: Duration = Duration::from_secs(2);
/// Time between two looks at what the process is to do.
const POLL_INTERVAL: Duration = Duration::from_millis(20);
/// Readiness to be ended first when memory is short, of 1000 (`proc(5)`).
const OOM_SCORE: &str = "800";
/// Stack of the run \[bytes\], as that of a worker of the service.
const STACK: usize = 16 << 20;
/// How the allocator's error begins, before it aborts the process.
const OUT_OF_MEMORY: &str = "memory allocation of ";

/// Runs one job, told on standard input, and tells standard output of it.
pub(super) fn run_job() -> ExitCode {
    match guarded_run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&error.to_string()),
    }
}

fn guarded_run() -> io::Result<()> {
    set_parent_process_death_signal(Some(Signal::KILL))?;
    let limits = Limits::default();
    let memory = Some(limits.process_memory_bytes);
    let bound = Rlimit {
        current: memory,
        maximum: memory,
    };
    setrlimit(Resource::As, bound)?;
    if let Err(error) = std::fs::write("/proc/self/oom_score_adj", OOM_SCORE) {
        tracing::warn!(%error, "the system may end the service before this process");
    }
    let runner = SolverRunner {
        assets: Arc::new(ShippedAssets),
        bodies: Arc::default(),
        limits,
    };
    let run = move || {
        let input = BufReader::new(io::stdin());
        job::run_child(input, io::stdout().lock(), &runner)
    };
    let run = thread::Builder::new().stack_size(STACK).spawn(run)?;
    run.join()
        .map_err(|_| io::Error::other("the run panicked"))?
}

/// The runner of the service: it runs jobs in this process, or each in one of its own.
pub(super) struct ServiceRunner {
    /// The runner in this process.
    pub(super) solver: SolverRunner,
}

impl Runner for ServiceRunner {
    fn run(
        &self,
        request: JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, Faults> {
        self.solver.run(request, cancel, progress)
    }

    fn run_apart(
        &self,
        request: JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, RunError> {
        let not_started = |error: io::Error| RunError::NotStarted(error.to_string());
        let mut child = start().map_err(not_started)?;
        let pipes = child.stdin.take().zip(child.stdout.take());
        let (input, output) = pipes.ok_or_else(|| not_started(io::Error::other("no pipes")))?;
        let memory = Arc::new(AtomicBool::new(false));
        let log = child.stderr.take();
        let log = log.map(|log| {
            let memory = Arc::clone(&memory);
            thread::spawn(move || pass_log_on(log, &memory))
        });
        let is_done = AtomicBool::new(false);
        let (ran, status) = thread::scope(|scope| {
            let ending = scope.spawn(|| end_if_deaf(&mut child, cancel, &is_done));
            let pipes = (input, BufReader::new(output));
            let ran = follow_child(pipes, &request, cancel, progress);
            is_done.store(true, Ordering::Relaxed);
            (ran, ending.join())
        });
        if let Some(log) = log {
            // A panic there has lost some lines of the log, no more.
            let _ = log.join();
        }
        ran.map_err(|error| match (error, status) {
            (RunError::Died(_), Ok(Ok(status))) => {
                RunError::Died(death(status, memory.load(Ordering::Relaxed)))
            }
            (error, _) => error,
        })
    }
}

/// Starts the process: this program, whatever has become of its file.
fn start() -> io::Result<Child> {
    Command::new("/proc/self/exe")
        .arg("run-job")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
}

/// Waits for the end of the process, and ends it if it was asked to and does not, or if its result
/// is there.
fn end_if_deaf(
    child: &mut Child,
    cancel: &CancelToken,
    is_done: &AtomicBool,
) -> io::Result<ExitStatus> {
    let mut asked: Option<Instant> = None;
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status);
        }
        if cancel.is_canceled() || is_done.load(Ordering::Relaxed) {
            let since = *asked.get_or_insert_with(Instant::now);
            if since.elapsed() > GRACE {
                child.kill()?;
            }
        }
        thread::sleep(POLL_INTERVAL);
    }
}

/// Passes the log of the process on, and notes if it told of a lack of memory.
fn pass_log_on(log: ChildStderr, memory: &AtomicBool) {
    for line in BufReader::new(log).lines().map_while(Result::ok) {
        if line.starts_with(OUT_OF_MEMORY) {
            memory.store(true, Ordering::Relaxed);
        }
        tracing::warn!(line, "of a job's own process");
    }
}

fn death(status: ExitStatus, is_memory: bool) -> ProcessDeath {
    match status.signal() {
        _ if is_memory => ProcessDeath::Memory,
        Some(signal) => ProcessDeath::Signal(signal),
        None => ProcessDeath::NoResult,
    }
}
