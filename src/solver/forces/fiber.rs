//! Springs between points of a triangle: what a net of springs is on a coarser mesh.

use crate::scene::FiberSpring;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Fibers, with energy k/2 (|d| - rest)², d = sum of weights times positions.
pub(crate) struct FiberForce {
    fibers: Vec<FiberSpring>,
    slots: Vec<[Slot; 6]>,
}

const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl FiberForce {
    /// Fibers whose corners are particles.
    pub(crate) fn new(fibers: Vec<FiberSpring>) -> Self {
        Self {
            fibers,
            slots: Vec::new(),
        }
    }
}

fn image(fiber: &FiberSpring, x: &[Vector3<f64>]) -> Vector3<f64> {
    let [a, b, c] = fiber.corners;
    let [wa, wb, wc] = fiber.weights;
    x[a] * wa + x[b] * wb + x[c] * wc
}

impl Potential for FiberForce {
    fn kind(&self) -> TermKind {
        TermKind::Stretch
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        for fiber in &self.fibers {
            pairs.extend(PAIRS.map(|(i, j)| (fiber.corners[i], fiber.corners[j])));
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        let slots = |f: &FiberSpring| PAIRS.map(|(i, j)| sparsity.slot(f.corners[i], f.corners[j]));
        self.slots = self.fibers.iter().map(slots).collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        self.fibers
            .iter()
            .map(|f| 0.5 * f.stiffness_n_m * (image(f, x).norm() - f.rest_length_m).powi(2))
            .sum()
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for f in &self.fibers {
            let d = image(f, x);
            let length = d.norm();
            // A fiber of no length has no direction to push in.
            if length > 0.0 {
                let pull = d * (f.stiffness_n_m * (1.0 - f.rest_length_m / length));
                for (&corner, &weight) in f.corners.iter().zip(&f.weights) {
                    force[corner] -= pull * weight;
                }
            }
        }
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        for (f, slots) in self.fibers.iter().zip(&self.slots) {
            let d = image(f, x);
            let length = d.norm();
            if length == 0.0 {
                continue;
            }
            let n = d / length;
            let along = n * n.transpose();
            let across = 1.0 - f.rest_length_m / length;
            let across = if across < 0.0 {
                across * (1.0 - hessian_modification)
            } else {
                across
            };
            let block = (along + (Matrix3::identity() - along) * across) * f.stiffness_n_m;
            for (&(i, j), &slot) in PAIRS.iter().zip(slots) {
                hessian.add(slot, &(block * (f.weights[i] * f.weights[j])));
            }
        }
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        for f in &self.fibers {
            let sum: f64 = f.weights.iter().map(|w| w.abs()).sum();
            for (&corner, weight) in f.corners.iter().zip(&f.weights) {
                stiffness[corner] += f.stiffness_n_m * weight.abs() * sum;
            }
        }
    }
}
