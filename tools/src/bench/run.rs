//! One run in this process, and how far from the rest shape it stopped.
//!
//! Rest shapes are not unique, so the reference is the one that the stopped shape leads to:
//! Newton's method goes on from there to the round-off floor. Where it is asked for, a second
//! method goes the same way on its own, and the two are compared.

use super::line::BenchLine;
use super::plan::BenchRun;
use rustix::time::{ClockId, clock_gettime};
use seamster::config::Limits;
use seamster::memory::peak_bytes;
use seamster::progress::CancelToken;
use seamster::scene::{Membrane, Scene};
use seamster::solver::{self, Context, Drape, Method, SolverOptions, rms_distance};
use seamster::study::RestShape;
use seamster_fixtures::scenes;
use serde_json::{Value, json};
use std::time::Instant;

/// Runs shorter than this are repeated \[CPU s\], so often at most.
const SHORT: f64 = 0.5;
const REPEATS: usize = 5;
/// CPU time allowed to a reference \[s\].
const REFERENCE_LIMIT: f64 = 20.0;

/// Methods of which the first that comes to rest confirms the reference.
const SECOND: [Method; 2] = [Method::ImplicitEuler, Method::SymplecticEuler];

/// One drape with what it took.
struct Timed {
    drape: Drape,
    cpu_s: f64,
    wall_s: f64,
}

/// Makes the run; nothing if the solver has no such method.
pub(crate) fn measured(run: &BenchRun) -> Option<BenchLine> {
    let scene = scenes::scene(&run.scene).expect("the plan names scenes that there are");
    let options = simulate(run);
    let mut timed = timed(&scene, &options);
    let report = timed.drape.report.clone();
    if run.setting["method"] != report.method {
        return None;
    }
    let memory_peak_bytes = peak_bytes().unwrap_or(0);
    let energy = report.energy_j;
    if run.setting.get("time_limit_s").is_none() {
        repeat(&scene, &options, &mut timed);
    }
    let mut line = BenchLine {
        scene: run.scene.clone(),
        method: report.method.clone(),
        membrane: if matches!(scene.membrane, Membrane::Springs(_)) {
            "springs".to_owned()
        } else {
            name(&options.membrane)
        },
        setting: run.setting.clone(),
        vertices: report.vertices,
        cpu_s: timed.cpu_s,
        wall_s: timed.wall_s,
        threads: 1,
        error_m: None,
        residual: report.residual,
        estimate_m: report.error_estimate_m,
        estimate_valid: report.error_estimate_valid,
        gap_m: report.seam_gap_max_m,
        penetration_m: report.penetration_max_m,
        strain_max: report.strain_max,
        energy_j: energy.stretch + energy.bend + energy.gravity + energy.seam + energy.contact,
        memory_peak_bytes,
        newton_iterations: report.newton_iterations,
        converged: report.converged,
        why: report.why.clone(),
        reference_moved_m: None,
        reference_floors: None,
        reference_apart_m: None,
    };
    // A shape whose seams are still open has no rest shape to go on to.
    let sewn = report.seam_gap_max_m < options.seam_eps_m;
    if (scene.friction == 0.0 || scene.body.is_none()) && sewn {
        refer(&scene, &options, &timed.drape, run.confirm, &mut line);
    }
    Some(line)
}

/// Fills in the distance from the reference.
fn refer(
    scene: &Scene,
    options: &SolverOptions,
    stopped: &Drape,
    confirm: bool,
    line: &mut BenchLine,
) {
    let on_by = |method: Method| {
        let options = SolverOptions {
            method,
            time_limit_s: Some(REFERENCE_LIMIT),
            ..options.clone()
        };
        with_context(|context| RestShape::of(scene, &options, stopped, context))
    };
    let Some(reference) = on_by(Method::Newton) else {
        return;
    };
    let report = &reference.drape.report;
    line.error_m = report.error_estimate_m.map(|_| reference.error_m());
    line.reference_moved_m = Some(reference.moved_m);
    line.reference_floors = Some(report.residual / report.residual_floor);
    // a reference that is the stopped shape itself would be confirmed by anything
    if confirm && reference.moved_m > 0.0 {
        let second = SECOND.into_iter().find_map(on_by);
        let apart = |s: RestShape| rms_distance(&s.drape.positions, &reference.drape.positions);
        line.reference_apart_m = second.map(apart);
    }
}

/// Options of the solver for a run.
fn simulate(run: &BenchRun) -> SolverOptions {
    let mut asked = json!({"time_limit_s": run.limit_s});
    let fields = run
        .setting
        .as_object()
        .expect("a setting is a list of fields");
    for (field, value) in fields {
        asked[field] = value.clone();
    }
    serde_json::from_value(asked).expect("the plan asks for what there is")
}

/// A short run once more and again: the median of its times.
fn repeat(scene: &Scene, options: &SolverOptions, first: &mut Timed) {
    let mut times = vec![(first.cpu_s, first.wall_s)];
    while times.len() < REPEATS && times.iter().map(|t| t.0).sum::<f64>() < SHORT {
        let again = timed(scene, options);
        times.push((again.cpu_s, again.wall_s));
    }
    times.sort_by(|s, t| s.0.total_cmp(&t.0));
    (first.cpu_s, first.wall_s) = times[times.len() / 2];
}

fn timed(scene: &Scene, options: &SolverOptions) -> Timed {
    let (began, cpu_began) = (Instant::now(), cpu_s());
    let drape = with_context(|context| solver::drape(scene, options, context));
    Timed {
        drape,
        cpu_s: cpu_s() - cpu_began,
        wall_s: began.elapsed().as_secs_f64(),
    }
}

fn with_context<T>(run: impl FnOnce(&mut Context<'_>) -> T) -> T {
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    run(&mut Context {
        cpu_s: &cpu_s,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    })
}

/// CPU time of this process, all threads \[s\].
fn cpu_s() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// The name that an enum has in JSON.
fn name(value: &impl serde::Serialize) -> String {
    match json!(value) {
        Value::String(name) => name,
        other => other.to_string(),
    }
}
