//! Outlines inside outlines: a sew line follows its outline at a small distance, all else inside is a hole or a line.

use super::chain::Chain;
use super::piece::Piece;
use super::{Findings, at_line};
use crate::fault::Fault;
use crate::pattern::outline::{bounds, contains, nearest, segments, signed_area};

/// Widest seam allowance that is taken for one \[m\].
const ALLOWANCE: f64 = 0.06;

/// A sew line encloses at least this share of its outline.
const SEW_SHARE: f64 = 0.4;

/// What a line inside an outline is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inner {
    /// Where the piece is sewn.
    Sew,
    /// Cut out.
    Hole,
    /// Drawn on the cloth.
    Line,
}

/// Removes outlines that are drawn twice in the same place.
pub(super) fn drop_duplicates(outlines: &mut Vec<Chain>, findings: &mut Findings) {
    let same = |a: &Chain, b: &Chain| {
        let (p, q) = (bounds(&a.points), bounds(&b.points));
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-6;
        (0..2).all(|i| (0..2).all(|k| near(p[i][k], q[i][k])))
            && near(signed_area(&a.points).abs(), signed_area(&b.points).abs())
    };
    let mut kept: Vec<Chain> = Vec::new();
    for outline in outlines.drain(..) {
        if kept.iter().any(|other| same(other, &outline)) {
            findings.warn(
                "pattern/duplicate_outline",
                outline.line,
                "an outline is drawn twice in the same place; it was taken once",
            );
        } else {
            kept.push(outline);
        }
    }
    *outlines = kept;
}

/// Splits outlines into those that lie in no other, and those inside with the index of their owner.
pub(super) fn nest(outlines: Vec<Chain>) -> (Vec<Chain>, Vec<(usize, Chain, Inner)>) {
    let area = |c: &Chain| signed_area(&c.points).abs();
    let owner: Vec<Option<usize>> = outlines
        .iter()
        .map(|inner| {
            let holders = outlines
                .iter()
                .enumerate()
                .filter(|(_, outer)| area(outer) > area(inner) && lies_in(inner, outer));
            holders
                .max_by(|a, b| area(a.1).total_cmp(&area(b.1)))
                .map(|(i, _)| i)
        })
        .collect();
    let mut place = vec![0; outlines.len()];
    let mut outer = Vec::new();
    for (i, chain) in outlines
        .iter()
        .enumerate()
        .filter(|(i, _)| owner[*i].is_none())
    {
        place[i] = outer.len();
        outer.push(chain.clone());
    }
    let inner = outlines
        .into_iter()
        .zip(&owner)
        .filter_map(|(chain, owner)| {
            let at = place[(*owner)?];
            let kind = kind(&outer[at], &chain);
            Some((at, chain, kind))
        })
        .collect();
    (outer, inner)
}

/// Whether `inner` lies in `outer` (its box does, and so does most of it: sew lines run on the outline along a fold).
pub(super) fn lies_in(inner: &Chain, outer: &Chain) -> bool {
    let (p, q) = (bounds(&inner.points), bounds(&outer.points));
    if !(0..2).all(|k| p[0][k] >= q[0][k] - 1e-6 && p[1][k] <= q[1][k] + 1e-6) {
        return false;
    }
    let sample: Vec<_> = inner
        .points
        .iter()
        .step_by(inner.points.len().div_ceil(16))
        .collect();
    2 * sample
        .iter()
        .filter(|at| contains(&outer.points, ***at))
        .count()
        > sample.len()
}

/// What a line inside an outline is, from its course.
pub(super) fn kind(outer: &Chain, inner: &Chain) -> Inner {
    let large = signed_area(&inner.points).abs() >= SEW_SHARE * signed_area(&outer.points).abs();
    let beside = |at: [f64; 2]| {
        nearest(segments(&outer.points), at).is_some_and(|n| n.distance <= ALLOWANCE)
    };
    let step = inner.points.len().div_ceil(200);
    if inner.closed && large && inner.points.iter().step_by(step).all(|at| beside(*at)) {
        Inner::Sew
    } else {
        Inner::Line
    }
}

/// The piece about whose outline an open line runs at the distance of a seam allowance.
pub(super) fn about(pieces: &[Piece], chain: &Chain) -> Option<usize> {
    let step = chain.points.len().div_ceil(50);
    pieces.iter().position(|piece| {
        chain.points.iter().step_by(step).all(|at| {
            nearest(segments(&piece.outline.points), *at).is_some_and(|n| n.distance <= ALLOWANCE)
        })
    })
}

/// The fault for more panels than the limit.
pub(super) fn too_many(count: usize, limit: usize, line: usize) -> Fault {
    Fault::new(
        "pattern/too_many_panels",
        at_line(line),
        format!("the file has {count} pieces; at most {limit} are read"),
    )
    .fix("export fewer pieces or sizes")
}
