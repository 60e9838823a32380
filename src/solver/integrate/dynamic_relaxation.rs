//! The shape at rest by dynamic relaxation (A. S. Day, The Engineer 219, 1965): steps with drag
//! until nothing moves any more.
//!
//! The loop is not that of a motion ([`crate::solver::integrate::simulation`]): steps follow
//! stability and growth, not a tolerance and frames; every block is shown to the caller; and what
//! goes wrong is begun anew from rest in shorter steps.

use crate::solver::integrate::energy_monitor::EnergyMonitor;
use crate::solver::integrate::integrator::{ParticleState, StepError};
use crate::solver::integrate::select::integrator_for;
use crate::solver::integrate::settings::{IntegratorSettings, SAFETY};
use crate::solver::integrate::stability::feasibility::LONGEST_EXPLICIT;
use crate::solver::model::system::System;
use crate::solver::optimize::iterate::{Callback, Iterate, Termination};
use crate::solver::options::Method;
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Implicit step at the start, and the longest one \[s\]: a garment sways at about 4 rad/s, which
/// such steps damp but follow.
const FIRST_IMPLICIT: f64 = 0.01;
const LONGEST_IMPLICIT: f64 = 0.05;
/// Shortest implicit step \[s\]; where that has no solution, none has.
const SHORTEST_IMPLICIT: f64 = 1e-7;
/// Factor by which an implicit step may be longer than the one before it.
const GROWTH: f64 = 1.5;
/// Residual to which implicit steps are solved, against the one that is to be reached.
const SOLVED: f64 = 0.1;
/// Least share of the stable step that is gone down to where steps drive the cloth, and where
/// forces became infinite.
const LEAST_DRIVEN: f64 = 0.05;
const LEAST_SHARE: f64 = 1e-3;
/// Blocks of steps after which the stability limit is computed anew, since cloth stiffens as it
/// stretches.
const BLOCKS_A_LIMIT: usize = 40;

/// Damping and bounds of a motion to rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DynamicRelaxation {
    /// A method that steps.
    pub(crate) method: Method,
    /// Drag per mass `C_d / m` \[1/s\].
    pub(crate) drag: f64,
    /// Greatest speed of explicit steps \[m/s\]: at the steps in question far less than the layer
    /// on the skin, so that nothing passes through.
    pub(crate) speed_limit: f64,
    /// The step asked for \[s\]; the method's own if absent.
    pub(crate) step: Option<f64>,
    /// The residual to be reached.
    pub(crate) tolerance: f64,
}

/// End of a dynamic relaxation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct RelaxationEnd {
    pub(crate) termination: Termination,
    /// True if steps were made shorter than stability of small motions asks for.
    pub(crate) shorter: bool,
}

/// Steps from `x` at rest until `callback` breaks, at most `limit` steps.
///
/// # Errors
/// The largest stable step, if the one asked for is above it.
pub(crate) fn run(
    system: &mut System<'_>,
    x: &mut [Vector3<f64>],
    motion: DynamicRelaxation,
    limit: u64,
    callback: &mut Callback<'_>,
) -> Result<RelaxationEnd, f64> {
    let mut shorter = false;
    let termination = steps(system, x, motion, limit, (callback, &mut shorter))?;
    Ok(RelaxationEnd {
        termination,
        shorter,
    })
}

fn steps(
    system: &mut System<'_>,
    x: &mut [Vector3<f64>],
    motion: DynamicRelaxation,
    limit: u64,
    (callback, shorter): (&mut Callback<'_>, &mut bool),
) -> Result<Termination, f64> {
    let settings = IntegratorSettings {
        drag: motion.drag,
        speed_limit: motion.speed_limit,
        residual: SOLVED * motion.tolerance,
    };
    let mut integrator = match integrator_for(system, motion.method, &settings) {
        Ok(Some(integrator)) => integrator,
        Ok(None) => return Ok(Termination::Stalled),
        Err(_) => return Ok(Termination::OutOfMemory),
    };
    let stable = integrator.stable_step(system, x);
    let explicit = stable.is_finite() || integrator.block() > 1;
    let chosen = explicit && motion.step.is_none();
    let mut share = SAFETY;
    let longest = |stable: f64, share: f64| match motion.step {
        Some(asked) => asked,
        None if explicit => share * stable.min(LONGEST_EXPLICIT),
        None => LONGEST_IMPLICIT,
    };
    if motion.step.is_some_and(|asked| asked > stable) {
        return Err(stable);
    }
    let mut most = longest(stable, share);
    let mut h = if explicit {
        most
    } else {
        most.min(FIRST_IMPLICIT)
    };
    let mut state = ParticleState::at_rest(x);
    let mut before = state.clone();
    let mut energy_monitor =
        (chosen && system.is_conservative()).then(|| EnergyMonitor::new(motion.drag));
    let mut force = vec![Vector3::zeros(); x.len()];
    let (mut number, mut steps) = (0, 0);
    while steps < limit {
        crate::solver::integrate::integrator::accept(system, &state);
        system.net_force(&state.x, &mut force);
        let residual = system.residual(&force);
        if !(residual.is_finite() && state.is_finite()) {
            return Ok(Termination::NotFinite);
        }
        x.copy_from_slice(&state.x);
        let flow = callback(Iterate {
            number,
            residual,
            positions: x,
            convex: true,
            contact_settled: true,
            estimate_before: None,
        });
        if let ControlFlow::Break(termination) = flow {
            return Ok(termination);
        }
        number += 1;
        let driven = energy_monitor.as_mut().is_some_and(|energy_monitor| {
            let time = h * integrator.block() as f64;
            number > 1 && share > LEAST_DRIVEN && energy_monitor.gains_energy(system, &state, time)
        });
        if driven {
            share *= 0.5;
            *shorter = true;
        }
        if chosen && (driven || number.is_multiple_of(BLOCKS_A_LIMIT)) {
            most = longest(integrator.stable_step(system, &state.x), share);
            h = most;
        }
        before.copy_from(&state);
        match integrator.advance(system, &mut state, h, integrator.block()) {
            Ok(_) => {
                integrator.accept(&before, h);
                steps += integrator.block();
                h = (h * GROWTH).min(most);
            }
            Err(StepError::NotConverged) if h > SHORTEST_IMPLICIT => {
                state.copy_from(&before);
                h *= 0.25;
            }
            Err(StepError::NotConverged) => return Ok(Termination::Stalled),
            // What stretched faster than the limit was looked at is gone back on, at rest.
            Err(StepError::NotFinite) if chosen && share > LEAST_SHARE => {
                state = ParticleState::at_rest(&before.x);
                share *= 0.25;
                *shorter = true;
                most = longest(integrator.stable_step(system, &state.x), share);
                h = most;
            }
            Err(StepError::NotFinite) => return Ok(Termination::NotFinite),
        }
    }
    Ok(Termination::IterationLimit)
}
