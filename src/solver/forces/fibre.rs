//! Springs between points of a triangle: what a net of springs is on a coarser mesh.

use crate::scene::Fibre;
use crate::solver::forces::Force;
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Fibres, with energy k/2 (|d| - rest)², d = sum of weights times positions.
pub(crate) struct FibreForce {
    fibres: Vec<Fibre>,
    slots: Vec<[Slot; 6]>,
}

const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl FibreForce {
    /// Fibres whose corners are particles.
    pub(crate) fn new(fibres: Vec<Fibre>) -> Self {
        Self {
            fibres,
            slots: Vec::new(),
        }
    }
}

fn image(fibre: &Fibre, x: &[Vector3<f64>]) -> Vector3<f64> {
    let [a, b, c] = fibre.corners;
    let [wa, wb, wc] = fibre.weights;
    x[a] * wa + x[b] * wb + x[c] * wc
}

impl Force for FibreForce {
    fn name(&self) -> &'static str {
        "stretch"
    }

    fn couple(&self, pairs: &mut Vec<(usize, usize)>) {
        for fibre in &self.fibres {
            pairs.extend(PAIRS.map(|(i, j)| (fibre.corners[i], fibre.corners[j])));
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        let slots = |f: &Fibre| PAIRS.map(|(i, j)| sparsity.slot(f.corners[i], f.corners[j]));
        self.slots = self.fibres.iter().map(slots).collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        self.fibres
            .iter()
            .map(|f| 0.5 * f.stiffness_n_m * (image(f, x).norm() - f.rest_length_m).powi(2))
            .sum()
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for f in &self.fibres {
            let d = image(f, x);
            let length = d.norm();
            // A fibre of no length has no direction to push in.
            if length > 0.0 {
                let pull = d * (f.stiffness_n_m * (1.0 - f.rest_length_m / length));
                for (&corner, &weight) in f.corners.iter().zip(&f.weights) {
                    force[corner] -= pull * weight;
                }
            }
        }
    }

    fn add_hessian(&mut self, x: &[Vector3<f64>], convexity: f64, hessian: &mut BlockMatrix) {
        for (f, slots) in self.fibres.iter().zip(&self.slots) {
            let d = image(f, x);
            let length = d.norm();
            if length == 0.0 {
                continue;
            }
            let n = d / length;
            let along = n * n.transpose();
            let across = 1.0 - f.rest_length_m / length;
            let across = if across < 0.0 {
                across * (1.0 - convexity)
            } else {
                across
            };
            let block = (along + (Matrix3::identity() - along) * across) * f.stiffness_n_m;
            for (&(i, j), &slot) in PAIRS.iter().zip(slots) {
                hessian.add(slot, &(block * (f.weights[i] * f.weights[j])));
            }
        }
    }

    fn add_stiffness(&self, stiffness: &mut [f64]) {
        for f in &self.fibres {
            let sum: f64 = f.weights.iter().map(|w| w.abs()).sum();
            for (&corner, weight) in f.corners.iter().zip(&f.weights) {
                stiffness[corner] += f.stiffness_n_m * weight.abs() * sum;
            }
        }
    }
}
