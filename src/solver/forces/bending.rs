//! Quadratic bending, orthotropic: a triangle bends as the quadratic surface through it and its
//! neighbors.
//!
//! The curvatures `κ_warp`, `κ_weft` and `κ_twist` of a triangle are those of the quadratic
//! function through its three corners and the far corners of the three triangles that share an edge
//! with it (E. Grinspun, Y. Gingold, J. Reisman, D. Zorin, "Computing discrete shape operators on
//! general meshes", Eurographics 2006), taken in the flat rest shape, in each coordinate of space.
//! Cloth hardly stretches, so that the flat rest shape will do (M. Bergou, M. Wardetzky, D. Harmon,
//! D. Zorin, E. Grinspun, "A quadratic bending model for inextensible surfaces", SGP 2006), and the
//! second derivative of the energy is constant and positive semidefinite.
//!
//! With A the area, the energy is `A/2 (Bw |κ_warp|² + Bf |κ_weft|² + (Bw + Bf) |κ_twist|²)`: a
//! plate without Poisson coupling, of which a strip cut at an angle a to the warp has the rigidity
//! Bw cos² a + Bf sin² a. Where a neighbor is missing, the energy is the least that the others
//! allow, which is what a free edge does.
//!
//! # Limitations
//! Energies of quadratic shapes are exact on every mesh. Shapes at rest converge to those of the
//! plate on meshes that look the same from every vertex, as the inside of a lattice does; where
//! triangles alternate, cloth comes out softer.

use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::{PairForce, PairForces, Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Least stiffness against bending in one way, over that in another, that a triangle's neighbors
/// may be too badly placed to tell apart: below it they are taken to say nothing more. Meshes of
/// garments stay above 0.3.
const SINGULAR: f64 = 0.03;

/// A triangle with its neighbors: its corners, then the far corner of the neighbor across from
/// each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BendPatch {
    /// The first corner again where there is no neighbor.
    pub(crate) particles: [usize; 6],
    /// Energy is half the sum of |sum of weight times position|² over the rows \[(N/m)^½\].
    pub(crate) weights: [[f64; 6]; 3],
}

/// The far corner of a neighbor: a particle, and its place when the neighbor is unfolded into the
/// triangle's plane \[m\].
type Wing = (usize, [f64; 2]);

/// Returns half the squares and the product of the coordinates: the functions of unit curvature
/// along warp, weft and twist.
fn unit_curvatures([x, y]: [f64; 2]) -> [f64; 3] {
    [0.5 * x * x, 0.5 * y * y, x * y]
}

fn twice_area(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
}

impl BendPatch {
    /// Returns the patch of a triangle at `rest` in warp-weft coordinates \[m\], with bending
    /// rigidities along warp and weft \[N m\]. `None` if it has no area or no neighbor.
    pub(crate) fn new(
        corners: [usize; 3],
        rest: [[f64; 2]; 3],
        wings: [Option<Wing>; 3],
        rigidity: [f64; 2],
    ) -> Option<Self> {
        let area = 0.5 * twice_area(rest[0], rest[1], rest[2]);
        let least = 1e-6 * rigidity[0].max(rigidity[1]);
        let [warp, weft] = rigidity.map(|b| b.max(least));
        let softness = Vector3::new(warp, weft, warp + weft).map(f64::recip);
        if !(area > 0.0 && softness.x.is_finite()) {
            return None;
        }
        let [a, b, c] = corners;
        let mut particles = [a, b, c, a, a, a];
        // How far each wing stands off the plane of the triangle: by weights of positions, and by
        // curvature.
        let mut standoff = [[0.0; 6]; 3];
        let mut by_curvature = Matrix3::zeros();
        for (k, wing) in wings.iter().enumerate() {
            let Some((particle, at)) = *wing else {
                continue;
            };
            particles[3 + k] = particle;
            let (row, curved) = above_plane(rest, at, k);
            let norm = (0..3)
                .map(|m| softness[m] * curved[m] * curved[m])
                .sum::<f64>()
                .sqrt();
            standoff[k] = row.map(|w| w / norm);
            by_curvature.set_row(k, &(curved.transpose() / norm));
        }
        // The least energy with standoffs s is A/2 s·M⁻¹ s, M = G D⁻¹ Gᵀ with G the standoffs by
        // curvature.
        let m = by_curvature * Matrix3::from_diagonal(&softness) * by_curvature.transpose();
        let eigen = SymmetricEigen::new(m);
        let mut weights = [[0.0; 6]; 3];
        for (row, (value, vector)) in weights.iter_mut().zip(
            eigen
                .eigenvalues
                .iter()
                .zip(eigen.eigenvectors.column_iter()),
        ) {
            // Rows without a neighbor are zero in M, and in the standoffs.
            let scale = (area / value.max(SINGULAR)).sqrt();
            for i in 0..6 {
                row[i] = scale * (0..3).map(|k| vector[k] * standoff[k][i]).sum::<f64>();
            }
        }
        (particles[3..] != [a; 3]).then_some(Self { particles, weights })
    }
}

