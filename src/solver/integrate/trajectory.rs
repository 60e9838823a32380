//! The motion of a scene from a start: frames at even times.

use crate::scene::Scene;
use crate::solver::Context;
use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::integrate::damping;
use crate::solver::integrate::integrator::ParticleState;
use crate::solver::integrate::report::{MotionReport, Trajectory};
use crate::solver::integrate::simulation::MotionSimulation;
use crate::solver::model::build::{Model, build};
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::seams::Seams;
use crate::solver::options::{Method, SolverOptions};
use crate::solver::report::describe::term_times;
use crate::solver::report::motion::{describe_completion, describe_method, describe_termination};
use crate::solver::statistics::TermTimes;
use nalgebra::Vector3;

/// Initial state of a motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Start {
    /// Position of each vertex \[m\]; `#V`. The scene's start if absent.
    pub positions: Option<Vec<Vector3<f64>>>,
    /// Velocity of each vertex \[m/s\]; `#V`. At rest if absent.
    pub velocities: Option<Vec<Vector3<f64>>>,
}

/// Simulates the motion of `scene` from `from` for [`SolverOptions::duration_s`].
///
/// Seams are taken as closed: drape a garment that is not sewn first. Drag is the scene's, or that
/// of its fabrics (`damping::drag`).
///
/// # Guarantees
/// Ends within the limits of the context; frames are finite. The report says whether all of the
/// time was simulated, and why not where it was not. Same input, same bytes.
pub fn trajectory(
    scene: &Scene,
    options: &SolverOptions,
    from: Start,
    context: &mut Context<'_>,
) -> Trajectory {
    let began = (context.cpu_s)();
    let build_options = BuildOptions {
        seams: Seams::closed(options, options.sewing_stiffness()),
        hold: None,
        gravity: true,
        friction: Some(&FrictionAnchors::default()),
        // Automatic methods may turn out to be explicit.
        explicit: options.method.is_explicit() || options.method == Method::Auto,
        least_thickness: None,
        finest: true,
    };
    let Model {
        dof_map,
        mut system,
    } = build(scene, options, &build_options, context.cpu_s);
    let mut state =
        ParticleState::at_rest(&dof_map.average(from.positions.as_ref().unwrap_or(&scene.start)));
    state.windy = true;
    if let Some(velocities) = &from.velocities {
        state.v = dof_map.average(velocities);
        system.zero_fixed(&mut state.v);
    }
    let mut simulation = MotionSimulation {
        options,
        began,
        dof_map: &dof_map,
        frames: Vec::new(),
        report: MotionReport {
            within_limits: true,
            step_min_s: f64::INFINITY,
            drag_1_s: scene.drag.unwrap_or_else(|| damping::drag(scene)),
            ..MotionReport::default()
        },
        method: None,
        method_reason: None,
        canceled: false,
        context,
    };
    let result = simulation.run(
        &mut system,
        &mut state,
        damping::fundamental_frequency(scene),
    );
    let report = &mut simulation.report;
    report.why = match result {
        Ok(()) => describe_completion(report.simulated_s),
        Err(termination) => describe_termination(&termination),
    };
    report.method = simulation
        .method
        .map_or(String::new(), |method| method.name().to_owned());
    report.method_because = simulation.method_reason.as_ref().map(describe_method);
    simulation.report.terms = term_times(&TermTimes::of_system(&system));
    simulation.report.cpu_s = (simulation.context.cpu_s)() - began;
    if simulation.report.steps == 0 {
        simulation.report.step_min_s = 0.0;
    }
    Trajectory {
        frames: simulation.frames,
        report: simulation.report,
        canceled: simulation.canceled,
    }
}
