//! Notches put on the edges of a panel. A notch drawn on the cut line belongs to the sew line
//! inside it; drawn on both, it is one.

use super::dxf_piece::{DxfPiece, NotchMark};
use super::folds::Folds;
use crate::fault::PatternCode;
use crate::pattern::Notch;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::outline::{Outline, notch_at, ring_of};
use crate::pattern::point::{Point2, distance, lerp};
use crate::pattern::polyline::{PolylineFoot, nearest, segments};

/// A notch on the cut line belongs to a sew line that is at most this far away \[m\].
const ALLOWANCE: f64 = 0.03;

/// A notch is drawn at most this far from its line: at its tip, or beside it \[m\].
const BESIDE: f64 = 0.005;

/// A notch that lies on a line is at most this far from it \[m\].
const ON: f64 = 1e-4;

/// A notch on the cut line and one on the sew line are one where the feet of both on the sew line
/// are this near \[m\]: they face each other along the cut line's normal, not the sew line's.
const TWINS: f64 = 0.002;

/// At most this many notches of a piece are read.
const MOST: usize = 1000;

/// A notch with its foot on the outline.
struct PlacedNotch {
    /// Index of its mark.
    mark: usize,
    /// Its foot on the outline.
    foot: PolylineFoot,
    /// The point of that foot.
    point: Point2,
    /// Depth to which it is cut, where the file gives it \[m\].
    depth: Option<f64>,
    /// True if it was drawn on the outline itself, not on the cut line about it.
    is_direct: bool,
    /// True if it stands for one on the other line too.
    has_twin: bool,
}

/// Returns the notches of a panel by their marks; those that lie on no edge are warned about.
pub(super) fn notches(
    piece: &DxfPiece,
    marks: &[NotchMark],
    outline: &Outline,
    folds: &Folds,
    findings: &mut DxfFindings,
) -> Vec<Notch> {
    let ring = ring_of(&outline.edges);
    let mut placed: Vec<PlacedNotch> = Vec::new();
    for (index, mark) in marks.iter().enumerate() {
        if index >= MOST {
            findings.skip("notch beyond the first 1000 of a piece", mark.line);
            continue;
        }
        let Some(found) = place(piece, &ring, mark, index) else {
            let detail = format!(
                "a notch of {:?} lies on no edge and is left out",
                piece.name
            );
            findings.warn(PatternCode::NotchIgnored, mark.line, detail);
            continue;
        };
        let images = folds.images(&mark.points);
        let images = images[1..]
            .iter()
            .filter_map(|points| foot_of_tip(&ring, points));
        let images = images.map(|foot| PlacedNotch {
            foot,
            point: point_at(&ring, foot),
            ..found
        });
        let images: Vec<PlacedNotch> = images.collect();
        add(&mut placed, found, marks);
        for image in images {
            add(&mut placed, image, marks);
        }
    }
    placed
        .iter()
        .enumerate()
        .map(|(index, notch)| Notch {
            depth_m: notch.depth,
            ..notch_at(&outline.edges, notch.foot, marks[notch.mark].kind, index)
        })
        .collect()
}

/// Adds a notch, unless it is the same as one on the other line.
fn add(placed: &mut Vec<PlacedNotch>, new: PlacedNotch, marks: &[NotchMark]) {
    let is_twin = |other: &&mut PlacedNotch| {
        other.is_direct != new.is_direct
            && !other.has_twin
            && other.mark != new.mark
            && marks[other.mark].kind == marks[new.mark].kind
            && distance(other.point, new.point) <= TWINS
    };
    match placed.iter_mut().find(is_twin) {
        Some(twin) => twin.has_twin = true,
        None => placed.push(new),
    }
}

/// Returns the place of a notch on the outline; `None` where it lies on no line of the piece.
fn place(piece: &DxfPiece, ring: &[Point2], mark: &NotchMark, index: usize) -> Option<PlacedNotch> {
    let points = &mark.points;
    let foot = foot_of_tip(ring, points)?;
    let distances = points
        .iter()
        .map(|p| nearest(segments(ring), *p).map_or(f64::INFINITY, |foot| foot.distance));
    let nearest_end = distances.clone().fold(f64::INFINITY, f64::min);
    let farthest = distances.fold(0.0, f64::max);
    let cut_lines = [Some(&piece.outline.chain), piece.cut.as_ref()];
    let is_on_cut = cut_lines.into_iter().flatten().any(|cut| {
        let foot = nearest(segments(&cut.points), points[0]);
        foot.is_some_and(|foot| foot.distance <= BESIDE / 5.0)
    });
    if nearest_end > BESIDE && !(is_on_cut && nearest_end <= ALLOWANCE) {
        return None;
    }
    let is_direct = nearest_end <= ON;
    let drawn_depth = (points.len() > 1 && is_direct).then_some(farthest);
    Some(PlacedNotch {
        mark: index,
        foot,
        point: point_at(ring, foot),
        depth: mark.depth.or(drawn_depth).filter(|depth| *depth > ON),
        is_direct,
        has_twin: false,
    })
}

/// Returns the foot of the point of a notch that is farthest from the outline.
fn foot_of_tip(ring: &[Point2], points: &[Point2]) -> Option<PolylineFoot> {
    let distance = |p: &Point2| nearest(segments(ring), *p).map_or(0.0, |foot| foot.distance);
    let tip = points
        .iter()
        .max_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest(segments(ring), tip.copied().unwrap_or_default())
}

/// Returns the point of a foot.
fn point_at(ring: &[Point2], foot: PolylineFoot) -> Point2 {
    let (a, b) = (ring[foot.segment], ring[(foot.segment + 1) % ring.len()]);
    lerp(a, b, foot.at)
}
