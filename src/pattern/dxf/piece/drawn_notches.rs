//! Notches drawn into an outline, as V, slit or castle, taken out of it as marks.

use super::chain::PathChain;
use super::corners::CorneredRing;
use super::dxf_piece::{DxfPiece, NotchMark};
use super::measured::MeasuredChain;
use crate::fault::PatternCode;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::point::{Point2, cross, distance, dot, lerp, sub};
use crate::pattern::{DrawnNotches, NotchKind};
use std::ops::RangeInclusive;

/// Depths of notches \[m\]: what is shallower is a curve, what is deeper a dart.
const DEPTH: RangeInclusive<f64> = 0.0015..=0.012;

/// The widest notch \[m\].
const WIDEST: f64 = 0.015;

/// An opening is at most this many times as wide as it is deep: flatter ones are curves.
const FLATTEST: f64 = 2.5;

/// Openings narrower than this are slits \[m\].
const SLIT: f64 = 0.0005;

/// The outline runs straight on behind a notch: by the cosine of its turn, 15 degrees.
const STRAIGHT: f64 = 0.966;

/// The sides of a castle stand upright: by the sine of their lean, 25 degrees.
const LEAN: f64 = 0.42;

/// The tip stands this near to the middle of the opening, as a share of it: the teeth of pleats do
/// not.
const EVEN: f64 = 0.25;

/// An outline with more of them is cut in teeth.
const MOST: usize = 60;

/// The outline runs at least this far on both sides of a notch \[m\].
const BESIDE: f64 = 0.001;

/// A turn point this near to one of a notch is one of it \[m\].
const TURN_POINT: f64 = 1e-5;

/// A notch as a mark, and the points of the outline that drew it.
type TakenNotch = (NotchMark, Vec<Point2>);

/// A notch as it lies in an outline.
struct DrawnNotch {
    /// Index of its first point, on the outline.
    first: usize,
    /// Number of its points, those on the outline too.
    count: usize,
    kind: NotchKind,
    depth: f64,
}

/// Takes the notches out of the outline and the sew line of a piece; they are warned about. A piece
/// with marks on the layers of notches has its notches there.
pub(crate) fn take_notches(
    piece: &mut DxfPiece,
    reading: DrawnNotches,
    findings: &mut DxfFindings,
) {
    if reading == DrawnNotches::Cloth || has_marks(piece) {
        return;
    }
    let mut found = 0;
    if let Some((chain, marks)) = without_notches(&piece.outline.chain) {
        found += marks.len();
        piece.outline = MeasuredChain::new(chain);
        add(piece, marks);
    }
    if let Some((chain, marks)) = piece.sew.as_ref().and_then(without_notches) {
        found += marks.len();
        piece.sew = Some(chain);
        add(piece, marks);
    }
    if found > 0 {
        warn_of_drawn(piece, found, findings);
    }
}

/// Returns true if a piece has notches on the layers of notches.
fn has_marks(piece: &DxfPiece) -> bool {
    piece.marks.notches.iter().any(|notch| !notch.is_drawn)
}

fn warn_of_drawn(piece: &DxfPiece, count: usize, findings: &mut DxfFindings) {
    let detail = format!(
        "{count} notches that are drawn into the outline of {:?} were taken as marks (notches=cloth takes them as its course)",
        piece.name
    );
    let line = piece.outline.chain.line;
    findings.warn(PatternCode::DrawnNotches, line, detail);
}

/// Returns an unfolded outline without the notches that are drawn at its folds, half of each, and
/// their marks.
pub(super) fn without_notches_at_folds(
    piece: &DxfPiece,
    ring: CorneredRing,
    reading: DrawnNotches,
    findings: &mut DxfFindings,
) -> (CorneredRing, Vec<NotchMark>) {
    if reading == DrawnNotches::Cloth || has_marks(piece) {
        return (ring, vec![]);
    }
    let chain = PathChain {
        sampled: vec![false; ring.points.len()],
        path_end: ring.is_corner.clone(),
        points: ring.points.clone(),
        closed: true,
        gaps: vec![],
        line: piece.line,
        path_count: 0,
    };
    match without_notches(&chain) {
        Some((chain, marks)) => {
            warn_of_drawn(piece, marks.len(), findings);
            let ring = CorneredRing {
                points: chain.points,
                is_corner: chain.path_end,
            };
            (ring, marks.into_iter().map(|(mark, _)| mark).collect())
        }
        None => (ring, vec![]),
    }
}

/// Gives the notches of a line to a piece, without the turn points at them.
fn add(piece: &mut DxfPiece, marks: Vec<TakenNotch>) {
    for (mark, points) in marks {
        let is_apart = |turn: &Point2| points.iter().all(|p| distance(*p, *turn) > TURN_POINT);
        piece.marks.turns.retain(is_apart);
        piece.marks.notches.push(mark);
    }
}

