//! Motion: methods that step from one time to the next, explicit and implicit, with fixed or chosen steps.
//!
//! m dv/dt = F(x) - c m v (P8), c the drag per mass. All methods move the same [`stepper::State`] and may be asked for a motion
//! ([`trajectory`]) or, with drag, for the shape at rest ([`run`]).

pub(crate) mod choose;
pub(crate) mod damping;
pub(crate) mod energy_monitor;
pub(crate) mod explicit;
pub(crate) mod implicit;
pub(crate) mod integrator;
pub(crate) mod limit;
pub(crate) mod needs;
pub(crate) mod report;
pub(crate) mod rest;
pub(crate) mod run;
pub(crate) mod stability;
pub(crate) mod step_control;
pub(crate) mod trajectory;

pub(crate) use crate::solver::integrate::needs::refuse;
pub(crate) use crate::solver::integrate::rest::{Motion, run};

pub use crate::solver::integrate::report::{Frame, MotionEnergy, MotionReport, Trajectory};
pub use crate::solver::integrate::stability::{StableStep, allowed_step, stable_step};
pub use crate::solver::integrate::trajectory::{Start, trajectory};

use crate::solver::integrate::integrator::Stepper;
use crate::solver::model::system::System;
use crate::solver::options::Method;
use seamster_cholesky::OutOfMemory;

/// Share of the stability limit that is used where the step is not given.
pub(crate) const SAFETY: f64 = 0.95;

/// What steps are taken with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    /// Drag per mass `C_d / m` \[1/s\].
    pub(crate) drag: f64,
    /// Greatest speed of explicit steps \[m/s\].
    pub(crate) speed_limit: f64,
    /// Residual to which the equations of an implicit step are solved.
    pub(crate) residual: f64,
}

/// The stepper of `method`; `None` if it is not one that steps.
pub(crate) fn stepper(
    system: &mut System<'_>,
    method: Method,
    settings: &Settings,
) -> Result<Option<Box<dyn Stepper>>, OutOfMemory> {
    let Settings {
        drag,
        speed_limit,
        residual,
    } = *settings;
    Ok(Some(match method {
        Method::SymplecticEuler => Box::new(explicit::symplectic_euler::SymplecticEuler::new(
            system,
            drag,
            speed_limit,
        )),
        Method::Verlet => Box::new(explicit::verlet::Verlet::new(system, drag, speed_limit)),
        Method::ImplicitEuler => {
            Box::new(implicit::euler::ImplicitEuler::new(system, drag, residual)?)
        }
        Method::Bdf2 => Box::new(implicit::bdf2::Bdf2::new(system, drag, residual)?),
        Method::Auto | Method::Newton => return Ok(None),
    }))
}
