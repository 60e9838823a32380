//! The report of a drape, from its outcome. Every sentence of the report is made here, after the
//! solve.

use crate::scene::Scene;
use crate::solver::forces::TermKind;
use crate::solver::model::build::bends;
use crate::solver::outcome::{
    AtRest, Drape, DrapeOutcome, ESTIMATE_RESIDUAL_LIMIT, ErrorEstimate, LevelOutcome, StageEnd,
    Unfinished, Validity,
};
use crate::solver::report::cost_model::{ErrorHalving, error_halving};
use crate::solver::report::motion::describe_infeasibility;
use crate::solver::report::schema::{
    Advice, CpuSeconds, DrapeReport, LevelReport, Plan, SkippedTerm, Support, TermTime,
};
use crate::solver::statistics::{SolveStatistics, TermTimes};
use nalgebra::Vector3;

/// Distance that the middle of a garment may sink while it comes to rest before it counts as fallen
/// off \[m\].
const FALLEN: f64 = 0.15;
/// Depth inside the body at which cloth may still be supported by it \[m\]: more than any layer
/// gives way or any triangle cuts off.
const INSIDE: f64 = 0.01;
/// Name of what is no term of its own, but a part of contact.
const FRICTION: &str = "friction";

/// Puts the outcome of a drape of `scene` into words.
#[inline(never)] // so that a profile tells what it takes
pub(crate) fn describe(scene: &Scene, outcome: DrapeOutcome) -> Drape {
    let report = drape_report(scene, &outcome);
    Drape {
        positions: outcome.positions,
        handed_on: outcome.handed_on,
        anchors: outcome.anchors,
        canceled: outcome.canceled,
        report,
    }
}

