//! Outcome of a drape as typed values. [`crate::solver::report::describe`] puts it into words.

use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::integrate::outcome::Infeasibility;
use crate::solver::options::Method;
use crate::solver::report::measure::ShapeMeasures;
use crate::solver::report::schema::{DrapeReport, Energy, ErrorPoint};
use crate::solver::statistics::SolveStatistics;
use nalgebra::Vector3;

/// Residual up to which `‖H⁻¹ f‖` was measured to be the error.
pub(crate) const ESTIMATE_RESIDUAL_LIMIT: f64 = 1e-2;

/// The draped shape and its report.
#[derive(Clone, Debug)]
pub struct Drape {
    /// Position of each vertex \[m\]; `#V`. The best shape so far where it did not converge.
    pub positions: Vec<Vector3<f64>>,
    /// The shape that the next coarser mesh handed on to this one, where both came to rest \[m;
    /// `#V`\]: at the vertices that both have, its own.
    pub handed_on: Option<Vec<Vector3<f64>>>,
    /// Points at which friction holds it.
    pub anchors: FrictionAnchors,
    /// Quality of the shape.
    pub report: DrapeReport,
    /// True if it was stopped by the cancel token.
    pub canceled: bool,
}

impl Drape {
    /// Makes a drape of a shape \[m; `#V`\] of which nothing else is known.
    pub fn of_shape(positions: &[Vector3<f64>]) -> Self {
        Self {
            positions: positions.to_vec(),
            handed_on: None,
            anchors: FrictionAnchors::default(),
            report: DrapeReport::default(),
            canceled: false,
        }
    }
}

/// Outcome of a drape over all levels.
#[derive(Clone, Debug)]
pub(crate) struct DrapeOutcome {
    /// Position of each vertex \[m\]; `#V`.
    pub(crate) positions: Vec<Vector3<f64>>,
    /// Points at which friction holds it.
    pub(crate) anchors: FrictionAnchors,
    /// Method that was used.
    pub(crate) method: Method,
    /// Success or failure of the last level that ran.
    pub(crate) end: Result<AtRest, Unfinished>,
    /// Forces left over, and energies.
    pub(crate) balance: ForceBalance,
    /// Distance to the solution on this mesh.
    pub(crate) estimate: Option<ErrorEstimate>,
    /// The shape that the next coarser level handed on \[m\], where both are at rest.
    pub(crate) handed_on: Option<Vec<Vector3<f64>>>,
    /// Distance to the shape that the next coarser level handed on \[m\], where both are at rest.
    pub(crate) mesh_error_m: Option<f64>,
    /// Gaps, strain and penetration.
    pub(crate) measures: ShapeMeasures,
    /// Distance by which the middle of the garment sank \[m\].
    pub(crate) sunk_m: f64,
    /// Time in which the distance to rest halves \[CPU s\], if it does.
    pub(crate) halving_s: Option<f64>,
    /// Levels planned.
    pub(crate) plan: LevelPlan,
    /// Levels that ran, coarsest first.
    pub(crate) levels: Vec<LevelOutcome>,
    /// Iterations, fallbacks and times of all levels.
    pub(crate) statistics: SolveStatistics,
    /// Errors of the shapes on the way.
    pub(crate) history: Vec<ErrorPoint>,
    /// CPU time of all of it \[s\].
    pub(crate) cpu_s: f64,
    /// True if the cancel token was raised.
    pub(crate) canceled: bool,
    /// True if the time was up.
    pub(crate) out_of_time: bool,
}

impl DrapeOutcome {
    /// Returns the CPU time allowed \[s\], if it was up.
    pub(crate) fn time_limit_reached(&self) -> Option<f64> {
        self.plan.time_limit_s.filter(|_| self.out_of_time)
    }
}

/// Levels planned, and the time for them.
#[derive(Clone, Debug)]
pub(crate) struct LevelPlan {
    /// Vertices of each level, coarsest first.
    pub(crate) vertices: Vec<usize>,
    /// CPU time allowed \[s\].
    pub(crate) time_limit_s: Option<f64>,
    /// CPU time expected for all levels once the coarsest had ended \[s\].
    pub(crate) expected_cpu_s: Option<f64>,
}

/// Outcome of one level: sewn if it was not yet, and relaxed.
#[derive(Clone, Debug)]
pub(crate) struct LevelOutcome {
    /// Vertices of its mesh.
    pub(crate) vertices: usize,
    /// The relaxed shape's figures, or why its seams did not close.
    pub(crate) relaxation: Result<RelaxOutcome, Unfinished>,
    /// RMS distance from the shape that the coarser level handed on \[m\]; none on the level that
    /// was sewn.
    pub(crate) moved_m: Option<f64>,
    /// Iterations, fallbacks and times.
    pub(crate) statistics: SolveStatistics,
    /// CPU time of sewing \[s\].
    pub(crate) sew_s: f64,
    /// CPU time of relaxing \[s\].
    pub(crate) relax_s: f64,
}

