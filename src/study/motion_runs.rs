//! The motions of a study on one mesh, with their errors.

use super::finding::{ReferenceFinding, StartShape};
use super::motion_reference::{MotionFrames, MotionReference};
use super::order;
use super::part::{PartKind, SkipReason, StudyPart};
use super::plan::{MeshResult, RunSetting, StudyPlan, StudyScene};
use super::report::{Study, StudyMesh, StudyReference, StudyRun};
use super::schedule::StudySchedule;
use super::wording;
use crate::solver::{self, Analysis, Drape, Method, SolverOptions, Start, Trajectory};
use nalgebra::Vector3;

/// Tolerance of runs with fixed steps, to which implicit steps are solved \[m/s\]: 2e-10 of the
/// weight.
const EXACT_TOLERANCE: f64 = 1e-7;
/// Steps that are left to the study: shares of the limit of explicit methods, and of the time
/// between two frames for implicit ones.
const SHARES_OF_LIMIT: [f64; 4] = [0.8, 0.4, 0.2, 0.1];
const SHARES_OF_FRAME: [f64; 4] = [0.25, 0.125, 0.0625, 0.03125];
/// The most frames of a run that are compared.
const MOST_FRAMES: usize = 31;
/// An error is certain if it is this many times the distance between the two methods of the
/// reference.
const CERTAIN: f64 = 3.0;
/// Weights of the start, and of the rest shape for the stability limits, among the parts of a
/// study.
const START_WEIGHT: f64 = 1.0;
const REST_WEIGHT: f64 = 1.0;
/// Residual of that rest shape.
const REST_TOLERANCE: f64 = 1e-9;

/// All motions on one mesh.
pub(super) struct MotionRuns<'a, 'c, 'w> {
    scene: &'a StudyScene,
    plan: &'a StudyPlan,
    schedule: &'a mut StudySchedule<'c, 'w>,
}

/// A run with the frames of it that are compared.
struct MotionRun {
    run: StudyRun,
    /// The frames; none if it did not end.
    frames: Option<MotionFrames>,
    /// Length of its steps on average \[s\].
    step_s: f64,
}

