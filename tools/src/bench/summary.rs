//! Summary of the lines: the time that each method takes to come to rest, and its growth with the
//! number of vertices.

use super::line::BenchLine;
use super::table::{error, figures};
use std::fmt::Write;

/// Residual that counts as at rest.
const AT_REST: f64 = 1e-5;
/// The tubes of which the growth is told.
const GROWING: &str = "tube";

/// The two as Markdown.
pub(crate) fn markdown(lines: &[BenchLine]) -> String {
    let mut methods: Vec<&str> = Vec::new();
    for line in lines {
        if !methods.contains(&line.method.as_str()) {
            methods.push(&line.method);
        }
    }
    let mut scenes: Vec<(&str, usize)> = Vec::new();
    for line in lines {
        if scenes.last().is_none_or(|scene| scene.0 != line.scene) {
            scenes.push((&line.scene, line.vertices));
        }
    }
    let mut out = format!(
        "### CPU seconds to rest (r ≤ 1e-5), with the error then\n\n| scene | vertices | {} |\n|---|---:|{}\n",
        methods.join(" | "),
        "---:|".repeat(methods.len())
    );
    for (scene, vertices) in scenes {
        let cells: Vec<String> = methods
            .iter()
            .map(|method| cell(lines, scene, method))
            .collect();
        let _ = writeln!(out, "| {scene} | {vertices} | {} |", cells.join(" | "));
    }
    out + &growth(lines)
}

/// The quickest run of a method on a scene that came to rest.
fn quickest<'a>(lines: &'a [BenchLine], scene: &str, method: &str) -> Option<&'a BenchLine> {
    lines
        .iter()
        .filter(|line| line.scene == scene && line.method == method)
        // One that was stopped may balance its forces in no minimum.
        .filter(|line| line.converged && line.residual <= AT_REST)
        .min_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s))
}

fn cell(lines: &[BenchLine], scene: &str, method: &str) -> String {
    let asked = |line: &BenchLine| {
        line.setting["tolerance"]
            .as_f64()
            .is_some_and(|t| t <= AT_REST)
    };
    let run = || {
        lines
            .iter()
            .any(|line| line.scene == scene && line.method == method && asked(line))
    };
    match quickest(lines, scene, method) {
        Some(line) if line.error_m.is_some() => {
            format!("{} ({} mm)", figures(line.cpu_s), error(line))
        }
        Some(line) => figures(line.cpu_s),
        None if run() => "not in the time".to_owned(),
        None => "–".to_owned(),
    }
}

/// A sentence on the exponent p of CPU time over vertices to the power of p, between the smallest
/// and the largest tube.
fn growth(lines: &[BenchLine]) -> String {
    let tubes = |line: &&BenchLine| line.scene.starts_with(GROWING) && !line.scene.contains('_');
    let mut points: Vec<(f64, f64)> = Vec::new();
    for line in lines.iter().filter(tubes) {
        if let Some(best) = quickest(lines, &line.scene, "newton") {
            let point = (best.vertices as f64, best.cpu_s);
            if points.last() != Some(&point) {
                points.push(point);
            }
        }
    }
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return String::new();
    };
    if first.0 >= last.0 {
        return String::new();
    }
    let exponent = (last.1 / first.1).ln() / (last.0 / first.0).ln();
    format!(
        "\nFrom {:.0} to {:.0} vertices the tubes' time grows with their number to the power of {exponent:.2}.\n",
        first.0, last.0
    )
}
