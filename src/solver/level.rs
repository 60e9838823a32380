//! The order of a fit on one level (P9, P10): pull the seams shut, close them for good, let the garment fall and come to rest.

use super::ask::{Method, SeamClose, Simulate};
use super::assemble::{Stage, assemble};
use super::measure;
use super::motion::Motion;
use super::newton::{FIRST_GAMMA, Iteration, NEAR_GAMMA, Newton, Stop, Verdict};
use super::report::Report;
use super::stage::{Bounds, Ended, note_rungs, push_once, run};
use super::summary::{add_terms, energies, mean_height};
use super::system::System;
use super::topology::Particles;
use super::trace::{Look, Trace};
use crate::scene::Scene;
use nalgebra::Vector3;

/// Stiffness of a stitch if none is asked for \[N/m\]: about that of the cloth beside it.
pub(super) const SEAM_STIFFNESS: f64 = 1e4;
/// How much stiffer than while sewing the spring of a closed seam is (P9).
const CLOSED_STIFFER: f64 = 10.0;
/// How often the stitches are made ten times stiffer when the seams settle with a gap.
const STIFFER_AT_MOST: usize = 3;
/// Residual at which an open seam counts as settled: nothing moves any more.
const SETTLED: f64 = 1e-3;
/// Share of the progress that sewing is told as.
const SEWING_SHARE: f64 = 0.4;
/// Distance for which explicit steps carry on a sample of the body \[m\]: third-order terms stay below 1e-11 m.
const EXPLICIT_REUSE: f64 = 2e-5;
/// Drag while sewing and while draping \[1/s\], and speed limit \[m/s\], of explicit steps. A garment sways at about
/// 4 rad/s: twice that is critical.
pub(super) const DRAPING_DRAG: f64 = 8.0;
const SEWING_MOTION: Motion = Motion {
    method: Method::SymplecticEuler,
    drag: 40.0,
    speed_limit: 2.0,
    step: None,
    tolerance: SETTLED,
};
const DRAPING_MOTION: Motion = Motion {
    method: Method::SymplecticEuler,
    drag: DRAPING_DRAG,
    speed_limit: 5.0,
    step: None,
    tolerance: SETTLED,
};
/// How far the middle of a garment sinks before it is plain that nothing will stop it \[m\].
const FREE_FALL: f64 = 0.5;
/// Residual up to which ‖H⁻¹ f‖ was measured to be the error.
const ESTIMATE_HOLDS: f64 = 1e-2;

/// How a level was left.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rest {
    /// Whether its seams are closed.
    pub(super) sewn: bool,
    /// Whether it was given up because the garment was falling.
    pub(super) fell: bool,
    /// How far the middle of the garment sank \[m\].
    pub(super) sunk: f64,
}

/// Stiffness of a closed stitch, `sewing` being what closed it \[N/m\]: the one asked for, or much stiffer than that (P9).
pub(super) fn closed_stiffness(ask: &Simulate, sewing: f64) -> f64 {
    ask.seam_stiffness_n_m.unwrap_or(sewing * CLOSED_STIFFER)
}

/// One level of a fit: its scene, and what all levels share.
pub(super) struct Level<'a, 'c, 'w> {
    pub(super) scene: &'a Scene,
    pub(super) ask: &'a Simulate,
    pub(super) clock: &'w dyn Fn() -> f64,
    pub(super) bounds: Bounds,
    pub(super) trace: &'a mut Trace<'c, 'w>,
    /// Residual to reach, unless the floor is above it.
    pub(super) tolerance: f64,
    /// Residual that is not gone below, in round-off floors.
    pub(super) floors: f64,
    /// Whether it is the level that was asked for.
    pub(super) finest: bool,
    /// Whether the start is near the end already, handed on by a coarser level.
    pub(super) near: bool,
}

impl<'w> Level<'_, '_, 'w> {
    /// The shape at rest from `x`, its seams closed first unless they are `sewn`.
    pub(super) fn run(
        &mut self,
        x: &mut Vec<Vector3<f64>>,
        sewn: bool,
        report: &mut Report,
    ) -> Rest {
        let began = self.trace.cpu_s();
        let stiffness = if sewn {
            Ok(self.ask.seam_stiffness_n_m.unwrap_or(SEAM_STIFFNESS))
        } else {
            self.sew(x, report)
        };
        let closed = self.trace.cpu_s();
        report.cpu_s.sew += closed - began;
        let rest = match stiffness {
            Ok(stiffness) => self.settle(x, stiffness, report),
            Err(why) => {
                report.why = why;
                report.converged = false;
                report.residual = f64::NAN;
                Rest::default()
            }
        };
        report.cpu_s.drape += self.trace.cpu_s() - closed;
        rest
    }

