//! Programs of the developers, a subcommand each:
//! `cargo run --release -p seamster-tools -- --help`.

mod accuracy;
mod bench;
mod bench_samples;
mod child;
mod draft_samples;
mod explicit_step;
mod instructions;
mod marked;
mod stability;
mod sweep;
mod truth_table;
mod unseen;

use clap::{Parser, Subcommand};
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

const SAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../static/samples");

/// Measures and tabulates what Seamster does.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    tool: Tool,
}

/// One of the programs.
#[derive(Subcommand)]
enum Tool {
    /// Error against run time on the benchmark's scenes.
    Bench(bench::BenchOptions),
    /// Run times of the shipped samples over mesh edge lengths.
    BenchSamples,
    /// Stiff and extreme cases against what is expected of them.
    Stability(stability::StabilityOptions),
    /// Real garments sewn, a row and a picture each; needs `SEAMSTER_TEST_DATA`.
    Sweep(sweep::SweepOptions),
    /// Error estimates against true errors, and time limits against times taken.
    Accuracy(accuracy::AccuracyOptions),
    /// Instructions that terms, reports and dress forms take; needs valgrind.
    Instructions(instructions::InstructionsOptions),
    /// Cost of an explicit step against the memory's bandwidth.
    ExplicitStep,
    /// Real patterns against what is known of them; needs `SEAMSTER_TEST_DATA`.
    TruthTable {
        /// Sections to print; all of them if none is named.
        sections: Vec<String>,
    },
    /// Suggestions of seams for drafted garments that the rules were not made with.
    Unseen(unseen::UnseenOptions),
    /// Writes the sample patterns anew.
    DraftSamples {
        /// Folder to write them into.
        #[arg(default_value = SAMPLES)]
        folder: PathBuf,
    },
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    match Arguments::parse().tool {
        Tool::Bench(options) => bench::main(&options)?,
        Tool::BenchSamples => bench_samples::main(),
        Tool::Stability(options) => return Ok(stability::main(&options)?),
        Tool::Sweep(options) => sweep::main(&options)?,
        Tool::Accuracy(options) => accuracy::main(&options)?,
        Tool::Instructions(options) => instructions::main(&options)?,
        Tool::ExplicitStep => explicit_step::main(),
        Tool::TruthTable { sections } => return Ok(truth_table::main(&sections)),
        Tool::Unseen(options) => unseen::main(&options),
        Tool::DraftSamples { folder } => draft_samples::main(&folder)?,
    }
    Ok(ExitCode::SUCCESS)
}
