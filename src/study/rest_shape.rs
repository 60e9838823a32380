//! The rest shape that a drape goes on to when it is not stopped: the reference that its error is
//! measured by.
//!
//! Rest shapes are not unique, so the reference of a shape is the one that it leads to itself:
//! Newton's method goes on from there to the round-off floor.

use crate::scene::Scene;
use crate::solver::{self, Context, Drape, Energy, SolverOptions, rms_distance};

/// Residual asked for: below any floor, which then is what stops it.
const TO_THE_FLOOR: f64 = 1e-300;

/// The rest shape that a drape leads to.
#[derive(Clone, Debug)]
pub struct RestShape {
    /// The shape at the round-off floor, with its report.
    pub drape: Drape,
    /// Distance to it from where the drape stopped \[m, RMS\].
    pub moved_m: f64,
}

impl RestShape {
    /// Goes on from where `from` stopped, by the method and within the time of `options`.
    ///
    /// Returns none if its seams are open (there is no rest shape to go on to), or if that method
    /// did not come to rest. Friction goes on from where it held the cloth.
    pub fn of(
        scene: &Scene,
        options: &SolverOptions,
        from: &Drape,
        context: &mut Context<'_>,
    ) -> Option<Self> {
        if from.report.seam_gap_max_m >= options.seam_eps_m {
            return None;
        }
        let options = SolverOptions {
            tolerance: TO_THE_FLOOR,
            tolerance_m: None,
            step_s: None,
            ..options.clone()
        };
        let drape = solver::drape_on(scene, &options, from, context);
        drape.report.converged.then(|| Self {
            moved_m: rms_distance(&from.positions, &drape.positions),
            drape,
        })
    }

    /// Returns the error of the shape that it went on from \[m, RMS\]: two shapes that are both at
    /// the floor say nothing of the distance to the exact one, which the estimate at the floor
    /// bounds.
    pub fn error_m(&self) -> f64 {
        self.moved_m.max(self.estimate_m())
    }

    /// Returns the error estimate at the floor \[m\], 0 where there is none.
    pub fn estimate_m(&self) -> f64 {
        self.drape.report.error_estimate_m.unwrap_or(0.0)
    }

    /// Returns the energy of all terms \[J\].
    pub fn energy_j(&self) -> f64 {
        total_energy(&self.drape.report.energy_j)
    }
}

/// Returns true if rest shapes of this scene depend on the way that the cloth came.
pub(super) fn depends_on_path(scene: &Scene) -> bool {
    scene.body.is_some() && scene.friction > 0.0
}

/// Returns the energy of all terms \[J\].
pub(super) fn total_energy(energy: &Energy) -> f64 {
    energy.stretch + energy.bend + energy.gravity + energy.seam + energy.contact
}
