//! Time integration: methods that step from one time to the next, explicit and implicit, with fixed
//! or chosen steps.
//!
//! m dv/dt = F(x) - c m v (P8), c the drag per mass. Every method moves an
//! [`integrator::ParticleState`] and serves for a motion ([`trajectory()`]) or, with drag, for the
//! shape at rest ([`dynamic_relaxation`]).

pub(crate) mod auto_method;
pub(crate) mod damping;
pub(crate) mod dynamic_relaxation;
pub(crate) mod energy_monitor;
pub(crate) mod explicit;
pub(crate) mod implicit;
pub(crate) mod integrator;
pub(crate) mod outcome;
pub(crate) mod report;
pub(crate) mod select;
pub(crate) mod settings;
pub(crate) mod simulation;
pub(crate) mod stability;
pub(crate) mod step_control;
pub(crate) mod trajectory;

pub use crate::solver::integrate::report::{Frame, MotionEnergy, MotionReport, Trajectory};
pub use crate::solver::integrate::stability::trial::{StableStep, allowed_step, stable_step};
pub use crate::solver::integrate::trajectory::{Start, trajectory};
