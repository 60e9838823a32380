//! Second-order backward differences (BDF2) for steps of unlike length: order 2, stable at any
//! step, loses little energy.
//!
//! C. F. Curtiss, J. O. Hirschfelder, Proc. Nat. Acad. Sci. 38, 1952; for variable steps E. Hairer,
//! S. P. Nørsett, G. Wanner, "Solving Ordinary Differential Equations I", III.5. With r the step
//! over the one before it and γ = (1 + r) / (1 + 2r), for y = X and y = V
//! `y' = (1 + r)² / (1 + 2r) y - r² / (1 + 2r) y₋ + γ h f(y')`.
//! Put together, X' minimizes `E(x) + w/2 |x - x̂|²_M` with H = γ h,
//! w = (1 + c H) / H², x̂ = x̃ + H ṽ / (1 + c H), x̃ and ṽ the sums of what is known. It is
//! zero-stable for r < 1 + √2; the controller at most doubles a step.
//!
//! The first step has nothing before it: it is one of implicit Euler, whose local error, of order
//! h², is made once.

use crate::solver::integrate::implicit::euler::{ImplicitEuler, NEWTON_ITERATIONS_PER_STEP};
use crate::solver::integrate::integrator::{Integrator, ParticleState, StepError, accept};
use crate::solver::model::system::System;
use nalgebra::Vector3;
use seamster_cholesky::OutOfMemory;

/// Longest step over the one before it: twice, and rounding. Beyond, the formula would not be
/// stable for long.
const LARGEST_RATIO: f64 = 2.0 + 1e-9;

/// BDF2 with variable steps.
pub(crate) struct Bdf2 {
    /// The first step's method, whose matrices serve every step.
    euler: ImplicitEuler,
    /// The state before the last accepted step, and that step \[s\].
    before: Option<(ParticleState, f64)>,
}

impl Bdf2 {
    /// Makes the method with drag per mass `drag` \[1/s\], solved to `tolerance` (a residual,
    /// dimensionless).
    pub(crate) fn new(
        system: &mut System<'_>,
        drag: f64,
        tolerance: f64,
    ) -> Result<Self, OutOfMemory> {
        Ok(Self {
            euler: ImplicitEuler::new(system, drag, tolerance)?,
            before: None,
        })
    }
}

/// Coefficients for a step `ratio` times as long as the one before it.
struct Bdf2Formula {
    /// Weight of the current state; the one before it has 1 less this.
    now: f64,
    gamma: f64,
}

impl Bdf2Formula {
    fn new(ratio: f64) -> Self {
        let sum = 1.0 + 2.0 * ratio;
        Self {
            now: (1.0 + ratio).powi(2) / sum,
            gamma: (1.0 + ratio) / sum,
        }
    }

    /// Returns the weighted sum of the two states.
    fn known(&self, now: &Vector3<f64>, before: &Vector3<f64>) -> Vector3<f64> {
        // The two weights add up to 1: written as a difference, what is large in both is rounded
        // once.
        now + (now - before) * (self.now - 1.0)
    }
}

impl Integrator for Bdf2 {
    fn order(&self) -> i32 {
        2
    }

    fn block(&self) -> u64 {
        1
    }

    /// The formula misses (1 + r)² / (6 r (1 + 2r)) h³ x‴; x‴ is the second divided difference of
    /// the velocities.
    fn advance(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        h: f64,
        _count: u64,
    ) -> Result<f64, StepError> {
        let Some((before, h_before)) = &self.before else {
            return self.euler.advance(system, state, h, 1);
        };
        let ratio = h / h_before;
        if ratio > LARGEST_RATIO {
            return self.euler.advance(system, state, h, 1);
        }
        accept(system, state);
        let formula = Bdf2Formula::new(ratio);
        let reach = formula.gamma * h;
        let dragged = 1.0 + self.euler.drag * reach;
        let pairs = state.x.iter().zip(&before.x);
        let motions = state.v.iter().zip(&before.v);
        for (target, ((x, x0), (v, v0))) in self.euler.target.iter_mut().zip(pairs.zip(motions)) {
            *target = formula.known(x, x0) + formula.known(v, v0) * (reach / dragged);
        }
        self.euler
            .solve(system, dragged / (reach * reach), &state.x)?;
        let mut square = 0.0;
        for (i, next) in self.euler.next.iter().enumerate() {
            let v = (next - formula.known(&state.x[i], &before.x[i])) / reach;
            let (last, first) = ((v - state.v[i]) / h, (state.v[i] - before.v[i]) / *h_before);
            square += ((last - first) * (2.0 / (h + h_before))).norm_squared();
            (state.x[i], state.v[i]) = (*next, v);
        }
        state.time += h;
        let constant = (1.0 + ratio).powi(2) / (6.0 * ratio * (1.0 + 2.0 * ratio));
        let third = (square / state.x.len().max(1) as f64).sqrt();
        Ok(constant * h * h * third)
    }

    fn accept(&mut self, before: &ParticleState, h: f64) {
        match &mut self.before {
            Some((kept, h_before)) => {
                kept.copy_from(before);
                *h_before = h;
            }
            None => self.before = Some((before.clone(), h)),
        }
    }

    fn operations(&self) -> f64 {
        NEWTON_ITERATIONS_PER_STEP * self.euler.operations()
    }

    fn newton_iterations(&self) -> u64 {
        self.euler.newton_iterations()
    }
}