/// Returns the height of wing `k` at `at` over the plane of the triangle: by the six positions, and
/// for unit curvatures.
fn above_plane(rest: [[f64; 2]; 3], at: [f64; 2], k: usize) -> ([f64; 6], Vector3<f64>) {
    let [p, q, r] = rest;
    let whole = twice_area(p, q, r);
    let share = [
        twice_area(at, q, r) / whole,
        twice_area(p, at, r) / whole,
        twice_area(p, q, at) / whole,
    ];
    let mut row = [-share[0], -share[1], -share[2], 0.0, 0.0, 0.0];
    row[3 + k] = 1.0;
    let mut curved = Vector3::from(unit_curvatures(at));
    for (corner, share) in rest.iter().zip(share) {
        curved -= Vector3::from(unit_curvatures(*corner)) * share;
    }
    (row, curved)
}

/// Bending of all patches.
pub(crate) struct BendForce {
    patches: Vec<BendPatch>,
    slots: Vec<[Slot; 21]>,
    active: ActiveElements,
}

/// Pairs of the six particles of a patch, each once.
const PAIRS: [(usize, usize); 21] = pairs();

const fn pairs() -> [(usize, usize); 21] {
    let mut pairs = [(0, 0); 21];
    let (mut n, mut i) = (0, 0);
    while i < 6 {
        let mut j = i;
        while j < 6 {
            pairs[n] = (i, j);
            n += 1;
            j += 1;
        }
        i += 1;
    }
    pairs
}

impl BendForce {
    pub(crate) fn new(patches: Vec<BendPatch>) -> Self {
        Self {
            patches,
            slots: Vec::new(),
            active: ActiveElements::default(),
        }
    }
}

fn weighted(patch: &BendPatch, weights: &[f64; 6], x: &[Vector3<f64>]) -> Vector3<f64> {
    let mut sum = Vector3::zeros();
    for (&particle, weight) in patch.particles.iter().zip(weights) {
        sum += x[particle] * *weight;
    }
    sum
}

impl Potential for BendForce {
    fn kind(&self) -> TermKind {
        TermKind::Bend
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        for patch in &self.patches {
            let p = patch.particles;
            pairs.extend(PAIRS.iter().map(|&(i, j)| (p[i], p[j])));
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        let slot =
            |p: &BendPatch| PAIRS.map(|(i, j)| sparsity.slot(p.particles[i], p.particles[j]));
        self.slots = self.patches.iter().map(slot).collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.active.for_each(self.patches.len(), |k| {
            let patch = &self.patches[k];
            let row = |w| weighted(patch, w, x).norm_squared();
            sum += patch.weights.iter().map(row).sum::<f64>();
        });
        0.5 * sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.active.for_each(self.patches.len(), |k| {
            let patch = &self.patches[k];
            let bent = patch.weights.each_ref().map(|w| weighted(patch, w, x));
            for (i, &particle) in patch.particles.iter().enumerate() {
                let [u, v, w] = &patch.weights;
                force[particle] -= bent[0] * u[i] + bent[1] * v[i] + bent[2] * w[i];
            }
        });
    }

    fn add_hessian(
        &mut self,
        _x: &[Vector3<f64>],
        _hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        self.active.for_each(self.patches.len(), |k| {
            let (patch, slots) = (&self.patches[k], &self.slots[k]);
            let [u, v, w] = &patch.weights;
            for (&(i, j), &slot) in PAIRS.iter().zip(slots) {
                let mut product = u[i] * u[j] + v[i] * v[j] + w[i] * w[j];
                if i != j && patch.particles[i] == patch.particles[j] {
                    // Two wings that are one particle, at the tip of a dart: both halves fall on
                    // the diagonal.
                    product *= 2.0;
                }
                hessian.add(slot, &Matrix3::from_diagonal_element(product));
            }
        });
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        let patches = &self.patches;
        let has_one = |k: usize, moving: &[bool]| patches[k].particles.iter().any(|&p| moving[p]);
        self.active.narrow(moving, patches.len(), has_one);
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        for patch in &self.patches {
            for row in &patch.weights {
                let sum: f64 = row.iter().map(|w| w.abs()).sum();
                for (&particle, weight) in patch.particles.iter().zip(row) {
                    stiffness[particle] += weight.abs() * sum;
                }
            }
        }
    }

    fn add_to_pair_forces(&self, pair_forces: &mut PairForces) -> bool {
        for patch in &self.patches {
            let (p, [u, v, w]) = (&patch.particles, &patch.weights);
            let links = PAIRS.iter().filter(|&&(i, j)| p[i] != p[j]);
            // The weights of each row add up to 0, so that the force is one of differences of
            // positions.
            pair_forces.pairs.extend(links.map(|&(i, j)| PairForce {
                a: p[i],
                b: p[j],
                stiffness: -(u[i] * u[j] + v[i] * v[j] + w[i] * w[j]),
                stiffness_times_rest: 0.0,
            }));
        }
        true
    }
}
