//! The order of a fit (P9, P10): pull the seams shut, close them for good, let the garment fall and come to rest.

use super::ask::{Method, SeamClose, Simulate};
use super::assemble::{Stage, assemble};
use super::measure;
use super::newton::{Iteration, Newton, Stop, Verdict};
use super::report::{CpuSeconds, Report};
use super::stage::{Bounds, Ended, note_rungs, push_once, run};
use super::summary::{energies, left_out, mean_height, terms, worn};
use super::symplectic_euler::Motion;
use super::system::System;
use super::topology::Particles;
use super::trace::{Look, Trace};
use super::{Context, Drape};
use crate::scene::Scene;
use nalgebra::Vector3;

/// Stiffness of a stitch if none is asked for \[N/m\]: about that of the cloth beside it.
const SEAM_STIFFNESS: f64 = 1e4;
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
/// Drag while sewing and while draping \[1/s\], and speed limit \[m/s\], of the paper's method. A garment sways at about
/// 4 rad/s: twice that is critical.
const SEWING_MOTION: Motion = Motion {
    drag: 40.0,
    speed_limit: 2.0,
    step: None,
};
const DRAPING_MOTION: Motion = Motion {
    drag: 8.0,
    speed_limit: 5.0,
    step: None,
};
/// How far the middle of a garment sinks before it is plain that nothing will stop it \[m\].
const FREE_FALL: f64 = 0.5;
/// Residual up to which ‖H⁻¹ f‖ was measured to be the error.
const ESTIMATE_HOLDS: f64 = 1e-2;

/// Sews and drapes.
///
/// # Guarantees
/// Ends within the limits of the context and never with a shape that is not finite; the report says whether the shape is at
/// rest, and why not where it is not.
///
/// # Limitations
/// Rest shapes are not unique: cloth folds one way or another. Cloth passes through cloth.
pub fn drape(scene: &Scene, ask: &Simulate, context: &mut Context<'_>) -> Drape {
    Fit::new(scene, ask, context).run(None)
}

/// Drapes on from a shape \[m; `#V`\] whose seams are closed, without sewing.
pub fn drape_on(
    scene: &Scene,
    ask: &Simulate,
    shape: &[Vector3<f64>],
    context: &mut Context<'_>,
) -> Drape {
    Fit::new(scene, ask, context).run(Some(shape))
}

struct Fit<'s, 'c, 'w> {
    scene: &'s Scene,
    ask: &'s Simulate,
    clock: &'w dyn Fn() -> f64,
    bounds: Bounds,
    trace: Trace<'c, 'w>,
}

impl<'s, 'c, 'w> Fit<'s, 'c, 'w> {
    fn new(scene: &'s Scene, ask: &'s Simulate, context: &'c mut Context<'w>) -> Self {
        let bounds = Bounds {
            iterations: context.limits.iterations,
            steps: context.limits.steps,
        };
        let clock = context.cpu_s;
        let trace = Trace::new(context, ask.time_limit_s);
        Self {
            scene,
            ask,
            clock,
            bounds,
            trace,
        }
    }

    fn run(mut self, closed: Option<&[Vector3<f64>]>) -> Drape {
        let mut x = closed.unwrap_or(&self.scene.start).to_vec();
        let mut report = Report {
            method: self.method().to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            ..Report::default()
        };
        let sewn = match closed {
            Some(_) => Ok(self.ask.seam_stiffness_n_m.unwrap_or(SEAM_STIFFNESS)),
            None => self.sew(&mut x, &mut report),
        };
        report.cpu_s.sew = self.trace.cpu_s();
        match sewn {
            Ok(stiffness) => self.settle(&mut x, stiffness, &mut report),
            Err(why) => {
                report.why = why;
                self.measure(&x, &mut report);
            }
        }
        if !x.iter().all(|p| p.iter().all(|c| c.is_finite())) {
            x.clone_from(&self.scene.start);
        }
        report.error_against_run_time = self.trace.error_against_run_time(&x);
        Drape {
            positions: x,
            canceled: self.trace.canceled,
            report,
        }
    }

