//! A drape from start to end: the coarsest level is sewn and relaxed, and each finer one begins
//! with the shape of the last.

use crate::scene::Scene;
use crate::solver::context::Context;
use crate::solver::drape::error_estimate::estimate_by_moves;
use crate::solver::drape::force_balance::measure_unrelaxed;
use crate::solver::drape::hierarchy::MeshHierarchy;
use crate::solver::drape::level::Level;
use crate::solver::drape::monitor::Monitor;
use crate::solver::drape::perturb::perturb_degenerate;
use crate::solver::drape::solve_level::solve_level;
use crate::solver::drape::stage::IterationLimits;
use crate::solver::integrate::stability::feasibility;
use crate::solver::options::{Method, SolverOptions};
use crate::solver::outcome::{
    AtRest, Drape, DrapeOutcome, ErrorEstimate, ForceBalance, LevelOutcome, LevelPlan,
    RelaxOutcome, Unfinished,
};
use crate::solver::report::cost_model;
use crate::solver::report::describe::describe;
use crate::solver::report::measure::{measure_shape, rms_distance, seam_gap};
use crate::solver::report::schema::StartedFrom;
use crate::solver::statistics::{Fallback, SolveStatistics};
use nalgebra::Vector3;

/// Residual to which the coarser levels are solved: their shapes are off by their mesh error
/// anyway.
const COARSE_TOLERANCE: f64 = 1e-3;

/// Residual at which a drape stops at the latest, over its round-off floor; below a few floors
/// rounding decides.
const FLOOR_MULTIPLE: f64 = 10.0;
/// The same of a drape that is continued.
const CONTINUED_FLOOR_MULTIPLE: f64 = 3.0;
/// Gap of a seam up to which it is closed at once, not sewn \[m\]: what ease leaves between two
/// meshes.
const WELDED_GAP: f64 = 5e-3;

/// Sews and drapes.
///
/// # Guarantees
/// Ends within the limits of the context and never with a shape that is not finite; the report says
/// whether the shape is at rest, and why not where it is not.
///
/// Where the scene has `self_contact` and the method is Newton's, cloth that does not pass through
/// cloth when it is sewn, or is pulled out of it between two levels, does not at the end.
///
/// # Limitations
/// Rest shapes are not unique: cloth folds one way or another. Panels that pass through each other
/// by more than a fold at the start may do so at the end; methods that step in time have no contact
/// of cloth with cloth.
pub fn drape(scene: &Scene, options: &SolverOptions, context: &mut Context<'_>) -> Drape {
    let hierarchy = if options.method.is_time_stepping() {
        // Motion is that of the mesh asked for.
        MeshHierarchy::single(scene)
    } else {
        MeshHierarchy::new(scene)
    };
    describe(
        scene,
        MultilevelSolve::new(&hierarchy, options, None, context).run(),
    )
}

/// Drapes on from a drape of the same scene whose seams are closed, without sewing.
pub fn drape_on(
    scene: &Scene,
    options: &SolverOptions,
    from: &Drape,
    context: &mut Context<'_>,
) -> Drape {
    let hierarchy = MeshHierarchy::single(scene);
    describe(
        scene,
        MultilevelSolve::new(&hierarchy, options, Some(from), context).run(),
    )
}

/// Drapes on from any shape of the scene \[m; `#V`\], on its own mesh alone: seams that are open
/// there are sewn first.
pub fn drape_from(
    scene: &Scene,
    options: &SolverOptions,
    positions: &[Vector3<f64>],
    context: &mut Context<'_>,
) -> Drape {
    let stitches: Vec<_> = scene.mesh.stitches.iter().map(|s| (s.a, s.b)).collect();
    let hierarchy = MeshHierarchy::single(scene);
    let from = Drape::of_shape(positions);
    let mut solve = MultilevelSolve::new(&hierarchy, options, Some(&from), context);
    solve.is_sewn = seam_gap(&stitches, positions) < WELDED_GAP;
    let mut drape = describe(scene, solve.run());
    let at_start = measure_unrelaxed(scene, options, positions, context.cpu_s);
    drape.report.started_from = Some(StartedFrom {
        energy_j: at_start.energy,
    });
    drape
}

