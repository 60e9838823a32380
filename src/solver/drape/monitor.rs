//! Watches a run: tells how far it is, keeps its way, and gives the verdict on going on.

use crate::progress::Progress;
use crate::solver::Context;
use crate::solver::optimize::iterate::Termination;
use crate::solver::report::history::{ToGo, Way};
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Share of the progress that sewing is told as.
pub(crate) const SEWING_SHARE: f64 = 0.4;

/// Watches a run.
pub(crate) struct Trace<'c, 'w> {
    context: &'c mut Context<'w>,
    began: f64,
    time_limit: f64,
    fraction: f64,
    pace: Pace,
    /// The shapes that it went through.
    pub(crate) way: Way,
    /// Whether the cancel token was raised.
    pub(crate) canceled: bool,
    /// Level that runs now, 0 = coarsest.
    level: usize,
    /// Whether the time was up.
    pub(crate) out_of_time: bool,
}

/// What is told of one iteration.
pub(crate) struct Look<'a> {
    pub(crate) stage: &'static str,
    /// Share of the whole done, 0 to 1.
    pub(crate) fraction: f64,
    pub(crate) residual: f64,
    pub(crate) seam_gap: f64,
    /// Estimate of how far the shape of the iteration before was from the solution \[m\].
    pub(crate) estimate_before: Option<f64>,
    /// Position of each vertex.
    pub(crate) shape: &'a dyn Fn() -> Vec<Vector3<f64>>,
}

/// How long a level took to set up, and its last iterations \[CPU s\].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pace {
    began: f64,
    last: Option<f64>,
    /// From the start of the level to its first iteration.
    pub(crate) set_up: f64,
    /// The longer of the last two iterations.
    pub(crate) iteration: f64,
    before: f64,
}

impl Pace {
    fn look(&mut self, cpu_s: f64) {
        match self.last {
            None => self.set_up = cpu_s - self.began,
            Some(last) => {
                self.iteration = self.before.max(cpu_s - last);
                self.before = cpu_s - last;
            }
        }
        self.last = Some(cpu_s);
    }
}

impl<'c, 'w> Trace<'c, 'w> {
    pub(crate) fn new(context: &'c mut Context<'w>, time_limit: Option<f64>) -> Self {
        let began = (context.cpu_s)();
        let time_limit = time_limit
            .unwrap_or(f64::INFINITY)
            .min(context.limits.fit_cpu_s);
        Self {
            context,
            began,
            time_limit,
            fraction: 0.0,
            pace: Pace::default(),
            way: Way::default(),
            canceled: false,
            level: 0,
            out_of_time: false,
        }
    }

    /// CPU time since the start \[s\].
    pub(crate) fn cpu_s(&self) -> f64 {
        (self.context.cpu_s)() - self.began
    }

    /// CPU time left \[s\].
    pub(crate) fn left_s(&self) -> f64 {
        self.time_limit - self.cpu_s()
    }

    /// Whether it is not to go on: canceled, or the time was up.
    pub(crate) fn is_over(&self) -> bool {
        self.canceled || self.out_of_time
    }

    /// Goes on to a level: its number from the finest, from the coarsest, and its vertices.
    pub(crate) fn begin_level(&mut self, number: usize, level: usize, vertices: usize) {
        self.level = level;
        self.way.begin_level(number, vertices);
        self.begin_stage();
    }

    /// Begins to look at another system.
    pub(crate) fn begin_stage(&mut self) {
        self.pace = Pace {
            began: self.cpu_s(),
            ..Pace::default()
        };
    }

    /// How far the shape `x` with the residual r is from rest.
    pub(crate) fn to_go(&self, r: f64, x: &[Vector3<f64>]) -> Option<ToGo> {
        self.way.to_go(self.cpu_s(), r, x)
    }

    /// How fast the stage that runs now is.
    pub(crate) fn pace(&self) -> Pace {
        self.pace
    }

    /// Tells of an iteration; whether to go on.
    ///
    /// The time is up when another iteration as long as the last ones, and the factor that an error estimate takes, would end
    /// after the limit: an iteration is not cut short.
    #[inline(never)] // so that a profile tells what it takes
    pub(crate) fn look(&mut self, look: &Look<'_>) -> ControlFlow<Termination> {
        let cpu_s = self.cpu_s();
        self.pace.look(cpu_s);
        self.fraction = self.fraction.max(look.fraction.clamp(0.0, 1.0));
        (self.context.progress)(Progress {
            stage: look.stage.to_owned(),
            fraction: self.fraction,
            level: u32::try_from(self.level).unwrap_or(u32::MAX),
            residual: Some(look.residual),
            seam_gap_m: Some(look.seam_gap),
            cpu_s,
        });
        self.way.estimate_last(look.estimate_before);
        self.way.pass(cpu_s, look.residual, look.shape);
        self.canceled |= self.context.cancel.is_canceled();
        self.out_of_time |= cpu_s + 2.0 * self.pace.iteration > self.time_limit;
        if self.is_over() {
            ControlFlow::Break(Termination::Interrupted)
        } else {
            ControlFlow::Continue(())
        }
    }
}
