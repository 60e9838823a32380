//! From a [`crate::scene::Scene`] to a [`Drape`]: sews and drapes, and says how far to trust the shape.

mod drape;
mod forces;
mod integrate;
#[cfg(test)]
mod left_out;
mod linalg;
mod model;
mod optimize;
mod options;
mod report;

pub use crate::solver::drape::multilevel::{drape, drape_on};
pub use crate::solver::forces::contact::{FrictionAnchors, contact_force, contact_pressure};
pub use crate::solver::integrate::{
    Frame, MotionEnergy, MotionReport, StableStep, Start, Trajectory, allowed_step, stable_step,
    trajectory,
};
pub use crate::solver::model::build::{kept_distance, springs};
pub use crate::solver::options::{Analysis, MembraneModel, Method, SeamClose, SolverOptions};
pub use crate::solver::report::measure::rms_distance;
pub use crate::solver::report::schema::{
    Advice, CpuSeconds, DrapeReport, Energy, ErrorPoint, LevelReport, Plan, SkippedTerm, Support,
    TermTime,
};

use crate::config::Limits;
use crate::progress::{CancelToken, Progress};
use nalgebra::Vector3;

/// The settled shape, and what is known about it.
#[derive(Clone, Debug)]
pub struct Drape {
    /// Position of each vertex \[m\]; `#V`. The best shape so far where it did not converge.
    pub positions: Vec<Vector3<f64>>,
    /// Where friction holds it.
    pub anchors: FrictionAnchors,
    /// How far to trust it.
    pub report: DrapeReport,
    /// Whether it was stopped by the cancel token.
    pub canceled: bool,
}

impl Drape {
    /// A shape \[m; `#V`\] of which nothing else is known.
    pub fn of_shape(positions: &[Vector3<f64>]) -> Self {
        Self {
            positions: positions.to_vec(),
            anchors: FrictionAnchors::default(),
            report: DrapeReport::default(),
            canceled: false,
        }
    }
}

/// What a computation may use of the world outside.
pub struct Context<'a> {
    /// CPU seconds used so far by the caller's thread: the only clock.
    pub cpu_s: &'a dyn Fn() -> f64,
    /// Polled every iteration.
    pub cancel: &'a CancelToken,
    /// Told of every iteration.
    pub progress: &'a mut dyn FnMut(Progress),
    /// Bounds on the work.
    pub limits: &'a Limits,
}
