//! Explicit steps by a given rule: the fused kernel computes all terms that are pair forces, the
//! terms themselves the others.

use crate::solver::forces::{PairForces, TermKind};
use crate::solver::integrate::explicit::kernel::{Kernel, StepRule};
use crate::solver::integrate::integrator::{ParticleState, accept};
use crate::solver::model::system::System;
use nalgebra::Vector3;

/// Operations of a force outside the kernel, for each pair of particles that it couples.
const OPERATIONS_PER_PAIR: f64 = 40.0;
/// Operations of contact, for each particle.
const OPERATIONS_PER_CONTACT: f64 = 60.0;

/// The kernel of a system, and the forces that are not in it.
pub(crate) struct ExplicitStepper {
    kernel: Kernel,
    /// True for each term that the kernel computes.
    in_kernel: Vec<bool>,
    /// True if there are other forces.
    more: bool,
    more_operations: f64,
    force: Vec<Vector3<f64>>,
    /// Velocity before the last step taken \[m/s\].
    pub(crate) v_before: Vec<Vector3<f64>>,
}

impl ExplicitStepper {
    pub(crate) fn new(system: &System<'_>) -> Self {
        let count = system.particle_count();
        let mut pair_forces = PairForces::new(count);
        let in_kernel: Vec<bool> = system
            .terms
            .iter()
            .map(|term| term.potential.add_to_pair_forces(&mut pair_forces))
            .collect();
        let more = in_kernel.contains(&false);
        let mut pairs = Vec::new();
        for (term, _) in system.terms.iter().zip(&in_kernel).filter(|(_, k)| !**k) {
            term.potential.add_coupled_pairs(&mut pairs);
        }
        let touching = if system.has(TermKind::Contact) {
            count
        } else {
            0
        };
        let more_operations =
            OPERATIONS_PER_PAIR * pairs.len() as f64 + OPERATIONS_PER_CONTACT * touching as f64;
        Self {
            more_operations,
            kernel: Kernel::new(system, &pair_forces, more),
            in_kernel,
            more,
            force: vec![Vector3::zeros(); count],
            v_before: vec![Vector3::zeros(); count],
        }
    }

    /// Returns the operations of one step, those of the terms that are not in the kernel by the
    /// pairs of particles that they couple.
    pub(crate) fn operations(&self) -> f64 {
        self.kernel.operations() + self.more_operations
    }

    /// Returns the bytes of the arrays of the kernel.
    pub(crate) fn bytes(&self) -> u64 {
        self.kernel.bytes() as u64
    }

    /// Takes `count` steps by `rule`.
    pub(crate) fn run(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        rule: StepRule,
        count: u64,
    ) {
        let began = (system.clock)();
        let mut elsewhere = 0.0;
        self.kernel.load(&state.x, &state.v);
        for step in 0..count {
            if step + 1 == count {
                self.kernel.velocities(&mut self.v_before);
            }
            if self.more {
                let before = (system.clock)();
                self.kernel.positions(&mut state.x);
                self.kernel.velocities(&mut state.v);
                self.other_forces(system, state);
                elsewhere += (system.clock)() - before;
                self.kernel.set_push(&self.force);
            }
            self.kernel.step(rule);
            state.time += rule.h;
        }
        self.kernel.positions(&mut state.x);
        self.kernel.velocities(&mut state.v);
        let spent = (system.clock)() - began - elsewhere;
        // The pass is one: its time is that of the first term in it.
        let first = system.terms.iter_mut().zip(&self.in_kernel);
        if let Some((term, _)) = first.into_iter().find(|(_, in_kernel)| **in_kernel) {
            term.cpu_s += spent;
        }
    }

    /// Computes the forces outside the kernel.
    fn other_forces(&mut self, system: &mut System<'_>, state: &ParticleState) {
        self.force.fill(Vector3::zeros());
        accept(system, state);
        system.add_forces_except(&self.in_kernel, &state.x, &mut self.force);
    }
}
