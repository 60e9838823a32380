//! A job in a process of its own: its request on its standard input, its progress and its result on
//! its standard output, a JSON value a line.

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
use std::convert::Infallible;
use std::io::{BufRead, Error, Result, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// Time between two looks at whether the run is canceled.
const POLL_INTERVAL: Duration = Duration::from_millis(20);

/// The line that asks the process to end its run.
const CANCEL: &str = "cancel";

/// A message of the process.
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
            told = tell(&mut output, &ChildMessage::Progress(progress.finite()));
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
fn send_request(input: &mut impl Write, request: &JobRequest) -> Result<()> {
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
    send_request(&mut input, request).map_err(died)?;
    let (run, end_of_run) = channel();
    std::thread::scope(|scope| {
        scope.spawn(move || pass_cancel_on(input, cancel, &end_of_run));
        // Dropped with the result, and if `progress` panics.
        let _run = run;
        read_result(output, progress)
    })
}

/// Tells the process if the run is canceled. Its input ends with the run.
fn pass_cancel_on(mut input: impl Write, cancel: &CancelToken, run: &Receiver<Infallible>) {
    while run.recv_timeout(POLL_INTERVAL) == Err(RecvTimeoutError::Timeout) {
        if cancel.is_canceled() {
            // It may have ended by itself.
            let _ = writeln!(input, "{CANCEL}").and_then(|()| input.flush());
            return;
        }
    }
}

fn read_result(
    mut output: impl BufRead,
    progress: &mut dyn FnMut(Progress),
) -> std::result::Result<JobOutcome, RunError> {
    let mut line = vec![];
    loop {
        line.clear();
        output.read_until(b'\n', &mut line).map_err(died)?;
        if line.pop() != Some(b'\n') {
            return Err(RunError::Died(ProcessDeath::NoResult));
        }
        let message = serde_json::from_slice(&line);
        return match message.map_err(|error| RunError::Protocol(error.to_string()))? {
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
}

/// Returns the error of a process that broke off.
fn died(_: Error) -> RunError {
    RunError::Died(ProcessDeath::NoResult)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::Garment;
    use std::io::{BufReader, pipe};

    /// Does what the default fabric of the garment says.
    struct Script;

    impl Runner for Script {
        fn run(
            &self,
            request: JobRequest,
            cancel: &CancelToken,
            progress: &mut dyn FnMut(Progress),
        ) -> std::result::Result<JobOutcome, Faults> {
            let JobRequest::Fit(garment) = request else {
                panic!("fits only");
            };
            progress(Progress {
                fraction: f64::NAN,
                residual: Some(f64::INFINITY),
                cpu_s: 2.0,
                ..Progress::default()
            });
            match &*garment.default_fabric {
                "panic" => panic!("as told"),
                "wait" => {
                    while !cancel.is_canceled() {
                        std::thread::sleep(POLL_INTERVAL);
                    }
                }
                _ => {}
            }
            Ok(JobOutcome::Fit(Box::new(FitOutcome {
                mesh: GarmentMesh::default(),
                report: DrapeReport::default(),
                canceled: cancel.is_canceled(),
            })))
        }
    }

    fn request(does: &str) -> JobRequest {
        let garment = serde_json::json!({"seams": [], "default_fabric": does});
        let garment: Garment = serde_json::from_value(garment).unwrap();
        JobRequest::Fit(Box::new(garment))
    }

    /// Runs both ends of a run, joined by pipes.
    fn run(
        does: &str,
        cancel: &CancelToken,
        progress: &mut dyn FnMut(Progress),
    ) -> std::result::Result<JobOutcome, RunError> {
        let (child_input, input) = pipe().unwrap();
        let (output, child_output) = pipe().unwrap();
        let child = std::thread::spawn(move || {
            run_child(BufReader::new(child_input), child_output, &Script)
        });
        let pipes = (input, BufReader::new(output));
        let ran = follow_child(pipes, &request(does), cancel, progress);
        child.join().unwrap().unwrap();
        ran
    }

    #[test]
    fn progress_without_a_number_is_told_and_the_result_comes() {
        let mut told = vec![];
        let ran = run("sew", &CancelToken::new(), &mut |one| told.push(one));
        assert!(ran.is_ok_and(|outcome| !outcome.is_canceled()));
        let expected = Progress {
            cpu_s: 2.0,
            ..Progress::default()
        };
        assert_eq!(told, [expected]);
    }

    #[test]
    fn a_cancellation_reaches_the_run() {
        let cancel = CancelToken::new();
        let ran = run("wait", &cancel, &mut |_| cancel.cancel());
        assert!(ran.is_ok_and(|outcome| outcome.is_canceled()));
    }

    #[test]
    fn a_panic_of_the_run_is_told() {
        let ran = run("panic", &CancelToken::new(), &mut |_| {});
        assert!(matches!(ran, Err(RunError::Panicked)));
    }

    #[test]
    fn a_panic_of_who_hears_of_progress_ends_the_run() {
        let told = catch_unwind(|| run("wait", &CancelToken::new(), &mut |_| panic!("as told")));
        assert!(told.is_err());
    }

    #[test]
    fn what_cannot_be_read_is_told_and_what_breaks_off_is_a_death() {
        let read = |output: &[u8]| read_result(output, &mut |_| {}).err();
        for wrong in [&b"nonsense\n"[..], b"\xff\n", b"{\"progress\":{}}\n", b"\n"] {
            assert!(
                matches!(read(wrong), Some(RunError::Protocol(_))),
                "{wrong:?}"
            );
        }
        for broken in [&b""[..], b"{\"fit\":", b"\"panicked\""] {
            let death = Some(RunError::Died(ProcessDeath::NoResult));
            assert_eq!(
                format!("{:?}", read(broken)),
                format!("{death:?}"),
                "{broken:?}"
            );
        }
    }
}
