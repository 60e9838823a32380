//! The interface of all time stepping methods: a state, and steps that advance it.

use crate::solver::model::system::System;
use nalgebra::Vector3;

/// Positions \[m\] and velocities \[m/s\] of all particles at one time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ParticleState {
    pub(crate) x: Vec<Vector3<f64>>,
    pub(crate) v: Vec<Vector3<f64>>,
    /// \[s\]
    pub(crate) time: f64,
    /// True if wind gusts and feels how the cloth moves; what is to come to rest does so in the
    /// mean wind.
    pub(crate) windy: bool,
}

impl ParticleState {
    /// Returns the state at rest at `x`.
    pub(crate) fn at_rest(x: &[Vector3<f64>]) -> Self {
        Self {
            x: x.to_vec(),
            v: vec![Vector3::zeros(); x.len()],
            time: 0.0,
            windy: false,
        }
    }

    /// Copies another state of as many particles.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.x.copy_from_slice(&other.x);
        self.v.copy_from_slice(&other.v);
        self.time = other.time;
    }

    /// Returns true if all positions and velocities are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let finite = |v: &Vector3<f64>| v.iter().all(|c| c.is_finite());
        self.x.iter().all(finite) && self.v.iter().all(finite)
    }
}

/// Reason why a step could not be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StepError {
    /// The equations of an implicit step were not solved.
    NotConverged,
    /// Positions or velocities were not finite.
    NotFinite,
}

/// A time stepping method, with all scratch memory that it needs.
pub(crate) trait Integrator {
    /// Returns the order of the global error in the step.
    fn order(&self) -> i32;

    /// Returns the number of steps that are best taken at once, with one step length.
    fn block(&self) -> u64;

    /// Returns the longest stable step at `x` \[s\].
    fn stable_step(&mut self, _system: &mut System<'_>, _x: &[Vector3<f64>]) -> f64 {
        f64::INFINITY
    }

    /// Takes `count` steps of `h` \[s\] from `state`.
    ///
    /// Returns an estimate of the local error of position of the last step over its length
    /// \[m/s, RMS\].
    fn advance(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        h: f64,
        count: u64,
    ) -> Result<f64, StepError>;

    /// Remembers that the steps of `h` \[s\] that began at `before` are part of the trajectory.
    fn accept(&mut self, _before: &ParticleState, _h: f64) {}

    /// Returns the operations of one step, counted; what they cost a processor is about the same
    /// for all.
    fn operations(&self) -> f64;

    /// Returns the bytes of the arrays that an explicit step reads or writes, each counted once; 0
    /// for an implicit one.
    fn step_bytes(&self) -> u64 {
        0
    }

    /// Returns the Newton iterations so far.
    fn newton_iterations(&self) -> u64 {
        0
    }
}

/// Tells the terms with memory (friction, wind) of the state from which a step begins.
///
/// Velocities are those that the step begins with (with Verlet, of the half step before): wind is
/// lagged by a step.
pub(crate) fn accept(system: &mut System<'_>, state: &ParticleState) {
    if state.windy {
        system.set_motion(&state.v, state.time);
    }
    system.accept(&state.x);
}
