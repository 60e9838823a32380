//! One level of a drape, as sewing and relaxing see it.

use crate::scene::Scene;
use crate::solver::drape::monitor::Monitor;
use crate::solver::drape::stage::{IterationLimits, StageMethod};
use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::integrate::dynamic_relaxation::DynamicRelaxation;
use crate::solver::optimize::pseudo_transient::{FIRST_GAMMA, NEAR_GAMMA};
use crate::solver::options::SolverOptions;

/// Thickness of cloth on a coarser mesh, as a share of its mesh edges: about as deep as the chords
/// of a fold cut into it, so that layers are still apart on the next finer mesh.
const COARSE_THICKNESS: f64 = 0.15;
/// Thickness of the thinnest cloth in contact with itself \[m\].
const LEAST_THICKNESS: f64 = 1e-4;

/// One level of a drape: its scene, and what all levels share.
pub(crate) struct Level<'a, 'c, 'w> {
    /// Scene of this level.
    pub(crate) scene: &'a Scene,
    pub(crate) options: &'a SolverOptions,
    /// The only clock \[CPU s\].
    pub(crate) clock: &'w dyn Fn() -> f64,
    pub(crate) limits: IterationLimits,
    pub(crate) monitor: &'a mut Monitor<'c, 'w>,
    /// Residual to reach, unless the floor is above it.
    pub(crate) tolerance: f64,
    /// Distance to the rest shape to reach, if that is asked for \[m\].
    pub(crate) tolerance_m: Option<f64>,
    /// Least residual that is asked for, over its round-off floor.
    pub(crate) floor_multiple: f64,
    /// True on the level that was asked for.
    pub(crate) is_finest: bool,
    /// True if its seams are closed before it begins, so that the start is near the end already.
    pub(crate) is_sewn: bool,
    /// Points at which friction holds the start.
    pub(crate) anchors: FrictionAnchors,
}

impl Level<'_, '_, '_> {
    /// Returns the method of a stage; `motion` is its motion if it is run by one.
    pub(crate) fn stage_method(&self, motion: DynamicRelaxation) -> StageMethod {
        StageMethod {
            motion: self
                .options
                .method
                .is_time_stepping()
                .then_some(DynamicRelaxation {
                    method: self.options.method,
                    step: self.options.step_s,
                    ..motion
                }),
            first_gamma: if self.is_sewn {
                NEAR_GAMMA
            } else {
                FIRST_GAMMA
            },
            limits: self.limits,
        }
    }

    /// Returns the thickness that its cloth has at least where it touches itself \[m\]; none if
    /// cloth may pass through cloth.
    pub(crate) fn least_thickness(&self) -> Option<f64> {
        if !self.scene.self_contact || self.options.method.is_time_stepping() {
            None
        } else if self.is_finest {
            Some(LEAST_THICKNESS)
        } else {
            Some(LEAST_THICKNESS.max(COARSE_THICKNESS * self.scene.mesh.mean_edge()))
        }
    }

    /// Returns the vertex pairs sewn up to a stage.
    pub(crate) fn stitches(&self, last_stage: u32) -> Vec<(usize, usize)> {
        let stitches = self.scene.mesh.stitches.iter();
        let sewn = stitches.filter(|s| s.stage <= last_stage);
        sewn.map(|s| (s.a, s.b)).collect()
    }
}