impl LevelOutcome {
    /// Returns the residual where the level was left; NaN if its seams did not close.
    pub(crate) fn residual(&self) -> f64 {
        self.relaxation
            .as_ref()
            .map_or(f64::NAN, |relaxed| relaxed.balance.residual)
    }

    /// Returns success or the reason of failure.
    pub(crate) fn end(&self) -> Result<AtRest, Unfinished> {
        match &self.relaxation {
            Ok(relaxed) => relaxed.end.clone(),
            Err(unfinished) => Err(unfinished.clone()),
        }
    }

    /// Returns its CPU time \[s\].
    pub(crate) fn cpu_s(&self) -> f64 {
        self.sew_s + self.relax_s
    }
}

/// Outcome of sewing.
#[derive(Clone, Debug)]
pub(crate) struct SewOutcome {
    /// Stiffness of a stitch that closed the seams \[N/m\], or why they did not close.
    pub(crate) stiffness: Result<f64, Unfinished>,
    /// Iterations, fallbacks and times.
    pub(crate) statistics: SolveStatistics,
}

/// Figures of a relaxed shape.
#[derive(Clone, Debug)]
pub(crate) struct RelaxOutcome {
    /// Success or failure.
    pub(crate) end: Result<AtRest, Unfinished>,
    /// Forces left over, and energies.
    pub(crate) balance: ForceBalance,
    /// Distance to the solution by the Hessian; none where that was not looked at or has no factor.
    pub(crate) estimate: Option<ErrorEstimate>,
    /// Distance to rest by the moves of the shape.
    pub(crate) remaining: Option<RemainingError>,
    /// True if it was given up because the garment was falling.
    pub(crate) fell: bool,
    /// Distance by which the middle of the garment sank \[m\].
    pub(crate) sunk_m: f64,
    /// Points at which friction holds it.
    pub(crate) anchors: FrictionAnchors,
}

/// Success: a shape at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum AtRest {
    /// To the tolerance asked for.
    WithinTolerance,
    /// To the distance from the rest shape that was asked for.
    WithinDistance,
    /// To the round-off floor of the residual, which is above the tolerance.
    AtRoundOffFloor,
}

/// Reason why a shape is not at rest.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Unfinished {
    /// The drape was not begun since its method could not end.
    Refused(Infeasibility),
    /// The seams up to a stage did not close.
    SeamsOpen {
        stage: u32,
        gap_m: f64,
        end: StageEnd,
        residual: f64,
    },
    /// The relaxation ended early.
    NotRelaxed { end: StageEnd, residual: f64 },
    /// A coarser shape is at rest, and there was no time for the next finer mesh.
    NoTimeForFinerMesh {
        vertices: usize,
        finer_vertices: usize,
    },
}

/// End of one stage, sewing or relaxing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StageEnd {
    /// The convergence test was met.
    Converged,
    /// The step asked for is above the stability limit.
    StepTooLong { limit_s: f64 },
    /// The garment fell off the body.
    FellOff,
    /// The cancel token was raised.
    Canceled,
    /// The time allowed was up.
    OutOfTime,
    /// No step lowers the energy any more.
    Stalled,
    /// The limit of iterations was reached.
    IterationLimit,
    /// There was no memory for the matrix factor.
    OutOfMemory,
    /// Forces were not finite.
    NotFinite,
}

/// Forces left over on a shape, and its energies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ForceBalance {
    /// Net force on a particle over its weight, RMS.
    pub(crate) residual: f64,
    /// Residual below which forces are rounding.
    pub(crate) residual_floor: f64,
    /// Energy by term.
    pub(crate) energy: Energy,
}

/// Estimated distance to the solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ErrorEstimate {
    /// RMS distance \[m\].
    pub(crate) distance_m: Option<f64>,
    /// Basis of the estimate, and whether it holds.
    pub(crate) validity: Validity,
}

/// Basis of an error estimate, and whether it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Validity {
    /// By the Hessian, in a minimum of the energy near rest: holds.
    Valid,
    /// None: the Hessian is not positive definite.
    NotInMinimum,
    /// By the Hessian, but contact is not settled.
    ContactUnsettled,
    /// By the Hessian, but too far from rest.
    FarFromRest,
    /// By the forces left and the moves of the shape: right within three times, mostly.
    ByMoves,
    /// None: too little is known.
    Unknown,
}

/// Distance to rest as the moves of a shape tell it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RemainingError {
    /// RMS distance \[m\].
    pub(crate) distance_m: f64,
    /// CPU time in which it halves \[s\], if it gets shorter.
    pub(crate) halving_s: Option<f64>,
}
