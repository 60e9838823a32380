//! The paper's method (P8): V += (F / m - c V) t, then X += V t, with the step kept under the stability limit.

use super::newton::{Iteration, Stop, Verdict};
use super::system::System;
use nalgebra::Vector3;

/// Share of the stability limit that is used.
const SAFETY: f64 = 0.95;
/// Steps between two looks at the residual.
const LOOK_EVERY: usize = 100;

/// How a trajectory is damped and bounded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    /// Drag per mass `C_d / m` \[1/s\].
    pub(crate) drag: f64,
    /// Greatest speed \[m/s\]: at the steps in question far less than the layer on the skin, so that nothing passes through.
    pub(crate) speed_limit: f64,
    /// The step asked for \[s\]; the largest stable one if absent.
    pub(crate) step: Option<f64>,
}

/// The largest stable step of `system` \[s\].
///
/// The highest frequency is bounded by Gershgorin's theorem on M⁻¹ H in the rest shape; with drag c the scheme is stable
/// while h² ω² + 2 c h <= 4.
pub(crate) fn stable_step(system: &mut System<'_>, drag: f64) -> f64 {
    let square = system
        .stiffness()
        .iter()
        .zip(&system.mass)
        .map(|(k, m)| k / m)
        .fold(0.0, f64::max);
    if square == 0.0 {
        f64::INFINITY
    } else {
        ((drag * drag + 4.0 * square).sqrt() - drag) / square
    }
}

/// Steps from `x` at rest until `judge` says so, at most `limit` steps.
///
/// # Errors
/// The largest stable step, if the one asked for is above it.
pub(crate) fn run(
    system: &mut System<'_>,
    x: &mut [Vector3<f64>],
    motion: Motion,
    limit: u64,
    judge: &mut dyn FnMut(Iteration<'_>) -> Verdict,
) -> Result<Stop, f64> {
    let stable = stable_step(system, motion.drag);
    let h = match motion.step {
        Some(asked) if asked > stable => return Err(stable),
        Some(asked) => asked,
        None => SAFETY * stable.min(1e-3),
    };
    let mut velocity = vec![Vector3::zeros(); x.len()];
    let mut force = vec![Vector3::zeros(); x.len()];
    let mut number = 0;
    for step in 0..limit {
        if let Some(contact) = &mut system.contact {
            contact.accept(x);
        }
        system.net_force(x, &mut force);
        if step % LOOK_EVERY as u64 == 0 {
            let residual = system.residual(&force);
            if !residual.is_finite() {
                return Ok(Stop::NotFinite);
            }
            match judge(Iteration {
                number,
                residual,
                positions: x,
            }) {
                Verdict::Continue => {}
                Verdict::Reached => return Ok(Stop::Reached),
                Verdict::Interrupt => return Ok(Stop::Interrupted),
            }
            number += 1;
        }
        advance(system, &force, h, motion, x, &mut velocity);
    }
    Ok(Stop::Iterations)
}

fn advance(
    system: &System<'_>,
    force: &[Vector3<f64>],
    h: f64,
    motion: Motion,
    x: &mut [Vector3<f64>],
    velocity: &mut [Vector3<f64>],
) {
    let kept = 1.0 - motion.drag * h;
    let limit = motion.speed_limit * motion.speed_limit;
    for (((x, v), f), m) in x.iter_mut().zip(velocity).zip(force).zip(&system.mass) {
        *v = *v * kept + f * (h / m);
        let square = v.norm_squared();
        if square > limit {
            *v *= (limit / square).sqrt();
        }
        *x += *v * h;
    }
}
