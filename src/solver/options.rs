//! Options of the solver: which analysis, by which model and method, how finely and for how long.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Stiffness of a stitch while sewing if none is asked for \[N/m\]: about that of the cloth beside
/// it.
const SEWING_STIFFNESS: f64 = 1e4;
/// Ratio of the stiffness of the spring of a closed seam to that of the stitch that closed it (P9).
const CLOSED_STIFFENING: f64 = 10.0;

/// Options of a simulation. Absent fields have the values of [`SolverOptions::default`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(default, deny_unknown_fields, rename = "Simulate")]
#[schema(as = Simulate)]
pub struct SolverOptions {
    /// The shape at rest, or the motion.
    #[serde(rename = "want")]
    pub analysis: Analysis,
    /// Model of stretch and shear.
    pub membrane: MembraneModel,
    /// Method by which the equations are solved.
    pub method: Method,
    /// Length of mesh edges \[m\].
    pub edge_length_m: f64,
    /// Residual r to reach for a drape (dimensionless); RMS position error in meters per simulated
    /// second for motion.
    pub tolerance: f64,
    /// Distance to the rest shape of this mesh to reach for a drape, in place of `tolerance`
    /// \[m, RMS over the vertices\]; for Newton's method, which alone can tell it.
    pub tolerance_m: Option<f64>,
    /// Fixed step of a trajectory \[s\].
    pub step_s: Option<f64>,
    /// Simulated time of a trajectory \[s\].
    pub duration_s: Option<f64>,
    /// Frames per simulated second.
    pub frame_rate_hz: Option<f64>,
    /// CPU time after which the best shape so far is returned \[s\].
    pub time_limit_s: Option<f64>,
    /// Seam gap below which sewing ends \[m\].
    pub seam_eps_m: f64,
    /// Treatment of a seam whose gap is closed.
    pub seam_close: SeamClose,
    /// Stiffness of one stitch \[N/m\].
    pub seam_stiffness_n_m: Option<f64>,
}

impl Default for SolverOptions {
    fn default() -> Self {
        Self {
            analysis: Analysis::Static,
            membrane: MembraneModel::Continuum,
            method: Method::Auto,
            edge_length_m: 0.012,
            tolerance: 1e-5,
            tolerance_m: None,
            step_s: None,
            duration_s: None,
            frame_rate_hz: None,
            time_limit_s: None,
            seam_eps_m: 1e-3,
            seam_close: SeamClose::Weld,
            seam_stiffness_n_m: None,
        }
    }
}

impl SolverOptions {
    /// Returns the same options with the CPU time `spent` already \[s\] taken off the time limit.
    #[must_use]
    pub(crate) fn less_spent(&self, spent: f64) -> Self {
        Self {
            time_limit_s: self.time_limit_s.map(|limit| (limit - spent).max(0.0)),
            ..self.clone()
        }
    }

    /// Returns the stiffness of a stitch with which sewing begins \[N/m\].
    pub(crate) fn sewing_stiffness(&self) -> f64 {
        self.seam_stiffness_n_m.unwrap_or(SEWING_STIFFNESS)
    }

    /// Returns the stiffness of a stitch of a closed seam \[N/m\] which stitches of the stiffness
    /// `sewing` closed: the one asked for, or much stiffer than that (P9).
    pub(crate) fn closed_seam_stiffness(&self, sewing: f64) -> f64 {
        self.seam_stiffness_n_m
            .unwrap_or(sewing * CLOSED_STIFFENING)
    }
}

/// Kind of analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename = "Want")]
#[schema(as = Want)]
pub enum Analysis {
    /// The shape at rest.
    #[serde(rename = "drape")]
    Static,
    /// The motion.
    #[serde(rename = "motion")]
    Transient,
}

/// Model of stretch and shear.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename = "Membrane", rename_all = "snake_case")]
#[schema(as = Membrane)]
pub enum MembraneModel {
    /// Orthotropic triangles that converge to the continuum under refinement.
    Continuum,
    /// Linear springs on the mesh edges, as the paper has them (P8).
    Springs,
}

/// Method by which the equations are solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// The service chooses.
    Auto,
    /// The paper's method (P8).
    SymplecticEuler,
    /// Velocity Verlet.
    Verlet,
    /// Backward Euler.
    ImplicitEuler,
    /// Second-order backward differences.
    Bdf2,
    /// Pseudo-transient Newton to the shape at rest.
    Newton,
}

impl Method {
    /// Returns the name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::SymplecticEuler => "symplectic_euler",
            Self::Verlet => "verlet",
            Self::ImplicitEuler => "implicit_euler",
            Self::Bdf2 => "bdf2",
            Self::Newton => "newton",
        }
    }

    /// Returns true if it integrates over time and so follows the motion.
    pub fn is_time_stepping(self) -> bool {
        !matches!(self, Self::Auto | Self::Newton)
    }

    /// Returns true if it steps without solving equations.
    pub fn is_explicit(self) -> bool {
        matches!(self, Self::SymplecticEuler | Self::Verlet)
    }
}

/// Treatment of a seam whose gap is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum SeamClose {
    /// The two points of each stitch become one particle.
    Weld,
    /// A stiff spring of zero rest length stays (P9).
    Spring,
}
