//! Garments sewn and draped: they come to rest on the body, by either method, and say so when they
//! do not.

use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::fit;
use seamster::progress::{CancelToken, Progress};
use seamster::solver::{self, Drape, Energy, Method, SolverOptions};
use seamster_fixtures::samples::{sample, with_context};
use serde_json::json;

fn quiet(_: Progress) {}

fn rms(x: &[Vector3<f64>], y: &[Vector3<f64>]) -> f64 {
    (x.iter()
        .zip(y)
        .map(|(x, y)| (x - y).norm_squared())
        .sum::<f64>()
        / x.len() as f64)
        .sqrt()
}

fn total(energy: Energy) -> f64 {
    energy.stretch + energy.bend + energy.gravity + energy.seam + energy.contact
}

#[test]
fn both_samples_come_to_rest_on_the_body() {
    for name in ["skirt", "top"] {
        let prepared = sample(name, json!({"simulate": {"edge_length_m": 0.025}}));
        let outcome = with_context(&Limits::default(), &CancelToken::new(), quiet, |context| {
            fit::run(&prepared, context)
        })
        .unwrap();
        let report = &outcome.report;
        assert!(report.converged, "{name}: {}", report.why);
        assert_eq!(
            report.support.ok,
            Some(true),
            "{name}: {}",
            report.support.because
        );
        // The bounds that the issue sets for a garment that is sewn and worn.
        assert!(
            report.seam_gap_max_m < 1e-3 && report.penetration_max_m < 1e-3,
            "{name}: {report:?}"
        );
        assert!(
            report.residual <= 1e-5 && report.error_estimate_valid,
            "{name}: {report:?}"
        );
        let numbers = outcome
            .mesh
            .panels
            .iter()
            .flat_map(|panel| panel.positions.iter().flatten());
        assert!(numbers.clone().count() > 1000 && numbers.clone().all(|x| x.is_finite()));
    }
}

/// Cloth that is taut everywhere has one rest shape, and the two methods, which have only the
/// energy in common, must find it from flat panels. (Where cloth is slack it wrinkles, each way
/// down ends in wrinkles of its own, and only energies compare.)
#[test]
#[ignore = "minutes in a build that is hardly optimized: make soak"]
fn the_papers_method_finds_the_shape_that_newton_finds() {
    let simulate = json!({"edge_length_m": 0.04, "membrane": "springs", "seam_close": "spring"});
    let broad = json!({"form": {"height_m": 1.68, "bust_m": 1.1, "waist_m": 1.02, "hip_m": 1.12}});
    let changes = json!({"friction": 0, "default_fabric": "ponte-knit", "avatar": broad, "simulate": simulate});
    let prepared = sample("top", changes);
    let newton = SolverOptions {
        method: Method::Newton,
        ..prepared.garment().simulate.clone()
    };
    let paper = SolverOptions {
        method: Method::SymplecticEuler,
        ..newton.clone()
    };
    let [newton, paper] = with_context(&Limits::default(), &CancelToken::new(), quiet, |context| {
        let scene = fit::scene(&prepared, context).unwrap();
        [newton, paper].map(|options| solver::drape(&scene, &options, context))
    });
    for drape in [&newton, &paper] {
        assert!(
            drape.report.converged,
            "{}: {}",
            drape.report.method, drape.report.why
        );
        assert!(drape.report.seam_gap_max_m < 1e-3);
    }
    assert_eq!(paper.report.method, "symplectic_euler");
    let apart = rms(&newton.positions, &paper.positions);
    let energies = [&newton, &paper].map(|drape: &Drape| total(drape.report.energy_j));
    // The bound that the issue sets.
    assert!(
        apart < 1e-3,
        "{:.3} mm apart; energies {energies:?} J",
        apart * 1e3
    );
    let moved = paper.report.error_against_run_time[0].rms_error_m;
    assert!(moved > apart, "it was at rest from the start");
}

#[test]
fn the_same_garment_gives_the_same_bytes() {
    let prepared = sample("top", json!({"simulate": {"edge_length_m": 0.04}}));
    let run = || {
        with_context(&Limits::default(), &CancelToken::new(), quiet, |context| {
            fit::run(&prepared, context)
        })
        .unwrap()
    };
    assert_eq!(
        seamster::export::glb(&run().mesh),
        seamster::export::glb(&run().mesh)
    );
}

#[test]
fn a_raised_flag_stops_it_with_the_shape_so_far() {
    let prepared = sample("top", json!({"simulate": {"edge_length_m": 0.04}}));
    let cancel = CancelToken::new();
    let mut told = 0;
    let count = |_: Progress| {
        told += 1;
        if told == 5 {
            cancel.cancel();
        }
    };
    let outcome = with_context(&Limits::default(), &cancel, count, |context| {
        fit::run(&prepared, context)
    })
    .unwrap();
    assert!(outcome.canceled && !outcome.report.converged);
    // Where it was raised in the last iterate of a stage, the first of the next tells as well.
    assert!((5..=6).contains(&told), "{told}");
}

#[test]
fn what_is_not_at_rest_is_not_called_so() {
    let prepared = sample("top", json!({"simulate": {"edge_length_m": 0.04}}));
    let limits = Limits {
        iterations: 20,
        ..Limits::default()
    };
    let report = with_context(&limits, &CancelToken::new(), quiet, |context| {
        fit::run(&prepared, context)
    })
    .unwrap()
    .report;
    assert!(!report.converged && report.support.ok == Some(false));
    assert!(report.why.contains("limit of iterations"), "{}", report.why);
    assert!(report.residual > 1e-5);
}

#[test]
fn a_garment_that_nothing_holds_is_seen_to_fall() {
    let prepared = sample(
        "skirt",
        json!({"avatar": null, "simulate": {"edge_length_m": 0.04}}),
    );
    let report = with_context(&Limits::default(), &CancelToken::new(), quiet, |context| {
        fit::run(&prepared, context)
    })
    .unwrap()
    .report;
    assert!(!report.converged && report.support.ok.is_none());
    assert!(report.why.contains("fell off"), "{}", report.why);
}

#[test]
fn a_step_above_the_stability_limit_is_refused_with_the_limit() {
    let simulate = json!({"edge_length_m": 0.04, "method": "symplectic_euler", "membrane": "springs", "step_s": 0.01});
    let prepared = sample("top", json!({"simulate": simulate}));
    let report = with_context(&Limits::default(), &CancelToken::new(), quiet, |context| {
        fit::run(&prepared, context)
    })
    .unwrap()
    .report;
    assert!(!report.converged);
    assert!(report.why.contains("stability limit"), "{}", report.why);
}
