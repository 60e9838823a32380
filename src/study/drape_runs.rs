//! The drapes of a study on one mesh, and the rest shapes that they are measured against.

use super::finding::{ReferenceFinding, RestPair};
use super::part::{PartKind, SkipReason, StudyPart};
use super::plan::{MeshResult, RunSetting, StudyPlan, StudyScene};
use super::report::{Study, StudyMesh, StudyReference, StudyRun};
use super::rest_shape::{RestShape, depends_on_path, total_energy};
use super::rest_shapes::RestShapes;
use super::schedule::StudySchedule;
use super::wording;
use crate::solver::{self, Drape, Method, SolverOptions};

/// Tolerance of a method of the reference that no run of the study serves for.
const REFERENCE_TOLERANCE: f64 = 1e-2;
/// An error is certain if it is this many times the bound on that of its reference.
const CERTAIN: f64 = 3.0;
/// A run that did not converge and took this share of its time ran out of it: the solver ends a
/// little before its time is up.
const OUT_OF_TIME: f64 = 0.7;

/// All drapes on one mesh.
pub(super) struct DrapeRuns<'a, 'c, 'w> {
    scene: &'a StudyScene,
    plan: &'a StudyPlan,
    schedule: &'a mut StudySchedule<'c, 'w>,
    shapes: RestShapes,
    at_rest: Vec<RunAtRest>,
}

/// A run with the rest shape that it led to.
#[derive(Clone, Copy, Debug)]
struct RunAtRest {
    method: Method,
    tolerance: f64,
    energy_j: f64,
    /// The number of the shape; none if there are too many.
    shape: Option<usize>,
}

/// A drape with its CPU time and the one that it was allowed \[s\].
struct TimedDrape {
    drape: Drape,
    cpu_s: f64,
    allowed_s: f64,
}

impl<'a, 'c, 'w> DrapeRuns<'a, 'c, 'w> {
    /// Returns the weight of all drapes on a mesh: each run and going on from it, and the same for
    /// the two methods of the reference.
    pub(super) fn weight(plan: &StudyPlan) -> f64 {
        2.0 * (plan.methods.len() * plan.tolerances.len()) as f64 + 4.0
    }

    pub(super) fn new(
        scene: &'a StudyScene,
        plan: &'a StudyPlan,
        schedule: &'a mut StudySchedule<'c, 'w>,
    ) -> Self {
        Self {
            scene,
            plan,
            schedule,
            shapes: RestShapes::default(),
            at_rest: Vec::new(),
        }
    }

    /// Makes all runs, and adds them to the study.
    pub(super) fn run(mut self, study: &mut Study) -> MeshResult {
        let first = study.runs.len();
        // Newton first: it gives the reference.
        let (stepping, solving): (Vec<Method>, Vec<Method>) =
            self.plan.methods.iter().partition(|m| m.is_time_stepping());
        for &method in solving.iter().chain(&stepping) {
            self.runs_of(method, study);
        }
        let (reference, shape) = self.reference();
        let rest = shape.map(|number| self.shapes.drape(number).clone());
        if let Some(number) = shape {
            self.shapes.make_first(number);
        }
        for run in &mut study.runs[first..] {
            run.minimum = run.minimum.map(|m| self.shapes.place_of(m));
            run.same_as_reference = shape.and(run.minimum).map(|m| m == 0);
        }
        let mesh = &self.scene.scene.mesh;
        MeshResult {
            mesh: StudyMesh {
                edge_length_m: self.scene.edge_length_m,
                vertices: mesh.uv.len(),
                triangles: mesh.triangles.len(),
                reference,
                minima: self.shapes.listed(),
                mesh_error_m: None,
            },
            shapes: rest.iter().map(|r| r.positions.clone()).collect(),
            rest,
        }
    }

