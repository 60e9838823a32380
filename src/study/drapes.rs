//! The drapes of a study on one mesh, and what they are measured against.

use super::minima::Minima;
use super::report::{Study, StudyMesh, StudyReference, StudyRun};
use super::rest::{Rest, depends_on_path, total};
use super::run::{OnMesh, StudyPlan, StudyScene, edges};
use super::work::Work;
use crate::solver::{self, Drape, Method, SolverOptions};

/// What a method of the reference is asked for where no run of the study serves.
const OWN_TOLERANCE: f64 = 1e-2;
/// An error is certain if it is so many times what bounds that of its reference.
const CERTAIN: f64 = 3.0;

/// All drapes on one mesh.
pub(super) struct Drapes<'a, 'c, 'w> {
    scene: &'a StudyScene,
    plan: &'a StudyPlan,
    work: &'a mut Work<'c, 'w>,
    minima: Minima,
    found: Vec<Found>,
}

/// A rest shape that a run led to.
#[derive(Clone, Copy, Debug)]
struct Found {
    method: Method,
    tolerance: f64,
    energy_j: f64,
    minimum: Option<usize>,
}

impl<'a, 'c, 'w> Drapes<'a, 'c, 'w> {
    /// Each run with where it goes on to, and the same for the two methods of the reference.
    pub(super) fn parts(plan: &StudyPlan) -> f64 {
        2.0 * (plan.methods.len() * plan.tolerances.len()) as f64 + 4.0
    }

    pub(super) fn new(
        scene: &'a StudyScene,
        plan: &'a StudyPlan,
        work: &'a mut Work<'c, 'w>,
    ) -> Self {
        Self {
            scene,
            plan,
            work,
            minima: Minima::default(),
            found: Vec::new(),
        }
    }

    pub(super) fn run(mut self, study: &mut Study) -> OnMesh {
        let first = study.runs.len();
        // Newton first: it gives the reference.
        let (follow, find): (Vec<Method>, Vec<Method>) =
            self.plan.methods.iter().partition(|m| m.is_time_stepping());
        for &method in find.iter().chain(&follow) {
            let mut tolerances = self.plan.tolerances.clone();
            tolerances.sort_by(|a, b| b.total_cmp(a));
            let mut too_slow = false;
            for tolerance in tolerances {
                if too_slow {
                    let because = "a larger tolerance took all the time that one run may take";
                    self.work.leave_out(self.what(method, tolerance), because);
                    self.work.skip(2.0);
                    continue;
                }
                let (run, out_of_time) = self.measured(method, tolerance).unzip();
                too_slow = out_of_time.unwrap_or(false);
                study.runs.extend(run);
            }
        }
        let began = self.work.cpu_s();
        let reference = self
            .best(|m| !m.is_time_stepping())
            .or_else(|| self.own(Method::Newton));
        let second = self
            .best(Method::is_time_stepping)
            .or_else(|| self.own(Method::ImplicitEuler));
        let mut confirmed = self.confirmation(reference, second);
        confirmed.cpu_s = self.work.cpu_s() - began;
        let number = reference.and_then(|found| found.minimum);
        let rest = number.map(|number| self.minima.drape(number).clone());
        if let Some(number) = number {
            self.minima.make_first(number);
        }
        for run in &mut study.runs[first..] {
            run.minimum = run.minimum.map(|m| self.minima.place_of(m));
            run.same_as_reference = number.and(run.minimum).map(|m| m == 0);
        }
        let mesh = &self.scene.scene.mesh;
        OnMesh {
            mesh: StudyMesh {
                edge_length_m: self.scene.edge_length_m,
                vertices: mesh.uv.len(),
                triangles: mesh.triangles.len(),
                reference: confirmed,
                minima: self.minima.listed(),
                mesh_error_m: None,
            },
            shapes: rest.iter().map(|r| r.positions.clone()).collect(),
            rest,
        }
    }

