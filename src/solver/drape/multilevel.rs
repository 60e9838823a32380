//! A fit from start to end: the coarsest level is sewn and draped, and each finer one begins with the shape of the last.

use crate::scene::Scene;
use crate::solver::drape::hierarchy::Cascade;
use crate::solver::drape::level::{Level, Rest};
use crate::solver::drape::monitor::Trace;
use crate::solver::drape::perturb;
use crate::solver::drape::stage::{Bounds, push_once};
use crate::solver::integrate::stability::feasibility;
use crate::solver::options::{Method, SolverOptions};
use crate::solver::report::cost_model;
use crate::solver::report::describe::{left_out, worn};
use crate::solver::report::measure::{self, rms_distance};
use crate::solver::report::schema::{DrapeReport, Plan};
use crate::solver::report::unfinished;
use crate::solver::{Context, Drape};
use nalgebra::Vector3;

/// Residual to which the coarser levels are solved: their shapes are off by their mesh error anyway.
const COARSE_TOLERANCE: f64 = 1e-3;

/// Residual at which a drape stops at the latest, in round-off floors; a continued one goes on to the lower of the two, below
/// which rounding decides.
const FLOORS: f64 = 10.0;
const LEAST_FLOORS: f64 = 3.0;

/// Sews and drapes.
///
/// # Guarantees
/// Ends within the limits of the context and never with a shape that is not finite; the report says whether the shape is at
/// rest, and why not where it is not.
///
/// # Limitations
/// Rest shapes are not unique: cloth folds one way or another. Cloth passes through cloth.
pub fn drape(scene: &Scene, options: &SolverOptions, context: &mut Context<'_>) -> Drape {
    let cascade = if options.method.is_time_stepping() {
        // Motion is that of the mesh asked for.
        Cascade::single(scene)
    } else {
        Cascade::new(scene)
    };
    run(&cascade, options, None, context)
}

/// Drapes on from a drape of the same scene whose seams are closed, without sewing.
pub fn drape_on(
    scene: &Scene,
    options: &SolverOptions,
    from: &Drape,
    context: &mut Context<'_>,
) -> Drape {
    run(&Cascade::single(scene), options, Some(from), context)
}

/// A run from level to level.
struct Run<'a, 's, 'c, 'w> {
    cascade: &'a Cascade<'s>,
    options: &'a SolverOptions,
    from: Option<&'a Drape>,
    clock: &'w dyn Fn() -> f64,
    bounds: Bounds,
    trace: Trace<'c, 'w>,
    report: DrapeReport,
    /// Whether the seams are closed.
    sewn: bool,
    /// How far the middle of the garment sank \[m\].
    sunk: f64,
    /// The shape that the finest level began with, if it was one at rest.
    handed_on: Option<Vec<Vector3<f64>>>,
}

fn run(
    cascade: &Cascade<'_>,
    options: &SolverOptions,
    from: Option<&Drape>,
    context: &mut Context<'_>,
) -> Drape {
    let bounds = Bounds {
        iterations: context.limits.iterations,
        steps: context.limits.steps,
    };
    let report = DrapeReport {
        method: rest_method(options.method).name().to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        plan: Plan {
            levels: cascade.sizes(),
            time_limit_s: options.time_limit_s,
            ..Plan::default()
        },
        ..DrapeReport::default()
    };
    Run {
        cascade,
        options,
        from,
        clock: context.cpu_s,
        bounds,
        trace: Trace::new(context, options.time_limit_s),
        report,
        sewn: from.is_some(),
        sunk: 0.0,
        handed_on: None,
    }
    .go()
}

