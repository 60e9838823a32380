//! The equations of an implicit step as a minimum: `Φ(x) = E(x) + w/2 |x - x̂|²_M`, `|y|²_M = sum m_i |y_i|²`.
//!
//! Backward Euler with step h is w = 1/h² and x̂ = x + h v (J. C. Simo et al.; M. Ortiz, L. Stainier, Comput. Methods Appl.
//! Mech. Engrg. 171, 1999); other backward differences differ in the numbers only. Found by Newton's method: the true second
//! derivative first; where that has no Cholesky factor, with some or all left out that may make it indefinite; and a line search
//! on Φ (Armijo).
//!
//! # Guarantees
//! Φ never rises, apart from rounding. Ends at the residual asked for, or at that of rounding; says so where it can do neither.

use crate::solver::integrate::integrator::StepError;
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use crate::solver::linalg::cholesky::BlockCholesky;
use crate::solver::model::system::{STANDARD_GRAVITY, System};
use nalgebra::{Matrix3, Vector3};
use seamster_cholesky::OutOfMemory;

/// Iterations of one step at most; a step that needs more is too long.
const ITERATIONS: usize = 40;
/// Share of the decrease that the slope promises which an iteration must bring (Armijo).
const SUFFICIENT: f64 = 1e-4;
/// Halvings of an iteration at most.
const HALVINGS: usize = 12;
/// Shares of what may make the second derivative indefinite that are left out, one after the other until it has a factor.
const CONVEXITIES: [f64; 3] = [0.0, 0.25, 1.0];
/// Furthest that a particle is moved at once where there is a body that it could pass through \[m\].
const LARGEST_MOVE: f64 = 0.04;

/// Operations that a block of second derivatives takes to work out and to sum up.
const ASSEMBLY: f64 = 150.0;

/// What is to be minimised besides the energy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InertiaTerm<'a> {
    /// w \[1/s²\].
    pub(crate) weight: f64,
    /// x̂ \[m\].
    pub(crate) target: &'a [Vector3<f64>],
}

/// Newton's method on Φ; owns all scratch memory.
pub(crate) struct IncrementalPotential {
    sparsity: Sparsity,
    hessian: BlockMatrix,
    cholesky: BlockCholesky,
    force: Vec<Vector3<f64>>,
    step: Vec<Vector3<f64>>,
    trial: Vec<Vector3<f64>>,
    tolerance: f64,
    /// Iterations so far.
    pub(crate) iterations: u64,
}

impl IncrementalPotential {
    /// Solves to a net force of `tolerance` times the mean weight of a particle, RMS.
    pub(crate) fn new(system: &mut System<'_>, tolerance: f64) -> Result<Self, OutOfMemory> {
        let sparsity = system.bind();
        let count = system.particle_count();
        Ok(Self {
            hessian: BlockMatrix::zeros(&sparsity),
            cholesky: BlockCholesky::new(&sparsity)?,
            sparsity,
            force: vec![Vector3::zeros(); count],
            step: vec![Vector3::zeros(); count],
            trial: vec![Vector3::zeros(); count],
            tolerance,
            iterations: 0,
        })
    }

    /// Operations of one iteration, counted: assembly, the factor from its length, two solves.
    ///
    /// The columns of a factor of length L with n columns have L / n numbers on average, and their squares, which are the
    /// operations, add up to at least L²/n; for plane meshes ordered by minimum degree to about three times that.
    pub(crate) fn operations(&self) -> f64 {
        let length = self.cholesky.factor_len() as f64;
        let columns = 3.0 * self.force.len() as f64;
        ASSEMBLY * self.sparsity.block_count() as f64
            + 3.0 * length * length / columns
            + 4.0 * length
    }

    /// Φ \[J\].
    pub(crate) fn potential(
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &[Vector3<f64>],
    ) -> f64 {
        let apart = x.iter().zip(inertia_term.target).zip(&system.mass);
        let square: f64 = apart.map(|((x, t), m)| m * (x - t).norm_squared()).sum();
        system.energy(x) + 0.5 * inertia_term.weight * square
    }

