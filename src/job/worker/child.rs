//! A job in a process of its own: what it is told on its standard input and tells on its standard
//! output, a JSON value a line.

use super::runner::{RunError, Runner};
use crate::export::GarmentMesh;
use crate::fault::{Fault, Faults};
use crate::fit::FitOutcome;
use crate::job::kind::JobKind;
use crate::job::process_death::ProcessDeath;
use crate::job::request::JobRequest;
use crate::job::result::JobOutcome;
use crate::progress::{CancelToken, Progress};
use crate::solver::DrapeReport;
use crate::study::Study;
use serde::{Deserialize, Serialize};
use std::io::{BufRead, Error, Result, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Time between two looks at whether the run is canceled.
const POLL_INTERVAL: Duration = Duration::from_millis(20);

/// The line that asks the process to end its run.
const CANCEL: &str = "cancel";

/// What the process tells.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum ChildMessage {
    /// It came further.
    Progress(Progress),
    /// The result of a fit.
    Fit {
        mesh: Box<GarmentMesh>,
        report: Box<DrapeReport>,
        canceled: bool,
    },
    /// The result of a study.
    Study(Box<Study>),
    /// The request has faults.
    Refused(Vec<Fault>),
    /// The run panicked.
    Panicked,
}

impl ChildMessage {
    fn of(outcome: JobOutcome) -> Self {
        match outcome {
            JobOutcome::Fit(fit) => Self::Fit {
                mesh: Box::new(fit.mesh),
                report: Box::new(fit.report),
                canceled: fit.canceled,
            },
            JobOutcome::Study(study) => Self::Study(study),
        }
    }
}

/// Runs the job that `input` holds by `runner`, and tells `output` of it.
///
/// # Errors
/// If the request cannot be read or nothing can be told: nobody is there any more.
pub fn run_child(
    mut input: impl BufRead + Send + 'static,
    mut output: impl Write,
    runner: &dyn Runner,
) -> Result<()> {
    let kind: JobKind = serde_json::from_str(&line_of(&mut input)?)?;
    let request = JobRequest::read(kind, line_of(&mut input)?.as_bytes())?;
    let cancel = CancelToken::new();
    let token = cancel.clone();
    std::thread::spawn(move || {
        // The end of the input is that of the service.
        let _ = line_of(&mut input);
        token.cancel();
    });
    let mut told = Ok(());
    let mut on_progress = |progress: Progress| {
        if told.is_ok() {
            told = tell(&mut output, &ChildMessage::Progress(progress));
        }
    };
    let run = || runner.run(request, &cancel, &mut on_progress);
    let message = match catch_unwind(AssertUnwindSafe(run)) {
        Ok(Ok(outcome)) => ChildMessage::of(outcome),
        Ok(Err(faults)) => ChildMessage::Refused(faults.0),
        Err(_) => ChildMessage::Panicked,
    };
    told?;
    tell(&mut output, &message)
}

fn line_of(input: &mut impl BufRead) -> Result<String> {
    let mut line = String::new();
    input.read_line(&mut line)?;
    Ok(line)
}

fn tell(output: &mut impl Write, message: &impl Serialize) -> Result<()> {
    serde_json::to_writer(&mut *output, message)?;
    output.write_all(b"\n")?;
    output.flush()
}

/// Writes the request to the input of a process that runs [`run_child`].
///
/// # Errors
/// If the process does not take it.
fn ask(input: &mut impl Write, request: &JobRequest) -> Result<()> {
    tell(input, &request.kind())?;
    input.write_all(&request.json()?)?;
    input.write_all(b"\n")?;
    input.flush()
}

/// Follows a process that runs [`run_child`], from the request to its result. `cancel` asks it to
/// end; who calls ends it if it does not.
///
/// # Errors
/// The faults of the request, or that the process ended without a result.
pub fn follow_child(
    (mut input, output): (impl Write + Send, impl BufRead),
    request: &JobRequest,
    cancel: &CancelToken,
    progress: &mut dyn FnMut(Progress),
) -> std::result::Result<JobOutcome, RunError> {
    ask(&mut input, request).map_err(died)?;
    let is_done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| pass_cancel_on(input, cancel, &is_done));
        let result = read_result(output, progress);
        is_done.store(true, Ordering::Relaxed);
        result
    })
}

/// Tells the process if the run is canceled. Its input ends with the run.
fn pass_cancel_on(mut input: impl Write, cancel: &CancelToken, is_done: &AtomicBool) {
    while !is_done.load(Ordering::Relaxed) {
        if cancel.is_canceled() {
            // It may have ended by itself.
            let _ = writeln!(input, "{CANCEL}").and_then(|()| input.flush());
            return;
        }
        std::thread::sleep(POLL_INTERVAL);
    }
}

fn read_result(
    output: impl BufRead,
    progress: &mut dyn FnMut(Progress),
) -> std::result::Result<JobOutcome, RunError> {
    for line in output.lines() {
        let message = serde_json::from_str(&line.map_err(died)?);
        return match message.map_err(|error| died(error.into()))? {
            ChildMessage::Progress(one) => {
                progress(one);
                continue;
            }
            ChildMessage::Fit {
                mesh,
                report,
                canceled,
            } => Ok(JobOutcome::Fit(Box::new(FitOutcome {
                mesh: *mesh,
                report: *report,
                canceled,
            }))),
            ChildMessage::Study(study) => Ok(JobOutcome::Study(study)),
            ChildMessage::Refused(faults) => Err(RunError::Refused(Faults(faults))),
            ChildMessage::Panicked => Err(RunError::Panicked),
        };
    }
    Err(RunError::Died(ProcessDeath::NoResult))
}

/// Returns the error of a process that broke off.
fn died(_: Error) -> RunError {
    RunError::Died(ProcessDeath::NoResult)
}
