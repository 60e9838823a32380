//! One level of a fit (P9, P10): pull the seams shut, close them for good, let the garment fall and come to rest.

use crate::scene::Scene;
use crate::solver::drape::monitor::Trace;
use crate::solver::drape::relax::settle;
use crate::solver::drape::sew::{SEAM_STIFFNESS, close};
use crate::solver::drape::stage::{Bounds, How};
use crate::solver::forces::contact::FrictionAnchors;
use crate::solver::integrate::dynamic_relaxation::DynamicRelaxation;
use crate::solver::optimize::pseudo_transient::{FIRST_GAMMA, NEAR_GAMMA};
use crate::solver::options::SolverOptions;
use crate::solver::report::history::ToGo;
use crate::solver::report::schema::{DrapeReport, LevelReport};
use nalgebra::Vector3;

/// Residual at which an open seam counts as settled, and motion as ended: nothing moves any more.
pub(crate) const SETTLED: f64 = 1e-3;

/// How a level was left.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rest {
    /// Whether its seams are closed.
    pub(crate) sewn: bool,
    /// Whether it was given up because the garment was falling.
    pub(crate) fell: bool,
    /// How far the middle of the garment sank \[m\].
    pub(crate) sunk: f64,
    /// Where friction holds it.
    pub(crate) anchors: FrictionAnchors,
    /// Whether it was at rest.
    pub(crate) at_rest: bool,
    /// How far it still was from rest.
    pub(crate) to_go: Option<ToGo>,
}

/// One level of a fit: its scene, and what all levels share.
pub(crate) struct Level<'a, 'c, 'w> {
    pub(crate) scene: &'a Scene,
    pub(crate) options: &'a SolverOptions,
    pub(crate) clock: &'w dyn Fn() -> f64,
    pub(crate) bounds: Bounds,
    pub(crate) trace: &'a mut Trace<'c, 'w>,
    /// Residual to reach, unless the floor is above it.
    pub(crate) tolerance: f64,
    /// Residual that is not gone below, in round-off floors.
    pub(crate) floors: f64,
    /// Whether it is the level that was asked for.
    pub(crate) finest: bool,
    /// Whether its seams are closed before it begins, so that the start is near the end already.
    pub(crate) sewn: bool,
    /// Where friction holds the start.
    pub(crate) anchors: FrictionAnchors,
}

impl Level<'_, '_, '_> {
    /// The shape at rest from `x`, its seams closed first unless they are.
    pub(crate) fn run(&mut self, x: &mut Vec<Vector3<f64>>, report: &mut DrapeReport) -> Rest {
        let began = self.trace.cpu_s();
        let iterations = report.newton_iterations;
        let stiffness = if self.sewn {
            Ok(self.options.seam_stiffness_n_m.unwrap_or(SEAM_STIFFNESS))
        } else {
            close(self, x, report)
        };
        let closed = self.trace.cpu_s();
        report.cpu_s.sew += closed - began;
        let start = x.clone();
        let rest = match stiffness {
            Ok(stiffness) => settle(self, x, stiffness, report),
            Err(why) => {
                report.why = why;
                report.converged = false;
                report.residual = f64::NAN;
                report.residual = f64::NAN;
                Rest::default()
            }
        };
        let ended = self.trace.cpu_s();
        report.cpu_s.drape += ended - closed;
        report.levels.push(LevelReport {
            vertices: x.len(),
            newton_iterations: report.newton_iterations - iterations,
            cpu_s: ended - began,
            residual: report.residual,
            moved_m: self
                .sewn
                .then(|| crate::solver::report::measure::rms_distance(&start, x)),
        });
        rest
    }

    /// How a stage is run whose motion, if it is one, is `motion`.
    pub(crate) fn how(&self, motion: DynamicRelaxation) -> How {
        How {
            motion: self
                .options
                .method
                .is_time_stepping()
                .then_some(DynamicRelaxation {
                    method: self.options.method,
                    step: self.options.step_s,
                    ..motion
                }),
            first_gamma: if self.sewn { NEAR_GAMMA } else { FIRST_GAMMA },
            bounds: self.bounds,
        }
    }

    /// The vertex pairs sewn up to a stage.
    pub(crate) fn stitches(&self, last_stage: u32) -> Vec<(usize, usize)> {
        let stitches = self.scene.mesh.stitches.iter();
        let sewn = stitches.filter(|s| s.stage <= last_stage);
        sewn.map(|s| (s.a, s.b)).collect()
    }
}
