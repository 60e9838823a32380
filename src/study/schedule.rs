//! The parts of a study one after the other: time shared out, progress told, skipped parts kept.

use super::part::{SkipReason, StudyPart};
use super::wording;
use crate::progress::Progress;
use crate::solver::Context;

/// The most time a part may take, in shares of the time that is left: one slow method must not
/// starve the others.
const MOST_SHARES: f64 = 3.0;

/// The time and the parts that are left of a study.
pub(super) struct StudySchedule<'c, 'w> {
    context: &'c mut Context<'w>,
    began: f64,
    /// CPU time of the whole \[s\].
    allowed_s: f64,
    /// CPU time of one run \[s\].
    allowed_each_s: f64,
    /// Weight of all parts, and of those that are done.
    weight: f64,
    done: f64,
    /// The largest fraction told as progress: it never falls.
    told: f64,
    skipped: Vec<(StudyPart, SkipReason)>,
}

impl<'c, 'w> StudySchedule<'c, 'w> {
    /// Begins a study whose parts weigh `weight`, in the CPU time allowed for all of it and for
    /// each run \[s\].
    pub(super) fn new(
        context: &'c mut Context<'w>,
        [allowed, allowed_each]: [Option<f64>; 2],
        weight: f64,
    ) -> Self {
        let most = context.limits.study_cpu_s;
        Self {
            began: (context.cpu_s)(),
            allowed_s: allowed.unwrap_or(most).min(most),
            allowed_each_s: allowed_each.unwrap_or(f64::INFINITY),
            weight: weight.max(1.0),
            done: 0.0,
            told: 0.0,
            skipped: Vec::new(),
            context,
        }
    }

    /// Returns the CPU time so far \[s\].
    pub(super) fn cpu_s(&self) -> f64 {
        (self.context.cpu_s)() - self.began
    }

    pub(super) fn is_canceled(&self) -> bool {
        self.context.cancel.is_canceled()
    }

    /// Returns the parts that were not done.
    pub(super) fn skipped(&self) -> &[(StudyPart, SkipReason)] {
        &self.skipped
    }

    /// Lists a part as not done.
    pub(super) fn skip(&mut self, part: StudyPart, reason: SkipReason) {
        self.skipped.push((part, reason));
    }

    /// Counts parts of this weight, which are not needed, as done.
    pub(super) fn count_done(&mut self, weight: f64) {
        self.done += weight;
    }

    /// Does a part of this weight, with a context of its own and the CPU time that it may take
    /// \[s\]. Returns none, and lists the part as skipped, if it is too late.
    pub(super) fn run<T>(
        &mut self,
        part: StudyPart,
        weight: f64,
        run: impl FnOnce(&mut Context<'_>, f64) -> T,
    ) -> Option<T> {
        let left = self.allowed_s - self.cpu_s();
        let to_do = (self.weight - self.done).max(weight);
        let from = self.done;
        self.done += weight;
        if self.is_canceled() {
            self.skip(part, SkipReason::Canceled);
            return None;
        }
        if left <= 0.0 {
            self.skip(part, SkipReason::TimeUp);
            return None;
        }
        let fair = MOST_SHARES * left * weight / to_do;
        let share = left.min(fair).min(self.allowed_each_s);
        let name = wording::part(&part);
        let (outer, told) = (&mut *self.context.progress, &mut self.told);
        let (clock, began, whole) = (self.context.cpu_s, self.began, self.weight);
        let mut progress = |inner: Progress| {
            let fraction = (from + weight * inner.fraction.clamp(0.0, 1.0)) / whole;
            *told = told.max(fraction.min(1.0));
            outer(Progress {
                stage: name.clone(),
                fraction: *told,
                cpu_s: clock() - began,
                ..inner
            });
        };
        progress(Progress::default());
        let mut inner = Context {
            cpu_s: clock,
            cancel: self.context.cancel,
            progress: &mut progress,
            limits: self.context.limits,
        };
        Some(run(&mut inner, share))
    }
}