    fn explicit(&self) -> bool {
        self.ask.method == Method::SymplecticEuler
    }

    fn method(&self) -> &'static str {
        if self.explicit() {
            "symplectic_euler"
        } else {
            "newton"
        }
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
                let ended = self.pull(x, &stitches, stiffness);
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
        let motion = self.explicit().then_some(Motion {
            step: self.ask.step_s,
            ..SEWING_MOTION
        });
        let bounds = self.bounds;
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
        let mut ended = run(&mut system, x, motion, bounds, &mut judge).0;
        ended.residual = last;
        ended
    }

    /// Closes the seams for good and lets the garment come to rest.
    fn settle(&mut self, x: &mut Vec<Vector3<f64>>, stiffness: f64, report: &mut Report) {
        let stitches = self.stitches(u32::MAX);
        let weld = self.ask.seam_close == SeamClose::Weld;
        let particles = if weld {
            Particles::welded(x.len(), stitches.iter().copied())
        } else {
            Particles::apart(x.len())
        };
        let springs =
            (!weld && !stitches.is_empty()).then(|| (stitches.clone(), stiffness * CLOSED_STIFFER));
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
        let tolerance = self.ask.tolerance.max(10.0 * floor);
        let (ended, mut newton) =
            self.fall(&mut system, &mut shape, &particles, &stitches, tolerance);
        *x = particles.spread(&shape);
        note_rungs(&mut report.ladder, ended.rungs);
        report.residual = ended.residual;
        report.residual_floor = floor;
        report.converged = ended.stop == Stop::Reached;
        report.why = ended.reason(self.trace.canceled);
        if report.converged && tolerance > self.ask.tolerance {
            report.why = format!(
                "at rest: stopped by the round-off floor, r = {:.1e} at ten times {floor:.1e}",
                ended.residual
            );
        }
        if newton.is_none() && ended.stop == Stop::Reached {
            newton = Newton::new(&mut system).ok();
        }
        if let Some(newton) = &mut newton {
            report.error_estimate_m = newton.error_estimate(&mut system, &shape);
            report.error_estimate_valid = report.error_estimate_m.is_some()
                && newton.contact_settled
                && ended.residual <= ESTIMATE_HOLDS;
        }
        report.energy_j = energies(&mut system, &shape);
        report.cpu_s.drape = self.trace.cpu_s() - report.cpu_s.sew;
        report.terms = terms(&system);
        self.measure(x, report);
        report.worn = worn(
            self.scene,
            report,
            first_height - mean_height(gravity, &shape),
        );
    }

    fn fall(
        &mut self,
        system: &mut System<'_>,
        shape: &mut [Vector3<f64>],
        particles: &Particles,
        stitches: &[(usize, usize)],
        tolerance: f64,
    ) -> (Ended, Option<Newton>) {
        let motion = self.explicit().then_some(Motion {
            step: self.ask.step_s,
            drag: self.scene.drag.unwrap_or(DRAPING_MOTION.drag),
            ..DRAPING_MOTION
        });
        let bounds = self.bounds;
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
                shape: Some(&spread),
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
        let (mut ended, newton) = run(system, shape, motion, bounds, &mut judge);
        ended.residual = last;
        ended.fell = fell;
        (ended, newton)
    }

    /// Fills in what can be measured on the shape alone.
    fn measure(&self, x: &[Vector3<f64>], report: &mut Report) {
        let mesh = &self.scene.mesh;
        report.seam_gap_max_m = measure::seam_gap(&self.stitches(u32::MAX), x);
        report.strain_max = measure::strain(self.scene, x);
        report.penetration_max_m = measure::penetration(self.scene, x);
        report.vertices = mesh.uv.len();
        report.triangles = mesh.triangles.len();
        report.stitches = mesh.stitches.len();
        report.left_out = left_out(self.scene);
        report.cpu_s = CpuSeconds {
            total: self.trace.cpu_s(),
            ..report.cpu_s
        };
    }
}
