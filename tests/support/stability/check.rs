//! What must be true of every case, whatever it comes to.
//!
//! - It ends within the stated time, with finite numbers, and as its case says.
//! - Energy. A drape ends no higher than its finest level was after sewing, when it began to fall; friction and wind have no
//!   energy. A motion without drag, friction and wind gains none: backward Euler from frame to frame (its Φ never rises);
//!   for the others see [`largest_gain`].
//! - A shape that is not at rest is no worse than what it began with: that same energy bounds it.
//! - An error estimate that is called valid is within 0.3 to 3 times the true error.

use super::line::Line;
use super::run::{continued, draped};
use super::{Case, Expect, Made, Work};
use nalgebra::Vector3;
use seamster::scene::Scene;
use seamster::solver::{Drape, Energy, Method, MotionEnergy, Simulate, Trajectory};

/// Residual asked of the shape that a stopped one leads to: below any floor, which then is what stops it.
const TO_THE_FLOOR: f64 = 1e-300;
/// CPU time allowed to it \[s\].
const REFERENCE_LIMIT: f64 = 20.0;
/// What an estimate that is called valid may be over the error.
const ESTIMATE: [f64; 2] = [0.3, 3.0];
/// CPU time in which a refusal is given \[s\].
const AT_ONCE: f64 = 1.0;
/// Rounding of a sum of energies, over the sum of their sizes.
const ROUNDING: f64 = 1e-9;

/// Adds to the faults of `line` what is not as it must be of its time and end.
pub(super) fn judge(case: &Case, slower: f64, line: &mut Line) {
    let (expected, words) = match case.expect {
        Expect::Converged => ("converged", ""),
        Expect::NotConverged(words) => ("not converged", words),
        Expect::Refused(words) => ("refused", words),
    };
    if line.came_to != expected || !line.why.contains(words) {
        line.faults.push(format!("{}: {}", line.came_to, line.why));
    }
    let within = if expected == "refused" {
        AT_ONCE.min(case.within_s)
    } else {
        case.within_s
    };
    if line.cpu_s > within * slower {
        line.faults
            .push(format!("took {:.1} s of CPU, not {within} s", line.cpu_s));
    }
    if line.why.is_empty() {
        line.faults.push("no reason is given".to_owned());
    }
}

/// Notes numbers that are none.
pub(super) fn finite<'x>(mut vectors: impl Iterator<Item = &'x Vector3<f64>>, line: &mut Line) {
    if vectors.any(|p| p.iter().any(|c| !c.is_finite())) {
        line.faults.push("a position that is no number".to_owned());
    }
}

pub(super) fn total(energy: &Energy) -> f64 {
    energy.stretch + energy.bend + energy.gravity + energy.seam + energy.contact
}

fn size(energy: &Energy) -> f64 {
    let Energy {
        stretch,
        bend,
        gravity,
        seam,
        contact,
    } = energy;
    stretch.abs() + bend.abs() + gravity.abs() + seam.abs() + contact.abs()
}

/// What must be true of a drape that ended on level `finest`.
pub(super) fn drape(scene: &Scene, made: &Made, drape: &Drape, finest: f64, line: &mut Line) {
    let report = &drape.report;
    let numbers = [
        Some(report.residual),
        Some(report.residual_floor),
        report.error_estimate_m,
        report.mesh_error_m,
        Some(size(&report.energy_j)),
        Some(report.strain_max),
        Some(report.penetration_max_m),
    ];
    if numbers.into_iter().flatten().any(|n| !n.is_finite()) {
        line.faults
            .push(format!("the report has a number that is none: {numbers:?}"));
    }
    if line.came_to == "refused" {
        return;
    }
    energy_of_drape(scene, made, drape, finest, line);
    let sewn = report.seam_gap_max_m < made.ask.seam_eps_m;
    if report.converged && (scene.friction == 0.0 || scene.body.is_none()) && sewn {
        estimate(scene, &made.ask, drape, line);
    }
}

fn energy_of_drape(scene: &Scene, made: &Made, drape: &Drape, finest: f64, line: &mut Line) {
    let has_friction = scene.friction > 0.0 && scene.body.is_some();
    if has_friction || scene.wind.is_some() {
        let what = if has_friction { "friction" } else { "wind" };
        line.energy_unbounded = Some(what.to_owned());
        return;
    }
    let sewn = draped(scene, made, finest).0;
    if sewn.report.why.contains("apart") || drape.report.why.contains("apart") {
        line.energy_unbounded = Some("never sewn".to_owned());
        return;
    }
    let most = total(&sewn.report.energy_j);
    let rounding = ROUNDING * (size(&sewn.report.energy_j) + size(&drape.report.energy_j));
    line.energy_most_j = Some(most);
    if total(&drape.report.energy_j) > most + rounding {
        line.faults.push(format!(
            "ended at {:.9e} J, after sewing {most:.9e} J",
            total(&drape.report.energy_j)
        ));
    }
}