    /// Makes the runs of one method, the largest tolerance first, until one takes all its time.
    fn runs_of(&mut self, method: Method, study: &mut Study) {
        let mut tolerances = self.plan.tolerances.clone();
        tolerances.sort_by(|a, b| b.total_cmp(a));
        let mut is_too_slow = false;
        for tolerance in tolerances {
            if is_too_slow {
                let part = self.part(PartKind::Run(method, RunSetting::Tolerance(tolerance)));
                self.schedule.skip(part, SkipReason::LargerToleranceTooSlow);
                self.schedule.count_done(2.0);
                continue;
            }
            let Some(made) = self.drape(PartKind::Run, method, tolerance) else {
                continue;
            };
            let run = self.measured(method, tolerance, &made);
            is_too_slow = !run.converged && made.cpu_s >= OUT_OF_TIME * made.allowed_s;
            study.runs.push(run);
        }
    }

    /// Measures a run by the rest shape that it leads to.
    fn measured(&mut self, method: Method, tolerance: f64, made: &TimedDrape) -> StudyRun {
        let report = &made.drape.report;
        let mut run = StudyRun {
            method,
            used: report.method.clone(),
            tolerance: Some(tolerance),
            step_s: None,
            edge_length_m: self.scene.edge_length_m,
            vertices: report.vertices,
            cpu_s: made.cpu_s,
            error_m: None,
            error_certain: false,
            estimate_m: report.error_estimate_m,
            estimate_valid: report.error_estimate_valid,
            energy_j: Some(total_energy(&report.energy_j))
                .filter(|e| e.is_finite())
                .unwrap_or(0.0),
            residual: Some(report.residual).filter(|r| r.is_finite()),
            minimum: None,
            minimum_energy_j: None,
            same_as_reference: None,
            steps: report.newton_iterations as u64,
            converged: report.converged,
            why: report.why.clone(),
        };
        if let Some(rest) = self.rest_of(&made.drape, method, tolerance) {
            let found = self.keep(method, tolerance, &rest, true);
            run.error_m = Some(rest.error_m());
            run.error_certain = rest.moved_m >= CERTAIN * rest.estimate_m();
            run.minimum = found.shape;
            run.minimum_energy_j = Some(found.energy_j);
            if report.converged {
                self.at_rest.push(found);
            }
        }
        run
    }

    fn drape(
        &mut self,
        kind: fn(Method, RunSetting) -> PartKind,
        method: Method,
        tolerance: f64,
    ) -> Option<TimedDrape> {
        let scene = &self.scene.scene;
        let part = self.part(kind(method, RunSetting::Tolerance(tolerance)));
        let options = self.options(method, tolerance);
        self.schedule.run(part, 1.0, |context, time| {
            let began = (context.cpu_s)();
            let options = SolverOptions {
                time_limit_s: Some(time),
                ..options
            };
            TimedDrape {
                drape: solver::drape(scene, &options, context),
                cpu_s: (context.cpu_s)() - began,
                allowed_s: time,
            }
        })
    }

    /// Goes on from a drape to the rest shape that it leads to.
    fn rest_of(&mut self, drape: &Drape, method: Method, tolerance: f64) -> Option<RestShape> {
        let scene = &self.scene.scene;
        let part = self.part(PartKind::Continuation(
            method,
            RunSetting::Tolerance(tolerance),
        ));
        let options = self.options(Method::Newton, tolerance);
        let rest = self.schedule.run(part, 1.0, |context, time| {
            let options = SolverOptions {
                time_limit_s: Some(time),
                ..options
            };
            RestShape::of(scene, &options, drape, context)
        })?;
        if rest.is_none() {
            self.schedule.skip(part, SkipReason::NotAtRest);
        }
        rest
    }

    fn keep(
        &mut self,
        method: Method,
        tolerance: f64,
        rest: &RestShape,
        is_run: bool,
    ) -> RunAtRest {
        RunAtRest {
            method,
            tolerance,
            energy_j: rest.energy_j(),
            shape: self.shapes.find_or_add(rest, is_run),
        }
    }

