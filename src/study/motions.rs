//! The motions of a study on one mesh, with their errors.

use super::order;
use super::reference::{Kept, Reference, frames_apart};
use super::report::{Study, StudyMesh, StudyReference, StudyRun};
use super::run::{OnMesh, StudyPlan, StudyScene, edges};
use super::work::Work;
use crate::scene::Scene;
use crate::solver::{self, Analysis, Drape, Method, SolverOptions, Start, Trajectory};
use nalgebra::Vector3;

/// Tolerance of runs with fixed steps, which says how exactly implicit steps are solved \[m/s\]: to 2e-10 of the weight.
pub(super) const EXACTLY: f64 = 1e-7;
/// Where steps are left to the study: shares of the limit of explicit methods, and of the time between two frames for implicit
/// ones.
const SHARES_OF_LIMIT: [f64; 4] = [0.8, 0.4, 0.2, 0.1];
const SHARES_OF_FRAME: [f64; 4] = [0.25, 0.125, 0.0625, 0.03125];
/// Frames of a run that are compared, at most.
const FRAMES: usize = 31;
/// An error is certain if it is so many times the distance between the two methods of the reference.
pub(super) const CERTAIN: f64 = 3.0;
/// Parts that the start, and the rest shape for the stability limit, count as.
const START_PARTS: f64 = 1.0;
const REST_PARTS: f64 = 1.0;
/// Residual of that rest shape.
const REST_TOLERANCE: f64 = 1e-9;

/// All motions on one mesh.
pub(super) struct Motions<'a, 'c, 'w> {
    scene: &'a StudyScene,
    plan: &'a StudyPlan,
    work: &'a mut Work<'c, 'w>,
}

/// What is varied in one run.
#[derive(Clone, Copy, Debug)]
enum Setting {
    Step(f64),
    Tolerance(f64),
}

/// A run and the frames of it that are compared.
struct Made {
    run: StudyRun,
    kept: Option<Kept>,
    /// Length of its steps on average \[s\].
    step_s: f64,
}

impl<'a, 'c, 'w> Motions<'a, 'c, 'w> {
    pub(super) fn parts(plan: &StudyPlan) -> f64 {
        let given = plan.steps_s.len() + plan.tolerances.len();
        let settings = if given == 0 {
            SHARES_OF_LIMIT.len()
        } else {
            given
        };
        START_PARTS + REST_PARTS + (plan.methods.len() * settings) as f64 + Reference::PARTS
    }

    pub(super) fn new(
        scene: &'a StudyScene,
        plan: &'a StudyPlan,
        work: &'a mut Work<'c, 'w>,
    ) -> Self {
        Self { scene, plan, work }
    }

    pub(super) fn run(mut self, study: &mut Study) -> OnMesh {
        let start = self.start(study);
        let mut made = Vec::new();
        if let Some(start) = &start {
            for &method in &self.plan.methods {
                for setting in self.settings(method, start) {
                    made.extend(self.made(method, setting, start));
                }
            }
        }
        let (reference, shapes) = match &start {
            Some(start) if made.iter().any(|m: &Made| m.kept.is_some()) => {
                self.measure(&mut made, start)
            }
            _ => (StudyReference::default(), Vec::new()),
        };
        let steps: Vec<f64> = made.iter().map(|m| m.step_s).collect();
        let runs: Vec<StudyRun> = made.into_iter().map(|m| m.run).collect();
        study.orders.extend(order::orders(&runs, &steps));
        study.runs.extend(runs);
        let rest = start.and_then(|start| self.rest(&start));
        let mesh = &self.scene.scene.mesh;
        OnMesh {
            mesh: StudyMesh {
                edge_length_m: self.scene.edge_length_m,
                vertices: mesh.uv.len(),
                triangles: mesh.triangles.len(),
                reference,
                minima: Vec::new(),
                mesh_error_m: None,
            },
            shapes,
            rest,
        }
    }

