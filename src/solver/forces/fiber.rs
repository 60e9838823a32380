//! Springs between points of a triangle, into which a net of springs turns on a coarser mesh.

use crate::scene::FiberSpring;
use crate::solver::forces::central::CentralSpring;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::Vector3;

/// Fibers, with energy k/2 (|d| - rest)², d = sum of weights times positions.
pub(crate) struct FiberForce {
    fibers: Vec<FiberSpring>,
    slots: Vec<[Slot; 6]>,
}

const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl FiberForce {
    /// Returns the force of fibers whose corners are particles.
    pub(crate) fn new(fibers: Vec<FiberSpring>) -> Self {
        Self {
            fibers,
            slots: Vec::new(),
        }
    }
}

fn law(fiber: &FiberSpring) -> CentralSpring {
    CentralSpring {
        stiffness: fiber.stiffness_n_m,
        rest_length: fiber.rest_length_m,
    }
}

/// Returns the vector along a fiber, whose length is the fiber's.
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
            .map(|f| law(f).energy(&image(f, x)))
            .sum()
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for f in &self.fibers {
            if let Some(pull) = law(f).tension(&image(f, x)) {
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
            let Some(block) = law(f).hessian(&image(f, x), hessian_modification) else {
                continue;
            };
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
