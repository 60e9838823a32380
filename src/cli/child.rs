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
use std::convert::Infallible;
use std::io::{self, BufRead, BufReader, Write};
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, ChildStderr, Command, ExitCode, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Time that a process has to end by itself.
const GRACE: Duration = Duration::from_secs(2);
/// Time between two looks at what the process is to do.
const POLL_INTERVAL: Duration = Duration::from_millis(20);
/// Readiness to be ended first when memory is short, of 1000 (`proc(5)`).
const OOM_SCORE: &str = "800";
/// Stack of the run \[bytes\], as that of a worker of the service.
const STACK: usize = 16 << 20;
/// The beginning of the allocator's error, before it aborts the process.
const OUT_OF_MEMORY: &[u8] = b"memory allocation of ";

/// Runs one job: its limits and its request come on standard input, and standard output is told of
/// it.
pub(super) fn run_job() -> ExitCode {
    match guarded_run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&error.to_string()),
    }
}

fn guarded_run() -> io::Result<()> {
    set_parent_process_death_signal(Some(Signal::KILL))?;
    let mut input = BufReader::new(io::stdin());
    let mut line = String::new();
    input.read_line(&mut line)?;
    let limits: Limits = serde_json::from_str(&line)?;
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
    let run = move || job::run_child(input, io::stdout().lock(), &runner);
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

    fn run_isolated(
        &self,
        request: &JobRequest,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<JobOutcome, RunError> {
        let not_started = |error: io::Error| RunError::NotStarted(error.to_string());
        let mut child = start().map_err(not_started)?;
        let pipes = child.stdin.take().zip(child.stdout.take());
        let (mut input, output) = pipes.ok_or_else(|| not_started(io::Error::other("no pipes")))?;
        let memory = Arc::new(AtomicBool::new(false));
        let log = child.stderr.take();
        let log = log.map(|log| {
            let memory = Arc::clone(&memory);
            thread::spawn(move || pass_log_on(log, &memory))
        });
        let (run, end_of_run) = channel();
        let (ran, ended) = thread::scope(|scope| {
            let child = &mut child;
            let ended = scope.spawn(move || kill_after_grace(child, cancel, &end_of_run));
            let ran = match send_limits(&mut input, &self.solver.limits) {
                Ok(()) => {
                    let pipes = (input, BufReader::new(output));
                    follow_child(pipes, request, cancel, progress)
                }
                Err(_) => Err(RunError::Died(ProcessDeath::NoResult)),
            };
            // Dropped too if `progress` panics.
            drop(run);
            (ran, ended.join())
        });
        if let (Some(log), Ok(Some(_))) = (log, &ended) {
            // A panic there has lost some lines of the log, no more.
            let _ = log.join();
        }
        ran.map_err(|error| match (error, ended) {
            (RunError::Died(_), Ok(Some(end))) => {
                RunError::Died(end.death(memory.load(Ordering::Relaxed)))
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

/// Writes the line that the process reads first.
fn send_limits(input: &mut impl Write, limits: &Limits) -> io::Result<()> {
    serde_json::to_writer(&mut *input, limits)?;
    input.write_all(b"\n")
}

/// The end of a process.
struct ProcessEnd {
    status: ExitStatus,
    /// True if this program killed it.
    is_killed: bool,
}

impl ProcessEnd {
    /// Returns the cause of the death of a process that left no result.
    fn death(&self, is_memory: bool) -> ProcessDeath {
        match self.status.signal() {
            _ if is_memory => ProcessDeath::Memory,
            Some(signal) if !self.is_killed => ProcessDeath::Signal(signal),
            _ => ProcessDeath::NoResult,
        }
    }
}

/// Waits for the end of the process, and kills it if it lives on for [`GRACE`] after it was
/// canceled or its run was over. Returns `None` if the system does not tell of its end.
fn kill_after_grace(
    child: &mut Child,
    cancel: &CancelToken,
    run: &Receiver<Infallible>,
) -> Option<ProcessEnd> {
    let mut since: Option<Instant> = None;
    let mut is_killed = false;
    loop {
        let waited = child.try_wait();
        if let Ok(Some(status)) = waited {
            return Some(ProcessEnd { status, is_killed });
        }
        let is_over = matches!(run.try_recv(), Err(TryRecvError::Disconnected));
        if is_over || cancel.is_canceled() {
            let is_late = since.get_or_insert_with(Instant::now).elapsed() > GRACE;
            if is_late && !is_killed {
                is_killed = child.kill().is_ok();
            }
            if is_late && is_over && waited.is_err() {
                tracing::error!(process = child.id(), "the end of a process is not told");
                return None;
            }
        }
        thread::sleep(POLL_INTERVAL);
    }
}

/// Passes the log of the process on, and notes if it told of a lack of memory.
fn pass_log_on(log: ChildStderr, memory: &AtomicBool) {
    let mut log = BufReader::new(log);
    let mut line = vec![];
    while log
        .read_until(b'\n', &mut line)
        .is_ok_and(|bytes| bytes > 0)
    {
        if line.starts_with(OUT_OF_MEMORY) {
            memory.store(true, Ordering::Relaxed);
        }
        let text = String::from_utf8_lossy(&line);
        tracing::warn!(line = text.trim_end(), "of a job's own process");
        line.clear();
    }
}
