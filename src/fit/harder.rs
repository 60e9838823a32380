//! A second rest on a harder skin, of a garment so tight that triangles of its mesh cut into the
//! body.
//!
//! The skin gives way to the pressure of cloth, by half a millimeter where that is some kilopascal:
//! soft contact is what a solver gets through. Where cloth is drawn over a ridge by more, its
//! vertices and the middles of its edges stay outside, but triangles between them meet the body.

use super::crossings::{self, FoundCrossings};
use crate::scene::Scene;
use crate::solver::{self, Context, Drape, DrapeReport, SolverOptions, TermTime};

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
    report.newton_iterations += first.newton_iterations;
    report.levels.splice(0..0, first.levels);
    report.cpu_s.sew += first.cpu_s.sew;
    report.cpu_s.drape += first.cpu_s.drape;
    report.plan = first.plan;
    report.support = first.support;
    for TermTime { name, cpu_s } in first.terms {
        match report.terms.iter_mut().find(|term| term.name == name) {
            Some(term) => term.cpu_s += cpu_s,
            None => report.terms.push(TermTime { name, cpu_s }),
        }
    }
    let new = first
        .fallbacks
        .into_iter()
        .filter(|word| !report.fallbacks.contains(word));
    let new: Vec<_> = new.chain([FALLBACK.to_owned()]).collect();
    report.fallbacks.extend(new);
}
