//! Statistics of a solve: iterations, fallbacks and CPU time by term.

use crate::solver::forces::TermKind;
use crate::solver::model::system::System;
use crate::solver::optimize::newton::Fallbacks;

/// Iterations, fallbacks and times of a solve or a part of it.
#[derive(Clone, Debug, Default)]
pub(crate) struct SolveStatistics {
    /// Newton iterations.
    pub(crate) iterations: usize,
    /// Fallbacks used.
    pub(crate) fallbacks: FallbackSet,
    /// CPU time by term.
    pub(crate) terms: TermTimes,
}

impl SolveStatistics {
    /// Adds the statistics of another part.
    pub(crate) fn merge(&mut self, other: &Self) {
        self.iterations += other.iterations;
        for &fallback in &other.fallbacks.used {
            self.fallbacks.insert(fallback);
        }
        for &(kind, cpu_s) in &other.terms.times {
            self.terms.add(kind, cpu_s);
        }
    }
}

/// A deviation of the solver from its plain course.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fallback {
    /// Steps by the true Hessian: the plain course, listed with its fallbacks.
    TrueHessian,
    /// Projection of a share of the indefinite part.
    ConvexPart,
    /// Shift of the diagonal.
    DiagonalShift,
    /// Shorter steps.
    SmallerStep,
    /// Stiffer stitches.
    StifferSeams,
    /// Softer cloth first.
    SofterCloth,
    /// Cloth pulled out of cloth before a stage began.
    UntangledCloth,
}

impl Fallback {
    /// Returns the name in reports.
    pub(crate) fn as_str(self) -> &'static str {
        match self {
            Self::TrueHessian => "true_hessian",
            Self::ConvexPart => "convex_part",
            Self::DiagonalShift => "diagonal_shift",
            Self::SmallerStep => "smaller_step",
            Self::StifferSeams => "stiffer_seams",
            Self::SofterCloth => "softer_cloth",
            Self::UntangledCloth => "untangled_cloth",
        }
    }
}

/// Fallbacks used, in the order of their first use.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct FallbackSet {
    used: Vec<Fallback>,
}

impl FallbackSet {
    /// Adds a fallback unless it is there.
    pub(crate) fn insert(&mut self, fallback: Fallback) {
        if !self.used.contains(&fallback) {
            self.used.push(fallback);
        }
    }

    /// Adds those of the minimizer.
    pub(crate) fn insert_all(&mut self, used: Fallbacks) {
        for (is_used, fallback) in [
            (used.true_hessian, Fallback::TrueHessian),
            (used.projected_hessian, Fallback::ConvexPart),
            (used.diagonal_shift, Fallback::DiagonalShift),
            (used.smaller_step, Fallback::SmallerStep),
        ] {
            if is_used {
                self.insert(fallback);
            }
        }
    }

    /// Iterates over them.
    pub(crate) fn iter(&self) -> impl Iterator<Item = Fallback> {
        self.used.iter().copied()
    }
}

/// CPU time in each term \[s\], in the order of their first appearance.
#[derive(Clone, Debug, Default)]
pub(crate) struct TermTimes {
    times: Vec<(TermKind, f64)>,
}

impl TermTimes {
    /// Returns the times of the terms of `system`.
    pub(crate) fn of_system(system: &System<'_>) -> Self {
        let mut times = Self::default();
        for term in &system.terms {
            times.add(term.potential.kind(), term.cpu_s);
        }
        times
    }

    /// Adds a time \[s\] to that of a term.
    fn add(&mut self, kind: TermKind, cpu_s: f64) {
        match self.times.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, sum)) => *sum += cpu_s,
            None => self.times.push((kind, cpu_s)),
        }
    }

    /// Iterates over terms and times.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (TermKind, f64)> {
        self.times.iter().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(fallback: Fallback, kind: TermKind, cpu_s: f64) -> SolveStatistics {
        let mut part = SolveStatistics {
            iterations: 3,
            ..SolveStatistics::default()
        };
        part.fallbacks.insert(fallback);
        part.terms.add(kind, cpu_s);
        part
    }

    #[test]
    fn statistics_of_parts_add_up_in_the_order_of_first_use() {
        let mut sum = part(Fallback::SmallerStep, TermKind::Stretch, 1.0);
        sum.merge(&part(Fallback::TrueHessian, TermKind::Contact, 0.5));
        sum.merge(&part(Fallback::SmallerStep, TermKind::Stretch, 0.25));
        assert_eq!(sum.iterations, 9);
        let fallbacks: Vec<_> = sum.fallbacks.iter().collect();
        assert_eq!(fallbacks, [Fallback::SmallerStep, Fallback::TrueHessian]);
        let times: Vec<_> = sum.terms.iter().collect();
        assert_eq!(times, [(TermKind::Stretch, 1.25), (TermKind::Contact, 0.5)]);
    }
}
