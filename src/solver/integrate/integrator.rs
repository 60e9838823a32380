//! What every trajectory method has in common: a state, and steps that move it on.

use crate::solver::model::system::System;
use nalgebra::Vector3;

/// Positions \[m\] and velocities \[m/s\] of all particles at one time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ParticleState {
    pub(crate) x: Vec<Vector3<f64>>,
    pub(crate) v: Vec<Vector3<f64>>,
    /// \[s\]
    pub(crate) time: f64,
    /// Whether wind gusts and feels how the cloth moves; what is to come to rest does so in the mean wind.
    pub(crate) windy: bool,
}

impl ParticleState {
    /// At rest at `x`.
    pub(crate) fn at_rest(x: &[Vector3<f64>]) -> Self {
        Self {
            x: x.to_vec(),
            v: vec![Vector3::zeros(); x.len()],
            time: 0.0,
            windy: false,
        }
    }

    /// Takes over another state of as many particles.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.x.copy_from_slice(&other.x);
        self.v.copy_from_slice(&other.v);
        self.time = other.time;
    }

    /// Whether all numbers are.
    pub(crate) fn is_finite(&self) -> bool {
        let finite = |v: &Vector3<f64>| v.iter().all(|c| c.is_finite());
        self.x.iter().all(finite) && self.v.iter().all(finite)
    }
}

/// Why steps could not be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StepError {
    /// The equations of an implicit step were not solved.
    NotConverged,
    /// Numbers that are not finite.
    NotFinite,
}

/// A trajectory method, with all scratch memory that it needs.
pub(crate) trait Integrator {
    /// Order of the global error in the step.
    fn order(&self) -> i32;

    /// Steps that are best taken at once, with one step length.
    fn block(&self) -> u64;

    /// The longest stable step at `x` \[s\].
    fn stable_step(&mut self, _system: &mut System<'_>, _x: &[Vector3<f64>]) -> f64 {
        f64::INFINITY
    }

    /// Takes `count` steps of `h` \[s\] from `state`.
    ///
    /// Returns an estimate of the local error of position of the last step over its length \[m/s, RMS\].
    fn advance(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        h: f64,
        count: u64,
    ) -> Result<f64, StepError>;

    /// Remembers that the steps of `h` \[s\] that began at `before` are part of the trajectory.
    fn accept(&mut self, _before: &ParticleState, _h: f64) {}

    /// Operations of one step, counted; what they cost a processor is about the same for all.
    fn operations(&self) -> f64;

    /// Bytes of the arrays that an explicit step reads or writes, each counted once; 0 for an implicit one.
    fn step_bytes(&self) -> u64 {
        0
    }

    /// Newton iterations so far.
    fn newton_iterations(&self) -> u64 {
        0
    }
}

/// Tells what remembers the way of the cloth where it is, and wind how it moves.
///
/// Velocities are those that the step begins with (with Verlet, of the half step before): wind is lagged by a step.
pub(crate) fn accept(system: &mut System<'_>, state: &ParticleState) {
    if state.windy {
        system.set_motion(&state.v, state.time);
    }
    system.accept(&state.x);
}
