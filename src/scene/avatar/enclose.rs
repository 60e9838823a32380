//! A smooth distance that leaves nothing of its surface outside: its spline is lowered where the
//! surface stands out of it.
//!
//! What is sharper than the grid is rounded off by the spline: tips of a body would come through
//! cloth that is kept off the smooth surface. Each coefficient about a place that stands out is
//! lowered by its share in the least change that brings the place onto the smooth surface (S.
//! Kaczmarz, "Angenäherte Auflösung von Systemen linearer Gleichungen", 1937), over and over.

use super::TriangleMesh;
use super::lattice::Lattice;
use super::spline::weights;
use nalgebra::Vector3;

/// Distance by which the surface may stand out \[m\].
const OUTSIDE: f64 = 1e-4;
/// Rounds over all that stands out.
const ROUNDS: usize = 4;
/// Parts of a triangle's corners in the places that are looked at.
const PLACES: [[f64; 3]; 5] = [
    [1.0, 0.0, 0.0],
    [0.5, 0.5, 0.0],
    [0.0, 0.5, 0.5],
    [0.5, 0.0, 0.5],
    [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0],
];

/// Lowers spline `coefficients` of the distance at the nodes of `lattice` \[m\] where `surface`
/// stands out.
pub(super) fn enclose(lattice: &Lattice, coefficients: &mut [f64], surface: &TriangleMesh) {
    let of_triangle = |t| {
        let [a, b, c] = surface.corners(t);
        PLACES.map(|[u, v, w]| a * u + b * v + c * w)
    };
    let places = (0..surface.triangles.len()).flat_map(of_triangle);
    let mut outside: Vec<Vector3<f64>> = places.collect();
    for _ in 0..ROUNDS {
        outside.retain(|p| {
            let about = About::new(lattice, p);
            // The true distance is 0 there.
            let stands_out = about.value(coefficients);
            if stands_out > OUTSIDE {
                about.lower(coefficients, stands_out);
            }
            stands_out > 0.0
        });
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
        let furthest = |field: &DistanceField| {
            let out = surface.vertices.iter().filter_map(|v| field.distance(v));
            out.fold(0.0, f64::max)
        };
        let plain = DistanceField::new((&surface, &exact), 0.02, 0.006);
        assert!(furthest(&plain) > 1e-3);
        let enclosing = DistanceField::enclosing((&surface, &exact), 0.02, 0.006);
        // Places compete for coefficients: a part of what each stands out is left.
        let left = furthest(&enclosing);
        assert!(left < 3.0 * OUTSIDE, "{left}");
    }
}
