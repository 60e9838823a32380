//! One stage of a fit run to its end, by motion or by Newton's method.

use crate::solver::integrate::dynamic_relaxation::{self, DynamicRelaxation};
use crate::solver::model::system::System;
use crate::solver::optimize::iterate::{Callback, Termination};
use crate::solver::optimize::newton::{Fallbacks, Newton};
use nalgebra::Vector3;

/// One stage run to its end.
pub(crate) struct Ended {
    pub(crate) stop: Termination,
    pub(crate) residual: f64,
    pub(crate) fallbacks: Fallbacks,
    /// Newton iterations.
    pub(crate) iterations: usize,
    /// Whether it was ended because the garment was falling.
    pub(crate) fell: bool,
    /// The step that explicit steps may not exceed, if a longer one was asked for \[s\].
    pub(crate) too_long: Option<f64>,
}

/// How often a stage may be iterated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    /// Newton iterations.
    pub(crate) iterations: usize,
    /// Steps of motion.
    pub(crate) steps: u64,
}

/// How a stage is run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct How {
    /// By motion, if it is given; else by Newton's method.
    pub(crate) motion: Option<DynamicRelaxation>,
    /// γ that Newton's method begins with \[s\].
    pub(crate) first_gamma: f64,
    pub(crate) bounds: Bounds,
}

/// Runs one stage.
pub(crate) fn run(
    system: &mut System<'_>,
    x: &mut [Vector3<f64>],
    how: How,
    callback: &mut Callback<'_>,
) -> (Ended, Option<Newton>) {
    let ended = |stop| Ended {
        stop,
        residual: f64::NAN,
        fallbacks: Fallbacks::default(),
        iterations: 0,
        fell: false,
        too_long: None,
    };
    if let Some(motion) = how.motion {
        return match dynamic_relaxation::run(system, x, motion, how.bounds.steps, callback) {
            Ok(moved) => {
                let fallbacks = Fallbacks {
                    smaller_step: moved.shorter,
                    ..Fallbacks::default()
                };
                let ended = ended(moved.stop);
                (Ended { fallbacks, ..ended }, None)
            }
            Err(stable) => (
                Ended {
                    too_long: Some(stable),
                    ..ended(Termination::Stalled)
                },
                None,
            ),
        };
    }
    match Newton::new(system, how.first_gamma) {
        Ok(mut newton) => {
            let stop = newton.run(system, x, how.bounds.iterations, callback);
            (
                Ended {
                    fallbacks: newton.fallbacks,
                    iterations: newton.iterations,
                    ..ended(stop)
                },
                Some(newton),
            )
        }
        Err(_) => (ended(Termination::OutOfMemory), None),
    }
}

impl Ended {
    /// Why the stage ended, in words.
    pub(crate) fn reason(&self, canceled: bool) -> String {
        let r = self.residual;
        if let Some(step) = self.too_long {
            return format!(
                "step_s is above the stability limit of {step:.2e} s: give a shorter one or leave it out"
            );
        }
        if self.fell {
            return "it fell off the body: nothing holds it up".to_owned();
        }
        match self.stop {
            Termination::Reached => format!("at rest: r = {r:.1e}"),
            Termination::Interrupted if canceled => format!("canceled at r = {r:.1e}"),
            Termination::Interrupted => format!("the time allowed was up at r = {r:.1e}"),
            Termination::Stalled => format!("no step lowers the energy any more, at r = {r:.1e}"),
            Termination::IterationLimit => format!("the limit of iterations was reached at r = {r:.1e}"),
            Termination::OutOfMemory => "there is no memory for the matrix factor: ask for longer mesh edges".to_owned(),
            Termination::NotFinite => "forces became infinite: look for panels that start inside the body or seams of very unlike length".to_owned(),
        }
    }
}

/// Adds the fallbacks that were taken to the report's list.
pub(crate) fn note_fallbacks(ladder: &mut Vec<String>, fallbacks: Fallbacks) {
    for (taken, name) in [
        (fallbacks.true_hessian, "true_hessian"),
        (fallbacks.projected_hessian, "convex_part"),
        (fallbacks.diagonal_shift, "diagonal_shift"),
        (fallbacks.smaller_step, "smaller_step"),
    ] {
        if taken {
            push_once(ladder, name);
        }
    }
}

/// Adds `name` unless it is there.
pub(crate) fn push_once(ladder: &mut Vec<String>, name: &str) {
    if !ladder.iter().any(|n| n == name) {
        ladder.push(name.to_owned());
    }
}