fn drape_report(scene: &Scene, outcome: &DrapeOutcome) -> DrapeReport {
    let SolveStatistics {
        iterations,
        fallbacks,
        terms,
    } = &outcome.statistics;
    let (mesh, measures, levels) = (&scene.mesh, &outcome.measures, &outcome.levels);
    let (balance, estimate) = (&outcome.balance, outcome.estimate);
    let fallbacks = fallbacks
        .iter()
        .map(|fallback| fallback.as_str().to_owned());
    let terms = term_times(terms);
    DrapeReport {
        converged: outcome.end.is_ok(),
        why: reason(outcome),
        residual: balance.residual,
        residual_floor: balance.residual_floor,
        error_estimate_m: estimate.and_then(|estimate| estimate.distance_m),
        error_estimate_valid: estimate.is_some_and(|e| e.validity == Validity::Valid),
        error_estimate_because: estimate.map_or(String::new(), estimate_basis),
        mesh_error_m: outcome.mesh_error_m,
        to_halve_the_error: error_halving(outcome).map(|halving| advice(halving, &outcome.end)),
        energy_j: balance.energy,
        seam_gap_max_m: measures.seam_gap_m,
        strain_max: measures.strain,
        penetration_max_m: measures.penetration_m,
        support: support(scene, outcome),
        vertices: mesh.uv.len(),
        triangles: mesh.triangles.len(),
        stitches: mesh.stitches.len(),
        skipped_terms: skipped_terms(scene, &terms),
        terms,
        newton_iterations: *iterations,
        plan: plan(outcome),
        levels: levels.iter().map(level_report).collect(),
        cpu_s: CpuSeconds {
            sew: levels.iter().fold(0.0, |sum, level| sum + level.sew_s),
            drape: levels.iter().fold(0.0, |sum, level| sum + level.relax_s),
            total: outcome.cpu_s,
            ..CpuSeconds::default()
        },
        error_against_run_time: outcome.history.clone(),
        method: outcome.method.name().to_owned(),
        fallbacks: fallbacks.collect(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        ..DrapeReport::default()
    }
}

/// Returns why the drape ended.
fn reason(outcome: &DrapeOutcome) -> String {
    let residual = outcome.balance.residual;
    match &outcome.end {
        Ok(AtRest::WithinTolerance) => stage_reason(StageEnd::Converged, residual),
        Ok(AtRest::WithinDistance) => {
            format!("at rest: within the distance asked for, at r = {residual:.1e}")
        }
        Ok(AtRest::AtRoundOffFloor) => format!(
            "at rest: stopped by the round-off floor of {:.1e}, at r = {residual:.1e}",
            outcome.balance.residual_floor
        ),
        Err(Unfinished::Refused(reason)) => describe_infeasibility(reason),
        Err(Unfinished::SeamsOpen {
            stage,
            gap_m,
            end,
            residual,
        }) => format!(
            "the seams of stage {stage} are still {:.2} mm apart: {}",
            gap_m * 1e3,
            stage_reason(*end, *residual)
        ),
        Err(Unfinished::NotRelaxed { end, residual }) => stage_reason(*end, *residual),
        Err(Unfinished::NoTimeForFinerMesh {
            vertices,
            finer_vertices,
        }) => format!(
            "the time allowed was up before the mesh of {finer_vertices} vertices; this is the shape at rest of the one of {vertices}"
        ),
    }
}

/// Returns why a stage ended at the residual `r`.
fn stage_reason(end: StageEnd, r: f64) -> String {
    match end {
        StageEnd::Converged => format!("at rest: r = {r:.1e}"),
        StageEnd::StepTooLong { limit_s } => format!(
            "step_s is above the stability limit of {limit_s:.2e} s: give a shorter one or leave it out"
        ),
        StageEnd::FellOff => "it fell off the body: nothing holds it up".to_owned(),
        StageEnd::Canceled => format!("canceled at r = {r:.1e}"),
        StageEnd::OutOfTime => format!("the time allowed was up at r = {r:.1e}"),
        StageEnd::Stalled => format!("no step lowers the energy any more, at r = {r:.1e}"),
        StageEnd::IterationLimit => format!("the limit of iterations was reached at r = {r:.1e}"),
        StageEnd::OutOfMemory => {
            "there is no memory for the matrix factor: ask for longer mesh edges".to_owned()
        }
        StageEnd::NotFinite => "forces became infinite: look for panels that start inside the body or seams of very unlike length".to_owned(),
    }
}

/// Returns what an error estimate is made of, and how far it is to be trusted.
fn estimate_basis(estimate: ErrorEstimate) -> String {
    match estimate.validity {
        Validity::Valid => "valid: the forces left over, divided by the stiffness, of a shape in a minimum of the energy near to rest".to_owned(),
        Validity::NotInMinimum => {
            "none: the shape is at rest, but not in a minimum of the energy".to_owned()
        }
        Validity::ContactUnsettled => {
            "not valid: cloth slips on the body, or comes and goes there".to_owned()
        }
        Validity::FarFromRest => {
            format!("not valid: r is above {ESTIMATE_RESIDUAL_LIMIT:.0e}, too far from rest")
        }
        Validity::ByMoves => "not valid, but mostly right within 3 times: drawn from the forces left, from how the shape moved lately, and from mesh to mesh".to_owned(),
        Validity::Unknown => "none: too little is known of how the shape moves".to_owned(),
    }
}

/// Returns true if the body carries the garment, which came to rest on it without sinking far; and
/// why.
fn support(scene: &Scene, outcome: &DrapeOutcome) -> Support {
    let (sunk_mm, inside_mm) = (outcome.sunk_m * 1e3, outcome.measures.penetration_m * 1e3);
    let way = if outcome.sunk_m < 0.0 {
        "higher"
    } else {
        "lower"
    };
    let moved = format!(
        "{:.0} mm {way} than it was sewn",
        outcome.sunk_m.abs() * 1e3
    );
    let mut sank_m = None;
    let (ok, because) = if scene.body.is_none() {
        (None, "there is no avatar".to_owned())
    } else if outcome.end.is_err() {
        (
            Some(false),
            format!("it did not come to rest; its middle is {moved}"),
        )
    } else if outcome.measures.penetration_m > INSIDE {
        (
            Some(false),
            format!("it came to rest with cloth {inside_mm:.0} mm inside the body"),
        )
    } else if outcome.sunk_m > FALLEN {
        sank_m = Some(outcome.sunk_m);
        (
            Some(false),
            format!("it sank by {sunk_mm:.0} mm: nothing holds it where it was put"),
        )
    } else {
        (Some(true), format!("it came to rest on the body, {moved}"))
    };
    Support {
        ok,
        because,
        openings: vec![],
        sank_m,
    }
}

/// Returns the terms that `scene` has no need of, but for those in `ran`: coarser meshes bend even
/// where the cloth does not.
fn skipped_terms(scene: &Scene, ran: &[TermTime]) -> Vec<SkippedTerm> {
    let mut skipped = Vec::new();
    let mut skip = |name: &str, because: &str| {
        if ran.iter().all(|term| term.name != name) {
            skipped.push(SkippedTerm {
                name: name.to_owned(),
                because: because.to_owned(),
            });
        }
    };
    if scene.gravity == Vector3::zeros() {
        skip(TermKind::Gravity.name(), "the scene has none");
    }
    if scene.wind.is_none() {
        skip(TermKind::Wind.name(), "the scene has none");
    }
    let because = if scene.self_contact {
        "motion passes cloth through cloth in this version: crossings are counted"
    } else {
        "cloth may pass through cloth in this scene"
    };
    skip(TermKind::SelfContact.name(), because);
    if scene.body.is_none() {
        skip(TermKind::Contact.name(), "the scene has no avatar");
        skip(
            FRICTION,
            "the scene has no avatar; that of layers is part of their contact",
        );
    } else if scene.friction == 0.0 {
        skip(FRICTION, "the coefficient is 0");
    }
    if scene.mesh.stitches.is_empty() {
        skip(TermKind::Seam.name(), "the scene has no seams");
    }
    if !bends(scene) {
        skip(
            TermKind::Bend.name(),
            "the fabrics have no bending rigidity",
        );
    }
    skipped
}

/// Returns the terms that ran by their names.
pub(crate) fn term_times(terms: &TermTimes) -> Vec<TermTime> {
    let named = |(kind, cpu_s): (TermKind, f64)| TermTime {
        name: kind.name().to_owned(),
        cpu_s,
    };
    terms.iter().map(named).collect()
}

fn level_report(level: &LevelOutcome) -> LevelReport {
    LevelReport {
        vertices: level.vertices,
        newton_iterations: level.statistics.iterations,
        cpu_s: level.cpu_s(),
        residual: level.residual(),
        moved_m: level.moved_m,
    }
}

/// Returns what was planned, and what came of it.
fn plan(outcome: &DrapeOutcome) -> Plan {
    let (plan, total) = (&outcome.plan, outcome.cpu_s);
    let allowed = outcome.time_limit_reached();
    let expected = plan.expected_cpu_s.map_or(String::new(), |expected| {
        format!("; {expected:.1} s were expected to do for all")
    });
    Plan {
        levels: plan.vertices.clone(),
        time_limit_s: plan.time_limit_s,
        expected_cpu_s: plan.expected_cpu_s,
        outcome: format!(
            "{} of {} meshes in {total:.1} s of CPU{}{expected}",
            outcome.levels.len(),
            plan.vertices.len(),
            allowed.map_or(String::new(), |s| format!(" of {s:.1} s allowed")),
        ),
    }
}

/// Returns the option to change, by which factor, and why.
fn advice(halving: ErrorHalving, end: &Result<AtRest, Unfinished>) -> Advice {
    let (field, because) = match halving {
        ErrorHalving::Tolerance { .. } if *end == Ok(AtRest::WithinDistance) => (
            "tolerance_m",
            "most of the error is the solver's, and goes down with the distance asked for",
        ),
        ErrorHalving::Tolerance { .. } => (
            "tolerance",
            "most of the error is the solver's, and goes down with the residual",
        ),
        ErrorHalving::EdgeLength {
            is_error_known: true,
            ..
        } => (
            "edge_length_m",
            "most of the error is the mesh's, and goes down with the square of its edges where the cloth is smooth; folds that fall another way move further",
        ),
        ErrorHalving::EdgeLength { .. } => (
            "edge_length_m",
            "the mesh has no coarser ones to tell its error, which goes down with the square of its edges where the cloth is smooth",
        ),
        ErrorHalving::TimeLimit { .. } => {
            ("time_limit_s", "the time was up, and the shape still moved")
        }
    };
    Advice {
        field: field.to_owned(),
        factor: halving.factor(),
        cpu_s: halving.cpu_s(),
        because: because.to_owned(),
    }
}
