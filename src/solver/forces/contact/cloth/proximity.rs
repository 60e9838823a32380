//! The distance of two features of a surface, a vertex and a triangle or two edges, with its first
//! and second derivative.
//!
//! The vector between the closest points is `u = sum c_i x_i` over the four corners, whose
//! coefficients depend on up to two parameters w of the closest points: those that are not at an
//! end of their range. By the envelope theorem the gradient of |u|²/2 is `c_i u`; its second
//! derivative is the Schur complement of the parameters in that of |u(x, w)|²/2.

use nalgebra::{Matrix3, Vector3};

/// Sine squared of the angle of two edges below which their closest points are not told apart.
const PARALLEL: f64 = 1e-12;

/// Two features of a surface that may meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Features {
    /// A vertex, and the triangle of the other three.
    VertexTriangle,
    /// The edge of the first two and that of the last two.
    Edges,
}

/// A free parameter of the closest points.
#[derive(Clone, Copy, Debug)]
struct Parameter {
    /// Derivative of the coefficients.
    coefficients: [f64; 4],
    /// Derivative of u.
    along: Vector3<f64>,
}

/// The closest points of two features.
#[derive(Clone, Copy, Debug)]
pub(super) struct Proximity {
    /// Vector from the second feature to the first \[m\].
    separation: Vector3<f64>,
    pub(super) coefficients: [f64; 4],
    parameters: [Option<Parameter>; 2],
}

impl Proximity {
    /// Returns the closest points of features with these corners.
    pub(super) fn of(features: Features, corners: &[Vector3<f64>; 4]) -> Self {
        match features {
            Features::VertexTriangle => vertex_triangle(corners),
            Features::Edges => edges(corners),
        }
    }

    fn new(corners: &[Vector3<f64>; 4], coefficients: [f64; 4], free: &[[f64; 4]]) -> Self {
        let mut parameters = [None; 2];
        for (parameter, &coefficients) in parameters.iter_mut().zip(free) {
            *parameter = Some(Parameter {
                coefficients,
                along: combine(&coefficients, corners),
            });
        }
        Self {
            separation: combine(&coefficients, corners),
            coefficients,
            parameters,
        }
    }

    /// Returns the distance \[m\].
    pub(super) fn distance(&self) -> f64 {
        self.separation.norm()
    }

    /// Returns the direction from the second feature to the first.
    pub(super) fn normal(&self) -> Vector3<f64> {
        self.separation / self.distance()
    }

    /// Returns the block of corners `i` and `j` of the second derivative of half the squared
    /// distance.
    pub(super) fn half_square_block(&self, i: usize, j: usize) -> Matrix3<f64> {
        let c = &self.coefficients;
        let mut block = Matrix3::identity() * (c[i] * c[j]);
        // d²f / dx_i dw_k.
        let mixed = |p: &Parameter, i: usize| self.separation * p.coefficients[i] + p.along * c[i];
        match self.parameters {
            [Some(p), Some(q)] => {
                let (pp, qq) = (p.along.norm_squared(), q.along.norm_squared());
                let pq = p.along.dot(&q.along);
                let determinant = pp * qq - pq * pq;
                let (pi, qi) = (mixed(&p, i), mixed(&q, i));
                let (pj, qj) = (mixed(&p, j).transpose(), mixed(&q, j).transpose());
                block -= (pi * pj * qq + qi * qj * pp - (pi * qj + qi * pj) * pq) / determinant;
            }
            [Some(p), None] => {
                block -= mixed(&p, i) * mixed(&p, j).transpose() / p.along.norm_squared();
            }
            _ => {}
        }
        block
    }
}

fn combine(coefficients: &[f64; 4], corners: &[Vector3<f64>; 4]) -> Vector3<f64> {
    let terms = coefficients.iter().zip(corners);
    terms.map(|(c, x)| x * *c).sum()
}

/// Returns the closest points of a vertex and a triangle, by the regions of C. Ericson, Real-Time
/// Collision Detection (2005), 5.1.5.
fn vertex_triangle(corners: &[Vector3<f64>; 4]) -> Proximity {
    let [p, a, b, c] = corners;
    let at = |weights: [f64; 3], free: &[[f64; 4]]| {
        let [wa, wb, wc] = weights;
        Proximity::new(corners, [1.0, -wa, -wb, -wc], free)
    };
    let (ab, ac) = (b - a, c - a);
    let ap = p - a;
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return at([1.0, 0.0, 0.0], &[]);
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return at([0.0, 1.0, 0.0], &[]);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return at([1.0 - v, v, 0.0], &[[0.0, 1.0, -1.0, 0.0]]);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return at([0.0, 0.0, 1.0], &[]);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = d2 / (d2 - d6);
        return at([1.0 - w, 0.0, w], &[[0.0, 1.0, 0.0, -1.0]]);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return at([0.0, 1.0 - w, w], &[[0.0, 0.0, 1.0, -1.0]]);
    }
    let sum = va + vb + vc;
    let (v, w) = (vb / sum, vc / sum);
    at(
        [1.0 - v - w, v, w],
        &[[0.0, 1.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0]],
    )
}

