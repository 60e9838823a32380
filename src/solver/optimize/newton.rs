//! The shape at rest by pseudo-transient Newton iteration.
//!
//! Each iteration minimizes a quadratic model of the energy plus a proximal term (implicit Euler
//! with the velocity forgotten; see [`crate::solver::optimize::pseudo_transient`]).
//!
//! # Fallbacks
//! The true second derivative first. Where that has no Cholesky factor, a share of its indefinite
//! part is projected out, doubled until there is a factor; a diagonal shift where projecting out
//! all of it does not do. A line search on the energy accepts or shortens the step, and no particle
//! moves further than 4 cm at once. Before it judges one, the few particles whose forces the step
//! got wrong move on alone ([`crate::solver::optimize::local_elimination`]).
//!
//! # Guarantees
//! Apart from friction, whose normal forces are lagged, and wind, which has no energy, the energy
//! never rises. Stops at the residual asked for, at the round-off floor, at the limit of iterations
//! or time, or when canceled, and says which.

use crate::solver::forces::TermKind;
use crate::solver::linalg::block_matrix::BlockMatrix;
use crate::solver::linalg::nonsymmetric::NonsymmetricSolver;
use crate::solver::model::system::System;
use crate::solver::optimize::eliminated_energy::EliminatedEnergy;
use crate::solver::optimize::iterate::{Callback, Iterate, Termination};
use crate::solver::optimize::line_search::{LineSearch, MAX_DISPLACEMENT};
use crate::solver::optimize::local_elimination::{GlobalStep, LocalElimination};
use crate::solver::optimize::newton_workspace::{NewtonWorkspace, add_inertia};
use crate::solver::optimize::pseudo_transient::{FIRST_GAMMA, PseudoTransient};
use crate::solver::report::measure::rms;
use nalgebra::Vector3;
use seamster_cholesky::OutOfMemory;
use std::ops::ControlFlow;

/// Shares of a step that a line search tries at most.
const LINE_SEARCH_TRIALS: usize = 6;
/// Largest share of the proximal term in the curvature along a step whose length still is the
/// distance to the solution.
const PROXIMAL_SHARE: f64 = 0.1;

/// Steepness at the end of a step over that at its start from which on it was too short.
const SHORT: f64 = 0.25;

/// Fallbacks that were taken, the true second derivative among them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Fallbacks {
    /// The second derivative as it is.
    pub(crate) true_hessian: bool,
    /// Part or all of the indefinite part projected out.
    pub(crate) projected_hessian: bool,
    /// A shift of the diagonal as well.
    pub(crate) diagonal_shift: bool,
    /// A step that no line search could shorten enough, taken anew with a smaller γ.
    pub(crate) smaller_step: bool,
}

/// Newton's method on one system; owns all scratch memory.
pub(crate) struct Newton {
    work: NewtonWorkspace,
    /// The second derivative with the proximal term.
    shifted: BlockMatrix,
    /// Solver for forces that have no energy.
    nonsymmetric: Option<NonsymmetricSolver>,
    pseudo_transient: PseudoTransient,
    elimination: LocalElimination,
    /// Share of the indefinite part that is projected out of the last factor; 0 if that is the
    /// factor of the true second derivative.
    modification: f64,
    touching: Vec<bool>,
    /// Length of the last full step \[m, RMS\], if it is that to the solution.
    estimate: Option<f64>,
    pub(crate) fallbacks: Fallbacks,
    /// Steps taken.
    pub(crate) iterations: usize,
    /// True if the last step left the particles in contact as they were, and none of them slipped.
    pub(crate) contact_settled: bool,
}

impl Newton {
    /// Lays out the matrices of `system`, for a start with the pseudo-time `first_gamma` \[s\].
    ///
    /// # Errors
    /// [`OutOfMemory`] if there is none for the factor.
    pub(crate) fn new(system: &mut System<'_>, first_gamma: f64) -> Result<Self, OutOfMemory> {
        let work = NewtonWorkspace::new(system)?;
        Ok(Self {
            shifted: BlockMatrix::zeros(&work.sparsity),
            nonsymmetric: (!system.is_conservative()).then(NonsymmetricSolver::default),
            elimination: LocalElimination::new(&work.sparsity),
            modification: 0.0,
            work,
            pseudo_transient: PseudoTransient::new(first_gamma),
            iterations: 0,
            touching: Vec::new(),
            estimate: None,
            fallbacks: Fallbacks::default(),
            contact_settled: true,
        })
    }

