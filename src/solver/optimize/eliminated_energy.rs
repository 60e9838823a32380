//! The energy of a system along a step, less what local elimination gains at each trial.

use crate::solver::model::system::System;
use crate::solver::optimize::line_search::{LineSearch, Objective};
use crate::solver::optimize::local_elimination::{GlobalStep, LocalElimination};
use nalgebra::Vector3;

/// Share of the predicted decrease that a round of elimination must gain for another one.
const WORTH_ANOTHER: f64 = 0.01;
/// Shares of a step at which elimination is tried.
const TRIALS: i32 = 2;

/// The energy of a system along one step.
pub(crate) struct EliminatedEnergy<'e, 's> {
    pub(crate) system: &'e mut System<'s>,
    pub(crate) elimination: &'e mut LocalElimination,
    /// The step; its share is that of each trial.
    pub(crate) global: GlobalStep<'e>,
    pub(crate) step: &'e [Vector3<f64>],
    pub(crate) search: LineSearch,
}

impl Objective for EliminatedEnergy<'_, '_> {
    fn value(&mut self, x: &[Vector3<f64>]) -> f64 {
        self.system.energy(x)
    }

    fn confine(&mut self, x: &[Vector3<f64>], trial: &mut [Vector3<f64>]) {
        self.system.confine(x, trial);
    }

    fn improve(&mut self, trial: &mut [Vector3<f64>], share: f64, decrease: f64) -> f64 {
        let predicted = self.search.predicted(share);
        // Rounding is nothing that could be put right.
        let is_rounding = predicted <= 4.0 * self.search.rounding(trial.len());
        let least_share = self.search.first_share * 0.5_f64.powi(TRIALS - 1);
        if share < least_share || is_rounding {
            return decrease;
        }
        let global = GlobalStep {
            share,
            ..self.global
        };
        // Also where the step gained what was predicted: forces left over in few places would make
        // the next step of all particles as short.
        let worth_another = WORTH_ANOTHER * predicted;
        decrease
            + self
                .elimination
                .run(self.system, &global, trial, worth_another)
    }

    fn steepness(&mut self, trial: &[Vector3<f64>]) -> f64 {
        // Forces without an energy are no slope of one.
        if !self.system.is_conservative() {
            return 0.0;
        }
        let force = self.elimination.force_at(self.system, trial);
        let along: f64 = self.step.iter().zip(force).map(|(d, f)| d.dot(f)).sum();
        along / self.search.slope
    }
}
