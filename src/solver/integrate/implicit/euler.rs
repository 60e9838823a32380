//! Implicit (backward) Euler: order 1, stable at any step, loses energy.
//!
//! V' = V + h (F(X') / m - c V'), X' = X + h V'. Put together, X' minimizes
//! `E(x) + w/2 |x - x̂|²_M` with w = (1 + c h) / h² and x̂ = X + h V / (1 + c h). The iteration
//! begins at X or at x̂, whichever is lower, and only goes down; so, without drag,
//! `E(X') + |X' - x̂|²_M / 2h² <= E(X) + |V|²_M / 2`: what the step begins with.

use crate::solver::integrate::implicit::incremental_potential::{IncrementalNewton, InertiaTerm};
use crate::solver::integrate::integrator::{Integrator, ParticleState, StepError, accept};
use crate::solver::model::system::System;
use nalgebra::Vector3;
use seamster_cholesky::OutOfMemory;

/// Newton iterations that a step takes where the step follows the motion.
pub(crate) const NEWTON_ITERATIONS_PER_STEP: f64 = 3.0;

/// Implicit Euler.
pub(crate) struct ImplicitEuler {
    newton: IncrementalNewton,
    pub(crate) drag: f64,
    /// x̂ \[m\].
    pub(crate) target: Vec<Vector3<f64>>,
    /// Positions after the step \[m\].
    pub(crate) next: Vec<Vector3<f64>>,
}

impl ImplicitEuler {
    /// Makes the method with drag per mass `drag` \[1/s\], solved to `tolerance` (a residual,
    /// dimensionless).
    pub(crate) fn new(
        system: &mut System<'_>,
        drag: f64,
        tolerance: f64,
    ) -> Result<Self, OutOfMemory> {
        let zero = vec![Vector3::zeros(); system.particle_count()];
        Ok(Self {
            newton: IncrementalNewton::new(system, tolerance)?,
            drag,
            target: zero.clone(),
            next: zero,
        })
    }

    /// Returns the operations of one Newton iteration.
    pub(crate) fn operations(&self) -> f64 {
        self.newton.operations()
    }

    /// Minimizes `E + weight/2 |x - target|²_M` into `next`, from the lower of `x` and `target`.
    pub(crate) fn solve(
        &mut self,
        system: &mut System<'_>,
        weight: f64,
        x: &[Vector3<f64>],
    ) -> Result<(), StepError> {
        let inertia_term = InertiaTerm {
            weight,
            target: &self.target,
        };
        let stay = IncrementalNewton::potential(system, &inertia_term, x);
        let go = IncrementalNewton::potential(system, &inertia_term, &self.target);
        let guess = if go < stay { &self.target[..] } else { x };
        self.next.copy_from_slice(guess);
        self.newton.minimize(system, &inertia_term, &mut self.next)
    }

    /// Takes one step; returns its error over its length \[m/s, RMS\].
    fn step(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        h: f64,
    ) -> Result<f64, StepError> {
        accept(system, state);
        let dragged = 1.0 + self.drag * h;
        system.zero_fixed(&mut state.v);
        for ((target, x), v) in self.target.iter_mut().zip(&state.x).zip(&state.v) {
            *target = x + v * (h / dragged);
        }
        self.solve(system, dragged / (h * h), &state.x)?;
        let mut square = 0.0;
        for ((x, v), next) in state.x.iter_mut().zip(&mut state.v).zip(&self.next) {
            let after = (next - *x) / h;
            square += (after - *v).norm_squared();
            (*x, *v) = (*next, after);
        }
        state.time += h;
        Ok(0.5 * (square / state.x.len().max(1) as f64).sqrt())
    }
}

impl Integrator for ImplicitEuler {
    fn order(&self) -> i32 {
        1
    }

    fn block(&self) -> u64 {
        1
    }

    /// Against the exact solution, whose positions move by the mean of both velocities, a step
    /// moves them by h/2 |ΔV| too far.
    fn advance(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        h: f64,
        count: u64,
    ) -> Result<f64, StepError> {
        let mut error = 0.0_f64;
        for _ in 0..count {
            error = error.max(self.step(system, state, h)?);
        }
        Ok(error)
    }

    fn operations(&self) -> f64 {
        NEWTON_ITERATIONS_PER_STEP * self.operations()
    }

    fn newton_iterations(&self) -> u64 {
        self.newton.iterations
    }
}