/// A drape from level to level.
struct MultilevelSolve<'a, 's, 'c, 'w> {
    hierarchy: &'a MeshHierarchy<'s>,
    options: &'a SolverOptions,
    from: Option<&'a Drape>,
    clock: &'w dyn Fn() -> f64,
    limits: IterationLimits,
    monitor: Monitor<'c, 'w>,
    plan: LevelPlan,
    levels: Vec<LevelOutcome>,
    statistics: SolveStatistics,
    /// True if the seams are closed.
    is_sewn: bool,
    /// The shape that the finest level began with, if it was one at rest.
    handed_on: Option<Vec<Vector3<f64>>>,
}

/// A shape, the number of its level (0 is the finest), and how the levels ended.
struct LastShape {
    positions: Vec<Vector3<f64>>,
    /// 0 is the finest.
    level: usize,
    end: Result<AtRest, Unfinished>,
}

impl<'a, 's, 'c, 'w> MultilevelSolve<'a, 's, 'c, 'w> {
    fn new(
        hierarchy: &'a MeshHierarchy<'s>,
        options: &'a SolverOptions,
        from: Option<&'a Drape>,
        context: &'c mut Context<'w>,
    ) -> Self {
        Self {
            hierarchy,
            options,
            from,
            clock: context.cpu_s,
            limits: IterationLimits {
                iterations: context.limits.iterations,
                steps: context.limits.steps,
            },
            monitor: Monitor::new(context, options.time_limit_s),
            plan: LevelPlan {
                vertices: hierarchy.sizes(),
                time_limit_s: options.time_limit_s,
                expected_cpu_s: None,
            },
            levels: vec![],
            statistics: SolveStatistics::default(),
            is_sewn: from.is_some(),
            handed_on: None,
        }
    }

    /// Drapes, unless it cannot end.
    fn run(mut self) -> DrapeOutcome {
        let scene = self.hierarchy.scene(0);
        let last = match feasibility::find_infeasibility(
            scene,
            self.options,
            self.limits.steps,
            self.clock,
        ) {
            None => self.solve_levels(),
            Some(why) => LastShape {
                positions: self
                    .from
                    .map_or(&scene.start, |from| &from.positions)
                    .clone(),
                level: 0,
                end: Err(Unfinished::Refused(why)),
            },
        };
        self.finish(last)
    }

    /// Solves from the coarsest level to the finest, or as far as it goes.
    fn solve_levels(&mut self) -> LastShape {
        let coarsest = self.hierarchy.coarsest();
        let start = &self.hierarchy.scene(coarsest).start;
        let mut x = self.from.map_or(start, |from| &from.positions).clone();
        if self.from.is_none() {
            perturb_degenerate(self.hierarchy.scene(coarsest), &mut x);
        }
        let mut number = coarsest;
        loop {
            let level = self.solve_level(number, &mut x);
            let end = level.end();
            let fell = level.relaxation.as_ref().is_ok_and(|relaxed| relaxed.fell);
            if number == coarsest && self.from.is_none() {
                let expected = cost_model::expected_cpu_s(&self.plan.vertices, level.cpu_s());
                self.plan.expected_cpu_s = Some(expected);
            }
            self.levels.push(level);
            let end = if number == 0 || self.monitor.is_over() || fell {
                end
            } else if self.has_time_after(number) {
                x = self.refine(number, &x, end.is_ok());
                number -= 1;
                continue;
            } else {
                Err(self.no_time_after(number))
            };
            return LastShape {
                positions: x,
                level: number,
                end,
            };
        }
    }

    /// Solves one level from `x`, which becomes its shape.
    fn solve_level(&mut self, number: usize, x: &mut Vec<Vector3<f64>>) -> LevelOutcome {
        let coarsest = self.hierarchy.coarsest();
        self.monitor.begin_level(number, coarsest - number, x.len());
        let anchors = self.from.map(|from| from.anchors.clone());
        let mut level = Level {
            scene: self.hierarchy.scene(number),
            options: self.options,
            clock: self.clock,
            limits: self.limits,
            monitor: &mut self.monitor,
            tolerance: match (number, self.options.tolerance_m) {
                (0, None) => self.options.tolerance,
                (0, Some(_)) => 0.0,
                _ => self.options.tolerance.max(COARSE_TOLERANCE),
            },
            tolerance_m: self.options.tolerance_m.filter(|_| number == 0),
            floor_multiple: if self.from.is_some() {
                CONTINUED_FLOOR_MULTIPLE
            } else {
                FLOOR_MULTIPLE
            },
            is_finest: number == 0,
            is_sewn: self.is_sewn,
            anchors: anchors.unwrap_or_default(),
        };
        let outcome = solve_level(&mut level, x);
        self.is_sewn |= outcome.relaxation.is_ok();
        self.statistics.merge(&outcome.statistics);
        outcome
    }