    /// Lays out the matrices anew, for couplings that have come.
    fn lay_out(&mut self, system: &mut System<'_>) -> Result<(), OutOfMemory> {
        self.work.lay_out(system)?;
        self.shifted = BlockMatrix::zeros(&self.work.sparsity);
        self.elimination.lay_out(&self.work.sparsity);
        Ok(())
    }

    /// Iterates from `x` until `callback` breaks, at most `limit` times. `x` is always the last
    /// accepted shape.
    pub(crate) fn run(
        &mut self,
        system: &mut System<'_>,
        x: &mut [Vector3<f64>],
        limit: usize,
        callback: &mut Callback<'_>,
    ) -> Termination {
        for number in 0..limit {
            let slipped = system.accept(x);
            if system.has_outgrown() && self.lay_out(system).is_err() {
                return Termination::OutOfMemory;
            }
            self.contact_settled = !slipped;
            if system.has(TermKind::Contact) {
                let touching = system.touching(x);
                self.contact_settled &= touching == self.touching;
                self.touching = touching;
            }
            system.net_force(x, &mut self.work.force);
            let residual = system.residual(&self.work.force);
            if !residual.is_finite() {
                return Termination::NotFinite;
            }
            let flow = callback(Iterate {
                number,
                residual,
                positions: x,
                convex: self.is_convex(),
                contact_settled: self.contact_settled,
                estimate_before: self.estimate.take(),
            });
            if let ControlFlow::Break(termination) = flow {
                return termination;
            }
            self.iterations += 1;
            if !self.advance(system, x) {
                return Termination::Stalled;
            }
        }
        Termination::IterationLimit
    }

    /// Returns true if the true second derivative had a factor in the last step.
    pub(crate) fn is_convex(&self) -> bool {
        self.modification == 0.0
    }

    /// Returns ‖H⁻¹ f‖ over the particles \[m, RMS\], the distance to the solution of this mesh;
    /// none if H is not positive definite.
    pub(crate) fn error_estimate(
        &mut self,
        system: &mut System<'_>,
        x: &[Vector3<f64>],
    ) -> Option<f64> {
        let work = &mut self.work;
        system.net_force(x, &mut work.force);
        system.hessian(x, 0.0, &mut work.hessian);
        system.constrain(&work.sparsity, &mut work.hessian);
        work.cholesky.factorize(&work.hessian.blocks).ok()?;
        self.solve(system, x);
        Some(rms(x.len(), |i| self.work.step[i]))
    }

    /// Takes one step; returns false if there is none that lowers the energy.
    fn advance(&mut self, system: &mut System<'_>, x: &mut [Vector3<f64>]) -> bool {
        let energy = system.energy(x);
        let (mut failed, mut retreated) = (false, false);
        self.assemble(system, x);
        while !self.pseudo_transient.is_exhausted() {
            if !self.factorize(system) {
                failed = true;
                self.make_definite(system, x);
                continue;
            }
            self.modification = self.pseudo_transient.modification;
            let is_true = self.is_convex();
            self.fallbacks.true_hessian |= is_true;
            if !retreated {
                self.pseudo_transient.modify_less(failed);
            }
            let found = self.search(system, x, energy);
            self.estimate = self.estimate.filter(|_| is_true);
            if found {
                return true;
            }
            if retreated || self.modification == 1.0 {
                self.fallbacks.smaller_step = true;
                self.pseudo_transient.gamma *= 0.1;
            } else {
                // γ grows back by steps, so that shrinking it costs many: once all of the
                // indefinite part is projected out instead.
                retreated = true;
                self.fallbacks.projected_hessian = true;
                self.pseudo_transient.modification = 1.0;
                self.assemble(system, x);
            }
        }
        self.pseudo_transient.gamma = FIRST_GAMMA;
        false
    }

