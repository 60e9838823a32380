//! The equations of an implicit step as a minimum: `Φ(x) = E(x) + w/2 |x - x̂|²_M`,
//! `|y|²_M = sum m_i |y_i|²`.
//!
//! Backward Euler with step h is w = 1/h² and x̂ = x + h v (M. Ortiz, L. Stainier, Comput. Methods
//! Appl. Mech. Engrg. 171, 1999); other backward differences differ in the numbers only. Found by
//! Newton's method: the true second derivative first; where that has no Cholesky factor, with some
//! or all of its indefinite part projected out; and a line search on Φ.
//!
//! # Guarantees
//! Φ never rises, apart from rounding. Ends at the residual asked for, or at that of rounding; says
//! so where it can do neither.
//!
//! # Difference from the minimizer of the shape at rest
//! Memory, inertia and line search are shared ([`crate::solver::optimize`]). The loops differ, and
//! so would the bytes: here the inertia is given and no pseudo-time is adapted, the shares that are
//! projected out are three fixed ones that no iteration remembers, up to 12 shares of a step are
//! tried and not 6, moves are limited beside a body only, friction keeps its anchors within the
//! step, the part of wind without an energy is left out of the step, and the end is a residual, not
//! a caller's test.

use crate::solver::forces::TermKind;
use crate::solver::integrate::integrator::StepError;
use crate::solver::model::system::{STANDARD_GRAVITY, System};
use crate::solver::optimize::line_search::{LineSearch, MAX_DISPLACEMENT};
use crate::solver::optimize::newton_workspace::{NewtonWorkspace, add_inertia};
use nalgebra::Vector3;
use seamster_cholesky::OutOfMemory;

/// Iterations of one step at most; a step that needs more is too long.
const ITERATIONS: usize = 40;
/// Shares of a Newton step that a line search tries at most.
const LINE_SEARCH_TRIALS: usize = 12;
/// Shares of the indefinite part that are projected out, one after the other until there is a
/// factor.
const MODIFICATIONS: [f64; 3] = [0.0, 0.25, 1.0];

/// Operations that a block of second derivatives takes to work out and to sum up.
const ASSEMBLY: f64 = 150.0;

/// The term that is minimized besides the energy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InertiaTerm<'a> {
    /// w \[1/s²\].
    pub(crate) weight: f64,
    /// x̂ \[m\].
    pub(crate) target: &'a [Vector3<f64>],
}

/// Newton's method on Φ; owns all scratch memory.
pub(crate) struct IncrementalNewton {
    work: NewtonWorkspace,
    tolerance: f64,
    /// Iterations so far.
    pub(crate) iterations: u64,
}

impl IncrementalNewton {
    /// Solves to a net force of `tolerance` times the mean weight of a particle, RMS.
    pub(crate) fn new(system: &mut System<'_>, tolerance: f64) -> Result<Self, OutOfMemory> {
        Ok(Self {
            work: NewtonWorkspace::new(system)?,
            tolerance,
            iterations: 0,
        })
    }

    /// Returns the operations of one iteration, counted: assembly, the factor, two solves.
    pub(crate) fn operations(&self) -> f64 {
        ASSEMBLY * self.work.sparsity.block_count() as f64
            + self.work.cholesky.multiply_adds()
            + 4.0 * self.work.cholesky.factor_len() as f64
    }

    /// Returns Φ at `x` \[J\].
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
    pub(crate) fn minimize(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &mut [Vector3<f64>],
    ) -> Result<(), StepError> {
        let floor = rounding_residual(system, inertia_term, x);
        for _ in 0..ITERATIONS {
            self.net_force(system, inertia_term, x);
            let residual = system.residual(&self.work.force);
            if !residual.is_finite() {
                return Err(StepError::NotFinite);
            }
            if residual <= self.tolerance.max(floor) {
                return Ok(());
            }
            self.iterations += 1;
            self.direction(system, inertia_term, x)?;
            if !self.search(system, inertia_term, x) {
                // Where no iteration lowers Φ any more, rounding is all that is left, or nothing
                // is.
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

    /// Computes -dΦ/dx \[N\].
    fn net_force(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &[Vector3<f64>],
    ) {
        system.net_force(x, &mut self.work.force);
        let apart = x.iter().zip(inertia_term.target).zip(&system.mass);
        for (f, ((x, t), m)) in self.work.force.iter_mut().zip(apart) {
            *f -= (x - t) * (m * inertia_term.weight);
        }
        system.zero_fixed(&mut self.work.force);
    }

    /// Solves for the Newton step, by the true second derivative or as much of it as has a factor.
    fn direction(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &[Vector3<f64>],
    ) -> Result<(), StepError> {
        let work = &mut self.work;
        let weight = |mass| mass * inertia_term.weight;
        for modification in MODIFICATIONS {
            system.hessian(x, modification, &mut work.hessian);
            add_inertia(&mut work.hessian, &work.sparsity, &system.mass, weight);
            system.constrain(&work.sparsity, &mut work.hessian);
            let factor = work.cholesky.factorize(&work.hessian.blocks);
            if factor.is_ok() {
                work.solve();
                return Ok(());
            }
        }
        Err(StepError::NotConverged)
    }

    /// Moves `x` along the step as far as Φ allows; returns false if it allows nothing.
    fn search(
        &mut self,
        system: &mut System<'_>,
        inertia_term: &InertiaTerm<'_>,
        x: &mut [Vector3<f64>],
    ) -> bool {
        let value = Self::potential(system, inertia_term, x);
        let slope = self.work.slope();
        let longest = self.work.max_displacement();
        if !(slope > 0.0 && longest.is_finite()) {
            return false;
        }
        let search = LineSearch {
            value,
            slope,
            // The model is Φ's own, and its minimum is the whole step.
            curvature: slope,
            first_share: if system.has(TermKind::Contact) {
                (MAX_DISPLACEMENT / longest).min(1.0)
            } else {
                1.0
            },
            trials: LINE_SEARCH_TRIALS,
        };
        let along = (&self.work.step[..], &mut self.work.trial[..]);
        let mut potential = |x: &[Vector3<f64>]| Self::potential(system, inertia_term, x);
        search.run(x, along, &mut potential).is_some()
    }
}

/// Returns the residual below which forces and inertia are rounding.
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
