//! From a [`crate::scene::Scene`] to a [`Drape`] or a [`Trajectory`], each with a report that says
//! how far to trust it.
//!
//! - `options`, `context`: what is asked for, and what may be used for it. `outcome`, `statistics`:
//!   what comes back, typed.
//! - `model`: the particles and force terms of a scene; `forces`: the terms, a file each; `linalg`:
//!   sparse matrices.
//! - `optimize`: Newton's method for a shape at rest; `integrate`: steps in time.
//! - `drape`: the shape at rest, level by level; `report`: its measures, and every sentence of its
//!   report.

mod context;
mod drape;
mod forces;
mod integrate;
#[cfg(test)]
mod left_out;
mod linalg;
mod model;
mod optimize;
mod options;
mod outcome;
mod report;
mod statistics;

pub use crate::solver::context::Context;
pub use crate::solver::drape::multilevel::{drape, drape_from, drape_on};
pub use crate::solver::forces::contact::kept_distance;
pub use crate::solver::forces::friction_anchors::FrictionAnchors;
pub use crate::solver::integrate::{
    Frame, MotionEnergy, MotionReport, StableStep, Start, Trajectory, allowed_step, stable_step,
    trajectory,
};
pub use crate::solver::model::build::springs;
pub(crate) use crate::solver::model::rest_shape::{cut_triangles, vertex_areas};
pub use crate::solver::options::{Analysis, MembraneModel, Method, SeamClose, SolverOptions};
pub use crate::solver::outcome::Drape;
pub use crate::solver::report::contact_force::{contact_force, contact_pressure};
pub(crate) use crate::solver::report::measure::metric;
pub use crate::solver::report::measure::rms_distance;
pub use crate::solver::report::schema::{
    Advice, CpuSeconds, DrapeReport, Energy, ErrorPoint, Intersection, IntersectionKind,
    LevelReport, MapPart, MapSummary, Plan, Shortcoming, SkippedTerm, StartedFrom, Support,
    SupportOpening, TermTime, Verdict,
};
