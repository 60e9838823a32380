//! Real garments sewn, a row each: `cargo run --release -p seamster-tools sweep`.
//!
//! The garments of `own_size.json` in the folder that `SEAMSTER_TEST_DATA` names, each on the form
//! of its own size, the default form or a body from a file; first those whose seams are known, then
//! those by suggested seams. With `--drafted`, garments drafted by seeds instead, on forms that
//! they are drafted for. Each is a process of its own, so that its memory is its own and a
//! crash is a row too. A JSON line each goes to `target/sweep.jsonl`, a picture from four sides to
//! `target/sweep/`, of the last edge length.

mod alone;
mod form;
mod garment;
mod line;
mod options;
mod sewn;
mod table;

use crate::marked;
use garment::SweepGarment;
use line::SweepLine;
pub(crate) use options::SweepOptions;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, process};

const LINES: &str = "target/sweep.jsonl";
const PICTURES: &str = "target/sweep";

/// Sews the garments that `options` names.
///
/// # Errors
/// Files that cannot be read or written.
pub(crate) fn main(options: &SweepOptions) -> io::Result<()> {
    let folder = env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from);
    let (folder, mut garments) = match (options.drafted, folder) {
        (Some(each), folder) => (folder.unwrap_or_default(), garment::drafted(each)),
        (None, Some(folder)) => {
            let garments = garment::list(&folder)?;
            (folder, garments)
        }
        (None, None) => {
            eprintln!("SEAMSTER_TEST_DATA is to name the folder of real patterns");
            process::exit(2);
        }
    };
    garments.retain(|garment| options.names(garment));
    if options.suggest {
        garments.iter_mut().for_each(SweepGarment::forget_seams);
    }
    if garments.is_empty() {
        eprintln!("there is no such garment");
        process::exit(2);
    }
    if options.alone {
        for garment in &garments {
            let line = sewn::sew(garment, &folder, options, Path::new(PICTURES));
            println!("{}", serde_json::to_string(&line)?);
        }
        return Ok(());
    }
    let lines = sew_all(&garments, options)?;
    println!("\n{}", table::summary(&lines));
    match &options.table {
        Some(file) => marked::replace(file, "garments", &table::markdown(&lines)),
        None => Ok(()),
    }
}

/// Sews each garment in a process of its own, and prints the rows as they come.
fn sew_all(garments: &[SweepGarment], options: &SweepOptions) -> io::Result<Vec<SweepLine>> {
    fs::create_dir_all(PICTURES)?;
    let mut file = File::create(LINES)?;
    let mut lines = vec![];
    for are_true in [true, false] {
        let of_kind = garments.iter().filter(|g| g.has_true_seams() == are_true);
        for (number, garment) in of_kind.enumerate() {
            if number == 0 {
                println!("{}", table::head(are_true));
            }
            for &edge_length in &options.edge_lengths {
                let line = alone::run(garment, edge_length, options)?;
                println!("{}", table::row(&line));
                writeln!(file, "{}", serde_json::to_string(&line)?)?;
                lines.push(line);
            }
        }
    }
    Ok(lines)
}