    /// Moves `x` from a guess to the minimum.
    pub(crate) fn minimise(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &mut [Vector3<f64>],
    ) -> Result<(), StepError> {
        let floor = rounding_residual(system, inertia_term, x);
        for _ in 0..ITERATIONS {
            self.net_force(system, inertia_term, x);
            let residual = system.residual(&self.force);
            if !residual.is_finite() {
                return Err(StepError::NotFinite);
            }
            if residual <= self.tolerance.max(floor) {
                return Ok(());
            }
            self.iterations += 1;
            self.direction(system, inertia_term, x)?;
            if !self.search(system, inertia_term, x) {
                // Where no iteration lowers Φ any more, rounding is all that is left, or nothing is.
                let near = residual <= 100.0 * floor;
                return if near {
                    Ok(())
                } else {
                    Err(StepError::NotConverged)
                };
            }
        }
        Err(StepError::NotConverged)
    }

    /// -dΦ/dx \[N\].
    fn net_force(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &[Vector3<f64>],
    ) {
        system.net_force(x, &mut self.force);
        let apart = x.iter().zip(inertia_term.target).zip(&system.mass);
        for (f, ((x, t), m)) in self.force.iter_mut().zip(apart) {
            *f -= (x - t) * (m * inertia_term.weight);
        }
        system.hold_still(&mut self.force);
    }

    /// Newton's step, from the true second derivative or as much of it as has a factor.
    fn direction(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &[Vector3<f64>],
    ) -> Result<(), StepError> {
        for convexity in CONVEXITIES {
            system.hessian(x, convexity, &mut self.hessian);
            for (i, m) in system.mass.iter().enumerate() {
                let inertia = Matrix3::identity() * (m * inertia_term.weight);
                self.hessian
                    .add_diagonal(self.sparsity.diagonal(i), &inertia);
            }
            system.hold(&self.sparsity, &mut self.hessian);
            let factor = self.cholesky.factorise(&self.sparsity, &self.hessian);
            if factor.is_ok() {
                self.step.copy_from_slice(&self.force);
                self.cholesky.solve(&mut self.step);
                return Ok(());
            }
        }
        Err(StepError::NotConverged)
    }

    /// Walks along the step as far as Φ allows; whether it could.
    fn search(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &mut [Vector3<f64>],
    ) -> bool {
        let before = Self::potential(system, inertia_term, x);
        let pairs = self.step.iter().zip(&self.force);
        let slope: f64 = pairs.map(|(d, f)| d.dot(f)).sum();
        let longest = self.step.iter().map(Vector3::norm).fold(0.0, f64::max);
        if !(slope > 0.0 && longest.is_finite()) {
            return false;
        }
        let mut share = if system.contact.is_some() {
            (LARGEST_MOVE / longest).min(1.0)
        } else {
            1.0
        };
        // Differences of Φ below this are rounding: the model is trusted instead.
        let rounding = 64.0 * f64::EPSILON * before.abs() * (x.len() as f64).sqrt();
        for _ in 0..HALVINGS {
            for ((t, x), d) in self.trial.iter_mut().zip(x.iter()).zip(&self.step) {
                *t = x + d * share;
            }
            let gained = before - Self::potential(system, inertia_term, &self.trial);
            if gained >= SUFFICIENT * share * slope - rounding {
                x.copy_from_slice(&self.trial);
                return true;
            }
            share *= 0.5;
        }
        false
    }
}

/// The residual below which forces and inertia are rounding.
fn rounding_residual(
    system: &mut System<'_>,
    inertia_term: &InertiaTerm<'_>,
    x: &[Vector3<f64>],
) -> f64 {
    let count = x.len() as f64;
    let weight = system.mass.iter().sum::<f64>() * STANDARD_GRAVITY / count;
    let inertia: f64 = x
        .iter()
        .zip(&system.mass)
        .map(|(x, m)| (m * inertia_term.weight * f64::EPSILON * x.norm()).powi(2))
        .sum();
    2.0 * (system.residual_floor(x) + (inertia / count).sqrt() / weight)
}
