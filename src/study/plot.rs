//! The work-precision picture of a study.

use super::report::{Study, StudyRun};
use super::wording::{edges, method_name, run_summary};
use crate::export::{Plot, PlotPoint, PlotSeries};
use crate::solver::Analysis;

/// Draws work against precision of all runs as an SVG: CPU seconds across, the solver error up,
/// both logarithmic; a curve for each method and mesh. Runs whose error is not known are listed
/// below it.
pub fn plot_svg(study: &Study) -> String {
    let (mut series, mut foot): (Vec<PlotSeries>, Vec<String>) = Default::default();
    let lengths = study.meshes.iter().map(|mesh| mesh.edge_length_m);
    let finest = lengths.fold(f64::INFINITY, f64::min);
    for run in &study.runs {
        let Some(error) = run.error_m.filter(|e| *e > 0.0 && run.cpu_s > 0.0) else {
            foot.push(format!("not drawn: {}", run_summary(run)));
            continue;
        };
        let point = PlotPoint {
            across: run.cpu_s,
            up: 1e3 * error,
            reached: run.converged,
            tip: run_summary(run),
        };
        let name = curve_name(run, study);
        match series.iter_mut().find(|s| s.name == name) {
            Some(known) => known.points.push(point),
            None => series.push(PlotSeries {
                name,
                points: vec![point],
                scale: (finest / run.edge_length_m).clamp(0.4, 1.0),
            }),
        }
    }
    Plot {
        heading: heading(study),
        across: "CPU time [s]".to_owned(),
        up: "RMS solver error [mm]".to_owned(),
        series,
        foot,
    }
    .svg()
}

fn heading(study: &Study) -> String {
    let analysis = match study.want {
        Analysis::Static => "drape",
        Analysis::Transient => "motion",
    };
    let size = match &study.meshes[..] {
        [mesh] => format!(", {} vertices", mesh.vertices),
        _ => String::new(),
    };
    format!("Work against precision of a {analysis}{size}")
}

/// Returns the name of the curve that a run belongs to.
fn curve_name(run: &StudyRun, study: &Study) -> String {
    let mut name = method_name(run);
    if study.meshes.len() > 1 {
        name = format!("{name}, {}", edges(run.edge_length_m));
    }
    if !study.orders.is_empty() && run.tolerance.is_some() {
        name += ", chosen steps";
    }
    name
}
