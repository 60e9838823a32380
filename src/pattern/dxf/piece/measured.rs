//! A chain with its measures, and its place relative to points and other chains.

use super::chain::PathChain;
use crate::pattern::Point2;
use crate::pattern::polyline::{
    bounds, contains, length, nearest, perimeter, segments, signed_area,
};

/// Widest seam allowance that is taken for one \[m\].
const ALLOWANCE: f64 = 0.06;

/// A sew line encloses at least this share of its outline.
const SEW_SHARE: f64 = 0.4;

/// An open cut line is at least this share of its outline long.
const CUT_SHARE: f64 = 0.25;

/// Boxes and areas that differ by less than this are equal \[m, m²\].
const SAME: f64 = 1e-6;

/// A chain with its measures.
#[derive(Clone, Debug)]
pub(crate) struct MeasuredChain {
    /// The chain.
    pub(crate) chain: PathChain,
    /// The smallest and the largest coordinates \[m\].
    pub(super) bounds: [Point2; 2],
    /// Area that it encloses \[m²\].
    pub(super) area: f64,
}

impl MeasuredChain {
    /// Measures a chain.
    pub(super) fn new(chain: PathChain) -> Self {
        Self {
            bounds: bounds(&chain.points),
            area: signed_area(&chain.points).abs(),
            chain,
        }
    }

    /// Returns true if a point is in its box, or at most `margin` outside.
    pub(super) fn is_in_box(&self, p: Point2, margin: f64) -> bool {
        let [low, high] = self.bounds;
        (0..2).all(|k| low[k] - margin <= p[k] && p[k] <= high[k] + margin)
    }

    /// Returns true if a point lies inside.
    pub(super) fn contains(&self, p: Point2) -> bool {
        self.is_in_box(p, 0.0) && contains(&self.chain.points, p)
    }

    /// Returns true if a point lies at most `reach` from the line.
    pub(super) fn is_beside(&self, p: Point2, reach: f64) -> bool {
        self.is_in_box(p, reach)
            && nearest(segments(&self.chain.points), p).is_some_and(|foot| foot.distance <= reach)
    }

    /// Returns true if it lies in `outer`: its box does, and so does most of it (sew lines run on
    /// the outline along a fold).
    pub(super) fn lies_in(&self, outer: &Self) -> bool {
        if !self.bounds.iter().all(|p| outer.is_in_box(*p, SAME)) {
            return false;
        }
        let sample: Vec<&Point2> = sample(&self.chain.points, 16).collect();
        let inside = sample
            .iter()
            .filter(|p| contains(&outer.chain.points, ***p));
        2 * inside.count() > sample.len()
    }

    /// Returns true if `inner` is its sew line, from its course: all of it runs beside the outline,
    /// or all of the outline beside it (a sew line turns inwards at darts, and the cut line runs
    /// straight over them).
    pub(super) fn is_sewn_on(&self, inner: &Self) -> bool {
        let is_large = inner.area >= SEW_SHARE * self.area && inner.area < self.area;
        inner.chain.closed && is_large && (inner.follows(self) || self.follows(inner))
    }

    /// Returns true if all of it runs beside `other`, at the distance of a seam allowance.
    pub(super) fn follows(&self, other: &Self) -> bool {
        sample(&self.chain.points, 200).all(|p| other.is_beside(*p, ALLOWANCE))
    }

    /// Returns true if an open line runs about it at the distance of a seam allowance.
    pub(super) fn is_cut_along(&self, line: &PathChain) -> bool {
        length(&line.points) >= CUT_SHARE * perimeter(&self.chain.points)
            && sample(&line.points, 50).all(|p| self.is_beside(*p, ALLOWANCE))
    }

    /// Returns true if `other` is drawn in the same place.
    pub(super) fn is_drawn_over(&self, other: &Self) -> bool {
        let is_same = |x: f64, y: f64| (x - y).abs() <= SAME;
        (0..2).all(|i| (0..2).all(|k| is_same(self.bounds[i][k], other.bounds[i][k])))
            && is_same(self.area, other.area)
    }
}

/// Returns about `count` points of a line, evenly.
fn sample(points: &[Point2], count: usize) -> impl Iterator<Item = &Point2> {
    points.iter().step_by(points.len().div_ceil(count).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(x: f64, y: f64, w: f64, h: f64) -> MeasuredChain {
        let points = [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
        MeasuredChain::new(PathChain::ring(&points))
    }

    #[test]
    fn sew_line_is_told_from_a_patch() {
        let outline = rectangle(0.0, 0.0, 0.3, 0.4);
        assert!(outline.is_sewn_on(&rectangle(0.01, 0.01, 0.28, 0.38)));
        assert!(!outline.is_sewn_on(&rectangle(0.1, 0.1, 0.1, 0.1)));
    }
}
