//! Curves as polylines. Arcs and ellipses are cut every degree, splines so that their control polygon turns by
//! about one degree a step: the chord error stays below 4e-5 of the radius, the length error below 1.3e-5 of the length.

use super::outline::P;
use std::f64::consts::{PI, TAU};

/// Largest turn between two chords \[radians\].
const STEP: f64 = PI / 180.0;

/// Points of an arc from `from` over `sweep` (radians, counter-clockwise positive), both ends included.
pub(super) fn arc(center: P, radius: f64, from: f64, sweep: f64) -> Vec<P> {
    ellipse(center, [radius, 0.0], [0.0, radius], [from, sweep])
}

/// Points of the ellipse `center + cos(t) major + sin(t) minor`, `t` from `range[0]` over `range[1]`, both ends included.
pub(super) fn ellipse(center: P, major: P, minor: P, range: [f64; 2]) -> Vec<P> {
    let count = steps(range[1].abs(), 2, 720);
    (0..=count)
        .map(|i| {
            let (sin, cos) = (range[0] + range[1] * fraction(i, count)).sin_cos();
            [
                center[0] + cos * major[0] + sin * minor[0],
                center[1] + cos * major[1] + sin * minor[1],
            ]
        })
        .collect()
}

/// Points of the arc from `a` to `b` with a bulge (tangent of a quarter of its sweep), `b` left out.
pub(super) fn bulge(a: P, b: P, bulge: f64) -> Vec<P> {
    let chord = [b[0] - a[0], b[1] - a[1]];
    if bulge == 0.0 || chord == [0.0, 0.0] {
        return vec![a];
    }
    let k = (1.0 - bulge * bulge) / (4.0 * bulge);
    let center = [
        f64::midpoint(a[0], b[0]) - k * chord[1],
        f64::midpoint(a[1], b[1]) + k * chord[0],
    ];
    let radius = (a[0] - center[0]).hypot(a[1] - center[1]);
    let from = (a[1] - center[1]).atan2(a[0] - center[0]);
    let mut points = arc(center, radius, from, 4.0 * bulge.atan());
    points.pop();
    points[0] = a;
    points
}

/// Sweep of an arc counter-clockwise from `start` to `end` (radians), in (0, 2 pi].
pub(super) fn sweep(start: f64, end: f64) -> f64 {
    let turn = (end - start).rem_euclid(TAU);
    if turn < 1e-12 { TAU } else { turn }
}

/// A B-spline, rational where it has weights.
pub(super) struct Spline<'a> {
    /// Its degree, at least 1.
    pub(super) degree: usize,
    /// `controls.len() + degree + 1` knots that never fall.
    pub(super) knots: &'a [f64],
    /// Control points.
    pub(super) controls: &'a [P],
    /// As many weights as control points, or none.
    pub(super) weights: &'a [f64],
}

impl Spline<'_> {
    /// Its points, both ends included.
    pub(super) fn points(&self) -> Vec<P> {
        let spans = self.degree..self.controls.len();
        let per_span = steps(turning(self.controls), 4, 180);
        let mut points = Vec::new();
        for span in spans.filter(|i| self.knots[*i + 1] > self.knots[*i]) {
            let (a, b) = (self.knots[span], self.knots[span + 1]);
            let first = usize::from(!points.is_empty());
            points.extend(
                (first..=per_span).map(|i| self.at(span, a + (b - a) * fraction(i, per_span))),
            );
        }
        points
    }

    /// De Boor's algorithm in homogeneous coordinates, `t` within the knot span `span`.
    fn at(&self, span: usize, t: f64) -> P {
        let p = self.degree;
        let mut d: Vec<[f64; 3]> = (span - p..=span)
            .map(|i| {
                let w = self.weights.get(i).copied().unwrap_or(1.0);
                [w * self.controls[i][0], w * self.controls[i][1], w]
            })
            .collect();
        for r in 1..=p {
            for j in (r..=p).rev() {
                let i = span - p + j;
                let a = (t - self.knots[i]) / (self.knots[i + p + 1 - r] - self.knots[i]);
                d[j] = std::array::from_fn(|k| (1.0 - a) * d[j - 1][k] + a * d[j][k]);
            }
        }
        [d[p][0] / d[p][2], d[p][1] / d[p][2]]
    }
}

/// Sum of the turns of a polyline \[radians\].
fn turning(points: &[P]) -> f64 {
    let way = |a: P, b: P| (b[1] - a[1]).atan2(b[0] - a[0]);
    points
        .windows(3)
        .map(|w| {
            let turn = (way(w[1], w[2]) - way(w[0], w[1])).rem_euclid(TAU);
            turn.min(TAU - turn)
        })
        .sum()
}

/// How many steps of at most [`STEP`] make up `angle`, within bounds.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the value is clamped to a small positive range first"
)]
fn steps(angle: f64, least: usize, most: usize) -> usize {
    (angle / STEP - 1e-9)
        .ceil()
        .clamp(least as f64, most as f64) as usize
}

fn fraction(i: usize, count: usize) -> f64 {
    i as f64 / count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(points: &[P]) -> f64 {
        points
            .windows(2)
            .map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]))
            .sum()
    }

    #[test]
    fn half_circle_bulge_has_the_length_of_a_half_circle() {
        for (sign, side) in [(1.0, -1.0), (-1.0, 1.0)] {
            let mut points = bulge([-1.0, 0.0], [1.0, 0.0], sign);
            points.push([1.0, 0.0]);
            assert!((length(&points) / PI - 1.0).abs() < 1.3e-5);
            let middle = points[points.len() / 2];
            assert!((middle[1] - side).abs() < 1e-9, "{middle:?}");
        }
    }

    #[test]
    fn cubic_bezier_as_spline_matches_its_polynomial() {
        let controls = [[0.0, 0.0], [0.0, 1.0], [2.0, 1.0], [2.0, 0.0]];
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        let spline = Spline {
            degree: 3,
            knots: &knots,
            controls: &controls,
            weights: &[],
        };
        let points = spline.points();
        assert_eq!(
            (points[0], *points.last().expect("points")),
            (controls[0], controls[3])
        );
        let middle = points[points.len() / 2];
        assert!(
            (middle[0] - 1.0).abs() < 1e-12 && (middle[1] - 0.75).abs() < 1e-12,
            "{middle:?}"
        );
    }
}