    /// Returns true if there is time for the next finer level; else the time is up.
    fn has_time_after(&mut self, number: usize) -> bool {
        let [next, this] = [number - 1, number].map(|n| self.hierarchy.scene(n).start.len());
        let times = next as f64 / this as f64;
        let enough = cost_model::has_time(self.monitor.left_s(), self.monitor.pace(), times);
        self.monitor.out_of_time |= !enough;
        enough
    }

    /// Returns the reason of an end after `number`.
    fn no_time_after(&self, number: usize) -> Unfinished {
        Unfinished::NoTimeForFinerMesh {
            vertices: self.hierarchy.scene(number).start.len(),
            finer_vertices: self.hierarchy.scene(number - 1).start.len(),
        }
    }

    /// Carries the shape of level `number` to the next finer one, and keeps it if it is to tell the
    /// mesh error.
    fn refine(&mut self, number: usize, x: &[Vector3<f64>], is_at_rest: bool) -> Vec<Vector3<f64>> {
        let refined = self.hierarchy.refine(number, x);
        if self.hierarchy.is_softer(number) {
            self.statistics.fallbacks.insert(Fallback::SofterCloth);
            // What a coarser mesh of softer cloth handed on tells of both.
            self.handed_on = None;
        } else {
            let is_whole = refined.len() == self.hierarchy.scene(0).start.len();
            self.handed_on = (is_at_rest && is_whole).then(|| refined.clone());
        }
        refined
    }

    /// Measures the last shape on the finest mesh.
    fn finish(self, last: LastShape) -> DrapeOutcome {
        let scene = self.hierarchy.scene(0);
        let mut x = self.hierarchy.to_finest(last.level, last.positions);
        if !x.iter().all(|p| p.iter().all(|c| c.is_finite())) {
            x.clone_from(&scene.start);
        }
        let relaxed = self
            .levels
            .last()
            .and_then(|level| level.relaxation.as_ref().ok());
        let (balance, estimate) = self.assess(relaxed, last.level, &x);
        let measures = measure_shape(scene, &x);
        let handed_on = self.handed_on.filter(|_| last.end.is_ok());
        let to_finest = |level, x| self.hierarchy.to_finest(level, x);
        let sunk = self
            .levels
            .iter()
            .filter_map(|level| level.relaxation.as_ref().ok());
        DrapeOutcome {
            anchors: relaxed
                .map(|relaxed| relaxed.anchors.clone())
                .unwrap_or_default(),
            method: rest_method(self.options.method),
            end: last.end,
            balance,
            estimate,
            mesh_error_m: handed_on.as_ref().map(|shape| rms_distance(shape, &x)),
            handed_on,
            measures,
            sunk_m: sunk.fold(0.0, |sum, relaxed| sum + relaxed.sunk_m),
            halving_s: relaxed.and_then(|relaxed| relaxed.remaining?.halving_s),
            history: self.monitor.history.points(&to_finest, &x),
            cpu_s: self.monitor.cpu_s(),
            canceled: self.monitor.canceled,
            out_of_time: self.monitor.out_of_time,
            positions: x,
            plan: self.plan,
            levels: self.levels,
            statistics: self.statistics,
        }
    }

    /// Returns the forces on the last shape and its distance to the solution.
    fn assess(
        &self,
        relaxed: Option<&RelaxOutcome>,
        finer: usize,
        x: &[Vector3<f64>],
    ) -> (ForceBalance, Option<ErrorEstimate>) {
        match relaxed {
            Some(relaxed) if relaxed.balance.residual.is_finite() => {
                let estimate = estimate_by_moves(&self.levels, relaxed, finer);
                (relaxed.balance, Some(estimate))
            }
            _ => {
                let scene = self.hierarchy.scene(0);
                let balance = measure_unrelaxed(scene, self.options, x, self.clock);
                let estimate = relaxed.and_then(|relaxed| relaxed.estimate);
                let untold = |estimate| ErrorEstimate {
                    distance_m: None,
                    ..estimate
                };
                (balance, estimate.map(untold))
            }
        }
    }
}

/// Returns the method that finds a shape at rest where `asked` is asked for.
fn rest_method(asked: Method) -> Method {
    match asked {
        Method::Auto => Method::Newton,
        method => method,
    }
}
