//! The paper's method (P8): V += (F / m - c V) h, then X += V h. Order 1; keeps angular momentum.

use crate::solver::integrate::explicit::kernel::StepRule;
use crate::solver::integrate::explicit::stepper::ExplicitStepper;
use crate::solver::integrate::integrator::{Integrator, ParticleState, StepError};
use crate::solver::integrate::stability::limit;
use crate::solver::model::system::System;
use crate::solver::report::measure::rms;
use nalgebra::Vector3;

/// Steps taken at once.
const BLOCK: u64 = 100;

/// Symplectic Euler, the paper's method.
pub(crate) struct SymplecticEuler {
    explicit: ExplicitStepper,
    drag: f64,
    speed_limit: f64,
}

impl SymplecticEuler {
    /// Makes the method with drag per mass `drag` \[1/s\] and no speed above `speed_limit` \[m/s\].
    pub(crate) fn new(system: &System<'_>, drag: f64, speed_limit: f64) -> Self {
        Self {
            explicit: ExplicitStepper::new(system),
            drag,
            speed_limit,
        }
    }
}

impl Integrator for SymplecticEuler {
    fn order(&self) -> i32 {
        1
    }

    fn block(&self) -> u64 {
        BLOCK
    }

    fn step_bytes(&self) -> u64 {
        self.explicit.bytes()
    }

    fn operations(&self) -> f64 {
        self.explicit.operations()
    }

    fn stable_step(&mut self, system: &mut System<'_>, x: &[Vector3<f64>]) -> f64 {
        limit::symplectic_euler(limit::max_eigenvalue(system, x), self.drag)
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
        let rule = StepRule {
            keep: 1.0 - self.drag * h,
            gain: h,
            h,
            speed_limit: self.speed_limit,
        };
        self.explicit.run(system, state, rule, count);
        let before = &self.explicit.v_before;
        let error = 0.5 * rms(before.len(), |i| state.v[i] - before[i]);
        error
            .is_finite()
            .then_some(error)
            .ok_or(StepError::NotFinite)
    }
}