    fn first_gamma(&self) -> f64 {
        if self.near { NEAR_GAMMA } else { FIRST_GAMMA }
    }

    fn explicit(&self) -> bool {
        matches!(self.ask.method, Method::SymplecticEuler | Method::Verlet)
    }

    /// `motion` by the method asked for, if it is one that steps.
    fn by_motion(&self, motion: Motion) -> Option<Motion> {
        let steps = !matches!(self.ask.method, Method::Auto | Method::Newton);
        steps.then_some(Motion {
            method: self.ask.method,
            step: self.ask.step_s,
            ..motion
        })
    }

    fn stitches(&self, last_stage: u32) -> Vec<(usize, usize)> {
        self.scene
            .mesh
            .stitches
            .iter()
            .filter(|s| s.stage <= last_stage)
            .map(|s| (s.a, s.b))
            .collect()
    }

    /// Pulls the seams shut, stage by stage; the stiffness that did it, or why it could not be done.
    fn sew(&mut self, x: &mut [Vector3<f64>], report: &mut Report) -> Result<f64, String> {
        let mut stiffness = self.ask.seam_stiffness_n_m.unwrap_or(SEAM_STIFFNESS);
        let mut stages: Vec<u32> = self.scene.mesh.stitches.iter().map(|s| s.stage).collect();
        stages.sort_unstable();
        stages.dedup();
        for stage in stages {
            let stitches = self.stitches(stage);
            let mut tries = 0;
            loop {
                let ended = self.pull(x, &stitches, stiffness, report);
                note_rungs(&mut report.ladder, ended.rungs);
                let gap = measure::seam_gap(&stitches, x);
                if gap < self.ask.seam_eps_m {
                    break;
                }
                if ended.stop != Stop::Reached || tries == STIFFER_AT_MOST {
                    return Err(format!(
                        "the seams of stage {stage} are still {:.2} mm apart: {}",
                        gap * 1e3,
                        ended.reason(self.trace.canceled)
                    ));
                }
                tries += 1;
                stiffness *= 10.0;
                push_once(&mut report.ladder, "stiffer_seams");
            }
        }
        Ok(stiffness)
    }

