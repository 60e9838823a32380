//! Work against precision as a picture: one SVG a scene, CPU seconds across, the error or else the
//! residual up, both logarithmic.

use super::line::BenchLine;
use seamster::export::{Plot, PlotPoint, PlotSeries};
use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};

/// Results of other simulators after a second of simulated time: method, CPU time \[s\], RMS error
/// \[mm\]; each measured on one core, against the rest shape of the same net.
const OTHERS: [(&str, &str, f64, f64); 5] = [
    ("S1P", "Newton (NVIDIA), explicit", 4.2, 3e-4),
    ("S1P", "pypbd, XPBD", 1.5, 2.6),
    ("S1P", "pypbd, XPBD", 2.0, 0.115),
    ("S1P", "pypbd, XPBD", 5.8, 1e-3),
    ("S1P", "Newton (NVIDIA), VBD", 13.0, 0.066),
];

/// A picture of every scene that `lines` has.
pub(crate) fn write_all(folder: &Path, lines: &[BenchLine]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let mut scenes: BTreeMap<&str, Vec<&BenchLine>> = BTreeMap::new();
    for line in lines {
        scenes.entry(&line.scene).or_default().push(line);
    }
    for (scene, lines) in scenes {
        fs::write(folder.join(format!("{scene}.svg")), picture(scene, &lines))?;
    }
    Ok(())
}

fn picture(scene: &str, lines: &[&BenchLine]) -> String {
    let has_error = lines.iter().any(|line| line.error_m.is_some());
    let vertices = lines.first().map_or(0, |line| line.vertices);
    let up = if has_error {
        "RMS error [mm]"
    } else {
        "residual r: net force over weight"
    };
    Plot {
        heading: format!("{scene}: {vertices} vertices"),
        across: "CPU time [s]".to_owned(),
        up: up.to_owned(),
        series: series(scene, lines, has_error),
        foot: Vec::new(),
    }
    .svg()
}

/// Points by method, those of other programs among them.
fn series(scene: &str, lines: &[&BenchLine], has_error: bool) -> Vec<PlotSeries> {
    let mut series: BTreeMap<String, Vec<PlotPoint>> = BTreeMap::new();
    let mut add = |name: String, across: f64, up: f64, reached: bool| {
        let tip = format!("{name}: {across:.3} s, {up:.2e}");
        let point = PlotPoint {
            across,
            up,
            reached,
            tip,
        };
        series.entry(name).or_default().push(point);
    };
    for line in lines {
        let up = if has_error {
            line.error_m.map(|error| 1e3 * error)
        } else {
            Some(line.residual)
        };
        if let Some(up) = up.filter(|up| up.is_finite() && *up > 0.0) {
            add(name(line), line.cpu_s, up, line.converged);
        }
    }
    let others = OTHERS.iter().filter(|other| other.0 == scene && has_error);
    for &(_, name, work, off) in others {
        add(name.to_owned(), work, off, true);
    }
    let sorted = |(name, mut points): (String, Vec<PlotPoint>)| {
        points.sort_by(|p, q| p.across.total_cmp(&q.across));
        PlotSeries {
            name,
            points,
            scale: 1.0,
        }
    };
    series.into_iter().map(sorted).collect()
}

/// The method of a line with what else was asked of it.
fn name(line: &BenchLine) -> String {
    let membrane = format!("{}, {}", line.method, line.membrane);
    if line.setting.get("seam_close").is_some() {
        format!("{membrane}, seams stay springs")
    } else {
        membrane
    }
}
