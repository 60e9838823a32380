//! A second rest on a harder skin, of a garment so tight that triangles of its mesh cut into the
//! body.
//!
//! The skin gives way to the pressure of cloth, by half a millimeter where that is some kilopascal:
//! soft contact is what a solver gets through. Where cloth is drawn over a ridge by more, its
//! vertices and the middles of its edges stay outside, but triangles between them meet the body.

use super::costs;
use super::crossings::{self, FoundCrossings};
use crate::scene::Scene;
use crate::solver::{self, Context, Drape, DrapeReport, SolverOptions};

/// Pairs of triangles of cloth and body up to which skin that is harder helps.
const MOST_PAIRS: usize = 200;
/// Stiffness of the harder skin: cloth lies half as deep in it, since its pressure grows with the
/// cube of the depth.
const HARDER: f64 = 8.0;
/// Word for it among the fallbacks of a report.
const FALLBACK: &str = "harder_skin";

/// Goes on from `drape` on a harder skin, if it came to rest but cuts a little into the body, and
/// takes the new shape if that does less. Returns the crossings of the shape that it is then.
pub(super) fn settle(
    scene: &mut Scene,
    (drape, names): (&mut Drape, &[&str]),
    options: &SolverOptions,
    context: &mut Context<'_>,
) -> Option<FoundCrossings> {
    let pairs = context.limits.crossing_pairs;
    let find =
        |scene: &Scene, drape: &Drape| crossings::find(scene, names, &drape.positions, pairs);
    let found = find(scene, drape);
    let cuts = found.as_ref().and_then(|found| found.body).unwrap_or(0);
    if !drape.report.converged || !(1..=MOST_PAIRS).contains(&cuts) {
        return found;
    }
    scene.body_hardness = HARDER;
    let again = solver::drape_on(scene, options, drape, context);
    let found_again = find(scene, &again);
    let cuts_again = found_again.as_ref().and_then(|found| found.body);
    if !again.report.converged || cuts_again.is_none_or(|again| again >= cuts) {
        scene.body_hardness = 1.0;
        return found;
    }
    let first = std::mem::replace(drape, again);
    join(&mut drape.report, first.report);
    found_again
}

/// Adds to the report of the second rest what the way to the first cost and told.
fn join(report: &mut DrapeReport, first: DrapeReport) {
    report.mesh_error_m = first.mesh_error_m;
    report.started_from = first.started_from;
    report.plan = first.plan.clone();
    report.support = first.support.clone();
    let is_new = |word: &&String| !report.fallbacks.contains(word);
    let new: Vec<_> = first.fallbacks.iter().filter(is_new).cloned().collect();
    report.fallbacks.extend(new);
    report.fallbacks.push(FALLBACK.to_owned());
    costs::add(report, first);
}
