//! What is asked of the solver.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// How to simulate. Absent fields have the defaults of [`Simulate::default`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Simulate {
    /// The shape at rest, or the motion.
    pub want: Want,
    /// How stretch is modelled.
    pub membrane: Membrane,
    /// How equations are solved.
    pub method: Method,
    /// Length of mesh edges \[m\].
    pub edge_length_m: f64,
    /// Residual r to reach for a drape (dimensionless); RMS position error in metres per simulated second for motion.
    pub tolerance: f64,
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
    /// What becomes of a seam when its gap is closed.
    pub seam_close: SeamClose,
    /// Stiffness of one stitch \[N/m\].
    pub seam_stiffness_n_m: Option<f64>,
}

impl Default for Simulate {
    fn default() -> Self {
        Self {
            want: Want::Drape,
            membrane: Membrane::Continuum,
            method: Method::Auto,
            edge_length_m: 0.012,
            tolerance: 1e-5,
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

/// What is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Want {
    /// The shape at rest.
    Drape,
    /// The motion.
    Motion,
}

/// How stretch is modelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Membrane {
    /// Orthotropic triangles that converge to the continuum under refinement.
    Continuum,
    /// Linear springs on the mesh edges, as the paper has them (P8).
    Springs,
}

/// How equations are solved.
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
    /// The word for it in JSON.
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

    /// Whether it steps from one time to the next, and so follows the motion.
    pub fn steps(self) -> bool {
        !matches!(self, Self::Auto | Self::Newton)
    }

    /// Whether it steps without solving equations.
    pub fn is_explicit(self) -> bool {
        matches!(self, Self::SymplecticEuler | Self::Verlet)
    }
}

/// What becomes of a seam when its gap is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum SeamClose {
    /// The two points of each stitch become one particle.
    Weld,
    /// A stiff spring of zero rest length stays (P9).
    Spring,
}
