//! The shape at rest by pseudo-transient Newton iteration.
//!
//! Each iteration minimises a quadratic model of the energy plus a proximal term M / (2 γ²) `|x - x_n|²` (implicit Euler with
//! the velocity forgotten; C. T. Kelley, D. E. Keyes, "Convergence analysis of pseudo-transient continuation", SIAM J.
//! Numer. Anal. 35(2), 1998). γ grows while the model predicts well and shrinks where it does not.
//!
//! # Ladder
//! The true second derivative first. Where that has no Cholesky factor, a share of what may make it indefinite is left out,
//! doubled until there is a factor; a diagonal shift where leaving out all of it does not do. A line search on the energy
//! accepts or shortens the step, and no particle moves further than 4 cm at once.
//!
//! # Guarantees
//! Apart from friction, whose normal forces are lagged, and wind, which has no energy, the energy never rises. Stops at the
//! residual asked for, at the round-off floor, at the limit of iterations or time, or when canceled, and says which.

use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use crate::solver::linalg::cholesky::BlockCholesky;
use crate::solver::linalg::nonsymmetric::SkewSolver;
use crate::solver::model::system::System;
use crate::solver::optimize::iterate::{Callback, Iterate, Termination};
use crate::solver::report::measure::rms;
use nalgebra::{Matrix3, Vector3};
use seamster_cholesky::OutOfMemory;
use std::ops::ControlFlow;

/// Furthest that a particle moves in one iteration \[m\]; much more would carry cloth through a body.
const LARGEST_MOVE: f64 = 0.04;
/// γ at the start \[s\]: about the time in which seams close.
pub(crate) const FIRST_GAMMA: f64 = 0.01;
/// γ at the start from a shape near the solution \[s\]: slow enough for a garment's sway.
pub(crate) const NEAR_GAMMA: f64 = 1.0;
/// γ beyond which the proximal term is lost in rounding \[s\].
const LARGEST_GAMMA: f64 = 1e4;
const SMALLEST_GAMMA: f64 = 1e-7;
/// Share of the decrease that the slope promises which a step must bring (Armijo).
const SUFFICIENT: f64 = 1e-4;
/// Share of the indefinite part that is left out at least after a step that went too far.
const BACKTRACK_CONVEXITY: f64 = 0.4;
/// Smallest share of the indefinite part that is left out, if any is.
const LEAST_CONVEXITY: f64 = 0.02;
/// Largest share of the proximal term in the curvature along a step whose length still is the distance to the solution.
const PROXIMAL_SHARE: f64 = 0.1;

/// Which fallbacks of the ladder were taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Fallbacks {
    pub(crate) true_hessian: bool,
    pub(crate) projected_hessian: bool,
    pub(crate) diagonal_shift: bool,
    pub(crate) smaller_step: bool,
}

/// Newton's method on one system; owns all scratch memory.
pub(crate) struct Newton {
    sparsity: Sparsity,
    hessian: BlockMatrix,
    shifted: BlockMatrix,
    cholesky: BlockCholesky,
    /// For forces that have no energy.
    skew: Option<SkewSolver>,
    force: Vec<Vector3<f64>>,
    step: Vec<Vector3<f64>>,
    trial: Vec<Vector3<f64>>,
    gamma: f64,
    convexity: f64,
    /// Whether the last factor was that of the true second derivative.
    was_convex: bool,
    touching: Vec<bool>,
    /// Length of the last full step \[m, RMS\], if it is that to the solution.
    estimate: Option<f64>,
    pub(crate) fallbacks: Fallbacks,
    /// Steps taken.
    pub(crate) iterations: usize,
    /// Whether the last step left the particles in contact as they were, and none of them slipped.
    pub(crate) contact_settled: bool,
}

impl Newton {
    /// Lays out the matrices of `system`.
    pub(crate) fn new(system: &mut System<'_>, first_gamma: f64) -> Result<Self, OutOfMemory> {
        let sparsity = system.bind();
        let count = system.particle_count();
        Ok(Self {
            hessian: BlockMatrix::zeros(&sparsity),
            shifted: BlockMatrix::zeros(&sparsity),
            cholesky: BlockCholesky::new(&sparsity)?,
            skew: system.is_skew().then(SkewSolver::default),
            sparsity,
            force: vec![Vector3::zeros(); count],
            step: vec![Vector3::zeros(); count],
            trial: vec![Vector3::zeros(); count],
            gamma: first_gamma,
            iterations: 0,
            convexity: 0.0,
            was_convex: true,
            touching: Vec::new(),
            estimate: None,
            fallbacks: Fallbacks::default(),
            contact_settled: true,
        })
    }

