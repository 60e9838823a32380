//! Half pieces unfolded about their mirror line.

use super::corners::CorneredRing;
use crate::pattern::point::{Point2, distance, dot, sub};
use crate::pattern::polyline::signed_area;

/// Points this near to the mirror line lie on it \[m\].
const ON: f64 = 2e-4;

/// A half outline unfolded.
pub(super) struct Unfolded {
    /// The whole outline.
    pub(super) outline: CorneredRing,
    /// Holes that were drawn as bays of the half at its fold.
    pub(super) holes: Vec<CorneredRing>,
}

/// A fold line.
#[derive(Clone, Copy, Debug)]
pub(super) struct FoldLine {
    /// A point on it.
    at: Point2,
    /// Unit vector along it.
    along: Point2,
}

impl FoldLine {
    /// Returns the fold through two points; `None` where they are one.
    pub(super) fn new([a, b]: [Point2; 2]) -> Option<Self> {
        let length = distance(a, b);
        (length > ON).then(|| Self {
            at: a,
            along: [(b[0] - a[0]) / length, (b[1] - a[1]) / length],
        })
    }

    /// Returns the mirror image of a point.
    pub(super) fn mirror(&self, p: Point2) -> Point2 {
        let foot = self.foot(p);
        [2.0 * foot[0] - p[0], 2.0 * foot[1] - p[1]]
    }

    /// Returns the signed distance of a point from the fold, positive to the left \[m\].
    pub(super) fn side(&self, p: Point2) -> f64 {
        let d = sub(p, self.at);
        self.along[0] * d[1] - self.along[1] * d[0]
    }

    fn foot(&self, p: Point2) -> Point2 {
        let t = dot(sub(p, self.at), self.along);
        [
            self.at[0] + t * self.along[0],
            self.at[1] + t * self.along[1],
        ]
    }

    /// Returns true if a point lies on it.
    pub(super) fn contains(&self, p: Point2) -> bool {
        self.side(p).abs() <= ON
    }

    /// Returns the mirror image of a mark; `None` where it lies on the fold.
    pub(super) fn image(&self, points: &[Point2]) -> Option<Vec<Point2>> {
        let is_off = points.iter().any(|p| !self.contains(*p));
        is_off.then(|| points.iter().map(|p| self.mirror(*p)).collect())
    }

    /// Adds the mirror images of marks to them; what lies on the fold stays single.
    pub(super) fn add_images(&self, points: &mut Vec<Point2>) {
        let images: Vec<Point2> = points
            .iter()
            .filter(|p| !self.contains(**p))
            .map(|p| self.mirror(*p))
            .collect();
        points.extend(images);
    }

    /// Returns the whole outline of which `half` is drawn: without its stretches on the fold,
    /// joined to its mirror image. Where both halves go on straight over the fold there is no
    /// corner. What is drawn between two stretches becomes a hole.
    ///
    /// `None` where no stretch of `half` lies on the fold, or `half` lies on both sides of it.
    pub(super) fn unfold(&self, half: &CorneredRing) -> Option<Unfolded> {
        if self.is_across(half) {
            return None;
        }
        let n = half.points.len();
        let stretches = self.stretches(half);
        let arc = |(k, (start, count)): (usize, &(usize, usize))| {
            let (next, _) = stretches[(k + 1) % stretches.len()];
            let from = start + count - 1;
            let steps = (next + n - from % n) % n;
            let arc: Vec<usize> = (from..=from + steps).map(|i| i % n).collect();
            self.closed(half, &arc)
        };
        let mut rings: Vec<CorneredRing> = stretches.iter().enumerate().map(arc).collect();
        let area = |ring: &CorneredRing| signed_area(&ring.points).abs();
        let by_area = |a: &usize, b: &usize| area(&rings[*a]).total_cmp(&area(&rings[*b]));
        let outer = (0..rings.len()).max_by(by_area)?;
        let outline = rings.swap_remove(outer);
        Some(Unfolded {
            outline,
            holes: rings,
        })
    }

    /// Returns the ring that an arc of `half` from fold to fold makes up with its mirror image.
    fn closed(&self, half: &CorneredRing, arc: &[usize]) -> CorneredRing {
        let inner = &arc[1..arc.len() - 1];
        let ends = [arc[0], arc[arc.len() - 1]].map(|i| self.foot(half.points[i]));
        let mut points = vec![ends[0]];
        points.extend(inner.iter().map(|i| half.points[*i]));
        points.push(ends[1]);
        points.extend(inner.iter().rev().map(|i| self.mirror(half.points[*i])));
        let mut is_corner = vec![true];
        is_corner.extend(inner.iter().map(|i| half.is_corner[*i]));
        is_corner.push(true);
        is_corner.extend(inner.iter().rev().map(|i| half.is_corner[*i]));
        let mut whole = CorneredRing { points, is_corner };
        for end in [0, inner.len() + 1] {
            whole.is_corner[end] = whole.is_sharp(end);
        }
        whole
    }