    /// Computes the second derivative at `x`, less what is projected out.
    fn assemble(&mut self, system: &mut System<'_>, x: &[Vector3<f64>]) {
        let modification = self.pseudo_transient.modification;
        system.hessian(x, modification, &mut self.work.hessian);
    }

    /// Projects out more of the second derivative, or shifts it further where all is projected out.
    fn make_definite(&mut self, system: &mut System<'_>, x: &[Vector3<f64>]) {
        if self.pseudo_transient.modify_more() {
            self.fallbacks.projected_hessian = true;
            self.assemble(system, x);
        } else {
            self.fallbacks.diagonal_shift = true;
            self.pseudo_transient.gamma *= 0.25;
        }
    }

    /// Factorizes H + M / γ²; returns false if that is not positive definite.
    fn factorize(&mut self, system: &System<'_>) -> bool {
        let (work, gamma) = (&mut self.work, self.pseudo_transient.gamma);
        self.shifted.blocks.copy_from_slice(&work.hessian.blocks);
        let weight = |mass| mass / (gamma * gamma);
        add_inertia(&mut self.shifted, &work.sparsity, &system.mass, weight);
        system.constrain(&work.sparsity, &mut self.shifted);
        work.cholesky.factorize(&self.shifted.blocks).is_ok()
    }

    /// Solves for the step from `x` by the last factor.
    fn solve(&mut self, system: &System<'_>, x: &[Vector3<f64>]) {
        self.work.solve();
        if let Some(nonsymmetric) = &mut self.nonsymmetric {
            let NewtonWorkspace {
                cholesky,
                force,
                step,
                ..
            } = &mut self.work;
            let mut solve = |right: &mut [Vector3<f64>]| cholesky.solve(right);
            let mut apply = |d: &[Vector3<f64>], out: &mut [Vector3<f64>]| {
                system.antisymmetric_product(x, d, out);
            };
            nonsymmetric.correct(force, step, &mut solve, &mut apply);
        }
    }

    /// Solves for the step and moves `x` along it as far as the energy allows; returns false if it
    /// allows nothing.
    fn search(&mut self, system: &mut System<'_>, x: &mut [Vector3<f64>], energy: f64) -> bool {
        self.solve(system, x);
        let longest = self.work.max_displacement();
        if !longest.is_finite() {
            return false;
        }
        let curvature = self
            .work
            .hessian
            .quadratic_form(&self.work.sparsity, &self.work.step);
        self.estimate = (self.proximal(system) <= PROXIMAL_SHARE * curvature)
            .then(|| rms(x.len(), |i| self.work.step[i]));
        let search = LineSearch {
            value: energy,
            slope: self.work.slope(),
            curvature,
            first_share: (MAX_DISPLACEMENT / longest).min(1.0),
            trials: LINE_SEARCH_TRIALS,
        };
        let work = &mut self.work;
        let mut energy = EliminatedEnergy {
            system,
            elimination: &mut self.elimination,
            global: GlobalStep {
                sparsity: &work.sparsity,
                cholesky: &work.cholesky,
                force: &work.force,
                touching: &self.touching,
                share: search.first_share,
                modification: self.modification,
                gamma: self.pseudo_transient.gamma,
            },
            step: &work.step,
            search,
        };
        let along = (&work.step[..], &mut work.trial[..]);
        let Some(accepted) = search.run(x, along, &mut energy) else {
            return false;
        };
        if let Some(decrease) = accepted.decrease {
            let predicted = search.predicted(accepted.share);
            self.pseudo_transient
                .adapt(accepted.share, decrease, predicted);
        } else if accepted.share >= 1.0 && accepted.steepness > SHORT {
            // The energy tells nothing any more, but the step was too short.
            self.pseudo_transient.lengthen();
        }
        true
    }

    /// Returns what the proximal term adds to the curvature along the step.
    fn proximal(&self, system: &System<'_>) -> f64 {
        let gamma = self.pseudo_transient.gamma;
        let moved = self.work.step.iter().zip(&system.mass);
        moved.map(|(d, m)| m * d.norm_squared()).sum::<f64>() / (gamma * gamma)
    }
}