    fn pull(
        &mut self,
        x: &mut [Vector3<f64>],
        stitches: &[(usize, usize)],
        stiffness: f64,
        report: &mut Report,
    ) -> Ended {
        let particles = Particles::apart(x.len());
        let stage = Stage {
            particles: &particles,
            stitches: Some((stitches.to_vec(), stiffness)),
            gravity: false,
            friction: false,
            reuse: if self.explicit() { EXPLICIT_REUSE } else { 0.0 },
        };
        let mut system = assemble(self.scene, self.ask, &stage, self.clock);
        let first_gap = measure::seam_gap(stitches, x).max(1e-9);
        let eps = self.ask.seam_eps_m;
        let motion = self.by_motion(SEWING_MOTION);
        let bounds = self.bounds;
        let gamma = self.first_gamma();
        let trace = &mut self.trace;
        let mut last = f64::NAN;
        let mut judge = |i: Iteration<'_>| {
            last = i.residual;
            let gap = measure::seam_gap(stitches, i.positions);
            let closed = (gap / first_gap).ln() / (eps / first_gap).min(0.9).ln();
            let verdict = trace.look(&Look {
                stage: "sew",
                fraction: SEWING_SHARE * closed,
                residual: i.residual,
                seam_gap: gap,
                shape: None,
            });
            let settled = gap < eps || (i.number > 0 && i.residual < SETTLED);
            if verdict == Verdict::Continue && settled {
                Verdict::Reached
            } else {
                verdict
            }
        };
        let mut ended = run(&mut system, x, motion, bounds, gamma, &mut judge).0;
        ended.residual = last;
        add_terms(&mut report.terms, &system);
        report.newton_iterations += ended.iterations;
        ended
    }

    /// Closes the seams for good and lets the garment come to rest.
    fn settle(&mut self, x: &mut Vec<Vector3<f64>>, stiffness: f64, report: &mut Report) -> Rest {
        let stitches = self.stitches(u32::MAX);
        let weld = self.ask.seam_close == SeamClose::Weld;
        let particles = if weld {
            Particles::welded(x.len(), stitches.iter().copied())
        } else {
            Particles::apart(x.len())
        };
        let springs = (!weld && !stitches.is_empty())
            .then(|| (stitches.clone(), closed_stiffness(self.ask, stiffness)));
        let reuse = if self.explicit() { EXPLICIT_REUSE } else { 0.0 };
        let stage = Stage {
            particles: &particles,
            stitches: springs,
            gravity: true,
            friction: true,
            reuse,
        };
        let mut system = assemble(self.scene, self.ask, &stage, self.clock);
        let mut shape = particles.mean(x);
        let gravity = &self.scene.gravity;
        let first_height = mean_height(gravity, &shape);
        let floor = system.residual_floor(&shape);
        let tolerance = self.tolerance.max(self.floors * floor);
        let (ended, mut newton) =
            self.fall(&mut system, &mut shape, &particles, &stitches, tolerance);
        *x = particles.spread(&shape);
        note_rungs(&mut report.ladder, ended.rungs);
        report.newton_iterations += ended.iterations;
        report.residual = ended.residual;
        report.residual_floor = floor;
        report.converged = ended.stop == Stop::Reached;
        report.why = ended.reason(self.trace.canceled);
        if report.converged && tolerance > self.tolerance {
            report.why = format!(
                "at rest: stopped by the round-off floor of {floor:.1e}, at r = {:.1e}",
                ended.residual
            );
        }
        if newton.is_none() && ended.stop == Stop::Reached {
            newton = Newton::new(&mut system, NEAR_GAMMA).ok();
        }
        if let Some(newton) = &mut newton {
            report.error_estimate_m = newton.error_estimate(&mut system, &shape);
            report.error_estimate_valid = report.error_estimate_m.is_some()
                && newton.contact_settled
                && ended.residual <= ESTIMATE_HOLDS;
        }
        report.energy_j = energies(&mut system, &shape);
        add_terms(&mut report.terms, &system);
        Rest {
            sewn: true,
            fell: ended.fell,
            sunk: first_height - mean_height(gravity, &shape),
        }
    }

    fn fall(
        &mut self,
        system: &mut System<'_>,
        shape: &mut [Vector3<f64>],
        particles: &Particles,
        stitches: &[(usize, usize)],
        tolerance: f64,
    ) -> (Ended, Option<Newton>) {
        let motion = self.by_motion(Motion {
            drag: self.scene.drag.unwrap_or(DRAPING_MOTION.drag),
            tolerance,
            ..DRAPING_MOTION
        });
        let bounds = self.bounds;
        let (gamma, finest) = (self.first_gamma(), self.finest);
        let trace = &mut self.trace;
        let mut last = f64::NAN;
        let gravity = self.scene.gravity;
        let (first_height, mut fell) = (mean_height(&gravity, shape), false);
        let mut judge = |i: Iteration<'_>| {
            last = i.residual;
            fell = first_height - mean_height(&gravity, i.positions) > FREE_FALL;
            let gap = measure::seam_gap(stitches, &particles.spread(i.positions));
            let done =
                (1.0 - (i.residual / tolerance).ln() / (10.0 / tolerance).ln()).clamp(0.0, 1.0);
            let spread = || particles.spread(i.positions);
            let look = Look {
                stage: "drape",
                fraction: SEWING_SHARE + (1.0 - SEWING_SHARE) * done,
                residual: i.residual,
                seam_gap: gap,
                shape: if finest { Some(&spread) } else { None },
            };
            let verdict = trace.look(&look);
            if fell {
                Verdict::Interrupt
            } else if verdict == Verdict::Continue && i.residual <= tolerance {
                Verdict::Reached
            } else {
                verdict
            }
        };
        let (mut ended, newton) = run(system, shape, motion, bounds, gamma, &mut judge);
        ended.residual = last;
        ended.fell = fell;
        (ended, newton)
    }
}
