//! The lines as tables.

use super::line::AccuracyLine;
use crate::marked;
use std::fmt::Write;
use std::io;
use std::path::Path;

const HEAD: &str = "| garment | vertices | stopped at | CPU s | r | stated error mm | held valid | true error mm | stated / true | mesh error mm |
|---|---:|---|---:|---:|---:|---|---:|---:|---:|
";

/// Writes the tables `garments` and `budget` of `file`.
pub(crate) fn write(file: &Path, lines: &[AccuracyLine]) -> io::Result<()> {
    let of = |timed: bool| {
        let lines: Vec<&AccuracyLine> = lines
            .iter()
            .filter(|l| l.time_limit_s.is_some() == timed)
            .collect();
        format!("\n{}\n{HEAD}{}\n", summary(&lines, timed), rows(&lines))
    };
    marked::replace(file, "garments", &of(false))?;
    marked::replace(file, "budget", &of(true))
}

fn summary(lines: &[&AccuracyLine], timed: bool) -> String {
    let told: Vec<f64> = lines.iter().filter_map(|line| line.ratio()).collect();
    let within = |r: &&f64| (0.3..=3.0).contains(*r);
    let right = told.iter().filter(within).count();
    let is_wrong =
        |line: &&&AccuracyLine| line.valid && line.ratio().as_ref().is_some_and(|r| !within(&r));
    let wrong = lines.iter().filter(is_wrong);
    let mut text = format!(
        "Of {} runs whose true error can be told {right} state one within 0.3 to 3 times of it; of those that do not, {} are held valid.",
        told.len(),
        wrong.count()
    );
    if timed {
        let over = lines
            .iter()
            .filter_map(|line| Some(line.cpu_s / line.time_limit_s?));
        let _ = write!(
            text,
            " The longest took {:.3} of its time limit.",
            over.fold(0.0, f64::max)
        );
    }
    text + "\n"
}

fn rows(lines: &[&AccuracyLine]) -> String {
    lines.iter().fold(String::new(), |mut text, line| {
        let stopped = match line.time_limit_s {
            Some(limit) => format!("{limit:.0} s"),
            None => format!("r = {:.0e}", line.tolerance),
        };
        let sign = if line.referred { "" } else { "?" };
        let _ = writeln!(
            text,
            "| {} | {} | {stopped} | {:.2} | {:.0e} | {} | {} | {}{sign} | {} | {} |",
            line.garment,
            line.vertices,
            line.cpu_s,
            line.residual,
            millimeters(line.estimate_m),
            if line.valid { "yes" } else { "no" },
            millimeters(Some(line.error_m)),
            line.ratio()
                .map_or("–".to_owned(), |ratio| format!("{ratio:.2}")),
            millimeters(line.mesh_error_m),
        );
        text
    })
}

/// One line of plain text.
pub(crate) fn short(line: &AccuracyLine) -> String {
    rows(&[line]).trim().to_owned()
}

fn millimeters(meters: Option<f64>) -> String {
    match meters.map(|m| 1e3 * m) {
        None => "–".to_owned(),
        Some(mm) if mm < 0.01 => format!("{mm:.1e}"),
        Some(mm) => format!("{mm:.2}"),
    }
}
