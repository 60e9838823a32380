//! Which method `auto` is: Verlet or BDF2, whichever takes fewer operations by a count. No clock is asked, so the choice is the
//! same on every machine.
//!
//! Both are of order 2. For a motion with acceleration g and frequency ω the third derivative of position is about g ω, so the
//! step that meets the tolerance is h = √(tolerance / (C g ω)), C = 1/6 for Verlet and 2/9 for BDF2. Verlet's is also bounded by
//! stability. ω is the slowest swing of the cloth ([`crate::solver::integrate::damping`]).

use crate::solver::integrate::integrator::Integrator;
use crate::solver::integrate::select::integrator_for;
use crate::solver::integrate::settings::{IntegratorSettings, SAFETY};
use crate::solver::model::system::{STANDARD_GRAVITY, System};
use crate::solver::options::Method;
use nalgebra::Vector3;

/// What the choice goes by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MethodCriteria {
    /// The step asked for \[s\].
    pub(crate) step: Option<f64>,
    /// Error allowed over the time that it is made in \[m/s\].
    pub(crate) tolerance: f64,
    /// Slowest swing of the cloth \[rad/s\].
    pub(crate) swing: f64,
}

/// The method, and why.
pub(crate) fn choose_method(
    system: &mut System<'_>,
    x: &[Vector3<f64>],
    settings: &IntegratorSettings,
    criteria: &MethodCriteria,
) -> (Method, String) {
    let Ok(Some(mut verlet)) = integrator_for(system, Method::Verlet, settings) else {
        return (Method::Bdf2, "Verlet could not be set up".to_owned());
    };
    let stable = verlet.stable_step(system, x);
    if let Some(step) = criteria.step.filter(|&step| step > stable) {
        let why = format!("the step of {step:.2e} s is above Verlet's limit of {stable:.2e} s");
        return (Method::Bdf2, why);
    }
    let Ok(Some(bdf2)) = integrator_for(system, Method::Bdf2, settings) else {
        return (
            Method::Verlet,
            "there is no memory for BDF2's matrix factor".to_owned(),
        );
    };
    let follows = |constant: f64| {
        let jerk = STANDARD_GRAVITY * criteria.swing;
        (criteria.tolerance / (constant * jerk)).sqrt()
    };
    let explicit = criteria
        .step
        .unwrap_or((SAFETY * stable).min(follows(1.0 / 6.0)));
    let implicit = criteria.step.unwrap_or(follows(2.0 / 9.0));
    let cost = |integrator: &dyn Integrator, h: f64| integrator.operations() / h;
    let (explicit_cost, implicit_cost) = (
        cost(verlet.as_ref(), explicit),
        cost(bdf2.as_ref(), implicit),
    );
    let why = format!(
        "counted: {explicit_cost:.1e} operations a simulated second in steps of {explicit:.1e} s by verlet, {implicit_cost:.1e} in steps of {implicit:.1e} s by bdf2"
    );
    if explicit_cost <= implicit_cost {
        (Method::Verlet, why)
    } else {
        (Method::Bdf2, why)
    }
}
