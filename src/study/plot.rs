//! The work-precision picture of a study.

use super::report::{Study, StudyRun};
use super::run::edges;
use crate::export::{Plot, PlotPoint, PlotSeries};
use crate::solver::Analysis;

/// Work against precision of all runs as an SVG: CPU seconds across, the solver error up, both logarithmic; a curve for each
/// method and mesh. Runs whose error is not known are listed below it.
pub fn plot_svg(study: &Study) -> String {
    let (mut series, mut foot): (Vec<PlotSeries>, Vec<String>) = Default::default();
    let finest = study
        .meshes
        .iter()
        .map(|mesh| mesh.edge_length_m)
        .fold(f64::INFINITY, f64::min);
    for run in &study.runs {
        let Some(error) = run.error_m.filter(|e| *e > 0.0 && run.cpu_s > 0.0) else {
            foot.push(format!("not drawn: {}", tip(run)));
            continue;
        };
        let point = PlotPoint {
            across: run.cpu_s,
            up: 1e3 * error,
            reached: run.converged,
            tip: tip(run),
        };
        let name = name(run, study);
        match series.iter_mut().find(|s| s.name == name) {
            Some(known) => known.points.push(point),
            None => series.push(PlotSeries {
                name,
                points: vec![point],
                scale: (finest / run.edge_length_m).clamp(0.4, 1.0),
            }),
        }
    }
    let wanted = match study.want {
        Analysis::Static => "drape",
        Analysis::Transient => "motion",
    };
    let size = match &study.meshes[..] {
        [mesh] => format!(", {} vertices", mesh.vertices),
        _ => String::new(),
    };
    Plot {
        heading: format!("Work against precision of a {wanted}{size}"),
        across: "CPU time [s]".to_owned(),
        up: "RMS solver error [mm]".to_owned(),
        series,
        foot,
    }
    .svg()
}

/// The curve of a run.
fn name(run: &StudyRun, study: &Study) -> String {
    let method = method_name(run);
    let mut name = if study.meshes.len() > 1 {
        format!("{method}, {}", edges(run.edge_length_m))
    } else {
        method
    };
    if !study.orders.is_empty() && run.tolerance.is_some() {
        name += ", chosen steps";
    }
    name
}

/// The method asked for, and which one `auto` was.
pub(super) fn method_name(run: &StudyRun) -> String {
    let asked = run.method.name().to_owned();
    if asked == run.used || run.used.is_empty() {
        asked
    } else {
        format!("{asked}: {}", run.used)
    }
}

/// A run in a line.
fn tip(run: &StudyRun) -> String {
    let error = run.error_m.map_or_else(
        || "no error known".to_owned(),
        |error| format!("error {:.2e} mm", 1e3 * error),
    );
    let ended = if run.converged {
        String::new()
    } else {
        format!("; {}", run.why)
    };
    format!(
        "{}, {}, {}: {:.3} s, {error}{ended}",
        method_name(run),
        setting(run),
        edges(run.edge_length_m),
        run.cpu_s,
    )
}

/// What was varied.
pub(super) fn setting(run: &StudyRun) -> String {
    match (run.step_s, run.tolerance) {
        (Some(step), _) => format!("steps of {step:.2e} s"),
        (None, Some(tolerance)) => format!("tolerance {tolerance:.0e}"),
        (None, None) => "its own setting".to_owned(),
    }
}
