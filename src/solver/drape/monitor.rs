//! The monitor of a drape: reports progress, keeps the history and tells when to stop.

use crate::progress::Progress;
use crate::solver::context::Context;
use crate::solver::optimize::iterate::Termination;
use crate::solver::outcome::RemainingError;
use crate::solver::report::history::ConvergenceHistory;
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Share of sewing in the progress.
pub(crate) const SEWING_SHARE: f64 = 0.4;

/// Monitor of a drape.
pub(crate) struct Monitor<'c, 'w> {
    context: &'c mut Context<'w>,
    /// CPU time at the start \[s\].
    began: f64,
    /// CPU time allowed \[s\].
    time_limit: f64,
    /// Progress reported so far, 0 to 1.
    fraction: f64,
    pace: IterationPace,
    /// Shapes kept of every level.
    pub(crate) history: ConvergenceHistory,
    /// True if the cancel token was raised.
    pub(crate) canceled: bool,
    /// Level that runs now as progress tells it: 0 is the coarsest. The hierarchy numbers its
    /// levels the other way, 0 being the finest.
    level: usize,
    /// True if the time was up.
    pub(crate) out_of_time: bool,
}

/// Record of one iteration.
pub(crate) struct IterationRecord<'a> {
    /// Name of the stage in the progress.
    pub(crate) stage: &'static str,
    /// Share of the drape that is done, 0 to 1.
    pub(crate) fraction: f64,
    pub(crate) residual: f64,
    pub(crate) seam_gap: f64,
    /// Estimated distance of the shape of the iteration before from the solution \[m\].
    pub(crate) estimate_before: Option<f64>,
    /// Returns the position of each vertex \[m\].
    pub(crate) shape: &'a dyn Fn() -> Vec<Vector3<f64>>,
}

/// CPU time of setting a stage up, and of its last iterations \[s\].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct IterationPace {
    /// CPU time at which the stage began \[s\].
    began: f64,
    /// CPU time at the last iteration \[s\].
    last: Option<f64>,
    /// CPU time from the start of the stage to its first iteration \[s\].
    pub(crate) set_up: f64,
    /// Length of the longer of the last two iterations \[s\].
    pub(crate) iteration: f64,
    /// Length of the last iteration \[s\].
    before: f64,
}

impl IterationPace {
    fn record(&mut self, cpu_s: f64) {
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

impl<'c, 'w> Monitor<'c, 'w> {
    /// Begins to monitor a drape with so much CPU time \[s\].
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
            pace: IterationPace::default(),
            history: ConvergenceHistory::default(),
            canceled: false,
            level: 0,
            out_of_time: false,
        }
    }

    /// Returns the CPU time since the start \[s\].
    pub(crate) fn cpu_s(&self) -> f64 {
        (self.context.cpu_s)() - self.began
    }

    /// Returns the CPU time left \[s\].
    pub(crate) fn left_s(&self) -> f64 {
        self.time_limit - self.cpu_s()
    }

    /// Returns true if the drape is to stop: canceled, or out of time.
    pub(crate) fn is_over(&self) -> bool {
        self.canceled || self.out_of_time
    }

    /// Begins a level: its number from the finest, from the coarsest, and its vertices.
    pub(crate) fn begin_level(&mut self, number: usize, level: usize, vertices: usize) {
        self.level = level;
        self.history.begin_level(number, vertices);
        self.begin_stage();
    }

    /// Begins a stage of a level, which has a system of its own.
    pub(crate) fn begin_stage(&mut self) {
        self.pace = IterationPace {
            began: self.cpu_s(),
            ..IterationPace::default()
        };
    }

    /// Estimates how far the shape `x` with the residual r is from rest.
    pub(crate) fn remaining_error(&self, r: f64, x: &[Vector3<f64>]) -> Option<RemainingError> {
        self.history.remaining_error(self.cpu_s(), r, x)
    }

    /// Returns the pace of the stage that runs now.
    pub(crate) fn pace(&self) -> IterationPace {
        self.pace
    }

    /// Records an iteration; breaks if the drape is to stop.
    ///
    /// The time is up when another iteration as long as the last ones, and the factor that an error
    /// estimate takes, would end after the limit: an iteration is not cut short.
    #[inline(never)] // so that a profile tells what it takes
    pub(crate) fn record(&mut self, record: &IterationRecord<'_>) -> ControlFlow<Termination> {
        let cpu_s = self.cpu_s();
        self.pace.record(cpu_s);
        self.fraction = self.fraction.max(record.fraction.clamp(0.0, 1.0));
        (self.context.progress)(Progress {
            stage: record.stage.to_owned(),
            fraction: self.fraction,
            level: u32::try_from(self.level).unwrap_or(u32::MAX),
            residual: Some(record.residual),
            seam_gap_m: Some(record.seam_gap),
            cpu_s,
        });
        self.history.estimate_last(record.estimate_before);
        self.history.push(cpu_s, record.residual, record.shape);
        self.canceled |= self.context.cancel.is_canceled();
        self.out_of_time |= cpu_s + 2.0 * self.pace.iteration > self.time_limit;
        if self.is_over() {
            ControlFlow::Break(Termination::Interrupted)
        } else {
            ControlFlow::Continue(())
        }
    }
}
