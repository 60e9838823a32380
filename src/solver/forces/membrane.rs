//! Orthotropic membrane of triangles, see [`MembraneTriangle`].

use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::membrane_lanes::MembraneLanes;
use crate::solver::forces::membrane_triangle::MembraneTriangle;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix2, Matrix3, Vector3};

/// Membrane of all triangles.
pub(crate) struct ContinuumForce {
    triangles: Vec<MembraneTriangle>,
    /// The same, to compute the forces of all of them.
    lanes: MembraneLanes,
    slots: Vec<[Slot; 6]>,
    active: ActiveElements,
    /// True while no triangle is taken to buckle.
    taut: bool,
}

const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl ContinuumForce {
    pub(crate) fn new(triangles: Vec<MembraneTriangle>) -> Self {
        Self {
            lanes: MembraneLanes::new(&triangles),
            triangles,
            slots: Vec::new(),
            active: ActiveElements::default(),
            taut: false,
        }
    }
}

impl Potential for ContinuumForce {
    fn kind(&self) -> TermKind {
        TermKind::Stretch
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        for triangle in &self.triangles {
            pairs.extend(
                PAIRS
                    .iter()
                    .map(|&(i, j)| (triangle.particles[i], triangle.particles[j])),
            );
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        self.slots = self
            .triangles
            .iter()
            .map(|t| PAIRS.map(|(i, j)| sparsity.slot(t.particles[i], t.particles[j])))
            .collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.active.for_each(self.triangles.len(), |k| {
            let t = &self.triangles[k];
            sum += t.area * t.energy(MembraneTriangle::strain(&t.deformation(x)));
        });
        sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        if self.active.is_all() {
            self.lanes.add_force(x, force, self.taut);
            return;
        }
        self.active.for_each(self.triangles.len(), |k| {
            self.triangles[k].add_force(x, force, self.taut);
        });
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        self.active.for_each(self.triangles.len(), |k| {
            let (t, slots) = (&self.triangles[k], &self.slots[k]);
            let f = t.deformation(x);
            let strain = MembraneTriangle::strain(&f);
            let mut s = t.stress(strain);
            if hessian_modification > 0.0 {
                let pull = tension(s);
                for (s, pull) in s.iter_mut().zip(pull) {
                    *s += hessian_modification * (pull - *s);
                }
            }
            let [kw, kf, g] = t.tangent(strain);
            let h11 = (Matrix3::identity() * s[0]
                + f[0] * f[0].transpose() * kw
                + f[1] * f[1].transpose() * g)
                * t.area;
            let h22 = (Matrix3::identity() * s[1]
                + f[1] * f[1].transpose() * kf
                + f[0] * f[0].transpose() * g)
                * t.area;
            let h12 = (Matrix3::identity() * s[2] + f[1] * f[0].transpose() * g) * t.area;
            for (&(i, j), &slot) in PAIRS.iter().zip(slots) {
                let (a, b) = (t.gradients[i], t.gradients[j]);
                let block = h11 * (a[0] * b[0])
                    + h22 * (a[1] * b[1])
                    + h12 * (a[0] * b[1])
                    + h12.transpose() * (a[1] * b[0]);
                hessian.add(slot, &block);
            }
        });
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        let triangles = &self.triangles;
        let has_one = |k: usize, moving: &[bool]| triangles[k].particles.iter().any(|&p| moving[p]);
        self.active.narrow(moving, triangles.len(), has_one);
    }

    fn set_taut(&mut self, taut: bool) {
        self.taut = taut;
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        for t in &self.triangles {
            let [kw, kf, g] = t.moduli;
            let largest = kw.max(kf) + g;
            let norm = |g: &[f64; 2]| g[0].hypot(g[1]);
            let sum: f64 = t.gradients.iter().map(norm).sum();
            for (&particle, gradient) in t.particles.iter().zip(&t.gradients) {
                stiffness[particle] += t.area * largest * norm(gradient) * sum;
            }
        }
    }
}

/// Returns the tensile part of a stress (warp, weft, shear): its negative principal values become
/// zero.
fn tension(s: [f64; 3]) -> [f64; 3] {
    let eigen = Matrix2::new(s[0], s[2], s[2], s[1]).symmetric_eigen();
    let positive = eigen.eigenvalues.map(|v| v.max(0.0));
    let m = eigen.eigenvectors * Matrix2::from_diagonal(&positive) * eigen.eigenvectors.transpose();
    [m[(0, 0)], m[(1, 1)], m[(0, 1)]]
}