    /// Returns true if a ring lies on both sides of it.
    pub(super) fn is_across(&self, ring: &CorneredRing) -> bool {
        let lies = |way: f64| ring.points.iter().any(|p| way * self.side(*p) > ON);
        lies(1.0) && lies(-1.0)
    }

    /// Returns true if another fold runs along the same line.
    pub(super) fn is_along(&self, other: &Self) -> bool {
        let far = [other.at[0] + other.along[0], other.at[1] + other.along[1]];
        self.contains(other.at) && self.contains(far)
    }

    /// Returns the angle at which another fold meets it, at most a right one \[rad\].
    pub(super) fn angle_to(&self, other: &Self) -> f64 {
        dot(self.along, other.along).abs().min(1.0).acos()
    }

    /// Returns an open line with its mirror image, as a closed one: of what runs along the fold at
    /// its ends a single point stays.
    pub(super) fn unfold_line(&self, half: &[Point2]) -> Vec<Point2> {
        let on = |p: &&Point2| self.contains(**p);
        let [head, tail] = [
            half.iter().take_while(on).count(),
            half.iter().rev().take_while(on).count(),
        ];
        if head == half.len() {
            return half.to_vec();
        }
        let drawn = &half[head.saturating_sub(1)..half.len() - tail.saturating_sub(1)];
        let off = &half[head..half.len() - tail];
        let mut line = drawn.to_vec();
        if let (Some(first), true) = (line.first_mut(), head > 0) {
            *first = self.foot(*first);
        }
        if let (Some(last), true) = (line.last_mut(), tail > 0) {
            *last = self.foot(*last);
        }
        line.extend(off.iter().rev().map(|p| self.mirror(*p)));
        line
    }

    /// Returns the stretches of at least two consecutive points on the fold, round the ring: the
    /// first point and the number of each.
    fn stretches(&self, half: &CorneredRing) -> Vec<(usize, usize)> {
        let n = half.points.len();
        let on: Vec<bool> = half.points.iter().map(|p| self.contains(*p)).collect();
        let starts = (0..n).filter(|i| on[*i] && !on[(*i + n - 1) % n]);
        let stretches =
            starts.map(|start| (start, (0..n).take_while(|k| on[(start + k) % n]).count()));
        stretches.filter(|(_, count)| *count > 1).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_piece_is_unfolded_about_its_edge() {
        let half = CorneredRing {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 1.5], [0.0, 1.0]],
            is_corner: vec![true, true, true, true, false],
        };
        let fold = FoldLine::new([[0.0, 0.2], [0.0, 1.0]]).expect("two points");
        let whole = fold.unfold(&half).expect("on the fold").outline;
        assert_eq!(signed_area(&whole.points), 2.0 * signed_area(&half.points));
        let corners: Vec<Point2> = whole
            .points
            .iter()
            .zip(&whole.is_corner)
            .filter(|(_, c)| **c)
            .map(|(p, _)| *p)
            .collect();
        assert_eq!(
            corners,
            [[1.0, 0.0], [1.0, 2.0], [0.0, 1.5], [-1.0, 2.0], [-1.0, 0.0]],
            "straight at the hem, a V at the neck"
        );
    }

    #[test]
    fn bay_at_the_fold_becomes_a_hole() {
        let half = [
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 3.0],
            [0.0, 3.0],
            [0.0, 2.0],
            [1.0, 2.0],
            [1.0, 1.0],
            [0.0, 1.0],
        ];
        for first in 0..half.len() {
            let mut points = half.to_vec();
            points.rotate_left(first);
            let is_corner = vec![true; points.len()];
            let half = CorneredRing { points, is_corner };
            let fold = FoldLine::new([[0.0, 0.0], [0.0, 1.0]]).expect("two points");
            let whole = fold.unfold(&half).expect("on the fold");
            assert_eq!(signed_area(&whole.outline.points).abs(), 18.0);
            assert_eq!(whole.holes.len(), 1);
            assert_eq!(signed_area(&whole.holes[0].points).abs(), 2.0);
        }
    }

    #[test]
    fn open_line_is_unfolded_without_what_runs_along_the_fold() {
        let fold = FoldLine::new([[0.0, 0.0], [0.0, 1.0]]).expect("two points");
        let whole = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [-1.0, 2.0], [-1.0, 0.0]];
        let half = [[0.0, 0.5], [0.0, 0.0], [1.0, 0.0], [1.0, 2.0]];
        assert_eq!(fold.unfold_line(&half), whole);
        let ends_on_it = [&half[..], &[[0.0, 2.0], [0.0, 1.5]]].concat();
        let whole = [&whole[..3], &[[0.0, 2.0]], &whole[3..]].concat();
        assert_eq!(fold.unfold_line(&ends_on_it), whole);
    }

    #[test]
    fn line_that_is_not_on_the_outline_unfolds_nothing() {
        let half = CorneredRing {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]],
            is_corner: vec![true; 3],
        };
        assert!(
            FoldLine::new([[0.5, 0.0], [0.5, 1.0]])
                .expect("two points")
                .unfold(&half)
                .is_none()
        );
    }
}
