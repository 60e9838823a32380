//! Runs a study: all its parts, in the order in which they are worth most should the time not
//! suffice.

use super::drape_runs::DrapeRuns;
use super::finding::StartShape;
use super::motion_runs::MotionRuns;
use super::plan::{StudyPlan, StudyScene};
use super::report::{SCHEMA, Study, StudyMesh};
use super::resolve::ResolvedStudy;
use super::schedule::StudySchedule;
use super::{mesh_error, recommendation, stability, wording};
use crate::fault::Faults;
use crate::fit;
use crate::solver::{Analysis, Context};

const NO_SELF_CONTACT: &str = "Cloth may pass through cloth in all runs of this study: methods that \
    step in time cannot keep it from that.";

/// Makes all runs of a study, each measured against a reference that the study converges itself.
///
/// # Errors
/// Faults that show only on the way: a mesh too fine for the limits.
pub fn run(study: &ResolvedStudy, context: &mut Context<'_>) -> Result<Study, Faults> {
    let request = study.request();
    // Methods that step in time have none, and are measured by rest shapes.
    let has_self_contact = request.methods.iter().all(|m| !m.is_time_stepping());
    let mut leaves_out = false;
    let mut scenes = Vec::new();
    for garment in study.garments() {
        let scene = match fit::scene(garment, context) {
            Ok(mut scene) => {
                leaves_out |= scene.self_contact && !has_self_contact;
                scene.self_contact &= has_self_contact;
                scene
            }
            Err(_) if context.cancel.is_canceled() => break,
            Err(faults) => return Err(faults.under("/garment")),
        };
        scenes.push(StudyScene {
            edge_length_m: garment.garment().simulate.edge_length_m,
            scene,
        });
    }
    let plan = StudyPlan {
        simulate: request.garment.simulate.clone(),
        methods: request.methods.clone(),
        tolerances: request.tolerances.clone(),
        steps_s: request.steps_s.clone(),
        time_limit_s: request.time_limit_s,
    };
    let mut study = run_scenes(&scenes, &plan, context);
    if leaves_out {
        study.notes.push(NO_SELF_CONTACT.to_owned());
    }
    Ok(study)
}

/// As [`run`], on scenes that are assembled already, such as raw ones: the same cloth on one mesh
/// or several.
///
/// # Guarantees
/// Ends soon after the time allowed and when canceled, with what was left out listed. All numbers
/// are finite.
pub fn run_scenes(scenes: &[StudyScene], plan: &StudyPlan, context: &mut Context<'_>) -> Study {
    let is_motion = plan.simulate.analysis == Analysis::Transient;
    let runs = if is_motion {
        MotionRuns::weight(plan)
    } else {
        DrapeRuns::weight(plan)
    };
    let weight = (runs + stability::weight(plan)) * scenes.len() as f64;
    let allowed = [plan.time_limit_s, plan.simulate.time_limit_s];
    let mut schedule = StudySchedule::new(context, allowed, weight);
    let mut study = empty(plan);
    let mut results = Vec::new();
    for scene in scenes {
        results.push(if is_motion {
            MotionRuns::new(scene, plan, &mut schedule).run(&mut study)
        } else {
            DrapeRuns::new(scene, plan, &mut schedule).run(&mut study)
        });
    }
    for (scene, result) in scenes.iter().zip(&results) {
        let limits = stability::limits(scene, plan, result.rest.as_ref(), &mut schedule);
        study.stability.extend(limits);
    }
    let errors = mesh_error::mesh_errors(scenes, &results);
    for (result, error) in results.into_iter().zip(errors) {
        study.meshes.push(StudyMesh {
            mesh_error_m: error,
            ..result.mesh
        });
    }
    study.cpu_s = schedule.cpu_s();
    study.canceled = schedule.is_canceled();
    let skipped = schedule.skipped().iter();
    study.left_out = skipped
        .map(|(part, why)| wording::skipped(part, why))
        .collect();
    study.complete = study.left_out.is_empty() && !study.canceled;
    let notes = recommendation::notes(&study, scenes);
    study.notes = notes.iter().map(wording::note).collect();
    let recommended = recommendation::recommend(&study);
    study.recommendation = wording::recommendation(recommended.as_ref());
    study
}

fn empty(plan: &StudyPlan) -> Study {
    Study {
        schema: SCHEMA.to_owned(),
        want: plan.simulate.analysis,
        membrane: plan.simulate.membrane,
        start: wording::start(StartShape::Placed).to_owned(),
        meshes: Vec::new(),
        runs: Vec::new(),
        orders: Vec::new(),
        stability: Vec::new(),
        recommendation: String::new(),
        notes: Vec::new(),
        left_out: Vec::new(),
        complete: false,
        canceled: false,
        cpu_s: 0.0,
        version: env!("CARGO_PKG_VERSION").to_owned(),
    }
}
