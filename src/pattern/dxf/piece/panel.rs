//! Pieces to panels: the outline chosen, unfolded, checked, cut into edges, with its marks put on.

use super::dxf_piece::DxfPiece;
use super::folds::Folds;
use super::rings::{self, RingOf};
use super::{drawn_notches, holes, notch};
use crate::config::Limits;
use crate::fault::PatternCode;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::outline::{Outline, ring_of};
use crate::pattern::point::{Point2, cross, distance, sub};
use crate::pattern::polyline::signed_area;
use crate::pattern::{Grain, ImportOptions, Panel};

/// A grain line at least this share of the longest as long is one of its own, no arrow head.
const SECOND_GRAIN: f64 = 0.5;

/// Sine of the angle by which directions of the warp differ at least.
const OTHER_WAY: f64 = 0.02;

/// Builds the panel of a piece, without an id. What keeps it from being one becomes a fault at its
/// line.
///
/// The outline is the sew line where there is one, else the line as drawn.
pub(crate) fn build(
    piece: &DxfPiece,
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Option<Panel> {
    let drawn = rings::checked(RingOf::Piece(piece), &piece.outline.chain, limits, findings)?;
    let sew = piece.sew.as_ref();
    let sew = sew.and_then(|sew| rings::of_sew_line(piece, sew, limits, findings));
    let folds = Folds::of(piece, &drawn, options.unfold, findings);
    let mut cut = folds.unfolded(&drawn);
    let whole = sew.as_ref().map(|sew| folds.unfolded(sew));
    let (ring, bays) = match whole {
        Some(sewn) => (sewn.outline, sewn.holes),
        None => (cut.outline.clone(), std::mem::take(&mut cut.holes)),
    };
    let (ring, at_folds) = if folds.is_empty() {
        (ring, vec![])
    } else {
        drawn_notches::without_notches_at_folds(piece, ring, options.notches, findings)
    };
    let marks = [&piece.marks.notches[..], &at_folds].concat();
    let ring = rings::simple(RingOf::Piece(piece), ring, findings)?.into_clockwise();
    let outline = Outline::cut(&ring.points, &ring.is_corner);
    let holes = holes::holes(piece, &folds, bays, limits, findings);
    let hole_area: f64 = holes
        .iter()
        .map(|hole| signed_area(&ring_of(&hole.edges)))
        .sum();
    Some(Panel {
        id: String::new(),
        name: piece.name.chars().take(limits.name_chars).collect(),
        label: None,
        face: None,
        area_m2: signed_area(&ring.points).abs() - hole_area.abs(),
        perimeter_m: outline.edges.iter().map(|edge| edge.length_m).sum(),
        drawn_area_m2: signed_area(&drawn.points).abs(),
        unfolded: !folds.is_empty(),
        copy_of: None,
        quantity: piece.labels.quantity(),
        notches: notch::notches(piece, &marks, &outline, &folds, findings),
        corners: outline.corners,
        edges: outline.edges,
        holes,
        cut_line: if sew.is_some() {
            cut.outline.points
        } else {
            drawn_cut_line(piece, &folds)
        },
        drill_holes: drill_holes(piece, &folds),
        grain: grain(piece, findings),
        internal_lines: internal_lines(piece, sew.is_some(), &folds),
    })
}

fn drill_holes(piece: &DxfPiece, folds: &Folds) -> Vec<Point2> {
    let mut points = piece.marks.drills.clone();
    folds.add_images(&mut points);
    points
}

/// Returns the cut line drawn about a sewn outline; an open one is unfolded like the piece.
fn drawn_cut_line(piece: &DxfPiece, folds: &Folds) -> Vec<Point2> {
    match &piece.cut {
        Some(cut) if !cut.closed => folds.unfolded_line(&cut.points),
        Some(cut) => cut.points.clone(),
        None => Vec::new(),
    }
}

/// Returns the direction of the longest grain line. Another one in another direction that is no
/// arrow head is warned about.
fn grain(piece: &DxfPiece, findings: &mut DxfFindings) -> Option<Grain> {
    let lines = &piece.marks.grains;
    let length = |line: &[Point2; 2]| distance(line[0], line[1]);
    let longest = lines
        .iter()
        .max_by(|a, b| length(a).total_cmp(&length(b)))?;
    let [a, b] = *longest;
    let differs = |line: &[Point2; 2]| {
        length(line) >= SECOND_GRAIN * length(longest)
            && cross(sub(b, a), sub(line[1], line[0])).abs()
                > OTHER_WAY * length(line) * length(longest)
    };
    if lines.iter().any(differs) {
        let detail = format!(
            "{:?} has grain lines in several directions; the longest was taken",
            piece.name
        );
        findings.warn(PatternCode::GrainIgnored, piece.line, detail);
    }
    let angle = (b[1] - a[1]).atan2(b[0] - a[0]);
    let angle_deg = angle.to_degrees().rem_euclid(180.0);
    Some(Grain {
        angle_deg: if angle_deg >= 180.0 { 0.0 } else { angle_deg },
    })
}

/// Returns the lines that are not cut: those drawn on the cloth, and a sew or cut line that is not
/// used otherwise. A closed one ends at its first point.
fn internal_lines(piece: &DxfPiece, is_sewn: bool, folds: &Folds) -> Vec<Vec<Point2>> {
    let unused_sew = piece.sew.iter().filter(|_| !is_sewn);
    let second_cut = piece.cut.iter().filter(|_| is_sewn);
    let mut lines: Vec<Vec<Point2>> = Vec::new();
    for chain in piece.internal.iter().chain(unused_sew).chain(second_cut) {
        let mut line = chain.points.clone();
        line.extend(chain.points.first().filter(|_| chain.closed));
        if line.len() > 1 {
            lines.push(line);
        }
    }
    folds.add_line_images(&mut lines);
    lines
}
