//! A motion and its report.

use crate::solver::report::schema::{Energy, TermTime};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A motion: frames at even times, and what is known about them.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// The first one is the start.
    pub frames: Vec<Frame>,
    /// Counts, limits and errors by which to trust them.
    pub report: MotionReport,
    /// True if it was stopped by the cancel token.
    pub canceled: bool,
}

/// The cloth at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// \[s\]
    pub time_s: f64,
    /// Position of each vertex \[m\]; `#V`.
    pub positions: Vec<Vector3<f64>>,
    /// Velocity of each vertex \[m/s\]; `#V`.
    pub velocities: Vec<Vector3<f64>>,
    /// Energy then.
    pub energy: MotionEnergy,
}

/// Energy at one time \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct MotionEnergy {
    /// Of motion.
    pub kinetic: f64,
    /// Of position, by term.
    pub potential: Energy,
}

impl MotionEnergy {
    /// All of it.
    pub fn total(&self) -> f64 {
        let p = &self.potential;
        self.kinetic + p.stretch + p.bend + p.gravity + p.seam + p.contact
    }
}

/// Report by which to trust a motion.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct MotionReport {
    /// True if all of the time asked for was simulated.
    pub complete: bool,
    /// True if every step was below the stability limit, which is updated as the cloth moves.
    pub within_limits: bool,
    /// Reason why it ended, in words.
    pub why: String,
    /// The method that was used, and how it was chosen.
    pub method: String,
    /// Reason for that method, if it was chosen automatically.
    pub method_because: Option<String>,
    /// Time simulated \[s\].
    pub simulated_s: f64,
    /// Steps taken.
    pub steps: u64,
    /// Steps taken back because their error was above the tolerance or their equations were not
    /// solved.
    pub rejected: u64,
    /// Shortest step \[s\].
    pub step_min_s: f64,
    /// Longest step \[s\].
    pub step_max_s: f64,
    /// The longest stable step at the start \[s\]; none for implicit methods.
    pub stability_limit_s: Option<f64>,
    /// Bytes of the arrays that an explicit step reads or writes, each counted once; 0 for an
    /// implicit one.
    pub step_bytes: u64,
    /// Estimated local errors of position of all steps, added up \[m, RMS\].
    pub local_errors_m: f64,
    /// Drag force over mass and velocity \[1/s\].
    pub drag_1_s: f64,
    /// Newton iterations of all steps.
    pub newton_iterations: u64,
    /// The terms that ran.
    pub terms: Vec<TermTime>,
    /// CPU time \[s\].
    pub cpu_s: f64,
}