impl<'a, 'c, 'w> MotionRuns<'a, 'c, 'w> {
    /// Returns the weight of all motions on a mesh.
    pub(super) fn weight(plan: &StudyPlan) -> f64 {
        let given = plan.steps_s.len() + plan.tolerances.len();
        let settings = if given == 0 {
            SHARES_OF_LIMIT.len()
        } else {
            given
        };
        let runs = (plan.methods.len() * settings) as f64;
        START_WEIGHT + REST_WEIGHT + runs + MotionReference::WEIGHT
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
        }
    }

    /// Makes all runs, and adds them and the orders of their methods to the study.
    pub(super) fn run(mut self, study: &mut Study) -> MeshResult {
        let start = self.start(study);
        let mut made = Vec::new();
        if let Some(start) = &start {
            for &method in &self.plan.methods {
                for setting in self.settings(method, start) {
                    made.extend(self.motion_run(method, setting, start));
                }
            }
        }
        let (reference, shapes) = match &start {
            Some(start) if made.iter().any(|m: &MotionRun| m.frames.is_some()) => {
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
        MeshResult {
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

    /// Finds the shape that motions begin with: what is sewn must be closed first, and what is at
    /// rest must have something to move it.
    fn start(&mut self, study: &mut Study) -> Option<Vec<Vector3<f64>>> {
        let scene = &self.scene.scene;
        if scene.mesh.stitches.is_empty() && scene.wind.is_none() {
            self.schedule.count_done(START_WEIGHT);
            return Some(scene.start.clone());
        }
        let mut still = scene.clone();
        let start = if still.wind.take().is_some() {
            StartShape::DrapedInStillAir
        } else {
            still.gravity = Vector3::zeros();
            StartShape::SewnWithoutWeight
        };
        wording::start(start).clone_into(&mut study.start);
        let options = self.drape_options(1e-3);
        let part = self.part(PartKind::Start);
        let drape = self.schedule.run(part, START_WEIGHT, |context, time| {
            solver::drape(&still, &within(options, time), context)
        })?;
        if drape.report.seam_gap_max_m >= self.plan.simulate.seam_eps_m {
            let reason = SkipReason::SeamsOpen(drape.report.why);
            self.schedule.skip(self.part(PartKind::Motions), reason);
            return None;
        }
        Some(drape.positions)
    }

    /// Returns the settings that a method is run with.
    fn settings(&mut self, method: Method, start: &[Vector3<f64>]) -> Vec<RunSetting> {
        let steps = self.plan.steps_s.iter().copied().map(RunSetting::Step);
        let tolerances = self.plan.tolerances.iter().copied();
        let settings: Vec<RunSetting> =
            steps.chain(tolerances.map(RunSetting::Tolerance)).collect();
        if !settings.is_empty() {
            return settings;
        }
        let longest = self.longest_step(method, start);
        let frame = self.plan.frame_s();
        let steps = match longest {
            Some(limit) => SHARES_OF_LIMIT.map(|share| share * limit.min(frame)),
            None => SHARES_OF_FRAME.map(|share| share * frame),
        };
        steps.map(RunSetting::Step).to_vec()
    }

    /// Returns the longest step that an explicit method is allowed \[s\]; none for implicit ones.
    fn longest_step(&mut self, method: Method, start: &[Vector3<f64>]) -> Option<f64> {
        let options = self.options(method, RunSetting::Tolerance(EXACT_TOLERANCE));
        let part = self.part(PartKind::LongestStep(method));
        let scene = &self.scene.scene;
        self.schedule.run(part, 0.0, |context, _| {
            solver::allowed_step(scene, &options, start, context)
        })?
    }

    /// Makes one run.
    fn motion_run(
        &mut self,
        method: Method,
        setting: RunSetting,
        start: &[Vector3<f64>],
    ) -> Option<MotionRun> {
        let part = self.part(PartKind::Run(method, setting));
        let options = self.options(method, setting);
        let motion = self.trajectory(part, 1.0, options, start)?;
        let report = &motion.report;
        let (tolerance, step_s) = match setting {
            RunSetting::Tolerance(tolerance) => (Some(tolerance), None),
            RunSetting::Step(step_s) => (None, Some(step_s)),
        };
        let energy_j = motion.frames.last().map_or(0.0, |f| f.energy.total());
        let has_unstable_steps = report.complete && !report.within_limits;
        let run = StudyRun {
            method,
            used: report.method.clone(),
            tolerance,
            step_s,
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
            why: if has_unstable_steps {
                wording::ended_with_unstable_steps(&report.why)
            } else {
                report.why.clone()
            },
        };
        Some(MotionRun {
            run,
            frames: report.complete.then(|| compared_frames(&motion)),
            step_s: report.simulated_s / report.steps.max(1) as f64,
        })
    }

    /// Makes a motion from the start.
    fn trajectory(
        &mut self,
        part: StudyPart,
        weight: f64,
        options: SolverOptions,
        start: &[Vector3<f64>],
    ) -> Option<Trajectory> {
        let scene = &self.scene.scene;
        self.schedule.run(part, weight, |context, time| {
            let from = Start {
                positions: Some(start.to_vec()),
                velocities: None,
            };
            solver::trajectory(scene, &within(options, time), from, context)
        })
    }

    /// Fills in the errors against a reference that is refined as far as they need. Returns also
    /// its frames.
    fn measure(
        &mut self,
        made: &mut [MotionRun],
        start: &[Vector3<f64>],
    ) -> (StudyReference, Vec<Vec<Vector3<f64>>>) {
        let began = self.schedule.cpu_s();
        let Some(reference) = self.reference(made, start) else {
            let part = self.part(PartKind::Errors);
            self.schedule.skip(part, SkipReason::NoReference);
            let none = StudyReference {
                because: wording::reference(&ReferenceFinding::NoMotion, CERTAIN),
                ..StudyReference::default()
            };
            return (none, Vec::new());
        };
        let uncertainty = reference.apart_m;
        for made in made.iter_mut() {
            let Some(frames) = &made.frames else { continue };
            let error = frames.distance(&reference.frames);
            if error.is_finite() {
                made.run.error_m = Some(error.max(uncertainty.unwrap_or(0.0)));
                made.run.error_certain = uncertainty.is_some_and(|u| error >= CERTAIN * u);
            }
        }
        let told = StudyReference {
            confirmed: made.iter().any(|m| m.run.error_certain),
            methods: reference.methods,
            apart_m: uncertainty,
            uncertainty_m: uncertainty,
            because: wording::reference(&reference.finding, CERTAIN),
            cpu_s: self.schedule.cpu_s() - began,
            ..StudyReference::default()
        };
        (told, reference.frames.0)
    }

    /// Makes the reference, beginning with half the shortest steps of the runs.
    fn reference(&mut self, made: &[MotionRun], start: &[Vector3<f64>]) -> Option<MotionReference> {
        let first = self.first_steps(made, start);
        let frames: Vec<MotionFrames> = made.iter().filter_map(|m| m.frames.clone()).collect();
        let smallest = |reference: &MotionFrames| {
            let errors = frames.iter().map(|frames| frames.distance(reference));
            errors.filter(|e| *e > 0.0).fold(f64::INFINITY, f64::min)
        };
        let mut left = MotionReference::WEIGHT;
        let mut motion = |method: Method, step_s: f64, weight: f64| {
            left -= weight;
            let part = self.part(PartKind::ReferenceMotion(method, step_s));
            let options = self.options(method, RunSetting::Step(step_s));
            let motion = self.trajectory(part, weight, options, start)?;
            motion.report.complete.then(|| compared_frames(&motion))
        };
        let reference = MotionReference::refined(first, &mut motion, smallest);
        self.schedule.count_done(left.max(0.0));
        reference
    }

    /// Returns the steps that Verlet and BDF2 begin the reference with \[s\].
    fn first_steps(&mut self, made: &[MotionRun], start: &[Vector3<f64>]) -> [f64; 2] {
        let frame = self.plan.frame_s();
        let mut explicit = shortest_step(made, ["verlet", "symplectic_euler"]);
        let implicit = shortest_step(made, ["bdf2", "implicit_euler"]);
        if !explicit.is_finite() {
            let limit = self.longest_step(Method::Verlet, start);
            explicit = 0.5 * limit.unwrap_or(f64::INFINITY).min(frame);
        }
        [0.5 * explicit, 0.5 * implicit.min(0.25 * frame)]
    }

    /// Finds a rest shape near where the motion begins, for the stability limits.
    fn rest(&mut self, start: &[Vector3<f64>]) -> Option<Drape> {
        let scene = &self.scene.scene;
        let options = self.drape_options(REST_TOLERANCE);
        let part = self.part(PartKind::RestShape);
        let drape = self.schedule.run(part, REST_WEIGHT, |context, time| {
            solver::drape_on(
                scene,
                &within(options, time),
                &Drape::of_shape(start),
                context,
            )
        })?;
        drape.report.converged.then_some(drape)
    }

    fn part(&self, kind: PartKind) -> StudyPart {
        StudyPart {
            kind,
            edge_length_m: self.scene.edge_length_m,
        }
    }

    fn drape_options(&self, tolerance: f64) -> SolverOptions {
        SolverOptions {
            analysis: Analysis::Static,
            method: Method::Newton,
            tolerance,
            tolerance_m: None,
            step_s: None,
            ..self.plan.simulate.clone()
        }
    }

    fn options(&self, method: Method, setting: RunSetting) -> SolverOptions {
        let (tolerance, step_s) = match setting {
            RunSetting::Step(step_s) => (EXACT_TOLERANCE, Some(step_s)),
            RunSetting::Tolerance(tolerance) => (tolerance, None),
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

fn within(options: SolverOptions, time_s: f64) -> SolverOptions {
    SolverOptions {
        time_limit_s: Some(time_s),
        ..options
    }
}

/// Returns the shortest step of the finished runs by one of two methods \[s\]; infinite if there is
/// none.
fn shortest_step(made: &[MotionRun], methods: [&str; 2]) -> f64 {
    let finished = made.iter().filter(|m| m.frames.is_some());
    let such = finished.filter(|m| methods.contains(&m.run.used.as_str()));
    such.map(|m| m.step_s).fold(f64::INFINITY, f64::min)
}

/// Takes frames of a motion evenly over its time, the last one among them; the same ones for all
/// meshes.
fn compared_frames(motion: &Trajectory) -> MotionFrames {
    let last = motion.frames.len().saturating_sub(1);
    let count = last.min(MOST_FRAMES);
    let numbers = (1..=count).map(|i| i * last / count.max(1));
    MotionFrames(
        numbers
            .map(|number| motion.frames[number].positions.clone())
            .collect(),
    )
}
