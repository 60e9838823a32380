//! Runs a study: all its parts, in the order in which they are worth most should the time not suffice.

use super::drapes::Drapes;
use super::motions::Motions;
use super::prepare::PreparedStudy;
use super::report::{SCHEMA, Study, StudyMesh};
use super::work::Work;
use super::{compare, recommend, stable};
use crate::fault::Faults;
use crate::fit;
use crate::scene::Scene;
use crate::solver::{Analysis, Context, Drape, Method, SolverOptions};
use nalgebra::Vector3;

/// What a study varies, on scenes that are assembled already.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyPlan {
    /// What all runs have in common: what is wanted, membrane, seams, duration, frame rate, the time limit of one run.
    pub simulate: SolverOptions,
    /// Methods.
    pub methods: Vec<Method>,
    /// Tolerances, as [`super::StudyAsked::tolerances`].
    pub tolerances: Vec<f64>,
    /// Fixed steps of a motion, as [`super::StudyAsked::steps_s`] \[s\].
    pub steps_s: Vec<f64>,
    /// CPU time of the whole \[s\].
    pub time_limit_s: Option<f64>,
}

/// One mesh of what is studied.
#[derive(Clone, Debug)]
pub struct StudyScene {
    /// Length of its mesh edges \[m\].
    pub edge_length_m: f64,
    /// The scene.
    pub scene: Scene,
}

/// What one mesh gave besides its runs.
pub(super) struct OnMesh {
    pub(super) mesh: StudyMesh,
    /// What meshes are compared by: the rest shape, or frames of the motion \[m\].
    pub(super) shapes: Vec<Vec<Vector3<f64>>>,
    /// A shape at rest, to disturb.
    pub(super) rest: Option<Drape>,
}

/// Makes all runs of a study, each measured against a reference that the study converges itself.
///
/// # Errors
/// What could be found only on the way: a mesh too fine for the limits.
pub fn run(prepared: &PreparedStudy, context: &mut Context<'_>) -> Result<Study, Faults> {
    let asked = prepared.asked();
    let mut scenes = Vec::new();
    for fit in &prepared.fits {
        let scene = match fit::scene(fit, context) {
            Ok(scene) => scene,
            Err(_) if context.cancel.is_canceled() => break,
            Err(faults) => return Err(faults.under("/garment")),
        };
        scenes.push(StudyScene {
            edge_length_m: fit.garment().simulate.edge_length_m,
            scene,
        });
    }
    let plan = StudyPlan {
        simulate: asked.garment.simulate.clone(),
        methods: asked.methods.clone(),
        tolerances: asked.tolerances.clone(),
        steps_s: asked.steps_s.clone(),
        time_limit_s: asked.time_limit_s,
    };
    Ok(run_scenes(&scenes, &plan, context))
}

/// As [`run`], on scenes that are assembled already, such as raw ones: the same cloth on one mesh or several.
///
/// # Guarantees
/// Ends soon after the time allowed and when canceled, with what was left out listed. All numbers are finite.
pub fn run_scenes(scenes: &[StudyScene], plan: &StudyPlan, context: &mut Context<'_>) -> Study {
    let wants_motion = plan.simulate.analysis == Analysis::Transient;
    let per_mesh = if wants_motion {
        Motions::parts(plan)
    } else {
        Drapes::parts(plan)
    } + stable::parts(plan);
    let parts = per_mesh * scenes.len() as f64;
    let each = plan.simulate.time_limit_s;
    let mut work = Work::new(context, plan.time_limit_s, each, parts);
    let mut study = empty(plan);
    let mut on_meshes = Vec::new();
    for scene in scenes {
        on_meshes.push(if wants_motion {
            Motions::new(scene, plan, &mut work).run(&mut study)
        } else {
            Drapes::new(scene, plan, &mut work).run(&mut study)
        });
    }
    for (scene, on_mesh) in scenes.iter().zip(&on_meshes) {
        let found = stable::limits(scene, plan, on_mesh.rest.as_ref(), &mut work);
        study.stability.extend(found);
    }
    let errors = compare::mesh_errors(scenes, &on_meshes);
    for (on_mesh, error) in on_meshes.into_iter().zip(errors) {
        study.meshes.push(StudyMesh {
            mesh_error_m: error,
            ..on_mesh.mesh
        });
    }
    study.cpu_s = work.cpu_s();
    study.canceled = work.is_canceled();
    study.left_out = work.left_out;
    study.complete = study.left_out.is_empty() && !study.canceled;
    study.notes = recommend::notes(&study, scenes);
    study.recommendation = recommend::sentence(&study);
    study
}

fn empty(plan: &StudyPlan) -> Study {
    Study {
        schema: SCHEMA.to_owned(),
        want: plan.simulate.analysis,
        membrane: plan.simulate.membrane,
        start: "the panels where they were put".to_owned(),
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

/// A length of mesh edges in words.
pub(super) fn edges(edge_length_m: f64) -> String {
    format!("{} mm edges", (1e6 * edge_length_m).round() * 1e-3)
}