    /// One run with its error, and whether it was stopped because its time was up.
    fn measured(&mut self, method: Method, tolerance: f64) -> Option<(StudyRun, bool)> {
        let (drape, cpu_s, time) = self.draped(method, tolerance, "")?;
        let report = &drape.report;
        let mut run = StudyRun {
            method,
            used: report.method.clone(),
            tolerance: Some(tolerance),
            step_s: None,
            edge_length_m: self.scene.edge_length_m,
            vertices: report.vertices,
            cpu_s,
            error_m: None,
            error_certain: false,
            estimate_m: report.error_estimate_m,
            estimate_valid: report.error_estimate_valid,
            energy_j: Some(total(&report.energy_j))
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
        if let Some(rest) = self.rest_of(&drape, method, tolerance) {
            let found = self.keep(method, tolerance, &rest, true);
            run.error_m = Some(rest.error_m());
            run.error_certain = rest.moved_m >= CERTAIN * rest.estimate_m();
            run.minimum = found.minimum;
            run.minimum_energy_j = Some(found.energy_j);
            if report.converged {
                self.found.push(found);
            }
        }
        // The solver ends a little before its time is up.
        let out_of_time = !run.converged && cpu_s >= 0.7 * time;
        Some((run, out_of_time))
    }

    /// A drape, its CPU time and the one that it was allowed \[s\].
    fn draped(&mut self, method: Method, tolerance: f64, why: &str) -> Option<(Drape, f64, f64)> {
        let scene = &self.scene.scene;
        let what = format!("{why}{}", self.what(method, tolerance));
        let ask = self.ask(method, tolerance);
        self.work.part(&what, 1.0, |context, time| {
            let began = (context.cpu_s)();
            let ask = SolverOptions {
                time_limit_s: Some(time),
                ..ask
            };
            let drape = solver::drape(scene, &ask, context);
            (drape, (context.cpu_s)() - began, time)
        })
    }

    fn rest_of(&mut self, drape: &Drape, method: Method, tolerance: f64) -> Option<Rest> {
        let scene = &self.scene.scene;
        let what = format!("where {} leads to", self.what(method, tolerance));
        let ask = self.ask(Method::Newton, tolerance);
        let rest = self.work.part(&what, 1.0, |context, time| {
            let ask = SolverOptions {
                time_limit_s: Some(time),
                ..ask
            };
            Rest::of(scene, &ask, drape, context)
        })?;
        if rest.is_none() {
            self.work
                .leave_out(what, "its shape did not come to rest from there");
        }
        rest
    }

    fn keep(&mut self, method: Method, tolerance: f64, rest: &Rest, is_run: bool) -> Found {
        Found {
            method,
            tolerance,
            energy_j: rest.energy_j(),
            minimum: self.minima.find(rest, is_run),
        }
    }

    /// Of the runs that came to rest by such a method, the one that went furthest by itself.
    fn best(&mut self, such: impl Fn(Method) -> bool) -> Option<Found> {
        let of_such = self.found.iter().filter(|f| such(f.method));
        let best = of_such
            .min_by(|a, b| a.tolerance.total_cmp(&b.tolerance))
            .copied();
        if best.is_some() {
            self.work.skip(2.0);
        }
        best
    }

    /// A run that the study did not ask for, to have something to compare with.
    fn own(&mut self, method: Method) -> Option<Found> {
        let (drape, _, _) = self.draped(method, OWN_TOLERANCE, "for the reference: ")?;
        let rest = self.rest_of(&drape, method, OWN_TOLERANCE)?;
        Some(self.keep(method, OWN_TOLERANCE, &rest, false))
    }

    /// Whether the two agree.
    fn confirmation(&self, reference: Option<Found>, second: Option<Found>) -> StudyReference {
        let mut out = StudyReference::default();
        let found: Vec<Found> = reference.into_iter().chain(second).collect();
        out.methods = found.iter().map(|f| f.method).collect();
        out.energies_j = found.iter().map(|f| f.energy_j).collect();
        let [a, b] = found[..] else {
            out.because = why_alone(&found);
            return out;
        };
        let (names, energies) = (
            [a.method.name(), b.method.name()],
            [1e3 * a.energy_j, 1e3 * b.energy_j],
        );
        let (Some(i), Some(j)) = (a.minimum, b.minimum) else {
            out.because = "there are too many rest shapes to compare them all".to_owned();
            out.several_rest_shapes = true;
            return out;
        };
        let apart = self.minima.apart(i, j);
        out.apart_m = Some(apart);
        out.uncertainty_m = Some(self.minima.uncertainty(i));
        out.confirmed = i == j;
        out.several_rest_shapes = i != j;
        out.because = if i == j {
            format!(
                "{} and {}, each taken on to the round-off floor, came to rest in the same shape, at {:.6} and {:.6} mJ",
                names[0], names[1], energies[0], energies[1]
            )
        } else {
            let why = if depends_on_path(&self.scene.scene) {
                "with friction against the body, rest shapes depend on the way there"
            } else {
                "several rest shapes exist"
            };
            format!(
                "{why}: {} came to rest at {:.6} mJ, {} {:.2} mm away at {:.6} mJ",
                names[0],
                energies[0],
                names[1],
                1e3 * apart,
                energies[1]
            )
        };
        out
    }

    fn what(&self, method: Method, tolerance: f64) -> String {
        let edges = edges(self.scene.edge_length_m);
        format!("{} with tolerance {tolerance:.0e}, {edges}", method.name())
    }

    fn ask(&self, method: Method, tolerance: f64) -> SolverOptions {
        SolverOptions {
            method,
            tolerance,
            edge_length_m: self.scene.edge_length_m,
            ..self.plan.simulate.clone()
        }
    }
}

fn why_alone(found: &[Found]) -> String {
    match found {
        [] => "no method came to rest in the time allowed".to_owned(),
        [only, ..] => format!(
            "only {} came to rest in the time allowed: not confirmed",
            only.method.name()
        ),
    }
}