    /// Finds a rest shape by Newton's method and one by a method that steps, and compares them.
    /// Returns also the number of the first.
    fn reference(&mut self) -> (StudyReference, Option<usize>) {
        let began = self.schedule.cpu_s();
        let first = self
            .most_exact(|m| !m.is_time_stepping())
            .or_else(|| self.reference_run(Method::Newton));
        let second = self
            .most_exact(Method::is_time_stepping)
            .or_else(|| self.reference_run(Method::ImplicitEuler));
        let runs: Vec<RunAtRest> = first.into_iter().chain(second).collect();
        let mut reference = self.comparison(&runs);
        reference.methods = runs.iter().map(|run| run.method).collect();
        reference.energies_j = runs.iter().map(|run| run.energy_j).collect();
        reference.cpu_s = self.schedule.cpu_s() - began;
        (reference, first.and_then(|run| run.shape))
    }

    /// Returns the run with the smallest tolerance of those that came to rest by such a method.
    fn most_exact(&mut self, is_such: impl Fn(Method) -> bool) -> Option<RunAtRest> {
        let such = self.at_rest.iter().filter(|run| is_such(run.method));
        let best = such
            .min_by(|a, b| a.tolerance.total_cmp(&b.tolerance))
            .copied();
        if best.is_some() {
            self.schedule.count_done(2.0);
        }
        best
    }

    /// Makes a run that was not asked for, to have something to compare with.
    fn reference_run(&mut self, method: Method) -> Option<RunAtRest> {
        let made = self.drape(PartKind::ReferenceDrape, method, REFERENCE_TOLERANCE)?;
        let rest = self.rest_of(&made.drape, method, REFERENCE_TOLERANCE)?;
        Some(self.keep(method, REFERENCE_TOLERANCE, &rest, false))
    }

    /// Compares the rest shapes of two runs, if there are two.
    fn comparison(&self, runs: &[RunAtRest]) -> StudyReference {
        let mut reference = StudyReference::default();
        let finding = match *runs {
            [] => ReferenceFinding::NoneAtRest,
            [a, b] => match (a.shape, b.shape) {
                (Some(i), Some(j)) => {
                    let apart_m = self.shapes.distance(i, j);
                    reference.apart_m = Some(apart_m);
                    reference.uncertainty_m = Some(self.shapes.uncertainty(i));
                    reference.confirmed = i == j;
                    self.shape_finding([a, b], apart_m, i == j)
                }
                _ => ReferenceFinding::TooManyRestShapes,
            },
            [only, ..] => ReferenceFinding::OneAtRest(only.method),
        };
        reference.several_rest_shapes = matches!(
            finding,
            ReferenceFinding::TooManyRestShapes | ReferenceFinding::DifferentRestShapes { .. }
        );
        reference.because = wording::reference(&finding, CERTAIN);
        reference
    }

    fn shape_finding(
        &self,
        [a, b]: [RunAtRest; 2],
        apart_m: f64,
        is_same: bool,
    ) -> ReferenceFinding {
        let pair = RestPair {
            methods: [a.method, b.method],
            energies_j: [a.energy_j, b.energy_j],
        };
        if is_same {
            return ReferenceFinding::SameRestShape(pair);
        }
        ReferenceFinding::DifferentRestShapes {
            pair,
            apart_m,
            depends_on_path: depends_on_path(&self.scene.scene),
        }
    }

    fn part(&self, kind: PartKind) -> StudyPart {
        StudyPart {
            kind,
            edge_length_m: self.scene.edge_length_m,
        }
    }

    fn options(&self, method: Method, tolerance: f64) -> SolverOptions {
        SolverOptions {
            method,
            tolerance,
            tolerance_m: None,
            edge_length_m: self.scene.edge_length_m,
            ..self.plan.simulate.clone()
        }
    }
}
