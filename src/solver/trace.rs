//! The way of one run to its final shape: progress told, snapshots kept, the verdict on going on.

use super::Context;
use super::measure::rms_distance;
use super::newton::Verdict;
use super::report::ErrorPoint;
use crate::progress::Progress;
use nalgebra::Vector3;

/// Snapshots kept at most; when there are more, every other one is dropped.
const SNAPSHOTS: usize = 48;

struct Snapshot {
    cpu_s: f64,
    residual: f64,
    positions: Vec<Vector3<f64>>,
}

/// Watches a run.
pub(crate) struct Trace<'c, 'w> {
    context: &'c mut Context<'w>,
    began: f64,
    time_limit: f64,
    fraction: f64,
    snapshots: Vec<Snapshot>,
    stride: usize,
    seen: usize,
    /// Whether the cancel token was raised.
    pub(crate) canceled: bool,
    /// Level that runs now, 0 = coarsest.
    pub(crate) level: usize,
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
    /// Position of each vertex, for a snapshot.
    pub(crate) shape: Option<&'a dyn Fn() -> Vec<Vector3<f64>>>,
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
            snapshots: Vec::new(),
            stride: 1,
            seen: 0,
            canceled: false,
            level: 0,
            out_of_time: false,
        }
    }

    /// CPU time since the start \[s\].
    pub(crate) fn cpu_s(&self) -> f64 {
        (self.context.cpu_s)() - self.began
    }

    /// Whether it is not to go on: canceled, or the time was up.
    pub(crate) fn is_over(&self) -> bool {
        self.canceled || self.out_of_time
    }

    /// Tells of an iteration; whether to go on.
    pub(crate) fn look(&mut self, look: &Look<'_>) -> Verdict {
        let cpu_s = self.cpu_s();
        self.fraction = self.fraction.max(look.fraction.clamp(0.0, 1.0));
        (self.context.progress)(Progress {
            stage: look.stage.to_owned(),
            fraction: self.fraction,
            level: u32::try_from(self.level).unwrap_or(u32::MAX),
            residual: Some(look.residual),
            seam_gap_m: Some(look.seam_gap),
            cpu_s,
        });
        if let Some(shape) = look.shape {
            self.keep(cpu_s, look.residual, shape);
        }
        self.canceled |= self.context.cancel.is_canceled();
        self.out_of_time |= cpu_s > self.time_limit;
        if self.canceled || self.out_of_time {
            Verdict::Interrupt
        } else {
            Verdict::Continue
        }
    }

    fn keep(&mut self, cpu_s: f64, residual: f64, shape: &dyn Fn() -> Vec<Vector3<f64>>) {
        self.seen += 1;
        if !self.seen.is_multiple_of(self.stride) {
            return;
        }
        self.snapshots.push(Snapshot {
            cpu_s,
            residual,
            positions: shape(),
        });
        if self.snapshots.len() > SNAPSHOTS {
            let mut odd = false;
            self.snapshots.retain(|_| {
                odd = !odd;
                odd
            });
            self.stride *= 2;
        }
    }

    /// Distance of every snapshot from the final shape.
    pub(crate) fn error_against_run_time(&self, last: &[Vector3<f64>]) -> Vec<ErrorPoint> {
        let point = |s: &Snapshot| ErrorPoint {
            cpu_s: s.cpu_s,
            rms_error_m: rms_distance(&s.positions, last),
            error_estimate_m: None,
            residual: s.residual,
        };
        self.snapshots.iter().map(point).collect()
    }
}
