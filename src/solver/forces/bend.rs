//! Quadratic (isometric) bending.
//!
//! M. Bergou, M. Wardetzky, D. Harmon, D. Zorin, E. Grinspun, "A Quadratic Bending Model for Inextensible Surfaces"
//! (Symposium on Geometry Processing 2006): the energy of a hinge is c / 2 |sum K x|² with cotangent weights K of the flat
//! rest shape. Its second derivative is constant and positive semidefinite.
//!
//! The paper's c = 3 B / (A0 + A1) is right for a sphere. Cloth hardly stretches, so it bends into developable surfaces, and on
//! a cylinder that c gives three times the energy B/2 κ² A, on equilateral and on right-angled meshes alike. Here
//! c = B / (A0 + A1), so that a strip bends as its rigidity B says.

use super::Force;
use crate::solver::sparsity::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Two triangles that share an edge: four particles, the two of the edge first, with their weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hinge {
    pub(crate) particles: [usize; 4],
    /// Square root of the hinge's stiffness times K \[(N/m)^½\].
    pub(crate) weights: [f64; 4],
}

impl Hinge {
    /// The hinge of bending rigidity `rigidity` \[N m\] over an edge of which the two triangles have these rest shapes:
    /// cotangents at the first and the second point of the edge, and the area \[m²\].
    pub(crate) fn new(particles: [usize; 4], sides: [HingeSide; 2], rigidity: f64) -> Self {
        let [s, t] = sides;
        let scale = (rigidity / (s.area + t.area)).sqrt();
        let weights = [
            scale * (s.cotangents[1] + t.cotangents[1]),
            scale * (s.cotangents[0] + t.cotangents[0]),
            -scale * (s.cotangents[0] + s.cotangents[1]),
            -scale * (t.cotangents[0] + t.cotangents[1]),
        ];
        Self { particles, weights }
    }
}

/// One triangle of a hinge in its rest shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct HingeSide {
    /// Cotangents of its angles at the two points of the hinge's edge.
    pub(crate) cotangents: [f64; 2],
    /// \[m²\]
    pub(crate) area: f64,
}

/// All hinges.
pub(crate) struct BendForce {
    hinges: Vec<Hinge>,
    slots: Vec<[Slot; 10]>,
}

const PAIRS: [(usize, usize); 10] = [
    (0, 0),
    (1, 1),
    (2, 2),
    (3, 3),
    (0, 1),
    (0, 2),
    (0, 3),
    (1, 2),
    (1, 3),
    (2, 3),
];

impl BendForce {
    pub(crate) fn new(hinges: Vec<Hinge>) -> Self {
        Self {
            hinges,
            slots: Vec::new(),
        }
    }
}

fn curvature(hinge: &Hinge, x: &[Vector3<f64>]) -> Vector3<f64> {
    let [a, b, c, d] = hinge.particles;
    let [wa, wb, wc, wd] = hinge.weights;
    x[a] * wa + x[b] * wb + x[c] * wc + x[d] * wd
}

impl Force for BendForce {
    fn name(&self) -> &'static str {
        "bend"
    }

    fn couple(&self, pairs: &mut Vec<(usize, usize)>) {
        for hinge in &self.hinges {
            pairs.extend(
                PAIRS
                    .iter()
                    .map(|&(i, j)| (hinge.particles[i], hinge.particles[j])),
            );
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        self.slots = self
            .hinges
            .iter()
            .map(|h| PAIRS.map(|(i, j)| sparsity.slot(h.particles[i], h.particles[j])))
            .collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        0.5 * self
            .hinges
            .iter()
            .map(|h| curvature(h, x).norm_squared())
            .sum::<f64>()
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for hinge in &self.hinges {
            let c = curvature(hinge, x);
            for (&particle, &weight) in hinge.particles.iter().zip(&hinge.weights) {
                force[particle] -= c * weight;
            }
        }
    }

    fn add_hessian(&mut self, _x: &[Vector3<f64>], _convexity: f64, hessian: &mut BlockMatrix) {
        for (hinge, slots) in self.hinges.iter().zip(&self.slots) {
            for (&(i, j), &slot) in PAIRS.iter().zip(slots) {
                hessian.add(
                    slot,
                    &(Matrix3::identity() * (hinge.weights[i] * hinge.weights[j])),
                );
            }
        }
    }

    fn add_stiffness(&self, stiffness: &mut [f64]) {
        for hinge in &self.hinges {
            let sum: f64 = hinge.weights.iter().map(|w| w.abs()).sum();
            for (&particle, &weight) in hinge.particles.iter().zip(&hinge.weights) {
                stiffness[particle] += weight.abs() * sum;
            }
        }
    }
}