    /// Where the motion begins: what is sewn must be closed first, and what is at rest must have something to move it.
    fn start(&mut self, study: &mut Study) -> Option<Vec<Vector3<f64>>> {
        let scene = &self.scene.scene;
        if scene.mesh.stitches.is_empty() && scene.wind.is_none() {
            self.work.skip(START_PARTS);
            return Some(scene.start.clone());
        }
        let (still, words) = if scene.wind.is_some() {
            let still = Scene {
                wind: None,
                ..scene.clone()
            };
            (
                still,
                "the garment draped in still air; then the wind blows",
            )
        } else {
            let still = Scene {
                gravity: Vector3::zeros(),
                ..scene.clone()
            };
            (still, "the garment sewn without weight; then it falls")
        };
        words.clone_into(&mut study.start);
        let what = format!("sewing the start, {}", edges(self.scene.edge_length_m));
        let ask = SolverOptions {
            analysis: Analysis::Static,
            method: Method::Newton,
            tolerance: 1e-3,
            step_s: None,
            ..self.plan.simulate.clone()
        };
        let drape = self.work.part(&what, START_PARTS, |context, time| {
            let ask = SolverOptions {
                time_limit_s: Some(time),
                ..ask
            };
            solver::drape(&still, &ask, context)
        })?;
        if drape.report.seam_gap_max_m >= self.plan.simulate.seam_eps_m {
            self.work.leave_out(
                format!("motions, {}", edges(self.scene.edge_length_m)),
                format!("the seams could not be closed: {}", drape.report.why),
            );
            return None;
        }
        Some(drape.positions)
    }

    fn settings(&mut self, method: Method, start: &[Vector3<f64>]) -> Vec<Setting> {
        let steps = self.plan.steps_s.iter().map(|&h| Setting::Step(h));
        let tolerances = self.plan.tolerances.iter().map(|&t| Setting::Tolerance(t));
        let mut settings: Vec<Setting> = steps.chain(tolerances).collect();
        if settings.is_empty() {
            let longest = self.allowed(method, start);
            let frame = 1.0 / self.plan.simulate.frame_rate_hz.unwrap_or(30.0);
            settings = match longest {
                Some(limit) => SHARES_OF_LIMIT.map(|s| Setting::Step(s * limit.min(frame))),
                None => SHARES_OF_FRAME.map(|s| Setting::Step(s * frame)),
            }
            .to_vec();
        }
        settings
    }

    /// The longest step that an explicit method is allowed \[s\].
    fn allowed(&mut self, method: Method, start: &[Vector3<f64>]) -> Option<f64> {
        let ask = self.ask(method, Setting::Tolerance(EXACTLY));
        let what = format!("the longest step of {}", method.name());
        let scene = &self.scene.scene;
        self.work.part(&what, 0.0, |context, _| {
            solver::allowed_step(scene, &ask, start, context)
        })?
    }

    fn made(&mut self, method: Method, setting: Setting, start: &[Vector3<f64>]) -> Option<Made> {
        let what = format!(
            "{} with {}, {}",
            method.name(),
            match setting {
                Setting::Step(h) => format!("steps of {h:.2e} s"),
                Setting::Tolerance(t) => format!("tolerance {t:.0e}"),
            },
            edges(self.scene.edge_length_m)
        );
        let ask = self.ask(method, setting);
        let motion = self.moved(&what, 1.0, ask, start)?;
        let report = &motion.report;
        let step_s = report.simulated_s / report.steps.max(1) as f64;
        let mut why = report.why.clone();
        if report.complete && !report.within_limits {
            why += "; some steps were above the stability limit of that moment";
        }
        let energy_j = motion.frames.last().map_or(0.0, |f| f.energy.total());
        let run = StudyRun {
            method,
            used: report.method.clone(),
            tolerance: match setting {
                Setting::Tolerance(t) => Some(t),
                Setting::Step(_) => None,
            },
            step_s: match setting {
                Setting::Step(h) => Some(h),
                Setting::Tolerance(_) => None,
            },
            edge_length_m: self.scene.edge_length_m,
            vertices: self.scene.scene.start.len(),
            cpu_s: report.cpu_s,
            error_m: None,
            error_certain: false,
            estimate_m: Some(report.local_errors_m).filter(|e| report.steps > 0 && e.is_finite()),
            // Errors of velocity are not in it.
            estimate_valid: false,
            energy_j: if energy_j.is_finite() { energy_j } else { 0.0 },
            residual: None,
            minimum: None,
            minimum_energy_j: None,
            same_as_reference: None,
            steps: report.steps,
            converged: report.complete,
            why,
        };
        let kept = report.complete.then(|| self.kept(&motion));
        Some(Made { run, kept, step_s })
    }

    /// A motion from the start.
    fn moved(
        &mut self,
        what: &str,
        parts: f64,
        ask: SolverOptions,
        start: &[Vector3<f64>],
    ) -> Option<Trajectory> {
        let scene = &self.scene.scene;
        self.work.part(what, parts, |context, time| {
            let ask = SolverOptions {
                time_limit_s: Some(time),
                ..ask
            };
            let from = Start {
                positions: Some(start.to_vec()),
                velocities: None,
            };
            solver::trajectory(scene, &ask, from, context)
        })
    }

