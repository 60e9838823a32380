//! Linear springs on mesh edges: the membrane of the paper (P8).

use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::central::CentralSpring;
use crate::solver::forces::{PairForce, PairForces, Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::Vector3;

/// A linear spring: energy k/2 (|xa - xb| - rest)².
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spring {
    pub(crate) a: usize,
    pub(crate) b: usize,
    /// \[m\]
    pub(crate) rest_length: f64,
    /// \[N/m\]
    pub(crate) stiffness: f64,
}

impl Spring {
    fn law(&self) -> CentralSpring {
        CentralSpring {
            stiffness: self.stiffness,
            rest_length: self.rest_length,
        }
    }
}

/// Springs, all of the same law.
pub(crate) struct SpringForce {
    springs: Vec<Spring>,
    slots: Vec<Slot>,
    diagonals: Vec<usize>,
    active: ActiveElements,
}

impl SpringForce {
    pub(crate) fn new(springs: Vec<Spring>) -> Self {
        Self {
            springs,
            slots: Vec::new(),
            diagonals: Vec::new(),
            active: ActiveElements::default(),
        }
    }
}

impl Potential for SpringForce {
    fn kind(&self) -> TermKind {
        TermKind::Stretch
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        pairs.extend(self.springs.iter().map(|s| (s.a, s.b)));
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        self.slots = self
            .springs
            .iter()
            .map(|s| sparsity.slot(s.a, s.b))
            .collect();
        self.diagonals = (0..sparsity.particle_count())
            .map(|i| sparsity.diagonal(i))
            .collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.active.for_each(self.springs.len(), |k| {
            let s = &self.springs[k];
            sum += s.law().energy(&(x[s.a] - x[s.b]));
        });
        sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.active.for_each(self.springs.len(), |k| {
            let s = &self.springs[k];
            if let Some(f) = s.law().tension(&(x[s.b] - x[s.a])) {
                force[s.a] += f;
                force[s.b] -= f;
            }
        });
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        self.active.for_each(self.springs.len(), |k| {
            let (s, slot) = (&self.springs[k], self.slots[k]);
            let d = x[s.b] - x[s.a];
            if let Some(block) = s.law().hessian(&d, hessian_modification) {
                hessian.add_diagonal(self.diagonals[s.a], &block);
                hessian.add_diagonal(self.diagonals[s.b], &block);
                hessian.add(slot, &-block);
            }
        });
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        let springs = &self.springs;
        let has_one = |k: usize, moving: &[bool]| moving[springs[k].a] || moving[springs[k].b];
        self.active.narrow(moving, springs.len(), has_one);
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        for s in &self.springs {
            stiffness[s.a] += 2.0 * s.stiffness;
            stiffness[s.b] += 2.0 * s.stiffness;
        }
    }
    fn add_to_pair_forces(&self, pair_forces: &mut PairForces) -> bool {
        pair_forces
            .pairs
            .extend(self.springs.iter().map(|s| PairForce {
                a: s.a,
                b: s.b,
                stiffness: s.stiffness,
                stiffness_times_rest: s.stiffness * s.rest_length,
            }));
        true
    }
}
