//! One case in a process of its own, so that a crash is a line too and what never ends is ended.

use seamster_fixtures::stability::StabilityCase;
use seamster_fixtures::stability::line::StabilityLine;
use std::io::{self, Read};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Wall time allowed to a case and to what it is compared with: so many times what it states, and
/// so much \[s\].
const PATIENCE: f64 = 4.0;
const COMPARISON: f64 = 60.0;

/// Runs the case of this number.
pub(crate) fn run(number: usize, case: &StabilityCase) -> io::Result<StabilityLine> {
    let mut child = Command::new(std::env::current_exe()?)
        .args(["stability", "--run", &number.to_string()])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let allowed = Duration::from_secs_f64(PATIENCE * case.within_s + COMPARISON);
    let Some(success) = wait(&mut child, allowed)? else {
        return Ok(failed(
            case,
            "did not end",
            format!("ended after {:.0} s", allowed.as_secs_f64()),
        ));
    };
    let mut text = String::new();
    if let Some(mut out) = child.stdout.take() {
        out.read_to_string(&mut text)?;
    }
    match serde_json::from_str(&text) {
        Ok(line) => Ok(line),
        Err(error) => Ok(failed(
            case,
            "crashed",
            format!("success: {success}; {error}"),
        )),
    }
}

/// Returns true if the process ended well, `None` if it had to be ended. A line is short enough for
/// the pipe to hold it meanwhile.
fn wait(child: &mut Child, allowed: Duration) -> io::Result<Option<bool>> {
    let began = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status.success()));
        }
        if began.elapsed() > allowed {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        sleep(Duration::from_millis(5));
    }
}

fn failed(case: &StabilityCase, came_to: &str, why: String) -> StabilityLine {
    StabilityLine {
        case: case.name.clone(),
        came_to: came_to.to_owned(),
        faults: vec![format!("{came_to}: {why}")],
        why,
        within_s: case.within_s,
        ..StabilityLine::default()
    }
}
