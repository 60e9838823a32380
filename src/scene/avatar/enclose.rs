//! A smooth distance that leaves nothing of its surface outside: its spline is lowered where the
//! surface stands out of it.
//!
//! What is sharper than the grid is rounded off by the spline: tips of a body would come through
//! cloth that is kept off the smooth surface. The coefficients about a place that stands out are
//! lowered by the least change that brings the place onto the smooth surface. Their weights are not
//! negative, so that no other place is brought out again.

use super::TriangleMesh;
use super::lattice::Lattice;
use super::spline::weights;
use nalgebra::Vector3;
use std::collections::BTreeSet;

/// Distance by which the surface may stand out \[m\].
const OUTSIDE: f64 = 1e-4;

/// Lowers spline `coefficients` of the distance at the nodes of `lattice` \[m\] where `surface`
/// stands out.
pub(super) fn enclose(lattice: &Lattice, coefficients: &mut [f64], surface: &TriangleMesh) {
    let corners: BTreeSet<usize> = surface.triangles.iter().flatten().copied().collect();
    let corners = corners.into_iter().map(|v| surface.vertices[v]);
    let between = (0..surface.triangles.len()).flat_map(|t| {
        let [a, b, c] = surface.corners(t);
        [
            (a + b) * 0.5,
            (b + c) * 0.5,
            (c + a) * 0.5,
            (a + b + c) / 3.0,
        ]
    });
    for p in corners.chain(between) {
        let about = About::new(lattice, &p);
        // The true distance is 0 there.
        let stands_out = about.value(coefficients);
        if stands_out > OUTSIDE {
            about.lower(coefficients, stands_out);
        }
    }
}

/// The coefficients about a place and their weights there.
struct About {
    indices: [usize; 64],
    weights: [f64; 64],
}

impl About {
    fn new(lattice: &Lattice, p: &Vector3<f64>) -> Self {
        let mut first = [0; 3];
        let mut along = [[0.0; 4]; 3];
        for axis in 0..3 {
            let u = (p[axis] - lattice.origin[axis]) / lattice.spacing;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "within the lattice, which pads the surface"
            )]
            let node = u as usize;
            first[axis] = node - 1;
            along[axis] = weights(u - node as f64);
        }
        let mut about = Self {
            indices: [0; 64],
            weights: [0.0; 64],
        };
        for n in 0..64 {
            let steps = [n / 16, n / 4 % 4, n % 4];
            about.indices[n] = lattice.index([0, 1, 2].map(|axis| first[axis] + steps[axis]));
            about.weights[n] = (0..3).map(|axis| along[axis][steps[axis]]).product();
        }
        about
    }

    fn value(&self, coefficients: &[f64]) -> f64 {
        let terms = self.indices.iter().zip(&self.weights);
        terms.map(|(&i, weight)| coefficients[i] * weight).sum()
    }

    /// Lowers the value here, and the coefficients as little as that takes.
    fn lower(&self, coefficients: &mut [f64], by: f64) {
        let square: f64 = self.weights.iter().map(|weight| weight * weight).sum();
        for (&i, weight) in self.indices.iter().zip(&self.weights) {
            coefficients[i] -= by * weight / square;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::exact::ExactDistance;
    use super::super::field::DistanceField;
    use super::*;

    /// A tip as sharp as they come: a double pyramid 40 mm high on a square of 20 mm.
    fn tip() -> TriangleMesh {
        let side = |k: usize| {
            let angle = std::f64::consts::FRAC_PI_2 * k as f64;
            Vector3::new(0.01 * angle.cos(), 0.0, 0.01 * angle.sin())
        };
        let mut vertices: Vec<_> = (0..4).map(side).collect();
        vertices.extend([Vector3::y() * 0.02, Vector3::y() * -0.02]);
        let around = |k: usize| [[k, 4, (k + 1) % 4], [(k + 1) % 4, 5, k]];
        TriangleMesh {
            vertices,
            triangles: (0..4).flat_map(around).collect(),
        }
    }

    #[test]
    fn a_tip_stands_out_of_the_smooth_surface_no_more() {
        let surface = tip();
        let exact = ExactDistance::new(&surface);
        let field = DistanceField::new((&surface, &exact), 0.02, 0.006);
        let out = surface.vertices.iter().filter_map(|v| field.distance(v));
        let left = out.fold(0.0, f64::max);
        // Of the spline alone more than 1 mm of the tip stand out.
        assert!(left <= OUTSIDE + 1e-12, "{left}");
    }
}
