//! The sentences of reports on motions and on stable steps.

use crate::solver::integrate::outcome::{
    Infeasibility, MethodReason, MotionTermination, StabilityFinding, StepExcess,
};

/// Words the reason why a motion ended early.
pub(crate) fn describe_termination(termination: &MotionTermination) -> String {
    match *termination {
        MotionTermination::InvalidTimes => {
            "duration_s and frame_rate_hz must be above 0".to_owned()
        }
        MotionTermination::TooManyFrames {
            count,
            positions_allowed,
        } => format!(
            "{count} frames of this mesh are more than the {positions_allowed} positions allowed: ask for fewer frames"
        ),
        MotionTermination::OutOfMemory => {
            "there is no memory for the matrix factor: ask for longer mesh edges".to_owned()
        }
        MotionTermination::NoTimeSteps => {
            "newton finds the shape at rest only: ask for another method, or a drape".to_owned()
        }
        MotionTermination::StepAboveLimit { limit_s } => format!(
            "step_s is above the stability limit of {limit_s:.2e} s: give a shorter one or leave it out"
        ),
        MotionTermination::TooManySteps(excess) => format!(
            "{}: ask for bdf2 or implicit_euler, for less time, longer mesh edges or softer cloth",
            describe_excess(&excess)
        ),
        MotionTermination::NotFinite { step_s } => format!(
            "forces became infinite in steps of {step_s:.1e} s: give a shorter one or leave it out"
        ),
        MotionTermination::StepTooShort { step_s } => {
            format!("steps of {step_s:.0e} s are still too long")
        }
        MotionTermination::Canceled { time_s } => format!("canceled at {time_s:.4} s"),
        MotionTermination::OutOfTime { time_s } => {
            format!("the time allowed was up at {time_s:.4} s")
        }
        MotionTermination::StepLimit { time_s } => {
            format!("the limit of steps was reached at {time_s:.4} s")
        }
    }
}

/// Words the end of a motion of which all was simulated.
pub(crate) fn describe_completion(simulated_s: f64) -> String {
    format!("all of {simulated_s:.4} s was simulated")
}

/// Words the reason for an automatic choice of method.
pub(crate) fn describe_method(reason: &MethodReason) -> String {
    match *reason {
        MethodReason::NoVerlet => "Verlet could not be set up".to_owned(),
        MethodReason::StepAboveLimit { step_s, limit_s } => {
            format!("the step of {step_s:.2e} s is above Verlet's limit of {limit_s:.2e} s")
        }
        MethodReason::NoMemory => "there is no memory for BDF2's matrix factor".to_owned(),
        MethodReason::Counted { verlet, bdf2 } => format!(
            "counted: {:.1e} operations a simulated second in steps of {:.1e} s by verlet, {:.1e} in steps of {:.1e} s by bdf2",
            verlet.operations, verlet.step_s, bdf2.operations, bdf2.step_s
        ),
    }
}

/// Words the reason why a drape by motion cannot end.
pub(crate) fn describe_infeasibility(infeasibility: &Infeasibility) -> String {
    match infeasibility {
        Infeasibility::Undamped => {
            "explicit steps without drag never come to rest: give the scene a drag, or ask for newton".to_owned()
        }
        Infeasibility::TooManySteps(excess) => format!(
            "{}: ask for newton, for longer mesh edges, or for softer cloth",
            describe_excess(excess)
        ),
    }
}

/// Words the result of the search for the longest stable step.
pub(crate) fn describe_stability(finding: &StabilityFinding) -> String {
    match *finding {
        StabilityFinding::NoTimeSteps => "the method takes no steps of time".to_owned(),
        StabilityFinding::Unbounded => "nothing here is stiff: any step is stable".to_owned(),
        StabilityFinding::Stopped => "stopped before it was found".to_owned(),
        StabilityFinding::NotAtRest { step_s } => {
            format!("even steps of {step_s:.1e} s let the shape move: it is not at rest")
        }
        StabilityFinding::NoneExplicit { tried_s } => format!("none found up to {tried_s:.1e} s"),
        StabilityFinding::Bracketed {
            steps,
            disturbance_m,
            stable_s,
            unstable_s,
        } => format!(
            "{steps} steps of {stable_s:.3e} s keep a disturbance of {disturbance_m:.0e} m small, steps of {unstable_s:.3e} s do not"
        ),
        StabilityFinding::NoneImplicit { tried_s } => format!("none found up to {tried_s} s"),
        StabilityFinding::LeftRest { tried_s, step_s } => format!(
            "{}with steps of {step_s} s the cloth left its rest shape, as it may by sliding",
            none_up_to(tried_s)
        ),
        StabilityFinding::NotSolved { tried_s, step_s } => format!(
            "{}the equations of steps of {step_s} s were not solved",
            none_up_to(tried_s)
        ),
    }
}

fn describe_excess(excess: &StepExcess) -> String {
    format!(
        "needs {:.1e} steps: {:.3} s in steps of {:.1e} s, more than the {} allowed",
        excess.count(),
        excess.time_s,
        excess.step_s,
        excess.limit
    )
}

/// Words what was found before a step failed for another reason.
fn none_up_to(tried_s: f64) -> String {
    if tried_s > 0.0 {
        format!("none found up to {tried_s} s; ")
    } else {
        String::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_beyond_the_limit_are_told() {
        let excess = StepExcess::of(2.0, 1e-3, 1000).expect("2000 are more");
        let why = describe_infeasibility(&Infeasibility::TooManySteps(excess));
        assert!(why.starts_with("needs 2.0e3 steps"), "{why}");
        assert!(why.contains("the 1000 allowed"), "{why}");
    }
}
