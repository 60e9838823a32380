//! Bézier curves through the points of polylines.
//!
//! A polyline that the importer drew from a curve has its points at parameters that are multiples
//! of 1/256. The fit first finds the parameters of the points and the control points together, by
//! Newton's method on the distances from the curve (Wang, Pottmann, Liu, "Fitting B-spline curves
//! to point clouds by curvature-based squared distance minimization", ACM TOG 25(2), 2006: tangent
//! distances), then takes the nearest multiples and solves for the control points once more.

use crate::pattern::point::{Point2, distance, dot, sub};
use nalgebra::{DMatrix, DVector};

/// Number of parts of the parameter between whose ends the importer puts points.
const PARTS: f64 = 256.0;

/// Points at least that the importer draws a curve with.
pub(super) const LEAST_POINTS: usize = 5;

/// Points at most that the importer draws a curve with: the ends of all parts.
pub(super) const MOST_POINTS: usize = 257;

/// Points that the importer drew lie on the curve to this \[m\].
const EXACT: f64 = 1e-8;

/// Steps before Newton's method, in which control points and parameters are found in turns: from
/// the lengths of chords alone it loses its way on curves that nearly turn back.
const TURNS: usize = 20;

/// Steps of Newton's method at most.
const STEPS: usize = 40;

/// Share of the diagonal that is added to it, so that controls which the distances do not determine
/// stay where they are.
const DAMPING: f64 = 1e-12;

/// A Bézier curve, by its control points with both ends: three or four.
#[derive(Clone, Debug)]
pub(super) struct Bezier(Vec<Point2>);

/// A curve near a polyline, with the parameters of its points.
pub(super) struct BezierFit {
    pub(super) curve: Bezier,
    pub(super) parameters: Vec<f64>,
}

impl Bezier {
    /// Returns the control points between the ends.
    pub(super) fn inner(&self) -> &[Point2] {
        &self.0[1..self.0.len() - 1]
    }

    /// Returns its point at `t`.
    pub(super) fn at(&self, t: f64) -> Point2 {
        sum(self.0.iter().copied(), bernstein(self.0.len() - 1, t))
    }

    fn derivative(&self, t: f64) -> Point2 {
        let degree = self.0.len() - 1;
        let steps = self.0.windows(2).map(|w| sub(w[1], w[0]));
        sum(steps, bernstein(degree - 1, t)).map(|c| degree as f64 * c)
    }

    fn second_derivative(&self, t: f64) -> Point2 {
        let degree = self.0.len() - 1;
        let bends = self.0.windows(3);
        let bends = bends.map(|w| sub(sub(w[2], w[1]), sub(w[1], w[0])));
        let factor = (degree * (degree - 1)) as f64;
        sum(bends, bernstein(degree - 2, t)).map(|c| factor * c)
    }

    /// Returns the greatest distance of points from their places on the curve \[m\].
    pub(super) fn deviation(&self, points: &[Point2], parameters: &[f64]) -> f64 {
        let apart = points.iter().zip(parameters);
        apart
            .map(|(p, t)| distance(*p, self.at(*t)))
            .fold(0.0, f64::max)
    }
}

/// Returns the curve of a degree that the importer drew a polyline from, of at least
/// [`LEAST_POINTS`] points, which `near` was fitted to; `None` if it drew it from none.
pub(super) fn exact(points: &[Point2], degree: usize, near: Option<&BezierFit>) -> Option<Bezier> {
    let part = |t: &f64| (t * PARTS).round() / PARTS;
    let drawn: Vec<f64> = if points.len() == LEAST_POINTS {
        vec![0.0, 0.25, 0.5, 0.75, 1.0]
    } else {
        near?.parameters.iter().map(part).collect()
    };
    if !drawn.is_sorted_by(|a, b| a < b) {
        return None;
    }
    let curve = with_parameters(points, &drawn, degree)?;
    (curve.deviation(points, &drawn) <= EXACT).then_some(curve)
}

/// Fits a curve of a degree to the points of a polyline.
pub(super) fn fit(points: &[Point2], degree: usize) -> Option<BezierFit> {
    let mut parameters = by_length(points)?;
    let mut curve = with_parameters(points, &parameters, degree)?;
    for _ in 0..TURNS {
        project(&curve, points, &mut parameters);
        curve = with_parameters(points, &parameters, degree)?;
    }
    for _ in 0..STEPS {
        project(&curve, points, &mut parameters);
        if curve.deviation(points, &parameters) <= 1e-3 * EXACT {
            break;
        }
        curve = improved(curve, points, &parameters)?;
    }
    project(&curve, points, &mut parameters);
    Some(BezierFit { curve, parameters })
}

/// Returns the share of the length up to each point.
fn by_length(points: &[Point2]) -> Option<Vec<f64>> {
    let mut way = vec![0.0];
    for w in points.windows(2) {
        way.push(way[way.len() - 1] + distance(w[0], w[1]));
    }
    let whole = *way.last()?;
    (whole > 0.0).then(|| way.iter().map(|s| s / whole).collect())
}

