//! The stability limits of a study: for each method that steps, near the rest shape on each mesh.

use super::part::{PartKind, SkipReason, StudyPart};
use super::plan::{StudyPlan, StudyScene};
use super::report::StudyStability;
use super::schedule::StudySchedule;
use crate::solver::{self, Drape, Method, SolverOptions};

/// Weight of the limit of one method.
const WEIGHT: f64 = 2.0;

/// Returns the weight of all limits on one mesh.
pub(super) fn weight(plan: &StudyPlan) -> f64 {
    WEIGHT * plan.methods.iter().filter(|m| m.is_time_stepping()).count() as f64
}

/// Finds the limit of every method that steps, near the rest shape `rest`.
pub(super) fn limits(
    scene: &StudyScene,
    plan: &StudyPlan,
    rest: Option<&Drape>,
    schedule: &mut StudySchedule<'_, '_>,
) -> Vec<StudyStability> {
    let mut found = Vec::new();
    for &method in plan.methods.iter().filter(|m| m.is_time_stepping()) {
        let part = StudyPart {
            kind: PartKind::StabilityLimit(method),
            edge_length_m: scene.edge_length_m,
        };
        let Some(rest) = rest else {
            schedule.count_done(WEIGHT);
            schedule.skip(part, SkipReason::NothingToDisturb);
            continue;
        };
        let options = SolverOptions {
            method,
            ..plan.simulate.clone()
        };
        found.extend(limit(scene, options, rest, (part, schedule)));
    }
    found
}

fn limit(
    scene: &StudyScene,
    options: SolverOptions,
    rest: &Drape,
    (part, schedule): (StudyPart, &mut StudySchedule<'_, '_>),
) -> Option<StudyStability> {
    let method: Method = options.method;
    let step = schedule.run(part, WEIGHT, |context, time| {
        let options = SolverOptions {
            time_limit_s: Some(time),
            ..options
        };
        solver::stable_step(&scene.scene, &options, rest, context)
    })?;
    if step.stopped {
        schedule.skip(part, SkipReason::TimeUp);
        return None;
    }
    Some(StudyStability {
        method,
        edge_length_m: scene.edge_length_m,
        found_s: step.found_s,
        theory_s: step.theory_s,
        tried_s: step.tried_s,
        because: step.because,
    })
}
