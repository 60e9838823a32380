//! B-splines as polylines. Spans are halved until the curve bulges over each chord by less than
//! 0.22 % of its length, as an arc of one degree does: a chord error below 4e-5 of the radius of
//! curvature, a length error below 1.3e-5 of the length.

use super::point::{Point2, cross, sub};

/// Height to which a curve may bulge over its chord, as a share of the chord:
/// tan(1 degree / 4) / 2.
const BULGE: f64 = 2.2e-3;

/// Number of chords that a span begins with, so that a curve that is straight in the middle is seen
/// all the same.
const FIRST: usize = 4;

/// Number of times that a chord is halved at most.
const HALVINGS: usize = 6;

/// A B-spline, rational where it has weights.
pub(super) struct BSpline<'a> {
    /// Its degree, at least 1.
    pub(super) degree: usize,
    /// `controls.len() + degree + 1` knots that never fall.
    pub(super) knots: &'a [f64],
    pub(super) controls: &'a [Point2],
    /// As many weights as control points, or none.
    pub(super) weights: &'a [f64],
}

impl BSpline<'_> {
    /// Returns its points, both ends included; where there are more than `most`, it ends early.
    pub(super) fn points(&self, most: usize) -> Vec<Point2> {
        let spans = self.degree..self.controls.len();
        let mut points = Vec::new();
        for span in spans.filter(|i| self.knots[*i + 1] > self.knots[*i]) {
            if points.len() > most {
                break;
            }
            let range = [self.knots[span], self.knots[span + 1]];
            flatten(&|t| self.at(span, t), range, &mut points);
        }
        points
    }

    /// Evaluates it by de Boor's algorithm in homogeneous coordinates, `t` within the knot span
    /// `span`.
    fn at(&self, span: usize, t: f64) -> Point2 {
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

/// Adds the points of a curve over `range`; its first only where there are none yet.
pub(super) fn flatten(curve: &impl Fn(f64) -> Point2, range: [f64; 2], points: &mut Vec<Point2>) {
    let at = |i: usize| range[0] + (range[1] - range[0]) * i as f64 / FIRST as f64;
    let mut from = (at(0), curve(at(0)));
    if points.is_empty() {
        points.push(from.1);
    }
    for i in 1..=FIRST {
        let to = (at(i), curve(at(i)));
        halve(curve, from, to, HALVINGS, points);
        from = to;
    }
}

/// Adds the points of a curve between two of it, the latter included.
fn halve(
    curve: &impl Fn(f64) -> Point2,
    from: (f64, Point2),
    to: (f64, Point2),
    halvings: usize,
    points: &mut Vec<Point2>,
) {
    let middle = f64::midpoint(from.0, to.0);
    let middle = (middle, curve(middle));
    let chord = sub(to.1, from.1);
    let long = chord[0].hypot(chord[1]);
    let bulge = cross(chord, sub(middle.1, from.1)).abs() / long.max(f64::MIN_POSITIVE);
    if halvings > 0 && bulge > BULGE * long {
        halve(curve, from, middle, halvings - 1, points);
        halve(curve, middle, to, halvings - 1, points);
    } else {
        points.push(to.1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::polyline::length;
    use std::f64::consts::PI;

    const MOST: usize = 1000;

    #[test]
    fn cubic_bezier_as_spline_matches_its_polynomial() {
        let controls = [[0.0, 0.0], [0.0, 1.0], [2.0, 1.0], [2.0, 0.0]];
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        let spline = BSpline {
            degree: 3,
            knots: &knots,
            controls: &controls,
            weights: &[],
        };
        let points = spline.points(MOST);
        assert_eq!(
            (points[0], *points.last().expect("points")),
            (controls[0], controls[3])
        );
        assert!(points.contains(&[1.0, 0.75]));
    }

    #[test]
    fn rational_quarter_circle_has_its_length() {
        let w = 0.5_f64.sqrt();
        let spline = BSpline {
            degree: 2,
            knots: &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            controls: &[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            weights: &[1.0, w, 1.0],
        };
        let points = spline.points(MOST);
        assert!((length(&points) / (PI / 2.0) - 1.0).abs() < 1.3e-5);
        assert!(
            points
                .iter()
                .all(|p| (p[0].hypot(p[1]) - 1.0).abs() < 1e-12)
        );
    }
}
