//! Shallow corners that a polyline gives away: where its curves were sampled anew, and where it
//! turns more than nearby.
//!
//! Assumption: each curve was sampled in even or slowly changing steps. A place where two curves
//! run smoothly into each other, sampled alike, shows in nothing and is not found.

use super::simplify::SimplifiedRing;
use crate::pattern::point::{Point2, distance, turn};

/// Steps of one curve grow or shrink by less than this from one to the next; where curves join they
/// jump by more.
const JUMP: f64 = 1.35;

/// Beside a corner, steps and turns change by less than this share of what they change at it.
const CALM: f64 = 1.0 / 3.0;

/// The least turn that stands out from a curve \[rad\].
const KINK: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// A step this many times as long as those of the curve beside it is a straight line.
const LINE: f64 = 5.0;

/// A straight line beside a curve is at least this long \[m\]: below, it may be the curve drawn
/// coarsely.
const LEAST_LINE: f64 = 0.05;

/// Steps beside a kink are at least this long \[m\]: below, they are how a corner was rounded or a
/// curve ended.
const LEAST_STEP: f64 = 0.002;

/// The turns and steps of a closed polyline.
struct TurnProfile {
    /// Size of the turn at each point \[rad\].
    turns: Vec<f64>,
    /// Length of the step from each point to the next \[m\].
    steps: Vec<f64>,
    /// Turns of this size or more are corners of their own \[rad\].
    sharp: f64,
}

/// Returns point by point true if it is a shallow corner of a closed polyline. `sampled` points are
/// not the file's and tell nothing; turns of `sharp` or more are corners of their own.
pub(super) fn shallow_corners(points: &[Point2], sampled: &[bool], sharp: f64) -> Vec<bool> {
    let mut found = vec![false; points.len()];
    let simplified = SimplifiedRing::of(points, sharp);
    let kept = &simplified.kept;
    let n = kept.len();
    if n < 8 {
        return found;
    }
    let points: Vec<Point2> = kept.iter().map(|i| points[*i]).collect();
    let profile = TurnProfile::of(&points, sharp);
    let is_known = |i: usize| (0..5).all(|k| !sampled[kept[(i + n + k - 2) % n]]);
    let joins =
        |i: usize| simplified.has_steps && (profile.is_resampled(i) || profile.is_tangent(i));
    for i in 0..n {
        let is_shallow = profile.turns[i] < sharp && is_known(i);
        found[kept[i]] = is_shallow && (joins(i) || profile.is_kink(i));
    }
    found
}

impl TurnProfile {
    fn of(points: &[Point2], sharp: f64) -> Self {
        let n = points.len();
        let at = |i: usize| points[i % n];
        let turn = |i: usize| turn(at(i + n - 1), at(i), at(i + 1)).abs();
        Self {
            turns: (0..n).map(turn).collect(),
            steps: (0..n).map(|i| distance(at(i), at(i + 1))).collect(),
            sharp,
        }
    }

    /// Returns the index of the point `by` points after point `i`.
    fn wrapped(&self, i: usize, by: isize) -> usize {
        let n = self.steps.len();
        (i + n).wrapping_add_signed(by) % n
    }

    /// Returns the two points before and the two after a point.
    fn neighbors(&self, i: usize) -> [usize; 4] {
        [-2, -1, 1, 2].map(|by| self.wrapped(i, by))
    }

    /// Returns the logarithm of how many times as long the step from a point is as the one to it.
    fn growth(&self, i: usize) -> f64 {
        (self.steps[i] / self.steps[self.wrapped(i, -1)]).ln()
    }

    fn is_sharp(&self, i: usize) -> bool {
        self.turns[i] >= self.sharp
    }

    /// Returns true if the lengths of steps jump here and nowhere near: two curves, each sampled
    /// evenly.
    fn is_resampled(&self, i: usize) -> bool {
        let jump = self.growth(i).abs();
        jump >= JUMP.ln()
            && self
                .neighbors(i)
                .iter()
                .all(|k| !self.is_sharp(*k) && self.growth(*k).abs() <= CALM * jump)
    }

    /// Returns true if a straight line runs into an evenly sampled curve here.
    fn is_tangent(&self, i: usize) -> bool {
        [-1, 1].into_iter().any(|way| {
            let step = |k: isize| self.steps[self.wrapped(i, if way > 0 { k } else { -1 - k })];
            let bends = |k: isize| self.turns[self.wrapped(i, way * k)];
            let even = |k: isize| (step(k + 1) / step(k)).ln().abs() <= JUMP.ln() / 2.0;
            let line = step(-1);
            line >= LEAST_LINE
                && line >= LINE * step(0)
                && (0..4).all(even)
                && (1..4).all(|k| bends(k) > 1e-4 && bends(k) < self.sharp)
        })
    }

    /// Returns true if it turns here far more than at the points beside it; sharp corners among
    /// these do not count.
    fn is_kink(&self, i: usize) -> bool {
        self.turns[i] >= KINK
            && self.steps[i].min(self.steps[self.wrapped(i, -1)]) >= LEAST_STEP
            && self
                .neighbors(i)
                .iter()
                .all(|k| self.is_sharp(*k) || self.turns[*k] <= CALM * self.turns[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHARP: f64 = 0.349;

    /// A half disc of radius 0.2 m: its round side sampled in `counts` stretches of equal sweep,
    /// then straight back.
    fn half_disc(counts: &[usize]) -> Vec<Point2> {
        let sweep = std::f64::consts::PI / counts.len() as f64;
        let mut points = Vec::new();
        for (part, count) in counts.iter().enumerate() {
            for k in 0..*count {
                let angle = sweep * (part as f64 + k as f64 / *count as f64);
                points.push([0.2 * angle.cos(), 0.2 * angle.sin()]);
            }
        }
        points.push([-0.2, 0.0]);
        points
    }

    fn found(points: &[Point2]) -> Vec<usize> {
        let shallow = shallow_corners(points, &vec![false; points.len()], SHARP);
        (0..points.len()).filter(|i| shallow[*i]).collect()
    }

    #[test]
    fn curves_sampled_differently_join_where_the_steps_jump() {
        assert_eq!(found(&half_disc(&[20, 60])), [20]);
        assert_eq!(found(&half_disc(&[40, 40])), Vec::<usize>::new());
    }

    #[test]
    fn line_runs_into_a_curve_at_a_corner() {
        let mut points = half_disc(&[40]);
        points.push([-0.2, -0.3]);
        points.push([0.2, -0.3]);
        assert_eq!(found(&points), [0, 40]);
    }

    #[test]
    fn shallow_kink_stands_out_from_a_curve() {
        let mut points = half_disc(&[90]);
        for p in &mut points[45..=90] {
            let d = [p[0], p[1] - 0.2];
            let (sin, cos) = 0.15_f64.sin_cos();
            *p = [cos * d[0] - sin * d[1], 0.2 + sin * d[0] + cos * d[1]];
        }
        assert_eq!(found(&points), [45]);
    }

    #[test]
    fn sampled_points_tell_nothing() {
        let points = half_disc(&[20, 60]);
        assert!(!shallow_corners(&points, &vec![true; points.len()], SHARP).contains(&true));
    }
}
