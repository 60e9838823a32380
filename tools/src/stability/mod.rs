//! Stiff and extreme cases, all of them: `cargo run --release -p seamster-tools stability --
//! 'seam*'`.
//!
//! Every case is a process of its own, which is killed when it takes far longer than it states, and
//! gives one JSON line in `target/stability.jsonl`; lines of cases that are not run again stay.
//! `--table docs/accuracy.md` writes the lines into the table there. Ends with 1 if a case did not
//! come to what is expected of it.

mod alone;
mod table;

use crate::marked;
use clap::Args;
use seamster_fixtures::stability::line::StabilityLine;
use seamster_fixtures::stability::{self, StabilityCase, cases};
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::{collections::BTreeMap, fs};

const LINES: &str = "target/stability.jsonl";

/// Runs stiff and extreme cases.
#[derive(Args)]
pub(crate) struct StabilityOptions {
    /// Cases to run; a name may end in `*`. All of them if none is named.
    cases: Vec<String>,
    /// Runs only the cases that continuous integration runs.
    #[arg(long)]
    small: bool,
    /// Runs nothing, but writes the lines that are there into the table of this file.
    #[arg(long)]
    table: Option<PathBuf>,
    /// Runs the case of this number in this process.
    #[arg(long, hide = true)]
    run: Option<usize>,
}

/// Runs the cases that `options` names, or writes the table.
///
/// # Errors
/// Files that cannot be read or written.
pub(crate) fn main(options: &StabilityOptions) -> io::Result<ExitCode> {
    let all = cases();
    if let Some(case) = options.run.and_then(|number| all.get(number)) {
        println!("{}", serde_json::to_string(&stability::line(case, 1.0))?);
        return Ok(ExitCode::SUCCESS);
    }
    let mut known = known_lines()?;
    if let Some(file) = &options.table {
        marked::replace(file, "stability", &table::markdown(&in_order(&all, &known)))?;
        return Ok(ExitCode::SUCCESS);
    }
    let mut wrong = 0;
    for (number, case) in all.iter().enumerate() {
        if !options.names(case) {
            continue;
        }
        let line = alone::run(number, case)?;
        eprintln!("{}", table::short(&line));
        wrong += usize::from(!line.faults.is_empty());
        known.insert(case.name.clone(), line);
        write_lines(&in_order(&all, &known))?;
    }
    eprintln!("{wrong} cases are not as expected");
    Ok(ExitCode::from(u8::from(wrong > 0)))
}

impl StabilityOptions {
    fn names(&self, case: &StabilityCase) -> bool {
        let fits = |name: &String| match name.strip_suffix('*') {
            Some(start) => case.name.starts_with(start),
            None => case.name == *name,
        };
        (self.cases.is_empty() || self.cases.iter().any(fits)) && (case.small || !self.small)
    }
}

fn in_order(
    cases: &[StabilityCase],
    known: &BTreeMap<String, StabilityLine>,
) -> Vec<StabilityLine> {
    cases
        .iter()
        .filter_map(|case| known.get(&case.name).cloned())
        .collect()
}

fn write_lines(lines: &[StabilityLine]) -> io::Result<()> {
    let mut file = fs::File::create(LINES)?;
    for line in lines {
        writeln!(file, "{}", serde_json::to_string(line)?)?;
    }
    Ok(())
}

fn known_lines() -> io::Result<BTreeMap<String, StabilityLine>> {
    let text = match fs::read_to_string(LINES) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(error),
    };
    let line = |text: &str| -> io::Result<(String, StabilityLine)> {
        let line: StabilityLine = serde_json::from_str(text)?;
        Ok((line.case.clone(), line))
    };
    text.lines().map(line).collect()
}