/// Returns a closed line without its notches, and these with their points; `None` if it has none.
fn without_notches(chain: &PathChain) -> Option<(PathChain, Vec<TakenNotch>)> {
    if !chain.closed {
        return None;
    }
    let points = &chain.points;
    let n = points.len();
    let mut is_left = vec![true; n];
    let mut is_corner = chain.path_end.clone();
    let mut marks = vec![];
    let mut i = 0;
    while i < n {
        let Some(notch) = notch_at(points, i) else {
            i += 1;
            continue;
        };
        let indices: Vec<usize> = (0..notch.count).map(|k| (i + k) % n).collect();
        let own: Vec<Point2> = indices.iter().map(|k| points[*k]).collect();
        for k in &indices[1..notch.count - 1] {
            is_left[*k] = false;
        }
        for end in [indices[0], indices[notch.count - 1]] {
            is_corner[end] = false;
        }
        let mark = NotchMark {
            points: vec![lerp(own[0], own[notch.count - 1], 0.5)],
            kind: notch.kind,
            is_drawn: true,
            depth: Some(notch.depth),
            line: chain.line,
        };
        marks.push((mark, own));
        i = notch.first + notch.count - 1;
    }
    let left: Vec<usize> = (0..n).filter(|i| is_left[*i]).collect();
    let is_worth = (1..=MOST).contains(&marks.len()) && left.len() > 2;
    is_worth.then(|| {
        let without = PathChain {
            points: left.iter().map(|i| points[*i]).collect(),
            path_end: left.iter().map(|i| is_corner[*i]).collect(),
            sampled: left.iter().map(|i| chain.sampled[*i]).collect(),
            ..chain.clone()
        };
        (without, marks)
    })
}

/// Returns the notch that begins at a point of a ring.
fn notch_at(points: &[Point2], first: usize) -> Option<DrawnNotch> {
    let n = points.len();
    let at = |k: usize| points[(first + k) % n];
    [3, 4]
        .into_iter()
        .filter(|count| n > count + 3)
        .find_map(|count| {
            let (start, end) = (at(0), at(count - 1));
            let (before, after) = (at(n - 1), at(count));
            let is_beside = distance(before, start) >= BESIDE && distance(end, after) >= BESIDE;
            if !is_beside || distance(start, end) > WIDEST {
                return None;
            }
            let along = unit(before, start)?;
            let opening = sub(end, start);
            let runs_on = dot(along, unit(end, after)?) >= STRAIGHT
                && dot(along, opening) >= STRAIGHT * distance(start, end) - SLIT;
            let depth = |k: usize| cross(along, sub(at(k), start)).abs();
            let (kind, depth) = match count {
                3 if distance(start, end) < SLIT => (NotchKind::Slit, depth(1)),
                3 => (NotchKind::V, depth(1)),
                _ => (NotchKind::Castle, depth(1).min(depth(2))),
            };
            let is_even = {
                let middle = dot(
                    along,
                    sub(lerp(at(1), at(count - 2), 0.5), lerp(start, end, 0.5)),
                );
                middle.abs() <= EVEN * distance(start, end) + SLIT
            };
            let stands = |a: usize, b: usize| {
                let side = sub(at(b), at(a));
                dot(along, side).abs() <= LEAN * distance(at(a), at(b))
            };
            let is_upright = count == 3 || stands(0, 1) && stands(3, 2);
            let is_steep = distance(start, end) <= FLATTEST * depth;
            let is_notch = runs_on && is_even && is_upright && is_steep && DEPTH.contains(&depth);
            is_notch.then_some(DrawnNotch {
                first,
                count,
                kind,
                depth,
            })
        })
}

fn unit(a: Point2, b: Point2) -> Option<Point2> {
    let length = distance(a, b);
    (length > 0.0).then(|| sub(b, a).map(|c| c / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rectangle of 300 by 400 mm whose lower side has a detour.
    fn with_detour(detour: &[Point2]) -> PathChain {
        let corners = [[0.0, 0.0], [0.3, 0.0], [0.3, 0.4], [0.0, 0.4]];
        let points: Vec<Point2> = [&corners[..1], detour, &corners[1..]].concat();
        PathChain::ring(&points)
    }

    #[test]
    fn notches_of_all_shapes_are_taken_out() {
        let shapes: [(&[Point2], NotchKind); 4] = [
            (&[[0.097, 0.0], [0.1, 0.005], [0.103, 0.0]], NotchKind::V),
            (&[[0.097, 0.0], [0.1, -0.005], [0.103, 0.0]], NotchKind::V),
            (&[[0.1, 0.0], [0.1, 0.006], [0.1, 0.0]], NotchKind::Slit),
            (
                &[[0.098, 0.0], [0.098, 0.004], [0.102, 0.004], [0.102, 0.0]],
                NotchKind::Castle,
            ),
        ];
        for (detour, kind) in shapes {
            for turned in 0..4 {
                let mut chain = with_detour(detour);
                chain.points.rotate_left(turned);
                let (left, marks) = without_notches(&chain).expect("a notch");
                assert_eq!(marks.len(), 1, "{detour:?}");
                assert_eq!(marks[0].0.kind, kind);
                assert!(distance(marks[0].0.points[0], [0.1, 0.0]) < 1e-12);
                assert_eq!(left.points.len(), 6);
            }
        }
    }

    #[test]
    fn darts_curves_and_steps_stay() {
        let shapes: [&[Point2]; 6] = [
            &[[0.1, 0.0], [0.106, 0.0027], [0.112, 0.0]],
            &[[0.1, 0.0], [0.1037, 0.0074], [0.1038, 0.0]],
            &[[0.09, 0.0], [0.1, 0.08], [0.11, 0.0]],
            &[[0.08, 0.0], [0.1, 0.003], [0.12, 0.0]],
            &[[0.1, 0.0], [0.1, 0.005]],
            &[[0.05, 0.0], [0.05, 0.01], [0.15, 0.01], [0.15, 0.0]],
        ];
        for detour in shapes {
            assert!(
                without_notches(&with_detour(detour)).is_none(),
                "{detour:?}"
            );
        }
    }
}
