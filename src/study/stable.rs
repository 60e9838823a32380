//! The stability limits of a study: for each method that steps, near the rest shape on each mesh.

use super::report::StudyStability;
use super::run::{StudyPlan, StudyScene, edges};
use super::work::Work;
use crate::solver::{self, Drape, Method, SolverOptions};

/// Parts of a study that the limit of one method counts as.
const PARTS: f64 = 2.0;

/// Parts of a study on one mesh.
pub(super) fn parts(plan: &StudyPlan) -> f64 {
    PARTS * plan.methods.iter().filter(|m| m.is_time_stepping()).count() as f64
}

/// The limit of every method that steps, near the rest shape `rest`.
pub(super) fn limits(
    scene: &StudyScene,
    plan: &StudyPlan,
    rest: Option<&Drape>,
    work: &mut Work<'_, '_>,
) -> Vec<StudyStability> {
    let methods = plan
        .methods
        .iter()
        .copied()
        .filter(|m| m.is_time_stepping());
    methods
        .filter_map(|method| limit(scene, plan, method, rest, work))
        .collect()
}

fn limit(
    scene: &StudyScene,
    plan: &StudyPlan,
    method: Method,
    rest: Option<&Drape>,
    work: &mut Work<'_, '_>,
) -> Option<StudyStability> {
    let what = format!(
        "stability limit of {}, {}",
        method.name(),
        edges(scene.edge_length_m)
    );
    let Some(rest) = rest else {
        work.skip(PARTS);
        work.leave_out(what, "there is no shape at rest to disturb");
        return None;
    };
    let ask = SolverOptions {
        method,
        ..plan.simulate.clone()
    };
    let step = work.part(&what, PARTS, |context, time| {
        let ask = SolverOptions {
            time_limit_s: Some(time),
            ..ask
        };
        solver::stable_step(&scene.scene, &ask, rest, context)
    })?;
    if step.stopped {
        work.leave_out(what, "the time allowed was up");
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
