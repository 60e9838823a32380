//! The command `import`: reads a pattern file and says what is in it.

use super::exit::{BAD_INPUT, fail, print};
use super::faults::print_faults;
use super::input::PatternOptions;
use super::output::write;
use clap::Args;
use seamster::config::Limits;
use seamster::export::{self, PatternFile, with_option_names};
use seamster::fault::{Fault, Faults, without_controls};
use seamster::pattern::Pattern;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `import`: the pattern, and the files to write.
#[derive(Args)]
pub(super) struct ImportCommand {
    /// The pattern: DXF or a GarmentCode specification
    #[arg(value_name = "PATTERN")]
    file: PathBuf,
    #[command(flatten)]
    options: PatternOptions,
    /// Print the whole pattern as JSON instead of a table
    #[arg(long)]
    json: bool,
    /// File to write a drawing to, with the numbers of corners and edges
    #[arg(long, value_name = "OUT.svg")]
    drawing: Option<PathBuf>,
    /// File to write the pattern to as AAMA DXF
    #[arg(long, value_name = "OUT.dxf")]
    dxf: Option<PathBuf>,
    /// File to write the pattern to as a GarmentCode specification
    #[arg(long, value_name = "OUT.json")]
    specification: Option<PathBuf>,
}

/// Imports a pattern, prints it and writes the files that are requested.
pub(super) fn import(command: &ImportCommand) -> ExitCode {
    let pattern = match command.options.read(&command.file, &Limits::default()) {
        Ok(pattern) => pattern,
        Err(faults) => {
            print_faults(&command.file, &with_options(faults));
            return BAD_INPUT.into();
        }
    };
    if let Err(error) = write_all(command, &pattern) {
        return fail(&error);
    }
    if !command.json {
        return print(&export::pattern_summary(&pattern));
    }
    match serde_json::to_string_pretty(&pattern) {
        Ok(json) => print(&json),
        Err(error) => fail(&error.to_string()),
    }
}

/// Returns faults that name the options of the command line.
fn with_options(faults: Faults) -> Faults {
    let named = faults.0.into_iter().map(|fault| Fault {
        detail: with_option_names(&fault.detail),
        fix: fault.fix.as_deref().map(with_option_names),
        ..fault
    });
    Faults(named.collect())
}

fn write_all(command: &ImportCommand, pattern: &Pattern) -> Result<(), String> {
    if let Some(path) = &command.drawing {
        write(path, export::drawing_svg(pattern).as_bytes())?;
    }
    if let Some(path) = &command.dxf {
        write_file(path, &export::pattern_dxf(pattern))?;
    }
    if let Some(path) = &command.specification {
        write_file(path, &export::pattern_specification(pattern))?;
    }
    Ok(())
}

/// Writes a pattern file, and prints what it leaves out to stderr.
fn write_file(path: &Path, file: &PatternFile) -> Result<(), String> {
    write(path, file.text.as_bytes())?;
    for what in &file.left_out {
        let line = format!("{}: not in this file: {what}", path.display());
        eprintln!("{}", without_controls(&line));
    }
    Ok(())
}
