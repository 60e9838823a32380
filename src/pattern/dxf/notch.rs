//! Notches put on the edges of a panel. A notch drawn on the cut line belongs to the sew line inside it; drawn on
//! both, it is one.

use super::Findings;
use super::fold::Fold;
use super::piece::{NotchMark, Piece};
use crate::pattern::Notch;
use crate::pattern::assemble::{self, Outline};
use crate::pattern::point::{Point2, distance};
use crate::pattern::polyline::{PolylineFoot, nearest, segments};

/// A notch on the cut line belongs to a sew line that is at most this far away \[m\].
const ALLOWANCE: f64 = 0.03;

/// A notch is drawn at most this far from its line: at its tip, or beside it \[m\].
const BESIDE: f64 = 0.005;

/// A notch that lies on a line is at most this far from it \[m\].
const ON: f64 = 1e-4;

/// A notch on the cut line and one on the sew line are one where the feet of both on the sew line are this near \[m\]:
/// they face each other along the cut line's normal, not the sew line's.
const TWINS: f64 = 0.002;

/// At most this many notches of a piece are read.
const MOST: usize = 1000;

/// A notch with its place on the outline.
struct Put {
    mark: usize,
    foot: PolylineFoot,
    at: Point2,
    depth: Option<f64>,
    /// Whether it was drawn on the outline itself, not on the cut line about it.
    direct: bool,
    /// Whether it stands for one on the other line too.
    twin: bool,
}

/// The notches of a panel; those that lie on no edge are warned about.
pub(super) fn notches(
    piece: &Piece,
    outline: &Outline,
    fold: Option<Fold>,
    findings: &mut Findings,
) -> Vec<Notch> {
    let ring = assemble::ring(&outline.edges);
    let mut put: Vec<Put> = Vec::new();
    for (index, mark) in piece.marks.notches.iter().enumerate() {
        if index >= MOST {
            findings.left_out("notch beyond the first 1000 of a piece", mark.line);
            continue;
        }
        let image = fold.and_then(|fold| fold.image(&mark.points));
        let Some(found) = place(piece, &ring, mark, &mark.points) else {
            findings.warn(
                "pattern/notch_ignored",
                mark.line,
                format!(
                    "a notch of {:?} lies on no edge and is left out",
                    piece.name
                ),
            );
            continue;
        };
        let mirrored = image.and_then(|points| {
            let found = nearest(segments(&ring), tip(&ring, &points))?;
            Some((found, foot_of(&ring, found)))
        });
        for (foot, at) in std::iter::once((found.foot, found.at)).chain(mirrored) {
            let new = Put {
                mark: index,
                foot,
                at,
                ..found
            };
            add(&mut put, new, &piece.marks.notches);
        }
    }
    put.iter()
        .enumerate()
        .map(|(index, p)| {
            let kind = piece.marks.notches[p.mark].kind;
            Notch {
                depth_m: p.depth,
                ..assemble::notch(&outline.edges, p.foot, kind, index)
            }
        })
        .collect()
}

/// Adds a notch, unless it is the same as one on the other line.
fn add(put: &mut Vec<Put>, new: Put, marks: &[NotchMark]) {
    let is_twin = |p: &&mut Put| {
        p.direct != new.direct
            && !p.twin
            && p.mark != new.mark
            && marks[p.mark].kind == marks[new.mark].kind
            && distance(p.at, new.at) <= TWINS
    };
    match put.iter_mut().find(is_twin) {
        Some(twin) => twin.twin = true,
        None => put.push(new),
    }
}

/// The place of a notch on the outline; `None` where it lies on no line of the piece.
fn place(piece: &Piece, ring: &[Point2], mark: &NotchMark, points: &[Point2]) -> Option<Put> {
    let foot = nearest(segments(ring), tip(ring, points))?;
    let away = |p: &Point2| nearest(segments(ring), *p).map_or(f64::INFINITY, |n| n.distance);
    let nearest_end = points.iter().map(away).fold(f64::INFINITY, f64::min);
    let farthest = points.iter().map(away).fold(0.0, f64::max);
    let cut = [Some(&piece.outline.chain), piece.cut.as_ref()];
    let on_cut = cut.into_iter().flatten().any(|cut| {
        let along = nearest(segments(&cut.points), points[0]);
        along.is_some_and(|n| n.distance <= BESIDE / 5.0)
    });
    let direct = nearest_end <= ON;
    let drawn_deep = (points.len() > 1 && direct).then_some(farthest);
    (nearest_end <= BESIDE || on_cut && nearest_end <= ALLOWANCE).then(|| Put {
        mark: 0,
        foot,
        at: foot_of(ring, foot),
        depth: mark.depth.or(drawn_deep).filter(|d| *d > ON),
        direct,
        twin: false,
    })
}

/// The point of a notch that is farthest from the outline.
fn tip(ring: &[Point2], points: &[Point2]) -> Point2 {
    let away = |p: &Point2| nearest(segments(ring), *p).map_or(0.0, |n| n.distance);
    let tip = points.iter().max_by(|a, b| away(a).total_cmp(&away(b)));
    tip.copied().unwrap_or_default()
}

fn foot_of(ring: &[Point2], foot: PolylineFoot) -> Point2 {
    let (a, b) = (ring[foot.segment], ring[(foot.segment + 1) % ring.len()]);
    [0, 1].map(|k| a[k] + foot.at * (b[k] - a[k]))
}
