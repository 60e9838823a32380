//! Instructions that terms and reports take: `cargo run --release -p seamster-tools instructions`.
//!
//! Needs valgrind. The first table is that of the tests of `solver::left_out`: drapes of a scene
//! that lacks a body, wind, bending and seams, against programs that put its two terms together by
//! hand. The second is of whole fits of a shipped sample: how much of them the report takes, with
//! its error estimate and the curve of error against run time, and how much the dress form.
//! `--table docs/accuracy.md` writes both between `<!-- instructions: begin -->` and
//! `<!-- instructions: end -->` there.

use crate::marked;
use clap::Args;
use seamster::config::Limits;
use seamster::fit;
use seamster::progress::CancelToken;
use seamster::solver::Context;
use seamster_fixtures::callgrind::{self, Profile, REPORT};
use seamster_fixtures::samples::sample;
use serde_json::json;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::Command;

/// Lengths of mesh edges \[m\].
const EDGES: [&str; 2] = ["0.040", "0.025"];
/// Functions listed of the finest fit.
const LISTED: usize = 10;
const OF_TERMS: &str = "
| scene of weight only | by hand | as a drape | more | its report |
|---|---:|---:|---:|---:|
";
const OF_FITS: &str = "
| skirt, edges | instructions | report | dress form | factorization |
|---|---:|---:|---:|---:|
";

/// Options of the count.
#[derive(Args)]
pub(crate) struct InstructionsOptions {
    /// Writes the tables into this file instead of printing them.
    #[arg(long)]
    table: Option<PathBuf>,
    /// Sews the sample skirt with edges of this length \[m\]: the program that is counted.
    #[arg(long, hide = true)]
    fit: Option<f64>,
}

/// Counts, and prints or writes the tables.
///
/// # Errors
/// What valgrind, cargo or the file said.
pub(crate) fn main(options: &InstructionsOptions) -> Result<(), String> {
    if let Some(edge_length) = options.fit {
        fit(edge_length);
        return Ok(());
    }
    let text = tables()?;
    match &options.table {
        Some(file) => marked::replace(file, "instructions", &text).map_err(|e| e.to_string()),
        None => {
            print!("{text}");
            Ok(())
        }
    }
}

/// Sews the sample skirt: the program that is counted. Its clock stands still, since the time that
/// counting takes is none of its.
fn fit(edge_length: f64) {
    let simulate = json!({"edge_length_m": edge_length});
    let prepared = sample("skirt", json!({ "simulate": simulate }));
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    let mut context = Context {
        cpu_s: &|| 0.0,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    };
    let fit = fit::run(&prepared, &mut context).expect("the shipped samples can be sewn");
    assert!(fit.report.converged, "{}", fit.report.why);
}

fn tables() -> Result<String, String> {
    let mut out = format!("{OF_TERMS}{}{OF_FITS}", of_terms()?);
    let mut finest = Profile::default();
    for edge in EDGES {
        finest = callgrind::run(&["instructions", "--fit", edge])?;
        out += &row(edge, &finest)?;
    }
    let _ = write!(
        out,
        "\nMost instructions of their own outside the matrix library, at {} m:\n\n",
        EDGES[1]
    );
    let all = whole(&finest)? as f64;
    let own = finest.most_expensive().into_iter();
    for (function, own) in own.filter(|(f, _)| !of_matrices(f)).take(LISTED) {
        let _ = writeln!(out, "- {:.1} % `{function}`", 100.0 * own as f64 / all);
    }
    out.push('\n');
    Ok(out)
}

/// Returns true if a function is one of the matrix library, whose innermost ones have addresses for
/// names.
fn of_matrices(function: &str) -> bool {
    let crates = ["0x", "seamster_cholesky::", "pulp::"];
    crates.iter().any(|name| function.contains(name))
}

/// The rows that the unit tests print.
fn of_terms() -> Result<String, String> {
    let tests = [
        "test",
        "--locked",
        "--lib",
        "solver::left_out::",
        "--",
        "--nocapture",
    ];
    let ran = Command::new(env!("CARGO")).args(tests).output();
    let ran = ran.map_err(|error| error.to_string())?;
    let said = String::from_utf8_lossy(&ran.stdout);
    if !ran.status.success() {
        return Err(format!("{said}{}", String::from_utf8_lossy(&ran.stderr)));
    }
    // with one thread a row stands on the line of its test
    let row = |line: &str| line.find("| drape").map(|at| line[at..].to_owned());
    let rows = said.lines().filter_map(row);
    Ok(rows.map(|row| format!("{row}\n")).collect())
}

fn whole(profile: &Profile) -> Result<u64, String> {
    of(profile, "fit::run::run")
}

fn of(profile: &Profile, function: &str) -> Result<u64, String> {
    let found = profile.of(function);
    found.ok_or_else(|| format!("{function} did not run, or not under that name"))
}

/// Shares of a fit.
fn row(edge: &str, profile: &Profile) -> Result<String, String> {
    let all = whole(profile)?;
    let share = |cost: u64| format!("{:.2} %", 100.0 * cost as f64 / all as f64);
    let mut report = 0;
    for function in REPORT.iter().filter(|f| !f.ends_with("refuse")) {
        report += of(profile, function)?;
    }
    let form = of(profile, "avatar::form::DressForm::build")?;
    let factors = of(profile, "seamster_cholesky::Cholesky::factorize")?;
    let shares = [report, form, factors].map(share).join(" | ");
    Ok(format!("| {edge} m | {all} | {shares} |\n"))
}
