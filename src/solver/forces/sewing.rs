//! The seam force F = -k l of the paper (P8): springs of rest length zero between the two points of
//! each stitch, which pull with a limited force where they are long.
//!
//! Beyond the length at which a spring reaches its greatest force its energy grows linearly (P. J.
//! Huber, "Robust estimation of a location parameter", Annals of Mathematical Statistics 35(1),
//! 1964). Its second derivative there is taken as that of a spring which pulls as hard: an upper
//! bound, so that a Newton step moves the two points onto each other and never raises the energy.

use crate::solver::forces::{PairForce, PairForces, Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Springs of rest length zero, all of one stiffness \[N/m\].
pub(crate) struct SewingForce {
    stitches: Vec<(usize, usize)>,
    stiffness: f64,
    /// Greatest force of a spring \[N\].
    max_force: f64,
    slots: Vec<[Slot; 3]>,
}

impl SewingForce {
    pub(crate) fn new(stitches: Vec<(usize, usize)>, stiffness: f64) -> Self {
        Self {
            stitches,
            stiffness,
            max_force: f64::INFINITY,
            slots: Vec::new(),
        }
    }

    /// Returns the same springs that pull no harder than `max_force` \[N\].
    pub(crate) fn with_max_force(self, max_force: f64) -> Self {
        Self { max_force, ..self }
    }

    /// Returns the stiffness of a spring of rest length zero that pulls as hard as this one does
    /// at a length \[N/m\].
    fn secant(&self, length: f64) -> f64 {
        if self.is_limited(length) {
            self.max_force / length
        } else {
            self.stiffness
        }
    }

    fn is_limited(&self, length: f64) -> bool {
        self.stiffness * length > self.max_force
    }

    fn energy_at(&self, length: f64) -> f64 {
        if self.is_limited(length) {
            self.max_force * (length - 0.5 * self.max_force / self.stiffness)
        } else {
            0.5 * self.stiffness * length * length
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
        let lengths = self.stitches.iter().map(|&(a, b)| (x[a] - x[b]).norm());
        lengths.map(|length| self.energy_at(length)).sum()
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for &(a, b) in &self.stitches {
            let way = x[b] - x[a];
            let f = way * self.secant(way.norm());
            force[a] += f;
            force[b] -= f;
        }
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        _hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        for (&(a, b), &[aa, bb, ab]) in self.stitches.iter().zip(&self.slots) {
            // Without the rounding of a spring's: n nᵀ + (I - n nᵀ) is not I to the last bit.
            let block = Matrix3::identity() * self.secant((x[b] - x[a]).norm());
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
