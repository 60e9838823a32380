//! Work against precision as a picture: one SVG a scene, CPU seconds across, the error or else the residual up, both logarithmic.
//!
//! Methods are told apart by marker and dashes as well as by colour. A hollow marker is a run that was stopped before it
//! reached what was asked.

mod axis;
mod ink;

use crate::line::Line;
use axis::Axis;
use ink::{Look, look, text};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

/// Size of a picture, and what is left free on its left, right, top and bottom \[px\].
const SIZE: [f64; 2] = [860.0, 480.0];
const MARGIN: [f64; 4] = [84.0, 280.0, 48.0, 64.0];
/// What others reach on a scene within a second of simulated time: method, CPU time \[s\], RMS error \[mm\]; each measured on one
/// core, against the rest shape of the same net.
const OTHERS: [(&str, &str, f64, f64); 5] = [
    ("S1P", "Newton (NVIDIA), explicit", 4.2, 3e-4),
    ("S1P", "pypbd, XPBD", 1.5, 2.6),
    ("S1P", "pypbd, XPBD", 2.0, 0.115),
    ("S1P", "pypbd, XPBD", 5.8, 1e-3),
    ("S1P", "Newton (NVIDIA), VBD", 13.0, 0.066),
];

/// A run in a picture.
#[derive(Clone, Copy, Debug)]
struct Point {
    /// CPU time \[s\].
    work: f64,
    /// Error \[mm\] or residual.
    off: f64,
    reached: bool,
}

/// Points of one method by its name.
type Series = BTreeMap<String, Vec<Point>>;

/// A picture of every scene that `lines` has.
pub(crate) fn write_all(folder: &Path, lines: &[Line]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let mut scenes: BTreeMap<&str, Vec<&Line>> = BTreeMap::new();
    for line in lines {
        scenes.entry(&line.scene).or_default().push(line);
    }
    for (scene, lines) in scenes {
        fs::write(folder.join(format!("{scene}.svg")), picture(scene, &lines))?;
    }
    Ok(())
}

fn picture(scene: &str, lines: &[&Line]) -> String {
    let has_error = lines.iter().any(|line| line.error_m.is_some());
    let series = series(scene, lines, has_error);
    let points = || series.values().flatten();
    let [left, right, top, bottom] = MARGIN;
    let across = Axis::over(points().map(|p| p.work), [left, SIZE[0] - right]);
    let up = Axis::over(points().map(|p| p.off), [SIZE[1] - bottom, top]);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\">\n<title>{scene}: work against precision</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
        SIZE[0],
        SIZE[1],
        ink::SHEET
    );
    let vertices = lines.first().map_or(0, |line| line.vertices);
    let heading = format!("{scene}: {vertices} vertices");
    out += &text(&heading, [left, 0.55 * top], 16.0, "start");
    out += &across.grid([SIZE[1] - bottom, top], false);
    out += &up.grid([left, SIZE[0] - right], true);
    let middle = [
        0.5 * (left + SIZE[0] - right),
        0.5 * (top + SIZE[1] - bottom),
    ];
    out += &text("CPU time [s]", [middle[0], SIZE[1] - 16.0], 13.0, "middle");
    let quantity = if has_error {
        "RMS error [mm]"
    } else {
        "residual r: net force over weight"
    };
    let turned = text(quantity, [0.0, 0.0], 13.0, "middle");
    let _ = writeln!(
        out,
        "<g transform=\"translate(20 {}) rotate(-90)\">{turned}</g>",
        middle[1]
    );
    for (place, (name, points)) in series.iter().enumerate() {
        let look = look(name);
        out += &curve(points, &look, [&across, &up]);
        out += &legend(name, &look, place);
    }
    out += &text(
        "hollow: stopped before it got there",
        [SIZE[0] - right + 20.0, SIZE[1] - bottom],
        12.0,
        "start",
    );
    out + "</svg>\n"
}

/// Points by method, those of other programs among them.
fn series(scene: &str, lines: &[&Line], has_error: bool) -> Series {
    let mut series = Series::new();
    for line in lines {
        let off = if has_error {
            line.error_m.map(|error| 1e3 * error)
        } else {
            Some(line.residual)
        };
        let Some(off) = off.filter(|off| off.is_finite() && *off > 0.0) else {
            continue;
        };
        series.entry(name(line)).or_default().push(Point {
            work: line.cpu_s,
            off,
            reached: line.converged,
        });
    }
    let others = OTHERS.iter().filter(|other| other.0 == scene && has_error);
    for &(_, name, work, off) in others {
        series.entry(name.to_owned()).or_default().push(Point {
            work,
            off,
            reached: true,
        });
    }
    for points in series.values_mut() {
        points.sort_by(|p, q| p.work.total_cmp(&q.work));
    }
    series
}

/// The method of a line with what else was asked of it.
fn name(line: &Line) -> String {
    let membrane = format!("{}, {}", line.method, line.membrane);
    if line.setting.get("seam_close").is_some() {
        format!("{membrane}, seams stay springs")
    } else {
        membrane
    }
}

fn curve(points: &[Point], look: &Look, [across, up]: [&Axis; 2]) -> String {
    let at = |p: &Point| [across.place(p.work), up.place(p.off)];
    let way: Vec<String> = points
        .iter()
        .map(|p| format!("{:.1},{:.1}", at(p)[0], at(p)[1]))
        .collect();
    let mut out = format!(
        "<polyline points=\"{}\" fill=\"none\" {}/>\n",
        way.join(" "),
        look.stroke()
    );
    out.extend(points.iter().map(|p| look.marker(at(p), p.reached)));
    out
}

fn legend(name: &str, look: &Look, place: usize) -> String {
    let x = SIZE[0] - MARGIN[1] + 20.0;
    let y = MARGIN[2] + 10.0 + 24.0 * place as f64;
    let line = format!(
        "<line x1=\"{x}\" y1=\"{y}\" x2=\"{}\" y2=\"{y}\" {}/>\n",
        x + 40.0,
        look.stroke()
    );
    let marker = look.marker([x + 20.0, y], true);
    line + &marker + &text(name, [x + 48.0, y + 4.0], 12.0, "start")
}