impl Run<'_, '_, '_, '_> {
    fn go(mut self) -> Drape {
        let scene = self.cascade.scene(0);
        let refused = feasibility::refuse(scene, self.options, self.bounds.steps, self.clock);
        let (mut x, last, rest) = match refused {
            None => self.down(),
            Some(why) => {
                self.report.why = why;
                self.report.residual = f64::NAN;
                let start = self.from.map_or(&scene.start, |from| &from.positions);
                (start.clone(), 0, Rest::default())
            }
        };
        x = self.cascade.to_finest(last, x);
        if !x.iter().all(|p| p.iter().all(|c| c.is_finite())) {
            x.clone_from(&scene.start);
        }
        if self.report.residual.is_finite() {
            self.say_error(last, &rest);
        } else {
            unfinished::describe(scene, self.options, &x, self.clock, &mut self.report);
        }
        measure_all(scene, &x, &mut self.report);
        self.report.support = worn(scene, &self.report, self.sunk);
        let handed_on = self.handed_on.as_ref().filter(|_| self.report.converged);
        self.report.mesh_error_m = handed_on.map(|coarse| rms_distance(coarse, &x));
        let to_finest = |level, x| self.cascade.to_finest(level, x);
        self.report.error_against_run_time = self.trace.way.points(&to_finest, &x);
        self.report.cpu_s.total = self.trace.cpu_s();
        self.advise(&rest);
        Drape {
            positions: x,
            anchors: rest.anchors,
            canceled: self.trace.canceled,
            report: self.report,
        }
    }

    /// From the coarsest level to the finest, or as far as it goes: the shape, its level, and how that was left.
    fn down(&mut self) -> (Vec<Vector3<f64>>, usize, Rest) {
        let coarsest = self.cascade.coarsest();
        let start = &self.cascade.scene(coarsest).start;
        let mut x = self.from.map_or(start, |from| &from.positions).clone();
        if self.from.is_none() {
            perturb::scatter(self.cascade.scene(coarsest), &mut x);
        }
        let mut number = coarsest;
        loop {
            let rest = self.level(number, &mut x);
            if number == coarsest && self.from.is_none() {
                let first = self.report.levels.first().map_or(0.0, |level| level.cpu_s);
                self.report.plan.expected_cpu_s =
                    Some(cost_model::expected_cpu_s(&self.report.plan.levels, first));
            }
            if number == 0 || self.trace.is_over() || rest.fell || !self.has_time(number) {
                return (x, number, rest);
            }
            x = self.cascade.refine(number, &x);
            if self.cascade.is_softer(number) {
                push_once(&mut self.report.fallbacks, "softer_cloth");
                // What a coarser mesh of softer cloth handed on tells of both.
                self.handed_on = None;
            } else {
                let is_whole = x.len() == self.cascade.scene(0).start.len();
                self.handed_on = (self.report.converged && is_whole).then(|| x.clone());
            }
            number -= 1;
        }
    }

    fn level(&mut self, number: usize, x: &mut Vec<Vector3<f64>>) -> Rest {
        let coarsest = self.cascade.coarsest();
        self.trace.begin_level(number, coarsest - number, x.len());
        let anchors = self.from.map(|from| from.anchors.clone());
        let mut level = Level {
            scene: self.cascade.scene(number),
            options: self.options,
            clock: self.clock,
            bounds: self.bounds,
            trace: &mut self.trace,
            tolerance: if number == 0 {
                self.options.tolerance
            } else {
                self.options.tolerance.max(COARSE_TOLERANCE)
            },
            floors: if self.from.is_some() {
                LEAST_FLOORS
            } else {
                FLOORS
            },
            finest: number == 0,
            sewn: self.sewn,
            anchors: anchors.unwrap_or_default(),
        };
        let rest = level.run(x, &mut self.report);
        self.sewn |= rest.sewn;
        self.sunk += rest.sunk;
        rest
    }

    /// Whether there is time for the level after `number`; what came of the plan, if there is not.
    fn has_time(&mut self, number: usize) -> bool {
        let [next, this] = [number - 1, number].map(|n| self.cascade.scene(n).start.len());
        let times = next as f64 / this as f64;
        let enough = cost_model::has_time(self.trace.left_s(), self.trace.pace(), times);
        self.trace.out_of_time |= !enough;
        if !enough {
            self.report.converged = false;
            self.report.why = format!(
                "the time allowed was up before the mesh of {next} vertices; this is the shape at rest of the one of {this}"
            );
        }
        enough
    }

