//! A piece as a block: its labels, lines and marks, each on its layer.

use super::drawn_piece::DrawnPiece;
use super::tags::TagWriter;
use crate::pattern::point::Point2;
use crate::pattern::polyline::bounds;
use crate::pattern::{NotchKind, Panel, Pattern};

/// Layers of ANSI/AAMA-292, and those of ASTM D6673 for notches of other shapes.
pub(super) mod layer {
    pub(in super::super) const BOUNDARY: u32 = 1;
    pub(super) const TURN: u32 = 2;
    pub(super) const CURVE: u32 = 3;
    pub(super) const NOTCH: u32 = 4;
    pub(super) const FOLD: u32 = 6;
    pub(super) const GRAIN: u32 = 7;
    pub(super) const INTERNAL: u32 = 8;
    pub(super) const CUTOUT: u32 = 11;
    pub(super) const DRILL: u32 = 13;
    pub(super) const SEW: u32 = 14;
    pub(super) const T_NOTCH: u32 = 80;
    pub(super) const CASTLE_NOTCH: u32 = 81;
    pub(super) const CHECK_NOTCH: u32 = 82;
    pub(super) const U_NOTCH: u32 = 83;
    /// Every layer that is used.
    pub(in super::super) const ALL: [u32; 15] = [
        0,
        BOUNDARY,
        TURN,
        CURVE,
        NOTCH,
        FOLD,
        GRAIN,
        INTERNAL,
        CUTOUT,
        DRILL,
        SEW,
        T_NOTCH,
        CASTLE_NOTCH,
        CHECK_NOTCH,
        U_NOTCH,
    ];
}

/// Curve points are written of patterns with up to this many points of outlines. They say nothing
/// that the lines do not, and a file holds at most so many entities.
pub(super) const MOST_CURVE_POINTS: usize = 100_000;

/// The largest number of pieces that is read as one.
pub(super) const MOST_CUT: u32 = 100;

/// Returns the labels of a piece.
pub(super) fn labels(panel: &Panel, pattern: &Pattern) -> Vec<String> {
    let name = panel.name.trim();
    let name = if name.is_empty() { &panel.id } else { name };
    let mut lines = vec![format!("Piece Name: {name}")];
    let size = pattern.source.sample_size.as_ref();
    if let Some(size) = size.filter(|_| !pattern.source.sizes.is_empty()) {
        lines.push(format!("Size: {size}"));
    }
    match cut(panel, pattern) {
        Some([left, 0]) => lines.push(format!("Quantity: {left}")),
        Some([left, right]) => lines.push(format!("Quantity: {left},{right}")),
        None => {}
    }
    lines
}

/// Returns the number that is cut as drawn and mirrored; a mirrored copy that the pattern holds
/// without a number counts as one.
pub(super) fn cut(panel: &Panel, pattern: &Pattern) -> Option<[u32; 2]> {
    let stated = panel
        .quantity
        .map(|quantity| [quantity.left, quantity.right]);
    let has_copy = || {
        let mut panels = pattern.panels.iter();
        panels.any(|other| other.copy_of.as_ref() == Some(&panel.id))
    };
    match stated {
        Some([_, right]) if right > 0 => stated,
        Some([left, _]) if has_copy() => Some([left, 1]),
        None if has_copy() => Some([1, 1]),
        _ => stated,
    }
    .map(|cut| cut.map(|count| count.min(MOST_CUT)))
}

/// Writes the block of a piece; the flag says if curve points are written.
pub(super) fn block(
    file: &mut TagWriter,
    name: &str,
    labels: &[String],
    (piece, with_curve_points): (&DrawnPiece, bool),
) {
    file.text(0, "BLOCK").text(8, "0").text(2, name);
    file.number(70, 0.0).place(10, [0.0; 2]).number(30, 0.0);
    file.text(3, name);
    file.lines_of_text(labels, middle(&piece.boundary));
    file.polyline(layer::BOUNDARY, &piece.boundary, true);
    if let Some(sew) = &piece.sew {
        file.polyline(layer::SEW, sew, true);
    }
    for turn in &piece.turns {
        file.point(layer::TURN, *turn);
    }
    for point in piece.curve_points.iter().filter(|_| with_curve_points) {
        file.point(layer::CURVE, *point);
    }
    lines(file, piece);
    marks(file, piece);
    file.text(0, "ENDBLK").text(8, "0");
}

fn lines(file: &mut TagWriter, piece: &DrawnPiece) {
    if let Some(fold) = piece.fold {
        file.line(layer::FOLD, fold);
    }
    for hole in &piece.holes {
        file.polyline(layer::CUTOUT, hole, true);
    }
    for line in &piece.lines {
        match line.split_last() {
            Some((last, open)) if open.len() > 2 && open[0] == *last => {
                file.polyline(layer::INTERNAL, open, true);
            }
            _ => file.polyline(layer::INTERNAL, line, false),
        }
    }
}

fn marks(file: &mut TagWriter, piece: &DrawnPiece) {
    for notch in &piece.notches {
        let point = file.point(notch_layer(notch.kind), notch.at);
        point.length(30, notch.depth_m.unwrap_or(0.0));
    }
    for drill in &piece.drills {
        file.point(layer::DRILL, *drill);
    }
    if let Some(angle_deg) = piece.grain_deg {
        file.line(layer::GRAIN, grain_line(&piece.boundary, angle_deg));
    }
}

/// Returns the layer of notches of a shape; slits have none of their own.
fn notch_layer(kind: NotchKind) -> u32 {
    match kind {
        NotchKind::V | NotchKind::Slit => layer::NOTCH,
        NotchKind::T => layer::T_NOTCH,
        NotchKind::Castle => layer::CASTLE_NOTCH,
        NotchKind::Check => layer::CHECK_NOTCH,
        NotchKind::U => layer::U_NOTCH,
    }
}

/// Returns the middle of the box of a line.
fn middle(points: &[Point2]) -> Point2 {
    let [low, high] = bounds(points);
    [0, 1].map(|k| f64::midpoint(low[k], high[k]))
}

/// Returns a line through the middle of a piece, half as long as its shorter side.
fn grain_line(boundary: &[Point2], angle_deg: f64) -> [Point2; 2] {
    let [low, high] = bounds(boundary);
    let half = 0.25 * (high[0] - low[0]).min(high[1] - low[1]);
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let way = if angle_deg == 90.0 {
        [0.0, half]
    } else {
        [half * cos, half * sin]
    };
    let at = middle(boundary);
    [
        [at[0] - way[0], at[1] - way[1]],
        [at[0] + way[0], at[1] + way[1]],
    ]
}
