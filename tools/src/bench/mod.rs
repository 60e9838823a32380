//! Work against precision on the benchmark's scenes:
//! `cargo run --release -p seamster-tools bench -- S3 'tube*'`.
//!
//! Every run is a process of its own, so that its peak of memory is told apart from the others',
//! and gives one JSON line in `target/bench.jsonl`; lines of scenes that are not run again stay.
//! Each scene gets a plot in `target/bench/`. `--table docs/performance.md` writes the lines into
//! the table there. A time says nothing without the error reached: every line has both.

mod line;
mod plan;
mod plot;
mod run;
mod summary;
mod table;

use clap::Args;
use line::BenchLine;
use plan::BenchRun;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

const LINES: &str = "target/bench.jsonl";
const PLOTS: &str = "target/bench";

/// Runs the benchmark's scenes.
#[derive(Args)]
pub(crate) struct BenchOptions {
    /// Scenes to run; a name may end in `*`. All of them if none is named.
    scenes: Vec<String>,
    /// Runs this method only.
    #[arg(long)]
    method: Option<String>,
    /// Wall time after which no further run is begun \[s\].
    #[arg(long, default_value_t = 600.0)]
    budget_s: f64,
    /// Runs nothing, but writes the lines that are there into the table of this file.
    #[arg(long)]
    table: Option<PathBuf>,
    /// One run, in this process.
    #[arg(long, hide = true)]
    run: Option<String>,
}

/// Runs the scenes that `options` names, or writes the table.
///
/// # Errors
/// Files that cannot be read or written.
pub(crate) fn main(options: &BenchOptions) -> io::Result<()> {
    if let Some(run) = &options.run {
        let run: BenchRun = serde_json::from_str(run)?;
        if let Some(line) = run::measured(&run) {
            println!("{}", serde_json::to_string(&line)?);
        }
        return Ok(());
    }
    if let Some(file) = &options.table {
        return table::write(file, &known_lines()?);
    }
    let runs = plan::runs(&options.scenes, options.method.as_deref());
    if runs.is_empty() {
        eprintln!(
            "no scene is called so; there are: {}",
            plan::names().join(" ")
        );
        std::process::exit(2);
    }
    let lines = all(&runs, options.budget_s)?;
    plot::write_all(Path::new(PLOTS), &lines)
}

/// Runs them one after the other; all lines known now, those of scenes that were not run included.
fn all(runs: &[BenchRun], budget_s: f64) -> io::Result<Vec<BenchLine>> {
    fs::create_dir_all(PLOTS)?;
    let mut lines = known_lines()?;
    let began = Instant::now();
    for (done, run) in runs.iter().enumerate() {
        if began.elapsed().as_secs_f64() > budget_s {
            eprintln!("the time is up: {} runs left out", runs.len() - done);
            break;
        }
        if let Some(line) = alone(run)? {
            eprintln!("{}", table::short(&line));
            lines.retain(|other| !other.same_run(&line));
            lines.push(line);
        }
    }
    // in the order of the plan, whatever was run when
    let place = |line: &BenchLine| plan::names().iter().position(|name| *name == line.scene);
    lines.sort_by_key(place);
    let mut file = fs::File::create(LINES)?;
    for line in &lines {
        writeln!(file, "{}", serde_json::to_string(line)?)?;
    }
    Ok(lines)
}

/// One run in a process of its own; none if its method is not what was asked for.
fn alone(run: &BenchRun) -> io::Result<Option<BenchLine>> {
    let output = Command::new(std::env::current_exe()?)
        .args(["bench", "--run"])
        .arg(serde_json::to_string(run)?)
        .stderr(std::process::Stdio::inherit())
        .output()?;
    if !output.status.success() {
        eprintln!(
            "{} ended with {}: {}",
            run.scene, output.status, run.setting
        );
        return Ok(None);
    }
    if output.stdout.is_empty() {
        return Ok(None);
    }
    Ok(Some(serde_json::from_slice(&output.stdout)?))
}

fn known_lines() -> io::Result<Vec<BenchLine>> {
    match fs::read_to_string(LINES) {
        Ok(text) => text
            .lines()
            .map(|line| serde_json::from_str(line).map_err(io::Error::from))
            .collect(),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(error) => Err(error),
    }
}
