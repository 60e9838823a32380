//! Outlines inside outlines: a sew line follows its outline at a small distance, all else inside is a line or a hole.

use super::chain::Chain;
use super::{Findings, at_line};
use crate::fault::Fault;
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

/// A chain with its measures.
#[derive(Clone, Debug)]
pub(super) struct Loop {
    /// The chain.
    pub(super) chain: Chain,
    /// Its box \[m\].
    pub(super) bounds: [Point2; 2],
    /// What it encloses \[m2\].
    area: f64,
}

impl Loop {
    /// Measures a chain.
    pub(super) fn new(chain: Chain) -> Self {
        Self {
            bounds: bounds(&chain.points),
            area: signed_area(&chain.points).abs(),
            chain,
        }
    }

    /// What it encloses \[m²\].
    pub(super) fn area(&self) -> f64 {
        self.area
    }

    /// Whether a point is in its box, or at most `margin` outside.
    pub(super) fn boxes(&self, p: Point2, margin: f64) -> bool {
        let [low, high] = self.bounds;
        (0..2).all(|k| low[k] - margin <= p[k] && p[k] <= high[k] + margin)
    }

    /// Whether a point lies inside.
    pub(super) fn holds(&self, p: Point2) -> bool {
        self.boxes(p, 0.0) && contains(&self.chain.points, p)
    }

    /// Whether a point lies at most `reach` from the line.
    pub(super) fn beside(&self, p: Point2, reach: f64) -> bool {
        self.boxes(p, reach)
            && nearest(segments(&self.chain.points), p).is_some_and(|n| n.distance <= reach)
    }

    /// Whether it lies in `outer`: its box does, and so does most of it (sew lines run on the outline along a fold).
    pub(super) fn lies_in(&self, outer: &Self) -> bool {
        if !self.bounds.iter().all(|p| outer.boxes(*p, 1e-6)) {
            return false;
        }
        let sample: Vec<&Point2> = sample(&self.chain.points, 16).collect();
        2 * sample
            .iter()
            .filter(|at| contains(&outer.chain.points, ***at))
            .count()
            > sample.len()
    }

    /// Whether `inner` is its sew line, from its course: all of it runs beside the outline, or all of the outline
    /// beside it (a sew line turns inwards at darts, and the cut line runs straight over them).
    pub(super) fn is_sewn_on(&self, inner: &Self) -> bool {
        let large = inner.area >= SEW_SHARE * self.area && inner.area < self.area;
        let follows =
            |a: &Self, b: &Self| sample(&a.chain.points, 200).all(|at| b.beside(*at, ALLOWANCE));
        inner.chain.closed && large && (follows(inner, self) || follows(self, inner))
    }

    /// Whether an open line runs about it at the distance of a seam allowance.
    pub(super) fn is_cut_along(&self, line: &Chain) -> bool {
        length(&line.points) >= CUT_SHARE * perimeter(&self.chain.points)
            && sample(&line.points, 50).all(|at| self.beside(*at, ALLOWANCE))
    }

    fn is_drawn_over(&self, other: &Self) -> bool {
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-6;
        (0..2).all(|i| (0..2).all(|k| near(self.bounds[i][k], other.bounds[i][k])))
            && near(self.area, other.area)
    }
}

/// About `count` points of a line, evenly.
fn sample(points: &[Point2], count: usize) -> impl Iterator<Item = &Point2> {
    points.iter().step_by(points.len().div_ceil(count).max(1))
}

/// Removes outlines that are drawn twice in the same place.
pub(super) fn drop_duplicates(outlines: Vec<Loop>, findings: &mut Findings) -> Vec<Loop> {
    let mut kept: Vec<Loop> = Vec::with_capacity(outlines.len());
    for outline in outlines {
        if kept.iter().any(|other| other.is_drawn_over(&outline)) {
            findings.warn(
                "pattern/duplicate_outline",
                outline.chain.line,
                "an outline is drawn twice in the same place; it was taken once",
            );
        } else {
            kept.push(outline);
        }
    }
    kept
}

/// Splits outlines into those that lie in no other, and those inside with the index of the largest that holds them.
pub(super) fn nest(outlines: Vec<Loop>) -> (Vec<Loop>, Vec<(usize, Loop)>) {
    let mut order: Vec<usize> = (0..outlines.len()).collect();
    order.sort_by(|a, b| outlines[*b].area.total_cmp(&outlines[*a].area));
    let mut outer: Vec<usize> = Vec::new();
    let mut owner = vec![None; outlines.len()];
    for i in order {
        owner[i] = outer
            .iter()
            .find(|o| outlines[i].lies_in(&outlines[**o]))
            .copied();
        if owner[i].is_none() {
            outer.push(i);
        }
    }
    outer.sort_unstable();
    let mut inner = Vec::new();
    let mut kept = Vec::new();
    for (outline, owner) in outlines.into_iter().zip(owner) {
        match owner.and_then(|o| outer.binary_search(&o).ok()) {
            Some(at) => inner.push((at, outline)),
            None => kept.push(outline),
        }
    }
    (kept, inner)
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

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(x: f64, y: f64, w: f64, h: f64) -> Loop {
        let points = vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
        Loop::new(Chain {
            run_end: vec![false; 4],
            made: vec![false; 4],
            points,
            closed: true,
            repaired: None,
            line: 1,
            runs: 1,
        })
    }

    #[test]
    fn sew_line_is_told_from_a_patch() {
        let outline = rectangle(0.0, 0.0, 0.3, 0.4);
        assert!(outline.is_sewn_on(&rectangle(0.01, 0.01, 0.28, 0.38)));
        assert!(!outline.is_sewn_on(&rectangle(0.1, 0.1, 0.1, 0.1)));
    }

    #[test]
    fn outlines_are_owned_by_the_largest_around_them() {
        let (outer, inner) = nest(vec![
            rectangle(0.1, 0.1, 0.1, 0.1),
            rectangle(0.0, 0.0, 0.3, 0.4),
            rectangle(1.0, 0.0, 0.3, 0.4),
            rectangle(0.05, 0.05, 0.2, 0.3),
        ]);
        assert_eq!(
            outer.iter().map(|l| l.bounds[0]).collect::<Vec<_>>(),
            [[0.0, 0.0], [1.0, 0.0]]
        );
        assert_eq!(
            inner.iter().map(|(owner, _)| *owner).collect::<Vec<_>>(),
            [0, 0]
        );
    }
}
