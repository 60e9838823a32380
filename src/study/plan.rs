//! The plan of a study: the settings and the meshes that it varies.

use super::report::StudyMesh;
use crate::scene::Scene;
use crate::solver::{Drape, Method, SolverOptions};
use nalgebra::Vector3;

/// The settings that a study varies, on scenes that are assembled already.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyPlan {
    /// Options that all runs have in common: analysis, membrane, seams, duration, frame rate, the
    /// time limit of one run.
    pub simulate: SolverOptions,
    /// Methods.
    pub methods: Vec<Method>,
    /// Tolerances, as [`super::StudyRequest::tolerances`].
    pub tolerances: Vec<f64>,
    /// Fixed steps of a motion, as [`super::StudyRequest::steps_s`] \[s\].
    pub steps_s: Vec<f64>,
    /// CPU time of the whole \[s\].
    pub time_limit_s: Option<f64>,
}

impl StudyPlan {
    /// Returns the time between two frames of a motion \[s\].
    pub(super) fn frame_s(&self) -> f64 {
        1.0 / self.simulate.frame_rate_hz.unwrap_or(30.0)
    }
}

/// One mesh of the garment under study.
#[derive(Clone, Debug)]
pub struct StudyScene {
    /// Length of its mesh edges \[m\].
    pub edge_length_m: f64,
    /// The scene.
    pub scene: Scene,
}

/// The results on one mesh besides its runs.
pub(super) struct MeshResult {
    pub(super) mesh: StudyMesh,
    /// The shapes by which meshes are compared: the rest shape, or frames of the motion \[m\].
    pub(super) shapes: Vec<Vec<Vector3<f64>>>,
    /// A shape at rest, to disturb.
    pub(super) rest: Option<Drape>,
}

/// The setting that is varied from run to run of one method.
#[derive(Clone, Copy, Debug)]
pub(super) enum RunSetting {
    /// A fixed step \[s\].
    Step(f64),
    /// A tolerance, as [`super::StudyRequest::tolerances`].
    Tolerance(f64),
}