    /// Says how far the shape is from rest where its second derivative does not tell.
    fn say_error(&mut self, last: usize, rest: &Rest) {
        let report = &mut self.report;
        if report.error_estimate_valid {
            return;
        }
        let (levels, earlier) = (&report.levels, report.levels.len().saturating_sub(1));
        let later = cost_model::moves_left(levels, last).filter(|_| last > 0);
        // It will hardly move further than it did on the level before.
        let most = levels[..earlier].iter().rev().find_map(|l| l.moved_m);
        let to_go = rest.to_go.map(|to_go| to_go.distance_m);
        let by_moves = match to_go.map(|m| m.min(most.unwrap_or(f64::INFINITY))) {
            _ if rest.at_rest && last > 0 => later,
            // It was stopped before it moved: all of this level is still to come.
            None => cost_model::moves_left(&levels[..earlier], last + 1),
            Some(to_go) => Some(to_go.hypot(later.unwrap_or(0.0))),
        };
        let known = report.error_estimate_m.filter(|_| rest.at_rest);
        let by_moves = by_moves.filter(|moves| known.is_none() && moves.is_finite());
        if let Some(moves) = by_moves {
            let by_forces = report.error_estimate_m.unwrap_or(0.0);
            report.error_estimate_m = Some(moves.max(by_forces));
            "not valid, but mostly right within 3 times: drawn from the forces left, from how the shape moved lately, and from mesh to mesh"
                .clone_into(&mut report.error_estimate_because);
        } else if report.error_estimate_because.is_empty() {
            "none: too little is known of how the shape moves"
                .clone_into(&mut report.error_estimate_because);
        }
    }

    /// Says what came of the plan, and what would halve the error.
    fn advise(&mut self, rest: &Rest) {
        let report = &mut self.report;
        let (total, plan) = (report.cpu_s.total, &mut report.plan);
        let allowed = plan.time_limit_s.filter(|_| self.trace.out_of_time);
        let expected = plan.expected_cpu_s.map_or(String::new(), |expected| {
            format!("; {expected:.1} s were expected to do for all")
        });
        plan.outcome = format!(
            "{} of {} meshes in {total:.1} s of CPU{}{expected}",
            report.levels.len(),
            plan.levels.len(),
            allowed.map_or(String::new(), |s| format!(" of {s:.1} s allowed")),
        );
        let halving = rest.to_go.and_then(|to_go| to_go.halving_s);
        report.to_halve_the_error = match allowed {
            Some(_) => {
                let all = report.plan.expected_cpu_s.map(|all| all - total);
                let more = halving.or(all).filter(|more_s| *more_s > 0.0);
                more.map(|more_s| cost_model::more_time(total, more_s))
            }
            None => cost_model::advice(report),
        };
    }
}

/// The method that finds a shape at rest where `asked` is.
fn rest_method(asked: Method) -> Method {
    match asked {
        Method::Auto => Method::Newton,
        method => method,
    }
}

/// Fills in what can be measured on the shape alone.
#[inline(never)] // so that a profile tells what it takes
fn measure_all(scene: &Scene, x: &[Vector3<f64>], report: &mut DrapeReport) {
    let mesh = &scene.mesh;
    let stitches: Vec<_> = mesh.stitches.iter().map(|s| (s.a, s.b)).collect();
    report.seam_gap_max_m = measure::seam_gap(&stitches, x);
    report.strain_max = measure::strain(scene, x);
    report.penetration_max_m = measure::penetration(scene, x);
    report.vertices = mesh.uv.len();
    report.triangles = mesh.triangles.len();
    report.stitches = mesh.stitches.len();
    report.skipped_terms = left_out(scene, &report.terms);
}
