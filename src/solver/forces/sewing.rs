//! The seam force F = -k l of the paper (P8): springs of rest length zero between the two points of
//! each stitch.

use crate::solver::forces::{PairForce, PairForces, Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Springs of rest length zero, all of one stiffness \[N/m\].
pub(crate) struct SewingForce {
    stitches: Vec<(usize, usize)>,
    stiffness: f64,
    slots: Vec<[Slot; 3]>,
}

impl SewingForce {
    pub(crate) fn new(stitches: Vec<(usize, usize)>, stiffness: f64) -> Self {
        Self {
            stitches,
            stiffness,
            slots: Vec::new(),
        }
    }
}

impl Potential for SewingForce {
    fn kind(&self) -> TermKind {
        TermKind::Seam
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        pairs.extend(&self.stitches);
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        self.slots = self
            .stitches
            .iter()
            .map(|&(a, b)| {
                [
                    sparsity.slot(a, a),
                    sparsity.slot(b, b),
                    sparsity.slot(a, b),
                ]
            })
            .collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        0.5 * self.stiffness
            * self
                .stitches
                .iter()
                .map(|&(a, b)| (x[a] - x[b]).norm_squared())
                .sum::<f64>()
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for &(a, b) in &self.stitches {
            let f = (x[b] - x[a]) * self.stiffness;
            force[a] += f;
            force[b] -= f;
        }
    }

    fn add_hessian(
        &mut self,
        _x: &[Vector3<f64>],
        _hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        // A central spring of rest length 0, without its rounding: n nᵀ + (I - n nᵀ) is not I to
        // the last bit.
        let block = Matrix3::identity() * self.stiffness;
        for &[aa, bb, ab] in &self.slots {
            hessian.add(aa, &block);
            hessian.add(bb, &block);
            hessian.add(ab, &-block);
        }
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        for &(a, b) in &self.stitches {
            stiffness[a] += 2.0 * self.stiffness;
            stiffness[b] += 2.0 * self.stiffness;
        }
    }
    fn add_to_pair_forces(&self, pair_forces: &mut PairForces) -> bool {
        pair_forces
            .pairs
            .extend(self.stitches.iter().map(|&(a, b)| PairForce {
                a,
                b,
                stiffness: self.stiffness,
                stiffness_times_rest: 0.0,
            }));
        true
    }
}
