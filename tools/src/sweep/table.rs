//! The lines as rows of plain text, and as a table in Markdown.

use super::line::SweepLine;
use std::fmt::Write;

/// Returns the head of the rows of one kind of seams.
pub(super) fn head(are_true: bool) -> String {
    let seams = if are_true { "true" } else { "suggested" };
    let columns = [
        "garment", "edge mm", "vertices", "rest", "good", "r", "gap mm", "pen. mm", "cloth",
        "body", "inside", "strain", "worn", "CPU s", "MB",
    ];
    format!("\n== {seams} seams\n{}", spaced(columns))
}

/// Returns a line as a row, with what is wrong at its end.
pub(super) fn row(line: &SweepLine) -> String {
    if let Some(error) = &line.error {
        return format!("{:32} {}", line.name, in_one_line(error));
    }
    let cells = [
        line.name.clone(),
        millimeters(line.edge_length_m),
        line.vertices.to_string(),
        yes(line.converged),
        good(line),
        format!("{:.0e}", line.residual),
        format!("{:.2}", 1e3 * line.seam_gap_m),
        format!("{:.2}", 1e3 * line.penetration_m),
        count(line.crossings),
        count(line.body_crossings),
        count(line.vertices_inside),
        format!("{:.2}", line.strain_max),
        yes(line.worn),
        format!("{:.1}", line.cpu_s),
        format!("{}", line.memory_bytes >> 20),
    ];
    let reasons = [(line.converged, &line.why), (line.worn, &line.worn_because)];
    let reasons = reasons.into_iter().filter(|(ok, _)| !ok);
    let reasons: Vec<&str> = reasons.map(|(_, reason)| reason.trim()).collect();
    format!(
        "{}  {}",
        spaced(cells.each_ref().map(String::as_str)),
        reasons.join("; ")
    )
}

/// Returns how many garments are at rest and good, in a sentence.
pub(super) fn summary(lines: &[SweepLine]) -> String {
    let of_kind = |are_true: bool| {
        let lines = lines.iter().filter(|line| line.true_seams == are_true);
        let all = lines.clone().count();
        let good = lines.filter(|line| line.converged && line.good).count();
        format!("{good} of {all}")
    };
    format!(
        "at rest and good: {} runs by true seams, {} by suggested ones",
        of_kind(true),
        of_kind(false)
    )
}

/// Returns the lines as a table of error and time in Markdown.
pub(super) fn markdown(lines: &[SweepLine]) -> String {
    let mut out = String::from(
        "\n| garment | edges mm | vertices | iterations | CPU s | to 0.1 mm | r | estimate mm | mesh error mm | good |\n\
         |---|---:|---:|---:|---:|---:|---:|---:|---:|---|\n",
    );
    for line in lines {
        let _ = writeln!(out, "| {} |", markdown_cells(line).join(" | "));
    }
    out.push('\n');
    out
}

fn markdown_cells(line: &SweepLine) -> Vec<String> {
    let name = line.name.trim_end_matches("_specification").to_owned();
    let mut cells = vec![name, millimeters(line.edge_length_m)];
    if let Some(error) = &line.error {
        cells.extend(["–"; 7].map(str::to_owned));
        cells.push(in_one_line(error));
        return cells;
    }
    let known = |of: Option<f64>, in_words: fn(f64) -> String| of.map_or("–".to_owned(), in_words);
    let star = if line.converged { "" } else { "*" };
    cells.extend([
        line.vertices.to_string(),
        line.newton_iterations.to_string(),
        format!("{:.1}", line.cpu_s),
        known(line.near_cpu_s, |s| format!("{s:.1}")),
        format!("{:.0e}{star}", line.residual),
        known(line.error_estimate_m, |m| format!("{:.1e}", 1e3 * m)),
        known(line.mesh_error_m, |m| format!("{:.1}", 1e3 * m)),
        good(line),
    ]);
    cells
}

fn good(line: &SweepLine) -> String {
    match line.failed.is_empty() {
        true => "good".to_owned(),
        false => line.failed.join(","),
    }
}

fn millimeters(length: f64) -> String {
    format!("{:.0}", 1e3 * length)
}

fn in_one_line(text: &str) -> String {
    text.trim().replace('\n', "; ")
}

fn spaced(cells: [&str; 15]) -> String {
    let [name, edge, vertices, rest, good, rest_of @ ..] = cells;
    let figures: Vec<String> = rest_of.iter().map(|cell| format!("{cell:>7}")).collect();
    format!(
        "{name:32} {edge:>7} {vertices:>8} {rest:>4} {good:26} {}",
        figures.join(" ")
    )
}

fn yes(is_so: bool) -> String {
    if is_so { "yes" } else { "no" }.to_owned()
}

fn count(of: Option<usize>) -> String {
    of.map_or("–".to_owned(), |count| count.to_string())
}
