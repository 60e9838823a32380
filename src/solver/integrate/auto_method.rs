//! The automatic choice of method: Verlet or BDF2, whichever takes fewer operations by a count. No
//! clock is asked, so the choice is the same on every machine.
//!
//! Both are of order 2. For a motion with acceleration g and frequency ω the third derivative of
//! position is about g ω, so the step that meets the tolerance is h = √(tolerance / (C g ω)), C =
//! 1/6 for Verlet and 2/9 for BDF2. Verlet's is also bounded by stability. ω is the fundamental
//! frequency of the cloth ([`crate::solver::integrate::damping`]).

use crate::solver::integrate::integrator::Integrator;
use crate::solver::integrate::outcome::{MethodReason, StepCost};
use crate::solver::integrate::select::integrator_for;
use crate::solver::integrate::settings::{IntegratorSettings, SAFETY};
use crate::solver::model::system::{STANDARD_GRAVITY, System};
use crate::solver::options::Method;
use nalgebra::Vector3;

/// Constant C of Verlet and of BDF2.
const VERLET_ERROR: f64 = 1.0 / 6.0;
const BDF2_ERROR: f64 = 2.0 / 9.0;

/// Criteria of the choice.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MethodCriteria {
    /// The step asked for \[s\].
    pub(crate) step: Option<f64>,
    /// Error allowed over the time that it is made in \[m/s\].
    pub(crate) tolerance: f64,
    /// Fundamental frequency of the cloth \[rad/s\].
    pub(crate) frequency: f64,
}

impl MethodCriteria {
    /// Returns the step of a method with the error constant `constant` that meets the tolerance
    /// \[s\].
    fn accurate_step(&self, constant: f64) -> f64 {
        let jerk = STANDARD_GRAVITY * self.frequency;
        (self.tolerance / (constant * jerk)).sqrt()
    }
}

/// Returns the cheaper method for a motion from `x`, and the reason.
pub(crate) fn choose_method(
    system: &mut System<'_>,
    x: &[Vector3<f64>],
    settings: &IntegratorSettings,
    criteria: &MethodCriteria,
) -> (Method, MethodReason) {
    let Ok(Some(mut verlet)) = integrator_for(system, Method::Verlet, settings) else {
        return (Method::Bdf2, MethodReason::NoVerlet);
    };
    let limit_s = verlet.stable_step(system, x);
    if let Some(step_s) = criteria.step.filter(|&step| step > limit_s) {
        let reason = MethodReason::StepAboveLimit { step_s, limit_s };
        return (Method::Bdf2, reason);
    }
    let Ok(Some(bdf2)) = integrator_for(system, Method::Bdf2, settings) else {
        return (Method::Verlet, MethodReason::NoMemory);
    };
    let explicit = (SAFETY * limit_s).min(criteria.accurate_step(VERLET_ERROR));
    let implicit = criteria.accurate_step(BDF2_ERROR);
    let verlet = step_cost(verlet.as_ref(), criteria.step.unwrap_or(explicit));
    let bdf2 = step_cost(bdf2.as_ref(), criteria.step.unwrap_or(implicit));
    let method = if verlet.operations <= bdf2.operations {
        Method::Verlet
    } else {
        Method::Bdf2
    };
    (method, MethodReason::Counted { verlet, bdf2 })
}

/// Returns the cost of steps of `step_s` \[s\].
fn step_cost(integrator: &dyn Integrator, step_s: f64) -> StepCost {
    StepCost {
        operations: integrator.operations() / step_s,
        step_s,
    }
}
