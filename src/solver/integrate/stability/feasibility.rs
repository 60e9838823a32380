//! A lower bound on the steps that a motion needs, so that what cannot end is refused before it
//! begins.
//!
//! A motion of known duration needs that over its longest step. A drape by motion has to come to
//! rest: with drag c per mass the energy of a swing falls by 2 c K a second, K its kinetic energy,
//! which is half of the whole on average; so amplitudes, and with them the residual, fall as exp(-c
//! t / 2), and those of swings slower than c / 2 (overdamped) more slowly still. From the residual
//! 1 of cloth that nothing holds up yet to ε that takes at least 2 ln(1 / ε) / c. The fundamental
//! frequency ([`crate::solver::integrate::damping::fundamental_frequency`]) would often ask for
//! more, but taut cloth has none, and a refusal must be right.

use crate::scene::Scene;
use crate::solver::drape::drag::RELAXATION_DRAG;
use crate::solver::integrate::outcome::{Infeasibility, StepExcess};
use crate::solver::integrate::select::integrator_for;
use crate::solver::integrate::settings::{IntegratorSettings, SAFETY};
use crate::solver::model::build::build;
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::seams::Seams;
use crate::solver::options::{Method, SeamClose, SolverOptions};
use nalgebra::Vector3;

/// Longest explicit step of a drape \[s\]: what moves nothing stiff still moves smoothly.
pub(crate) const LONGEST_EXPLICIT: f64 = 1e-3;

/// Returns the shortest time in which motion with `drag` \[1/s\] brings the residual from 1 to
/// `tolerance` \[s\].
fn time_to_rest(drag: f64, tolerance: f64) -> f64 {
    2.0 / drag * (1.0 / tolerance).max(1.0).ln()
}

/// Returns the reason why a drape of `scene` by the method asked for cannot end within `limit`
/// steps, if it cannot.
///
/// The stable step is that of the cloth flat and at rest, seams that stay springs included; bent,
/// stretched or pressed on a body its steps may only be shorter. Where there is friction or the
/// method damps by itself, drag of 0 is no reason.
#[inline(never)] // so that a profile tells what it takes
pub(crate) fn find_infeasibility(
    scene: &Scene,
    options: &SolverOptions,
    limit: u64,
    clock: &dyn Fn() -> f64,
) -> Option<Infeasibility> {
    let explicit = matches!(options.method, Method::SymplecticEuler | Method::Verlet);
    let step = match (explicit, options.step_s) {
        (false, step) => step?,
        (true, asked) => {
            let stable = stable_step(scene, options, clock);
            // One that is too long is refused for that.
            asked.unwrap_or(SAFETY * stable.min(LONGEST_EXPLICIT))
        }
    };
    let drag = scene.drag.unwrap_or(RELAXATION_DRAG);
    if drag == 0.0 {
        return (explicit && scene.friction == 0.0).then_some(Infeasibility::Undamped);
    }
    StepExcess::of(time_to_rest(drag, options.tolerance), step, limit)
        .map(Infeasibility::TooManySteps)
}

/// Returns the longest stable step of the cloth flat and at rest \[s\].
fn stable_step(scene: &Scene, options: &SolverOptions, clock: &dyn Fn() -> f64) -> f64 {
    // A flat garment cannot be welded: its panels lie apart.
    let seams = match options.seam_close {
        SeamClose::Spring => Seams::closed(options, options.sewing_stiffness()),
        SeamClose::Weld => Seams::Apart,
    };
    let build_options = BuildOptions {
        seams,
        hold: None,
        gravity: false,
        friction: None,
        explicit: false,
        least_thickness: None,
        finest: true,
    };
    let mut system = build(scene, options, &build_options, clock).system;
    let flat: Vec<_> = if scene.mesh.triangles.is_empty() {
        scene.start.clone()
    } else {
        let uv = scene.mesh.uv.iter();
        uv.map(|p| Vector3::new(p[0], p[1], 0.0)).collect()
    };
    let settings = IntegratorSettings {
        drag: scene.drag.unwrap_or(RELAXATION_DRAG),
        speed_limit: f64::INFINITY,
        residual: options.tolerance,
    };
    match integrator_for(&mut system, options.method, &settings) {
        Ok(Some(mut integrator)) => integrator.stable_step(&mut system, &flat),
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x = exp(-c t / 2) cos(…) is down to ε of its amplitude when c t / 2 = ln(1 / ε).
    #[test]
    fn a_swing_needs_the_time_of_its_decay() {
        let time = time_to_rest(8.0, 1e-5);
        assert!(((-0.5 * 8.0 * time).exp() / 1e-5 - 1.0).abs() < 1e-12);
        assert_eq!(time_to_rest(8.0, 10.0), 0.0);
    }
}
