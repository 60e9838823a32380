//! How many steps a motion needs at least, so that what cannot end is refused before it is begun.
//!
//! A motion of known duration needs that over its longest step. A drape by motion has to come to rest: with drag c per mass the
//! energy of a swing falls by 2 c K a second, K its kinetic energy, which is half of the whole on average; so amplitudes, and
//! with them the residual, fall as exp(-c t / 2), and those of swings slower than c / 2 (overdamped) more slowly still. From the
//! residual 1 of cloth that nothing holds up yet to ε that takes at least 2 ln(1 / ε) / c. The slowest swing
//! ([`crate::solver::integrate::damping::fundamental_frequency`]) would often ask for more, but taut cloth has none, and a refusal must be right.

use crate::scene::Scene;
use crate::solver::drape::drag::RELAXATION_DRAG;
use crate::solver::integrate::select::integrator_for;
use crate::solver::integrate::settings::{IntegratorSettings, SAFETY};
use crate::solver::model::build::{BuildOptions, build};
use crate::solver::model::seams::Seams;
use crate::solver::options::{Method, SeamClose, SolverOptions};
use nalgebra::Vector3;

/// Longest explicit step of a drape \[s\]: what moves nothing stiff still moves smoothly.
pub(crate) const LONGEST_EXPLICIT: f64 = 1e-3;

/// Shortest time in which motion with `drag` \[1/s\] brings the residual from 1 to `tolerance` \[s\].
fn time_to_rest(drag: f64, tolerance: f64) -> f64 {
    2.0 / drag * (1.0 / tolerance).max(1.0).ln()
}

/// What is said of `time` \[s\] in steps of `step` \[s\] where that is more than `limit` steps.
pub(crate) fn too_many(time: f64, step: f64, limit: u64) -> Option<String> {
    let count = time / step;
    (count > limit as f64).then(|| {
        format!(
            "needs {count:.1e} steps: {time:.3} s in steps of {step:.1e} s, more than the {limit} allowed"
        )
    })
}

/// Why a drape of `scene` by the method asked for cannot end within `limit` steps, if it cannot.
///
/// The stable step is that of the cloth flat and at rest, seams that stay springs included; bent, stretched or pressed on a body
/// its steps may only be shorter. Where there is friction or the method damps by itself, drag of 0 is no reason.
#[inline(never)] // so that a profile tells what it takes
pub(crate) fn refuse(
    scene: &Scene,
    options: &SolverOptions,
    limit: u64,
    clock: &dyn Fn() -> f64,
) -> Option<String> {
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
        return (explicit && scene.friction == 0.0).then(|| {
            "explicit steps without drag never come to rest: give the scene a drag, or ask for newton".to_owned()
        });
    }
    let why = too_many(time_to_rest(drag, options.tolerance), step, limit)?;
    Some(format!(
        "{why}: ask for newton, for longer mesh edges, or for softer cloth"
    ))
}

/// The longest stable step of the cloth flat and at rest \[s\].
fn stable_step(scene: &Scene, options: &SolverOptions, clock: &dyn Fn() -> f64) -> f64 {
    // A flat garment cannot be welded: its panels lie apart.
    let seams = match options.seam_close {
        SeamClose::Spring => Seams::closed(options, options.sewing_stiffness()),
        SeamClose::Weld => Seams::Apart,
    };
    let build_options = BuildOptions {
        seams,
        gravity: false,
        friction: None,
        explicit: false,
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

    #[test]
    fn steps_beyond_the_limit_are_counted_and_told() {
        assert_eq!(too_many(1.0, 1e-3, 1001), None);
        let why = too_many(2.0, 1e-3, 1000).expect("2000 are more");
        assert!(why.starts_with("needs 2.0e3 steps"), "{why}");
        assert!(why.contains("the 1000 allowed"), "{why}");
    }
}
