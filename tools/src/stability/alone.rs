//! One case in a process of its own, so that a crash is a line too and what never ends is ended.

use crate::child;
use seamster_fixtures::stability::StabilityCase;
use seamster_fixtures::stability::line::StabilityLine;
use std::io;
use std::process::Stdio;
use std::time::Duration;

/// Wall time allowed to a case and to what it is compared with: so many times what it states, and
/// so much \[s\].
const PATIENCE: f64 = 4.0;
const COMPARISON: f64 = 60.0;

/// Runs the case of this number.
pub(crate) fn run(number: usize, case: &StabilityCase) -> io::Result<StabilityLine> {
    let allowed = Duration::from_secs_f64(PATIENCE * case.within_s + COMPARISON);
    let arguments = ["stability", "--run", &number.to_string()];
    let Some(output) = child::run(&arguments, allowed, Stdio::null())? else {
        return Ok(failed(
            case,
            "did not end",
            format!("ended after {:.0} s", allowed.as_secs_f64()),
        ));
    };
    match serde_json::from_str(&output.text) {
        Ok(line) => Ok(line),
        Err(error) => Ok(failed(
            case,
            "crashed",
            format!("success: {}; {error}", output.success),
        )),
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
