//! Detection of explicit steps that drive the cloth: its energy must fall by what drag dissipates.
//!
//! Below the stability limit no mode of linear springs is driven; but cloth yields to pressure and
//! pulls when taut, and an oscillator that is stiff to one side only is driven by some steps far
//! below its limit (a parametric resonance of the steps: each side's map is a rotation, their
//! product need not be). Drag takes 2 c K a second, K the kinetic energy. Where the energy falls by
//! less than half of that, the steps are too long.

use crate::solver::integrate::integrator::ParticleState;
use crate::solver::model::system::System;

/// Blocks of steps after which the balance is drawn.
const WINDOW: usize = 20;
/// Share of what drag takes by which the energy must have fallen.
const LEAST_SHARE: f64 = 0.5;
/// Dissipation over the whole energy below which it is rounding.
const ROUNDING: f64 = 1e-10;

/// Energy balance of a motion with drag.
pub(crate) struct EnergyMonitor {
    /// \[1/s\]
    drag: f64,
    /// Kinetic energy after the last block \[J\].
    kinetic: f64,
    /// The whole energy when the window began; none if it is yet to begin \[J\].
    then: Option<f64>,
    /// Energy dissipated by drag since then \[J\].
    taken: f64,
    blocks: usize,
}

impl EnergyMonitor {
    pub(crate) fn new(drag: f64) -> Self {
        Self {
            drag,
            kinetic: 0.0,
            then: None,
            taken: 0.0,
            blocks: 0,
        }
    }

    /// Returns true if the cloth gained energy by its steps, the last block of which took `time`
    /// \[s\].
    pub(crate) fn gains_energy(
        &mut self,
        system: &mut System<'_>,
        state: &ParticleState,
        time: f64,
    ) -> bool {
        let moving = state.v.iter().zip(&system.mass);
        let kinetic = 0.5 * moving.map(|(v, m)| m * v.norm_squared()).sum::<f64>();
        self.taken += self.drag * (self.kinetic + kinetic) * time;
        self.kinetic = kinetic;
        self.blocks += 1;
        if self.then.is_some() && self.blocks < WINDOW {
            return false;
        }
        let potential = system.energy(&state.x);
        let now = potential + kinetic;
        let driven = self.then.is_some_and(|then| {
            self.taken > ROUNDING * (potential.abs() + kinetic)
                && now > then - LEAST_SHARE * self.taken
        });
        self.restart(Some(now));
        driven
    }

    /// Restarts the window with the energy `now` \[J\].
    pub(crate) fn restart(&mut self, now: Option<f64>) {
        (self.then, self.taken, self.blocks) = (now, 0.0, 0);
    }
}
