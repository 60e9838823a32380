//! The parts of a study one after the other: time shared out, progress told, what was left out kept.

use super::report::NotDone;
use crate::progress::Progress;
use crate::solver::Context;

/// No part may take more than so many times its share of the time that is left, so that one slow method does not starve the
/// others.
const FAIR: f64 = 3.0;

/// What is left to be done, and with what.
pub(super) struct Work<'c, 'w> {
    context: &'c mut Context<'w>,
    began: f64,
    /// CPU time of the whole \[s\].
    allowed: f64,
    /// CPU time of one run \[s\].
    allowed_each: f64,
    /// Parts in all, and those done.
    parts: f64,
    done: f64,
    told: f64,
    pub(super) left_out: Vec<NotDone>,
}

impl<'c, 'w> Work<'c, 'w> {
    pub(super) fn new(
        context: &'c mut Context<'w>,
        allowed: Option<f64>,
        allowed_each: Option<f64>,
        parts: f64,
    ) -> Self {
        let most = context.limits.study_cpu_s;
        Self {
            began: (context.cpu_s)(),
            allowed: allowed.unwrap_or(most).min(most),
            allowed_each: allowed_each.unwrap_or(f64::INFINITY),
            parts: parts.max(1.0),
            done: 0.0,
            told: 0.0,
            left_out: Vec::new(),
            context,
        }
    }

    /// CPU time so far \[s\].
    pub(super) fn cpu_s(&self) -> f64 {
        (self.context.cpu_s)() - self.began
    }

    pub(super) fn is_canceled(&self) -> bool {
        self.context.cancel.is_canceled()
    }

    pub(super) fn leave_out(&mut self, what: impl Into<String>, because: impl Into<String>) {
        self.left_out.push(NotDone {
            what: what.into(),
            because: because.into(),
        });
    }

    /// Counts parts that are not needed as done.
    pub(super) fn skip(&mut self, parts: f64) {
        self.done += parts;
    }

    /// Does what counts as `parts` parts, with a context of its own and the CPU time that it may take \[s\]. `None`, and listed as
    /// left out, if it is too late.
    pub(super) fn part<T>(
        &mut self,
        what: &str,
        parts: f64,
        run: impl FnOnce(&mut Context<'_>, f64) -> T,
    ) -> Option<T> {
        let left = self.allowed - self.cpu_s();
        let to_do = (self.parts - self.done).max(parts);
        self.done += parts;
        if self.is_canceled() {
            self.leave_out(what, "canceled before it");
            return None;
        }
        if left <= 0.0 {
            self.leave_out(what, "the time allowed was up");
            return None;
        }
        let share = left.min(FAIR * left * parts / to_do).min(self.allowed_each);
        let (from, whole) = (self.done - parts, self.parts);
        let (outer, told) = (&mut *self.context.progress, &mut self.told);
        let (clock, began) = (self.context.cpu_s, self.began);
        let mut progress = |inner: Progress| {
            let fraction = (from + parts * inner.fraction.clamp(0.0, 1.0)) / whole;
            *told = told.max(fraction.min(1.0));
            outer(Progress {
                stage: what.to_owned(),
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