/// Compares the error estimate with how far the stopped shape still had to go.
fn estimate(scene: &Scene, ask: &Simulate, drape: &Drape, line: &mut Line) {
    let ask = Simulate {
        method: Method::Newton,
        tolerance: TO_THE_FLOOR,
        time_limit_s: Some(REFERENCE_LIMIT),
        ..ask.clone()
    };
    let reference = continued(scene, &ask, drape);
    if !reference.report.converged {
        return;
    }
    let pairs = drape.positions.iter().zip(&reference.positions);
    let square: f64 = pairs.map(|(a, b)| (a - b).norm_squared()).sum();
    let error = (square / drape.positions.len() as f64).sqrt();
    // The reference is off by its own estimate: a distance near that says nothing.
    let own = reference.report.error_estimate_m.unwrap_or(f64::INFINITY);
    if error < ESTIMATE[1] * own {
        return;
    }
    line.error_m = Some(error);
    let Some(estimate) = drape
        .report
        .error_estimate_m
        .filter(|_| drape.report.error_estimate_valid)
    else {
        return;
    };
    let ratio = estimate / error;
    if !(ESTIMATE[0]..=ESTIMATE[1]).contains(&ratio) {
        line.faults.push(format!(
            "the estimate of {estimate:.1e} m is called valid; the error is {error:.1e} m"
        ));
    }
}

/// How much the energy of an undamped linear oscillator, over that at rest, may become over what it was.
///
/// With steps up to 0.95 of the limit, a = h ω / 2 = 0.95: symplectic Euler keeps v² + ω² x² - h ω² x v, so (1 + a) / (1 - a);
/// Verlet keeps (1 - a²) ω² x² + v², so 1 / (1 - a²). BDF2 lowers the norm of G = ((5, -2), (-2, 1)) / 4 of two states (G. Dahlquist,
/// BIT 18, 1978), which is between 1/4 of the square of the last and 10/4 of the larger: 10.
fn largest_gain(method: &str) -> f64 {
    match method {
        "symplectic_euler" => 39.0,
        "verlet" => 1.0 / (1.0 - 0.95 * 0.95),
        _ => 10.0,
    }
}

/// What must be true of a motion.
pub(super) fn motion(scene: &Scene, made: &Made, trajectory: &Trajectory, line: &mut Line) {
    let energies: Vec<MotionEnergy> = trajectory.frames.iter().map(|f| f.energy).collect();
    if energies.iter().any(|e| !e.total().is_finite()) {
        line.faults.push("an energy that is no number".to_owned());
    }
    let has_friction = scene.friction > 0.0 && scene.body.is_some();
    let lossy = [
        (trajectory.report.drag_1_s > 0.0, "drag"),
        (has_friction, "friction"),
        (scene.wind.is_some(), "wind"),
    ];
    if let Some((_, what)) = lossy.into_iter().find(|(is, _)| *is) {
        line.energy_unbounded = Some(what.to_owned());
        return;
    }
    let Some(first) = energies.first() else {
        return;
    };
    let rounding = |e: &MotionEnergy| ROUNDING * (size(&e.potential) + e.kinetic);
    if line.method == "implicit_euler" {
        let gained = energies.windows(2).find(|pair| {
            pair[1].total() > pair[0].total() + rounding(&pair[0]) + rounding(&pair[1])
        });
        line.energy_most_j = Some(first.total());
        if let Some(pair) = gained {
            line.faults.push(format!(
                "gained energy: {:.9e} J, then {:.9e} J",
                pair[0].total(),
                pair[1].total()
            ));
        }
        return;
    }
    let rest = Made {
        work: Work::NoScene(seamster::fault::Faults(vec![])),
        ask: Simulate {
            method: Method::Newton,
            step_s: None,
            tolerance: 1e-3,
            time_limit_s: Some(5.0),
            ..made.ask.clone()
        },
        limits: made.limits.clone(),
    };
    let lowest = total(&draped(scene, &rest, f64::INFINITY).0.report.energy_j);
    let most = lowest + largest_gain(&line.method) * (first.total() - lowest);
    line.energy_most_j = Some(most);
    let highest = energies
        .iter()
        .map(MotionEnergy::total)
        .fold(f64::NEG_INFINITY, f64::max);
    if highest > most + rounding(first) {
        line.faults.push(format!(
            "gained energy: {highest:.9e} J from {:.9e} J",
            first.total()
        ));
    }
}
