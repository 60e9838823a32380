//! One garment in a process of its own.

use super::garment::SweepGarment;
use super::line::SweepLine;
use super::options::SweepOptions;
use crate::child;
use std::io;
use std::process::Stdio;
use std::time::Duration;

/// Wall time allowed: so many times the CPU time, and so much \[s\].
const PATIENCE: f64 = 4.0;
const BESIDES: f64 = 60.0;

/// Sews a garment as the options say.
///
/// # Errors
/// A process that cannot be started.
pub(super) fn run(
    garment: &SweepGarment,
    edge_length: f64,
    options: &SweepOptions,
) -> io::Result<SweepLine> {
    let length = edge_length.to_string();
    let time_limit = options.time_limit.to_string();
    let form = options.form.to_string();
    let mut arguments = vec![
        "sweep",
        "--alone",
        "--edge-length",
        &length,
        "--form",
        &form,
        "--time-limit",
        &time_limit,
        &garment.name,
    ];
    if options.suggest {
        arguments.push("--suggest");
    }
    if options.no_self_contact {
        arguments.push("--no-self-contact");
    }
    let each = options.drafted.map(|each| each.to_string());
    if let Some(each) = &each {
        arguments.extend(["--drafted", each]);
    }
    let allowed = Duration::from_secs_f64(PATIENCE * options.time_limit + BESIDES);
    let error = match child::run(&arguments, allowed, Stdio::inherit())? {
        None => format!("ended after {:.0} s", allowed.as_secs_f64()),
        Some(output) => match serde_json::from_str(&output.text) {
            Ok(line) => return Ok(line),
            Err(error) => format!("crashed: {error}"),
        },
    };
    Ok(SweepLine {
        error: Some(error),
        ..options.line(garment, edge_length)
    })
}
