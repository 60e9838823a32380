//! One stage of a drape run to its end, by motion or by Newton's method.

use crate::solver::integrate::dynamic_relaxation::{self, DynamicRelaxation};
use crate::solver::model::system::System;
use crate::solver::optimize::iterate::{Callback, Termination};
use crate::solver::optimize::newton::{Fallbacks, Newton};
use crate::solver::outcome::StageEnd;
use crate::solver::statistics::{FallbackSet, SolveStatistics, TermTimes};
use nalgebra::Vector3;

/// Outcome of one stage.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StageOutcome {
    /// Reason of its end, as the method tells it.
    pub(crate) termination: Termination,
    /// Residual of the last iterate; NaN if there was none.
    pub(crate) residual: f64,
    /// Fallbacks used.
    pub(crate) fallbacks: Fallbacks,
    /// Newton iterations.
    pub(crate) iterations: usize,
    /// True if it was ended because the garment was falling.
    pub(crate) fell: bool,
    /// Longest stable step, if a longer one was asked for \[s\].
    pub(crate) stability_limit: Option<f64>,
}

/// Limits on the work of a stage.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IterationLimits {
    /// Newton iterations.
    pub(crate) iterations: usize,
    /// Steps of motion.
    pub(crate) steps: u64,
}

/// Method by which a stage is run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StageMethod {
    /// The motion, if it is run by motion; else it is run by Newton's method.
    pub(crate) motion: Option<DynamicRelaxation>,
    /// γ that Newton's method begins with \[s\].
    pub(crate) first_gamma: f64,
    pub(crate) limits: IterationLimits,
}

/// Runs one stage from `x`, which becomes its last accepted shape; returns Newton's method too, if
/// that ran and still has its matrices.
pub(crate) fn run_stage(
    system: &mut System<'_>,
    x: &mut [Vector3<f64>],
    method: StageMethod,
    callback: &mut Callback<'_>,
) -> (StageOutcome, Option<Newton>) {
    if let Some(motion) = method.motion {
        let outcome = run_motion(system, x, (motion, method.limits.steps), callback);
        return (outcome, None);
    }
    let Ok(mut newton) = Newton::new(system, method.first_gamma) else {
        return (StageOutcome::new(Termination::OutOfMemory), None);
    };
    let termination = newton.run(system, x, method.limits.iterations, callback);
    let outcome = StageOutcome {
        fallbacks: newton.fallbacks,
        iterations: newton.iterations,
        ..StageOutcome::new(termination)
    };
    let has_matrices = termination != Termination::OutOfMemory;
    (outcome, has_matrices.then_some(newton))
}

/// Runs one stage by motion of so many steps at most.
fn run_motion(
    system: &mut System<'_>,
    x: &mut [Vector3<f64>],
    (motion, step_limit): (DynamicRelaxation, u64),
    callback: &mut Callback<'_>,
) -> StageOutcome {
    match dynamic_relaxation::run(system, x, motion, step_limit, callback) {
        Ok(moved) => StageOutcome {
            fallbacks: Fallbacks {
                smaller_step: moved.shorter,
                ..Fallbacks::default()
            },
            ..StageOutcome::new(moved.termination)
        },
        Err(limit) => StageOutcome {
            stability_limit: Some(limit),
            ..StageOutcome::new(Termination::Stalled)
        },
    }
}

impl StageOutcome {
    fn new(termination: Termination) -> Self {
        Self {
            termination,
            residual: f64::NAN,
            fallbacks: Fallbacks::default(),
            iterations: 0,
            fell: false,
            stability_limit: None,
        }
    }

    /// Returns why the stage ended; `canceled` tells an interruption by the cancel token from one
    /// by the time limit.
    pub(crate) fn end(&self, canceled: bool) -> StageEnd {
        if let Some(limit_s) = self.stability_limit {
            return StageEnd::StepTooLong { limit_s };
        }
        if self.fell {
            return StageEnd::FellOff;
        }
        match self.termination {
            Termination::Reached => StageEnd::Converged,
            Termination::Interrupted if canceled => StageEnd::Canceled,
            Termination::Interrupted => StageEnd::OutOfTime,
            Termination::Stalled => StageEnd::Stalled,
            Termination::IterationLimit => StageEnd::IterationLimit,
            Termination::OutOfMemory => StageEnd::OutOfMemory,
            Termination::NotFinite => StageEnd::NotFinite,
        }
    }

    /// Returns its statistics with these times.
    pub(crate) fn statistics(&self, terms: TermTimes) -> SolveStatistics {
        let mut fallbacks = FallbackSet::default();
        fallbacks.insert_all(self.fallbacks);
        SolveStatistics {
            iterations: self.iterations,
            fallbacks,
            terms,
        }
    }
}