    /// Frames of a motion evenly over its time, the last one among them; the same ones for all meshes.
    fn kept(&self, motion: &Trajectory) -> Kept {
        let last = motion.frames.len().saturating_sub(1);
        let count = last.min(FRAMES);
        let number = |i: usize| i * last / count.max(1);
        let frame = |i: usize| motion.frames[number(i)].positions.clone();
        Kept((1..=count).map(frame).collect())
    }

    /// Fills in the errors against a reference that is refined as far as they need.
    fn measure(
        &mut self,
        made: &mut [Made],
        start: &[Vector3<f64>],
    ) -> (StudyReference, Vec<Vec<Vector3<f64>>>) {
        let began = self.work.cpu_s();
        let frame = 1.0 / self.plan.simulate.frame_rate_hz.unwrap_or(30.0);
        let shortest = |such: fn(&str) -> bool| {
            let of_such = made
                .iter()
                .filter(|m| m.kept.is_some() && such(&m.run.used));
            of_such.map(|m| m.step_s).fold(f64::INFINITY, f64::min)
        };
        let explicit = shortest(|used| matches!(used, "verlet" | "symplectic_euler"));
        let implicit = shortest(|used| matches!(used, "bdf2" | "implicit_euler"));
        let explicit = if explicit.is_finite() {
            explicit
        } else {
            let limit = self.allowed(Method::Verlet, start).unwrap_or(f64::INFINITY);
            0.5 * limit.min(frame)
        };
        let first = [0.5 * explicit, 0.5 * implicit.min(0.25 * frame)];
        let all: Vec<Kept> = made.iter().filter_map(|m| m.kept.clone()).collect();
        let smallest = |reference: &Kept| {
            let errors = all.iter().map(|kept| frames_apart(kept, reference));
            errors.filter(|e| *e > 0.0).fold(f64::INFINITY, f64::min)
        };
        let mut left = Reference::PARTS;
        let edges = edges(self.scene.edge_length_m);
        let mut motion = |method: Method, h: f64, share: f64| {
            left -= share;
            let what = format!(
                "reference: {} in steps of {h:.2e} s, {edges}",
                method.name()
            );
            let ask = self.ask(method, Setting::Step(h));
            let motion = self.moved(&what, share, ask, start)?;
            motion.report.complete.then(|| self.kept(&motion))
        };
        let reference = Reference::refined(first, &mut motion, smallest);
        self.work.skip(left.max(0.0));
        let Some(mut reference) = reference else {
            let because = "no reference motion was finished in the time allowed".to_owned();
            self.work
                .leave_out(format!("errors, {edges}"), because.clone());
            let none = StudyReference {
                because,
                ..StudyReference::default()
            };
            return (none, Vec::new());
        };
        let uncertain = reference.told.uncertainty_m;
        for made in made.iter_mut() {
            let Some(kept) = &made.kept else { continue };
            let error = frames_apart(kept, &reference.motion);
            if error.is_finite() {
                made.run.error_m = Some(error.max(uncertain.unwrap_or(0.0)));
                made.run.error_certain = uncertain.is_some_and(|u| error >= CERTAIN * u);
            }
        }
        reference.told.confirmed = made.iter().any(|m| m.run.error_certain);
        reference.told.cpu_s = self.work.cpu_s() - began;
        (reference.told, reference.motion.0)
    }

    /// A rest shape near where the motion begins, for the stability limits.
    fn rest(&mut self, start: &[Vector3<f64>]) -> Option<Drape> {
        let scene = &self.scene.scene;
        let ask = SolverOptions {
            analysis: Analysis::Static,
            method: Method::Newton,
            tolerance: REST_TOLERANCE,
            step_s: None,
            ..self.plan.simulate.clone()
        };
        let what = format!(
            "a rest shape for the stability limits, {}",
            edges(self.scene.edge_length_m)
        );
        let drape = self.work.part(&what, REST_PARTS, |context, time| {
            let ask = SolverOptions {
                time_limit_s: Some(time),
                ..ask
            };
            solver::drape_on(scene, &ask, &Drape::of_shape(start), context)
        })?;
        drape.report.converged.then_some(drape)
    }

    fn ask(&self, method: Method, setting: Setting) -> SolverOptions {
        let (tolerance, step_s) = match setting {
            Setting::Step(h) => (EXACTLY, Some(h)),
            Setting::Tolerance(t) => (t, None),
        };
        SolverOptions {
            analysis: Analysis::Transient,
            method,
            tolerance,
            step_s,
            edge_length_m: self.scene.edge_length_m,
            ..self.plan.simulate.clone()
        }
    }
}
