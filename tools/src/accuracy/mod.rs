//! Error estimates against true errors, and time limits against times:
//! `cargo run --release -p seamster-tools accuracy`.
//!
//! Garments from real files are sewn and draped, stopped by their tolerance (`garments`) or by a
//! time limit (`budget`). Each is then draped on from where it stopped to three times the round-off
//! floor: how far it moves is the true error. One JSON line a run goes to `target/accuracy.jsonl`;
//! `--table docs/accuracy.md` writes the lines into the tables there. The folder of real files is
//! named by `SEAMSTER_TEST_DATA`.

mod garment;
mod line;
mod table;

use clap::Args;
use garment::GARMENTS;
use line::AccuracyLine;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, fs};

const LINES: &str = "target/accuracy.jsonl";
/// Length of mesh edges \[m\] with which garments run to their end.
const COARSE: f64 = 0.025;
/// Residuals at which they stop.
const TOLERANCES: [f64; 2] = [1e-3, 1e-5];
/// CPU times allowed \[s\].
const TIMES: [f64; 2] = [2.0, 5.0];

/// Measures how true estimates are.
#[derive(Args)]
pub(crate) struct AccuracyOptions {
    /// Garments to run; all of them if none is named.
    garments: Vec<String>,
    /// Runs nothing, but writes the lines that are there into the tables of this file.
    #[arg(long)]
    table: Option<PathBuf>,
}

/// Runs the garments that `options` names, or writes the tables.
///
/// # Errors
/// Files that cannot be read or written.
pub(crate) fn main(options: &AccuracyOptions) -> io::Result<()> {
    if let Some(file) = &options.table {
        return table::write(file, &known()?);
    }
    let Some(folder) = env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from) else {
        eprintln!("SEAMSTER_TEST_DATA is to name the folder of real patterns");
        std::process::exit(2);
    };
    let names =
        |name: &str| options.garments.is_empty() || options.garments.iter().any(|n| n == name);
    for kind in GARMENTS.iter().filter(|kind| names(kind.name)) {
        for tolerance in TOLERANCES {
            keep(line::measured(kind, &folder, COARSE, tolerance, None))?;
        }
        if let Some(edge_length) = kind.fine_edge_length {
            for time_limit in TIMES {
                keep(line::measured(
                    kind,
                    &folder,
                    edge_length,
                    1e-5,
                    Some(time_limit),
                ))?;
            }
        }
    }
    Ok(())
}

/// Writes a line in the place of the one of the same run.
fn keep(line: AccuracyLine) -> io::Result<()> {
    eprintln!("{}", table::short(&line));
    let mut lines = known()?;
    lines.retain(|other| !other.same_run(&line));
    lines.push(line);
    let place = |line: &AccuracyLine| GARMENTS.iter().position(|kind| kind.name == line.garment);
    lines.sort_by_key(place);
    fs::create_dir_all("target")?;
    let mut file = fs::File::create(LINES)?;
    for line in &lines {
        writeln!(file, "{}", serde_json::to_string(line)?)?;
    }
    Ok(())
}

fn known() -> io::Result<Vec<AccuracyLine>> {
    if !Path::new(LINES).exists() {
        return Ok(vec![]);
    }
    let text = fs::read_to_string(LINES)?;
    text.lines()
        .map(|line| serde_json::from_str(line).map_err(io::Error::from))
        .collect()
}