    /// Iterates from `x` until `callback` says so, at most `limit` times. `x` is always the last accepted shape.
    pub(crate) fn run(
        &mut self,
        system: &mut System<'_>,
        x: &mut [Vector3<f64>],
        limit: usize,
        callback: &mut Callback<'_>,
    ) -> Termination {
        for number in 0..limit {
            let slipped = system.accept(x);
            if let Some(contact) = &mut system.contact {
                let touching = contact.touching(x);
                self.contact_settled = !slipped && touching == self.touching;
                self.touching = touching;
            }
            system.net_force(x, &mut self.force);
            let residual = system.residual(&self.force);
            if !residual.is_finite() {
                return Termination::NotFinite;
            }
            let flow = callback(Iterate {
                number,
                residual,
                positions: x,
                convex: self.was_convex,
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

    /// Whether the second derivative had a factor in the last step.
    pub(crate) fn is_convex(&self) -> bool {
        self.was_convex
    }

    /// ‖H⁻¹ f‖ over the particles \[m, RMS\], with whether H is positive definite: the distance to the solution of this mesh.
    pub(crate) fn error_estimate(
        &mut self,
        system: &mut System<'_>,
        x: &[Vector3<f64>],
    ) -> Option<f64> {
        system.net_force(x, &mut self.force);
        system.hessian(x, 0.0, &mut self.hessian);
        system.hold(&self.sparsity, &mut self.hessian);
        self.cholesky
            .factorise(&self.sparsity, &self.hessian)
            .ok()?;
        self.solve(system, x);
        Some(rms(x.len(), |i| self.step[i]))
    }

    /// One step; false if there is none that lowers the energy.
    fn advance(&mut self, system: &mut System<'_>, x: &mut [Vector3<f64>]) -> bool {
        let energy = system.energy(x);
        let mut failed = false;
        system.hessian(x, self.convexity, &mut self.hessian);
        while self.gamma > SMALLEST_GAMMA {
            if !self.factorise(system) {
                failed = true;
                if self.convexity < 1.0 {
                    self.fallbacks.projected_hessian = true;
                    self.convexity = (2.0 * self.convexity).clamp(LEAST_CONVEXITY, 1.0);
                    system.hessian(x, self.convexity, &mut self.hessian);
                } else {
                    self.fallbacks.diagonal_shift = true;
                    self.gamma *= 0.25;
                }
                continue;
            }
            let is_true = self.convexity == 0.0;
            self.fallbacks.true_hessian |= is_true;
            self.was_convex = is_true;
            self.convexity *= if failed { 0.9 } else { 0.5 };
            if self.convexity < LEAST_CONVEXITY {
                self.convexity = 0.0;
            }
            let found = self.search(system, x, energy);
            self.estimate = self.estimate.filter(|_| is_true);
            if found {
                return true;
            }
            self.fallbacks.smaller_step = true;
            self.gamma *= 0.1;
        }
        self.gamma = FIRST_GAMMA;
        false
    }

    /// Factors H + M / γ².
    fn factorise(&mut self, system: &System<'_>) -> bool {
        self.shifted.blocks.copy_from_slice(&self.hessian.blocks);
        for (i, mass) in system.mass.iter().enumerate() {
            self.shifted.add_diagonal(
                self.sparsity.diagonal(i),
                &(Matrix3::identity() * (mass / (self.gamma * self.gamma))),
            );
        }
        system.hold(&self.sparsity, &mut self.shifted);
        self.cholesky
            .factorise(&self.sparsity, &self.shifted)
            .is_ok()
    }

    /// The step from `x` by the last factor.
    fn solve(&mut self, system: &System<'_>, x: &[Vector3<f64>]) {
        self.step.copy_from_slice(&self.force);
        self.cholesky.solve(&mut self.step);
        if let Some(skew) = &mut self.skew {
            let cholesky = &mut self.cholesky;
            let mut solve = |right: &mut [Vector3<f64>]| cholesky.solve(right);
            let mut apply = |d: &[Vector3<f64>], out: &mut [Vector3<f64>]| system.skew(x, d, out);
            skew.correct(&self.force, &mut self.step, &mut solve, &mut apply);
        }
    }

    /// Solves for the step and walks along it as far as the energy allows.
    fn search(&mut self, system: &mut System<'_>, x: &mut [Vector3<f64>], energy: f64) -> bool {
        self.solve(system, x);
        let longest = self
            .step
            .iter()
            .map(Vector3::norm_squared)
            .fold(0.0, f64::max)
            .sqrt();
        if !longest.is_finite() {
            return false;
        }
        let slope: f64 = self
            .step
            .iter()
            .zip(&self.force)
            .map(|(d, f)| d.dot(f))
            .sum();
        let curvature = self.hessian.quadratic_form(&self.sparsity, &self.step);
        self.estimate = (self.proximal(system) <= PROXIMAL_SHARE * curvature)
            .then(|| rms(x.len(), |i| self.step[i]));
        let mut share = (LARGEST_MOVE / longest).min(1.0);
        // Differences of energy below this are rounding: the model is trusted instead.
        let rounding = 64.0 * f64::EPSILON * energy.abs() * (x.len() as f64).sqrt();
        for _ in 0..6 {
            for ((t, x), d) in self.trial.iter_mut().zip(x.iter()).zip(&self.step) {
                *t = x + d * share;
            }
            let predicted = share * slope - 0.5 * share * share * curvature;
            let gained = energy - system.energy(&self.trial);
            if gained >= SUFFICIENT * share * slope - rounding {
                x.copy_from_slice(&self.trial);
                self.adapt(share, gained, predicted.max(rounding));
                return true;
            }
            share *= 0.5;
        }
        false
    }

    /// What the proximal term adds to the curvature along the step.
    fn proximal(&self, system: &System<'_>) -> f64 {
        let moved = self.step.iter().zip(&system.mass);
        moved.map(|(d, m)| m * d.norm_squared()).sum::<f64>() / (self.gamma * self.gamma)
    }

    /// γ grows where the model foretold the energy well. Where only a share of the step could be taken, the model was too soft
    /// along some wrinkle that is about to form: leaving out more of what makes it soft shortens the next step there, while a
    /// smaller γ would shorten it everywhere.
    fn adapt(&mut self, share: f64, gained: f64, predicted: f64) {
        let gamma = if share < 1.0 {
            self.convexity = (2.0 * self.convexity).clamp(BACKTRACK_CONVEXITY, 1.0);
            0.7 * self.gamma
        } else if gained > 0.75 * predicted {
            3.0 * self.gamma
        } else if gained > 0.25 * predicted {
            1.5 * self.gamma
        } else {
            0.7 * self.gamma
        };
        self.gamma = gamma.clamp(SMALLEST_GAMMA * 10.0, LARGEST_GAMMA);
    }
}