/// Returns the curve of least squares whose points at `parameters` are `points`.
fn with_parameters(points: &[Point2], parameters: &[f64], degree: usize) -> Option<Bezier> {
    let (first, last) = (*points.first()?, *points.last()?);
    let count = degree - 1;
    let mut normal = DMatrix::<f64>::zeros(count, count);
    let mut right = DMatrix::<f64>::zeros(count, 2);
    for (p, t) in points.iter().zip(parameters) {
        let weights = bernstein(degree, *t);
        for i in 0..count {
            for k in 0..2 {
                let ends = weights[0] * first[k] + weights[degree] * last[k];
                right[(i, k)] += weights[i + 1] * (p[k] - ends);
            }
            for j in 0..count {
                normal[(i, j)] += weights[i + 1] * weights[j + 1];
            }
        }
    }
    let solved = normal.cholesky()?.solve(&right);
    let mut controls = vec![first];
    controls.extend((0..count).map(|i| [solved[(i, 0)], solved[(i, 1)]]));
    controls.push(last);
    Some(Bezier(controls))
}

/// Returns the curve after a step of Newton's method on the distances along its normals.
fn improved(curve: Bezier, points: &[Point2], parameters: &[f64]) -> Option<Bezier> {
    let degree = curve.0.len() - 1;
    let count = 2 * (degree - 1);
    let mut normal = DMatrix::<f64>::zeros(count, count);
    let mut right = DVector::<f64>::zeros(count);
    for (p, t) in points.iter().zip(parameters) {
        let [x, y] = curve.derivative(*t);
        let long = x.hypot(y).max(f64::MIN_POSITIVE);
        let across = [-y / long, x / long];
        let apart = dot(across, sub(*p, curve.at(*t)));
        let weights = bernstein(degree, *t);
        let entry = |i: usize| weights[(i / 2 + 1).min(3)] * across[i % 2];
        let row: [f64; 4] = std::array::from_fn(entry);
        for i in 0..count {
            right[i] += row[i] * apart;
            for j in 0..count {
                normal[(i, j)] += row[i] * row[j];
            }
        }
    }
    for i in 0..count {
        normal[(i, i)] += DAMPING * (1.0 + normal[(i, i)]);
    }
    let step = normal.cholesky()?.solve(&right);
    let mut controls = curve.0;
    for i in 0..count {
        controls[i / 2 + 1][i % 2] += step[i];
    }
    let is_finite = controls.iter().flatten().all(|c| c.is_finite());
    is_finite.then_some(Bezier(controls))
}

/// Moves parameters to the feet of their points, the ends apart.
fn project(curve: &Bezier, points: &[Point2], parameters: &mut [f64]) {
    let inner = 1..points.len() - 1;
    for i in inner {
        for _ in 0..4 {
            let t = parameters[i];
            let (off, way) = (sub(curve.at(t), points[i]), curve.derivative(t));
            let curvature = dot(way, way) + dot(off, curve.second_derivative(t));
            let slope = if curvature > 0.0 {
                curvature
            } else {
                dot(way, way)
            };
            let step = dot(off, way) / slope.max(f64::MIN_POSITIVE);
            parameters[i] = (t - step).clamp(0.0, 1.0);
            if parameters[i] == t {
                break;
            }
        }
    }
}

/// Returns the Bernstein polynomials of a degree up to 3 at `t`, then zeros.
fn bernstein(degree: usize, t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    match degree {
        0 => [1.0, 0.0, 0.0, 0.0],
        1 => [s, t, 0.0, 0.0],
        2 => [s * s, 2.0 * s * t, t * t, 0.0],
        _ => [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
    }
}

fn sum(points: impl Iterator<Item = Point2>, weights: [f64; 4]) -> Point2 {
    let add = |s: Point2, (p, w): (Point2, f64)| [s[0] + w * p[0], s[1] + w * p[1]];
    points.zip(weights).fold([0.0; 2], add)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a curve as the importer may put them.
    fn drawn(controls: &[Point2]) -> Vec<Point2> {
        let curve = Bezier(controls.to_vec());
        let parts = [0, 16, 32, 64, 72, 80, 96, 128, 144, 160, 192, 224, 256];
        let at = |k: &u32| curve.at(f64::from(*k) / PARTS);
        parts.iter().map(at).collect()
    }

    #[test]
    fn curve_of_drawn_points_is_found_to_the_last_digits() {
        for controls in [
            vec![[0.0, 0.0], [0.1, 0.3], [0.4, 0.1]],
            vec![[0.0, 0.0], [0.0, 0.2], [0.3, -0.1], [0.4, 0.1]],
            vec![[0.0, 0.0], [0.3, 0.1], [0.1, 0.1], [0.4, 0.0]],
            vec![[0.0, 0.0], [0.35, 0.1], [0.0, 0.12], [0.4, 0.0]],
        ] {
            let points = drawn(&controls);
            let degree = controls.len() - 1;
            let near = fit(&points, degree);
            let found = exact(&points, degree, near.as_ref()).expect("a curve");
            for (a, b) in found.0.iter().zip(&controls) {
                assert!(distance(*a, *b) < 1e-9, "{found:?} {controls:?}");
            }
        }
    }

    #[test]
    fn polyline_of_no_curve_has_none() {
        let mut points = drawn(&[[0.0, 0.0], [0.1, 0.3], [0.4, 0.1]]);
        points[5][0] += 1e-4;
        for degree in [2, 3] {
            let near = fit(&points, degree);
            assert!(exact(&points, degree, near.as_ref()).is_none());
        }
        let near = fit(&points, 2).expect("a fit");
        assert!(near.curve.deviation(&points, &near.parameters) < 1e-4);
    }
}
