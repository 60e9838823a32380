//! The hold of cloth on its places while seams close.
//!
//! Stitches alone leave a garment free to slide down the body and to turn about it, and what pulls
//! unevenly, a band that is sewn on from one side, turns it. Each particle is held against moves
//! along the plane that its cloth stands in at the start, weakly, and is free toward the body; what
//! carries the garment, once it is sewn, firmly and every way (`model/holds.rs`).

use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Hold of one particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ParticleHold {
    /// Place that it is held at \[m\].
    pub(crate) place: Vector3<f64>,
    /// Direction in which it is free, of length 1; 0 if there is none.
    pub(crate) free: Vector3<f64>,
    /// Stiffness against moves across that direction \[N/m\].
    pub(crate) stiffness: f64,
}

impl ParticleHold {
    fn block(&self) -> Matrix3<f64> {
        (Matrix3::identity() - self.free * self.free.transpose()) * self.stiffness
    }

    /// Returns the move across the free direction \[m\].
    fn offset(&self, x: &Vector3<f64>) -> Vector3<f64> {
        let moved = x - self.place;
        moved - self.free * self.free.dot(&moved)
    }
}

/// Springs that hold particles at their places, all of them.
pub(crate) struct Hold {
    holds: Vec<ParticleHold>,
    diagonals: Vec<usize>,
    active: ActiveElements,
}

impl Hold {
    /// Returns the hold of all particles; `#P`.
    pub(crate) fn new(holds: Vec<ParticleHold>) -> Self {
        Self {
            holds,
            diagonals: vec![],
            active: ActiveElements::default(),
        }
    }
}

impl Potential for Hold {
    /// A part of sewing.
    fn kind(&self) -> TermKind {
        TermKind::Seam
    }

    fn add_coupled_pairs(&self, _pairs: &mut Vec<(usize, usize)>) {}

    fn bind(&mut self, sparsity: &Sparsity) {
        let particles = 0..sparsity.particle_count();
        self.diagonals = particles.map(|i| sparsity.diagonal(i)).collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.active.for_each(x.len(), |i| {
            let hold = &self.holds[i];
            sum += 0.5 * hold.stiffness * hold.offset(&x[i]).norm_squared();
        });
        sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.active.for_each(x.len(), |i| {
            let hold = &self.holds[i];
            force[i] -= hold.offset(&x[i]) * hold.stiffness;
        });
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        _hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        self.active.for_each(x.len(), |i| {
            hessian.add_diagonal(self.diagonals[i], &self.holds[i].block());
        });
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        let count = self.holds.len();
        self.active.narrow(moving, count, |i, moving| moving[i]);
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        for (sum, hold) in stiffness.iter_mut().zip(&self.holds) {
            *sum += hold.stiffness;
        }
    }
}