/// Returns the closest points of two edges (C. Ericson, Real-Time Collision Detection, 2005,
/// 5.1.9).
fn edges(corners: &[Vector3<f64>; 4]) -> Proximity {
    let [p1, q1, p2, q2] = corners;
    let (d1, d2, r) = (q1 - p1, q2 - p2, p1 - p2);
    let (a, e) = (d1.norm_squared(), d2.norm_squared());
    let (b, c, f) = (d1.dot(&d2), d1.dot(&r), d2.dot(&r));
    let determinant = a * e - b * b;
    let are_parallel = determinant <= PARALLEL * a * e;
    let mut s = if are_parallel {
        0.0
    } else {
        ((b * f - c * e) / determinant).clamp(0.0, 1.0)
    };
    let mut t = (b * s + f) / e;
    if !(0.0..=1.0).contains(&t) {
        t = t.clamp(0.0, 1.0);
        s = ((b * t - c) / a).clamp(0.0, 1.0);
    }
    let is_free = |w: f64| w > 0.0 && w < 1.0;
    let (along_s, along_t) = ([-1.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, -1.0]);
    let coefficients = [1.0 - s, s, t - 1.0, -t];
    match (is_free(s), is_free(t)) {
        (true, true) if !are_parallel => Proximity::new(corners, coefficients, &[along_s, along_t]),
        (true, false) => Proximity::new(corners, coefficients, &[along_s]),
        (_, true) => Proximity::new(corners, coefficients, &[along_t]),
        (false, false) => Proximity::new(corners, coefficients, &[]),
    }
}

/// Returns the squared sine of the angle between the edges of the first two and of the last two
/// corners.
pub(super) fn sine_squared(corners: &[Vector3<f64>; 4]) -> f64 {
    let (d1, d2) = (corners[1] - corners[0], corners[3] - corners[2]);
    let lengths = d1.norm_squared() * d2.norm_squared();
    d1.cross(&d2).norm_squared() / lengths.max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 1e-4;

    /// Corners whose closest points are inside both features, on an edge, at a corner.
    fn cases() -> Vec<(Features, [Vector3<f64>; 4])> {
        let v = Vector3::new;
        let triangle = [v(0.0, 0.0, 0.0), v(1.0, 0.1, 0.0), v(0.2, 1.1, 0.1)];
        let above = [
            v(0.3, 0.4, 0.5),
            v(0.5, -0.6, 0.3),
            v(-0.6, 0.5, 0.2),
            v(0.9, 0.9, -0.4),
            v(-0.5, -0.6, 0.3),
            v(1.9, 0.2, 0.3),
            v(0.2, 2.0, 0.5),
        ];
        let vertices = above.map(|p| {
            let [a, b, c] = triangle;
            (Features::VertexTriangle, [p, a, b, c])
        });
        let others = [
            [v(0.4, -0.5, 0.3), v(0.6, 0.7, 0.4)],
            [v(0.4, 0.3, 0.3), v(0.6, 0.9, 0.4)],
            [v(1.4, -0.5, 0.3), v(1.6, 0.7, 0.4)],
            [v(1.4, 0.5, 0.3), v(1.9, 0.7, 0.4)],
        ];
        let edges = others.map(|[c, d]| (Features::Edges, [triangle[0], triangle[1], c, d]));
        vertices.into_iter().chain(edges).collect()
    }

    fn distance(features: Features, corners: &[Vector3<f64>; 4]) -> f64 {
        Proximity::of(features, corners).distance()
    }

    /// Among points sampled on both features there is none nearer, and one about as near.
    #[test]
    fn no_other_points_are_nearer() {
        for (features, x) in cases() {
            let count = 200;
            let mut least = f64::INFINITY;
            for i in 0..=count {
                for j in 0..=count {
                    let (s, t) = (i as f64 / count as f64, j as f64 / count as f64);
                    let between = match features {
                        Features::VertexTriangle if s + t > 1.0 => continue,
                        Features::VertexTriangle => {
                            x[0] - (x[1] * (1.0 - s - t) + x[2] * s + x[3] * t)
                        }
                        Features::Edges => {
                            x[0] * (1.0 - s) + x[1] * s - (x[2] * (1.0 - t) + x[3] * t)
                        }
                    };
                    least = least.min(between.norm());
                }
            }
            let found = distance(features, &x);
            // The nearest sample is half a step of either parameter off, of features below 1.2.
            let off = 1.2 / count as f64;
            assert!(
                found <= least + 1e-12 && least - found <= off,
                "{found} {least}"
            );
        }
    }

    #[test]
    fn derivatives_are_those_of_the_distance() {
        for (features, x) in cases() {
            let proximity = Proximity::of(features, &x);
            let normal = proximity.normal();
            for i in 0..4 {
                for axis in 0..3 {
                    let moved = |by: f64| {
                        let mut y = x;
                        y[i][axis] += by;
                        y
                    };
                    let slope = (distance(features, &moved(STEP))
                        - distance(features, &moved(-STEP)))
                        / (2.0 * STEP);
                    let exact = proximity.coefficients[i] * normal[axis];
                    // Third derivatives of distances of about 1 are of order 1.
                    assert!(
                        (slope - exact).abs() < 100.0 * STEP * STEP,
                        "{slope} {exact}"
                    );
                    let gradient = |y: [Vector3<f64>; 4], j: usize| {
                        let p = Proximity::of(features, &y);
                        p.separation * p.coefficients[j]
                    };
                    for j in 0..4 {
                        let change =
                            (gradient(moved(STEP), j) - gradient(moved(-STEP), j)) / (2.0 * STEP);
                        let block = proximity.half_square_block(j, i);
                        let off = (block.column(axis) - change).norm();
                        assert!(off < 100.0 * STEP * STEP, "{features:?} {off}");
                    }
                }
            }
        }
    }
}
