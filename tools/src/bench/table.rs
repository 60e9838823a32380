//! The lines as a table for people, in Markdown or one by one.

use super::line::BenchLine;
use super::summary;
use crate::marked;
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

const HEAD: &str = "| scene | vertices | method | setting | CPU s | iterations | r | error mm | estimate mm | gap mm | penetration mm | strain % | energy J | memory MB |
|---|---:|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|
";

/// Replaces the table in `file` by one of these lines.
pub(crate) fn write(file: &Path, lines: &[BenchLine]) -> io::Result<()> {
    marked::replace(file, "bench", &markdown(lines))
}

fn markdown(lines: &[BenchLine]) -> String {
    let mut out = format!("\n{}\n\n{}", machine(), summary::markdown(lines));
    let _ = write!(out, "\n### Every run\n\n{HEAD}");
    for line in lines {
        let [cpu, iterations, residual] = work(line);
        let cells = [
            line.scene.clone(),
            line.vertices.to_string(),
            format!("{}, {}", line.method, line.membrane),
            setting(&line.setting),
            cpu,
            iterations,
            residual,
            error(line),
            millimeters(line.estimate_m.filter(|_| line.estimate_valid)),
            millimeters(Some(line.gap_m)),
            millimeters(Some(line.penetration_m)),
            figures(100.0 * line.strain_max),
            format!("{:.5}", line.energy_j),
            format!("{:.0}", line.memory_peak_bytes as f64 / 1e6),
        ];
        let _ = writeln!(out, "| {} |", cells.join(" | "));
    }
    out.push('\n');
    out
}

/// One line of plain text.
pub(crate) fn short(line: &BenchLine) -> String {
    let [cpu, iterations, residual] = work(line);
    format!(
        "{:15} {:16} {:42} {cpu:>8} s {iterations:>5} it, r {residual:>8}, error {:>8} mm (estimate {}), gap {} mm, in {} mm, strain {} %, {:.6} J, {:.0} MB",
        line.scene,
        line.method,
        setting(&line.setting),
        error(line),
        millimeters(line.estimate_m.filter(|_| line.estimate_valid)),
        millimeters(Some(line.gap_m)),
        millimeters(Some(line.penetration_m)),
        figures(100.0 * line.strain_max),
        line.energy_j,
        line.memory_peak_bytes as f64 / 1e6,
    )
}

/// CPU time, iterations and residual; a residual that was to be lower has a star.
fn work(line: &BenchLine) -> [String; 3] {
    let iterations = match line.newton_iterations {
        0 => "–".to_owned(),
        count => count.to_string(),
    };
    let star = if line.converged { "" } else { "*" };
    [
        figures(line.cpu_s),
        iterations,
        format!("{:.1e}{star}", line.residual),
    ]
}

/// Options besides the method and the membrane, which have a column.
fn setting(setting: &Value) -> String {
    let fields = setting.as_object().into_iter().flatten();
    let told = fields
        .filter(|(field, _)| !matches!(field.as_str(), "method" | "membrane"))
        .map(|(field, value)| match value.as_f64() {
            Some(number) if number < 0.01 => format!("{field} {number:.0e}"),
            Some(number) => format!("{field} {number}"),
            None => format!("{field} {}", value.as_str().unwrap_or_default()),
        });
    told.collect::<Vec<_>>().join(", ")
}

/// The error in millimeters, with a sign where only a bound is known.
pub(crate) fn error(line: &BenchLine) -> String {
    let bound = line.reference_moved_m < line.error_m;
    let sign = if bound { "≤ " } else { "" };
    format!("{sign}{}", millimeters(line.error_m))
}

fn millimeters(meters: Option<f64>) -> String {
    meters.map_or("–".to_owned(), |meters| figures(1e3 * meters))
}

/// Two figures that count.
pub(crate) fn figures(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        a if a < 1e-3 => format!("{x:.1e}"),
        a if a < 0.1 => format!("{x:.4}"),
        a if a < 10.0 => format!("{x:.2}"),
        _ => format!("{x:.0}"),
    }
}

/// Machine that it was measured on.
fn machine() -> String {
    let cpus = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpus
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split(':').nth(1));
    format!(
        "Measured with Seamster {} on one core of {}. A star: stopped by the time allowed or by a fault before the residual asked for.",
        env!("CARGO_PKG_VERSION"),
        model.unwrap_or("an unknown machine").trim()
    )
}
