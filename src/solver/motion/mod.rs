//! Motion: methods that step from one time to the next, explicit and implicit, with fixed or chosen steps.
//!
//! m dv/dt = F(x) - c m v (P8), c the drag per mass. All methods move the same [`stepper::State`] and may be asked for a motion
//! ([`trajectory`]) or, with drag, for the shape at rest ([`run`]).

mod balance;
mod bdf2;
mod choose;
mod control;
mod damping;
mod explicit;
mod implicit_euler;
mod incremental;
mod kernel;
mod limit;
mod needs;
mod report;
mod rest;
mod run;
mod stability;
mod stepper;
mod symplectic_euler;
mod trajectory;
mod verlet;

pub(crate) use needs::refuse;
pub(crate) use rest::{Motion, run};

pub use report::{Frame, MotionEnergy, MotionReport, Trajectory};
pub use stability::{StableStep, allowed_step, stable_step};
pub use trajectory::{Start, trajectory};

use super::ask::Method;
use super::system::System;
use seamster_cholesky::OutOfMemory;
use stepper::Stepper;

/// Share of the stability limit that is used where the step is not given.
const SAFETY: f64 = 0.95;

/// What steps are taken with.
#[derive(Clone, Copy, Debug)]
struct Settings {
    /// Drag per mass `C_d / m` \[1/s\].
    drag: f64,
    /// Greatest speed of explicit steps \[m/s\].
    speed_limit: f64,
    /// Residual to which the equations of an implicit step are solved.
    residual: f64,
}

/// The stepper of `method`; `None` if it is not one that steps.
fn stepper(
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
        Method::SymplecticEuler => Box::new(symplectic_euler::SymplecticEuler::new(
            system,
            drag,
            speed_limit,
        )),
        Method::Verlet => Box::new(verlet::Verlet::new(system, drag, speed_limit)),
        Method::ImplicitEuler => {
            Box::new(implicit_euler::ImplicitEuler::new(system, drag, residual)?)
        }
        Method::Bdf2 => Box::new(bdf2::Bdf2::new(system, drag, residual)?),
        Method::Auto | Method::Newton => return Ok(None),
    }))
}
