//! Runs a study.

use super::prepare::PreparedStudy;
use super::report::{SCHEMA, Study, StudyRun};
use crate::fault::Faults;
use crate::fit;
use crate::scene::Scene;
use crate::solver::{self, Context, Method, Simulate};

/// Makes all runs of a study, each measured against a reference that the study converges itself.
///
/// # Errors
/// What could be found only on the way: a mesh too fine for the limits.
pub fn run(prepared: &PreparedStudy, context: &mut Context<'_>) -> Result<Study, Faults> {
    let asked = prepared.asked();
    let mut study = Study {
        schema: SCHEMA.to_owned(),
        want: asked.garment.simulate.want,
        membrane: asked.garment.simulate.membrane,
        start: String::new(),
        meshes: Vec::new(),
        runs: Vec::new(),
        orders: Vec::new(),
        stability: Vec::new(),
        recommendation: String::new(),
        notes: Vec::new(),
        left_out: Vec::new(),
        complete: true,
        canceled: false,
        cpu_s: 0.0,
        version: env!("CARGO_PKG_VERSION").to_owned(),
    };
    for fit in &prepared.fits {
        let scene = fit::scene(fit, context)?;
        for &method in &asked.methods {
            for &tolerance in &asked.tolerances {
                let ask = Simulate {
                    method,
                    tolerance,
                    ..fit.garment().simulate.clone()
                };
                study.runs.push(draped(&scene, &ask, context));
            }
        }
    }
    Ok(study)
}

fn draped(scene: &Scene, ask: &Simulate, context: &mut Context<'_>) -> StudyRun {
    let report = solver::drape(scene, ask, context).report;
    let energy = report.energy_j;
    StudyRun {
        method: ask.method,
        used: report.method.clone(),
        tolerance: Some(ask.tolerance),
        step_s: None,
        edge_length_m: ask.edge_length_m,
        vertices: report.vertices,
        cpu_s: report.cpu_s.total,
        error_m: None,
        error_certain: false,
        estimate_m: report.error_estimate_m,
        estimate_valid: report.error_estimate_valid,
        energy_j: energy.stretch + energy.bend + energy.gravity + energy.seam + energy.contact,
        residual: Some(report.residual),
        minimum: None,
        minimum_energy_j: None,
        same_as_reference: None,
        steps: report.newton_iterations as u64,
        converged: report.converged,
        why: report.why,
    }
}

/// The name that a method has in JSON.
pub(super) fn name_of(method: Method) -> String {
    match method {
        Method::Auto => "auto",
        Method::SymplecticEuler => "symplectic_euler",
        Method::Verlet => "verlet",
        Method::ImplicitEuler => "implicit_euler",
        Method::Bdf2 => "bdf2",
        Method::Newton => "newton",
    }
    .to_owned()
}
