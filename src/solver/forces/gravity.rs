//! Weight of the particles.

use crate::solver::forces::{PairForces, Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::Vector3;

/// Weight, of energy -m g·(x - x0): zero at the start, so that little is lost to rounding.
pub(crate) struct Gravity {
    pub(crate) weight: Vec<Vector3<f64>>,
    pub(crate) start: Vec<Vector3<f64>>,
}

impl Potential for Gravity {
    fn kind(&self) -> TermKind {
        TermKind::Gravity
    }

    fn add_coupled_pairs(&self, _pairs: &mut Vec<(usize, usize)>) {}

    fn bind(&mut self, _sparsity: &Sparsity) {}

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        -self
            .weight
            .iter()
            .zip(x)
            .zip(&self.start)
            .map(|((w, x), x0)| w.dot(&(x - x0)))
            .sum::<f64>()
    }

    fn add_force(&mut self, _x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for (f, w) in force.iter_mut().zip(&self.weight) {
            *f += w;
        }
    }

    fn add_hessian(
        &mut self,
        _x: &[Vector3<f64>],
        _hessian_modification: f64,
        _hessian: &mut BlockMatrix,
    ) {
    }

    fn add_stiffness_bound(&self, _stiffness: &mut [f64]) {}

    fn add_to_pair_forces(&self, pair_forces: &mut PairForces) -> bool {
        for (push, weight) in pair_forces.constant.iter_mut().zip(&self.weight) {
            *push += weight;
        }
        true
    }
}
