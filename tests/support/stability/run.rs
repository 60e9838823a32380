//! Runs one case and writes down what it came to.

use super::check;
use super::line::Line;
use super::{Case, Expect, Made, Work};
use nalgebra::Vector3;
use rustix::time::{ClockId, clock_gettime};
use seamster::config::Limits;
use seamster::fit;
use seamster::progress::{CancelToken, Progress};
use seamster::scene::Scene;
use seamster::solver::{self, Context, Drape, Report, Simulate, Trajectory};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Words of a reason that mean that nothing was begun.
const REFUSALS: [&str; 3] = ["needs ", "stability limit", "never come to rest"];

/// Runs `case` and judges it. Times are held against what it states times `slower`, for builds that are not optimised.
pub(crate) fn line(case: &Case, slower: f64) -> Line {
    let mut line = Line {
        case: case.name.clone(),
        expected: match case.expect {
            Expect::Converged => "converged".to_owned(),
            Expect::NotConverged(why) => format!("not converged: {why}"),
            Expect::Refused(why) => format!("refused: {why}"),
        },
        within_s: case.within_s,
        ..Line::default()
    };
    let run = AssertUnwindSafe(|| {
        let mut line = line.clone();
        let made = (case.make)();
        simulate(&made, &mut line);
        line
    });
    match catch_unwind(run) {
        Ok(done) => line = done,
        Err(panic) => {
            let text = panic.downcast_ref::<String>().map(String::as_str);
            let text = text.or(panic.downcast_ref::<&str>().copied());
            line.came_to = "panicked".to_owned();
            line.why = text.unwrap_or("without words").to_owned();
        }
    }
    check::judge(case, slower, &mut line);
    line
}

fn simulate(made: &Made, line: &mut Line) {
    let began = cpu_s();
    line.method = made.ask.method.name().to_owned();
    match &made.work {
        Work::NoScene(faults) => {
            line.came_to = "refused".to_owned();
            line.why = faults.to_string();
        }
        Work::Drape(scene) => {
            let (drape, finest) = draped(scene, made, f64::INFINITY);
            line.cpu_s = cpu_s() - began;
            line.memory_peak_bytes = memory_peak_bytes();
            of_report(&drape.report, line);
            check::finite(drape.positions.iter(), line);
            check::drape(scene, made, &drape, finest, line);
        }
        Work::Fit(prepared) => {
            let outcome = with_context(
                &made.limits,
                &CancelToken::new(),
                |_| {},
                |context| fit::run(prepared, context),
            );
            line.cpu_s = cpu_s() - began;
            line.memory_peak_bytes = memory_peak_bytes();
            match outcome {
                Ok(outcome) => {
                    of_report(&outcome.report, line);
                    let panels = outcome.mesh.panels.iter();
                    let positions: Vec<Vector3<f64>> = panels
                        .flat_map(|p| p.positions.iter().map(|x| (*x).into()))
                        .collect();
                    check::finite(positions.iter(), line);
                    line.energy_unbounded = Some("friction".to_owned());
                }
                Err(faults) => {
                    line.came_to = "refused".to_owned();
                    line.why = faults.to_string();
                }
            }
        }
        Work::Motion(scene, start) => {
            let cancel = CancelToken::new();
            let trajectory = with_context(
                &made.limits,
                &cancel,
                |_| {},
                |context| solver::trajectory(scene, &made.ask, start.clone(), context),
            );
            line.cpu_s = cpu_s() - began;
            line.memory_peak_bytes = memory_peak_bytes();
            of_trajectory(&trajectory, scene, line);
            for frame in &trajectory.frames {
                check::finite(frame.positions.iter().chain(&frame.velocities), line);
            }
            check::motion(scene, made, &trajectory, line);
        }
    }
}

/// The drape of `scene`, ended as the finest level begins to fall if `until` is that level, with the level that it ended on.
pub(super) fn draped(scene: &Scene, made: &Made, until: f64) -> (Drape, f64) {
    let cancel = CancelToken::new();
    let mut finest = 0.0_f64;
    let told = |progress: Progress| {
        let level = f64::from(progress.level);
        finest = finest.max(level);
        if progress.stage == "drape" && level >= until {
            cancel.cancel();
        }
    };
    let drape = with_context(&made.limits, &cancel, told, |context| {
        solver::drape(scene, &made.ask, context)
    });
    (drape, finest)
}

/// The shape that `drape` leads to, to the round-off floor.
pub(super) fn continued(scene: &Scene, ask: &Simulate, drape: &Drape) -> Drape {
    let limits = Limits::default();
    with_context(
        &limits,
        &CancelToken::new(),
        |_| {},
        |context| solver::drape_on(scene, ask, drape, context),
    )
}

fn of_report(report: &Report, line: &mut Line) {
    line.came_to = if report.converged {
        "converged"
    } else if REFUSALS.iter().any(|words| report.why.contains(words)) {
        "refused"
    } else {
        "not converged"
    }
    .to_owned();
    line.method.clone_from(&report.method);
    line.vertices = report.vertices;
    line.why.clone_from(&report.why);
    line.residual = Some(report.residual);
    line.newton_iterations = report.newton_iterations as u64;
    line.ladder.clone_from(&report.ladder);
    line.estimate_m = report.error_estimate_m;
    line.estimate_valid = report.error_estimate_valid;
    line.energy_j = check::total(&report.energy_j);
    line.strain_max = report.strain_max;
    line.gap_m = report.seam_gap_max_m;
    line.penetration_m = report.penetration_max_m;
}

fn of_trajectory(trajectory: &Trajectory, scene: &Scene, line: &mut Line) {
    let report = &trajectory.report;
    line.came_to = if report.complete {
        "converged"
    } else if report.steps == 0 && REFUSALS.iter().any(|words| report.why.contains(words)) {
        "refused"
    } else {
        "not converged"
    }
    .to_owned();
    if !report.method.is_empty() {
        line.method.clone_from(&report.method);
    }
    line.vertices = scene.start.len();
    line.why.clone_from(&report.why);
    line.newton_iterations = report.newton_iterations;
    line.steps = report.steps;
    line.energy_j = trajectory.frames.last().map_or(0.0, |f| f.energy.total());
}

pub(super) fn with_context<T>(
    limits: &Limits,
    cancel: &CancelToken,
    mut told: impl FnMut(Progress),
    run: impl FnOnce(&mut Context<'_>) -> T,
) -> T {
    run(&mut Context {
        cpu_s: &cpu_s,
        cancel,
        progress: &mut told,
        limits,
    })
}

/// CPU time of this thread \[s\].
fn cpu_s() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// Largest resident memory of this process so far \[bytes\]; 0 where the system does not tell.
fn memory_peak_bytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = peak.and_then(|peak| peak.split_whitespace().next()?.parse::<u64>().ok());
    1024 * kilobytes.unwrap_or(0)
}
