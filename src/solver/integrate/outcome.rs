//! Results of motions and reasons for choosing or refusing methods, as values;
//! [`crate::solver::report::motion`] words them.

/// A number of steps above the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StepExcess {
    /// Time to be simulated \[s\].
    pub(crate) time_s: f64,
    /// Step \[s\].
    pub(crate) step_s: f64,
    /// Steps allowed.
    pub(crate) limit: u64,
}

impl StepExcess {
    /// Returns the excess of `time_s` in steps of `step_s` \[s\] over `limit` steps, if there is
    /// one.
    pub(crate) fn of(time_s: f64, step_s: f64, limit: u64) -> Option<Self> {
        (time_s / step_s > limit as f64).then_some(Self {
            time_s,
            step_s,
            limit,
        })
    }

    /// Returns the number of steps.
    pub(crate) fn count(&self) -> f64 {
        self.time_s / self.step_s
    }
}

/// Reason why a drape by motion cannot end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Infeasibility {
    /// Nothing takes energy from the cloth.
    Undamped,
    /// It would take more steps than are allowed.
    TooManySteps(StepExcess),
}

/// Reason why a motion ended before all of its time was simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum MotionTermination {
    /// Duration or frame rate is not a positive number.
    InvalidTimes,
    /// More frames than are allowed, which is bounded by positions.
    TooManyFrames {
        count: f64,
        positions_allowed: usize,
    },
    /// No memory for the matrix factor.
    OutOfMemory,
    /// The method takes no steps of time.
    NoTimeSteps,
    /// The step asked for is not stable.
    StepAboveLimit { limit_s: f64 },
    /// More steps than are allowed.
    TooManySteps(StepExcess),
    /// Forces were not finite in steps of the length asked for.
    NotFinite { step_s: f64 },
    /// Even the shortest step was rejected.
    StepTooShort { step_s: f64 },
    /// The cancel token was raised.
    Canceled { time_s: f64 },
    /// The CPU time allowed was up.
    OutOfTime { time_s: f64 },
    /// All steps allowed were taken.
    StepLimit { time_s: f64 },
}

/// A method's cost of simulated time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StepCost {
    /// Operations a simulated second.
    pub(crate) operations: f64,
    /// Step \[s\].
    pub(crate) step_s: f64,
}

/// Reason for an automatic choice of method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum MethodReason {
    /// Verlet could not be set up.
    NoVerlet,
    /// The step asked for is above Verlet's stability limit.
    StepAboveLimit { step_s: f64, limit_s: f64 },
    /// No memory for BDF2's matrix factor.
    NoMemory,
    /// Operations were counted.
    Counted { verlet: StepCost, bdf2: StepCost },
}

/// Result of the search for the longest stable step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StabilityFinding {
    /// The method takes no steps of time.
    NoTimeSteps,
    /// Nothing is stiff.
    Unbounded,
    /// It was stopped before the limit was found.
    Stopped,
    /// Even steps far below the limit let the shape move.
    NotAtRest { step_s: f64 },
    /// No explicit step was unstable.
    NoneExplicit { tried_s: f64 },
    /// The limit lies between two explicit steps.
    Bracketed {
        steps: u64,
        disturbance_m: f64,
        stable_s: f64,
        unstable_s: f64,
    },
    /// No implicit step was unstable.
    NoneImplicit { tried_s: f64 },
    /// The cloth left its rest shape in implicit steps.
    LeftRest { tried_s: f64, step_s: f64 },
    /// The equations of an implicit step were not solved.
    NotSolved { tried_s: f64, step_s: f64 },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_beyond_the_limit_are_counted() {
        assert_eq!(StepExcess::of(1.0, 1e-3, 1001), None);
        let excess = StepExcess::of(2.0, 1e-3, 1000).expect("2000 are more");
        assert!((excess.count() - 2000.0).abs() < 1e-9);
    }
}
