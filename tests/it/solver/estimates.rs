//! Error estimates of reports: true within what they promise, also where the time was up.

use seamster::config::Limits;
use seamster::fit::{self, ResolvedGarment};
use seamster::job::thread_cpu_s;
use seamster::progress::CancelToken;
use seamster::solver::{self, Context, Drape, DrapeReport, SolverOptions, rms_distance};
use seamster_fixtures::samples::sample;
use serde_json::{Value, json};

/// Largest ratio of a stated error to the true one: the promise of the reports.
const PROMISE: std::ops::RangeInclusive<f64> = 0.3..=3.0;
/// Residual below any floor: rounding stops it.
const TO_THE_FLOOR: f64 = 1e-300;

fn prepared(name: &str, simulate: Value) -> ResolvedGarment {
    sample(name, json!({ "simulate": simulate }))
}

fn with_clock<T>(run: impl FnOnce(&mut Context<'_>) -> T) -> T {
    let began = thread_cpu_s();
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    run(&mut Context {
        cpu_s: &|| thread_cpu_s() - began,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    })
}

/// The drape of a sample, and the one that goes on from it to the floor.
fn draped_on(name: &str, simulate: Value) -> [Drape; 2] {
    let prepared = prepared(name, simulate);
    with_clock(|context| {
        let scene = fit::scene(&prepared, context).expect("samples are sound");
        let options = prepared.garment().simulate.clone();
        let drape = solver::drape(&scene, &options, context);
        let on = SolverOptions {
            tolerance: TO_THE_FLOOR,
            tolerance_m: None,
            ..options
        };
        let on = solver::drape_on(&scene, &on, &drape, context);
        [drape, on]
    })
}

#[test]
fn estimates_at_rest_are_true_within_three_times_or_held_invalid() {
    let mut valid = 0;
    for (name, tolerance) in [("skirt", 1e-3), ("top", 1e-3), ("top", 1e-4)] {
        let simulate = json!({"edge_length_m": 0.03, "tolerance": tolerance});
        let [drape, on] = draped_on(name, simulate);
        assert!(
            drape.report.converged && on.report.converged,
            "{}",
            on.report.why
        );
        let error = rms_distance(&drape.positions, &on.positions);
        let estimate = drape
            .report
            .error_estimate_m
            .expect("a shape at rest has one");
        let because = &drape.report.error_estimate_because;
        if drape.report.error_estimate_valid {
            valid += 1;
            assert!(
                PROMISE.contains(&(estimate / error)),
                "{name}: {estimate} {error}"
            );
            assert!(because.starts_with("valid"), "{because}");
        } else {
            assert!(because.starts_with("not valid"), "{because}");
        }
    }
    assert!(valid > 0, "one of three is in contact that does not change");
}

/// Friction holds on where it held: going on from a shape at rest moves it by its error, not by
/// what friction keeps it from.
#[test]
fn a_drape_that_goes_on_keeps_what_friction_holds() {
    let [drape, on] = draped_on("top", json!({"edge_length_m": 0.03}));
    assert!(on.report.converged, "{}", on.report.why);
    let error = drape
        .report
        .error_estimate_m
        .expect("a shape at rest has one");
    let moved = rms_distance(&drape.positions, &on.positions);
    assert!(moved <= PROMISE.end() * error, "{moved} {error}");
}

#[test]
fn a_distance_asked_for_is_reached_and_not_gone_far_beyond() {
    let iterations = |simulate: Value| {
        let [drape, on] = draped_on("top", simulate);
        assert!(drape.report.converged, "{}", drape.report.why);
        (drape.report.newton_iterations, drape, on)
    };
    let asked = 1e-4;
    let (few, drape, on) = iterations(json!({"edge_length_m": 0.03, "tolerance_m": asked}));
    let error = rms_distance(&drape.positions, &on.positions);
    assert!(error <= PROMISE.end() * asked, "{error}");
    let estimate = drape.report.error_estimate_m;
    assert!(estimate.is_some_and(|e| e <= asked), "{estimate:?}");
    let why = &drape.report.why;
    assert!(why.starts_with("at rest: within the distance"), "{why}");
    let (more, ..) = iterations(json!({"edge_length_m": 0.03, "tolerance_m": 1e-9}));
    // The last iterations come nearer by orders of magnitude each, so that both may end at one.
    assert!(few <= more, "{few} against {more} iterations");
}

fn fitted(name: &str, simulate: Value) -> DrapeReport {
    let prepared = prepared(name, simulate);
    with_clock(|context| fit::run(&prepared, context).expect("samples are sound")).report
}

#[test]
fn a_time_limit_is_kept_and_the_error_said_all_the_same() {
    // Enough for the coarse levels in a build that is hardly optimized.
    let limit = 8.0;
    let report = fitted(
        "skirt",
        json!({"edge_length_m": 0.009, "time_limit_s": limit}),
    );
    assert!(!report.converged);
    assert!(
        report.why.contains("the time allowed was up"),
        "{}",
        report.why
    );
    assert!(report.cpu_s.total < 1.1 * limit, "{:?}", report.cpu_s);
    let plan = &report.plan;
    assert_eq!(plan.time_limit_s, Some(limit));
    assert!(
        plan.expected_cpu_s.is_some_and(|s| s > limit),
        "{}",
        plan.outcome
    );
    assert!(report.levels.len() <= plan.levels.len());
    let estimate = report
        .error_estimate_m
        .expect("two levels and more tell how it moves");
    assert!(estimate > 0.0 && !report.error_estimate_valid);
    assert!(
        report.error_estimate_because.starts_with("not valid"),
        "{report:?}"
    );
}

#[test]
fn a_report_says_what_would_halve_its_error_and_what_that_costs() {
    let report = fitted("skirt", json!({"edge_length_m": 0.025}));
    assert!(report.converged, "{}", report.why);
    let mesh = report
        .mesh_error_m
        .expect("a mesh of a thousand vertices has a coarser one");
    let solver = report.error_estimate_m.expect("a shape at rest has one");
    let advice = report.to_halve_the_error.expect("it is at rest");
    let field = if mesh > solver {
        "edge_length_m"
    } else {
        "tolerance"
    };
    assert_eq!(advice.field, field);
    assert!(advice.factor < 1.0 && advice.cpu_s > report.cpu_s.total);
}

#[test]
fn the_curve_leads_from_the_start_to_the_shape_and_knows_its_errors_near_it() {
    let report = fitted("skirt", json!({"edge_length_m": 0.025, "tolerance": 1e-7}));
    let curve = &report.error_against_run_time;
    assert!(curve.windows(2).all(|w| w[0].cpu_s <= w[1].cpu_s));
    let (first, last) = (&curve[0], &curve[curve.len() - 1]);
    assert!(last.rms_error_m < first.rms_error_m);
    // Sewing and the coarser level are on it, from the shape as it was placed, far from the body's
    // back.
    assert!(first.cpu_s < report.levels[0].cpu_s && first.rms_error_m > 0.01);
    // Errors within a few times the last one are not those to the exact solution; of coarser meshes
    // none is known.
    let exact = 100.0 * report.error_estimate_m.expect("a shape at rest has one");
    let (_, coarser) = report.levels.split_last().expect("it ran");
    let on_finest = coarser.iter().map(|level| level.cpu_s).sum::<f64>();
    let near = curve
        .iter()
        .filter(|p| p.cpu_s > on_finest && p.residual <= 1e-2 && p.rms_error_m > exact);
    assert!(curve.iter().any(|point| point.error_estimate_m.is_some()));
    let known = near.filter_map(|point| Some((point, point.error_estimate_m?)));
    for (point, estimate) in known {
        assert!(
            PROMISE.contains(&(estimate / point.rms_error_m)),
            "{point:?}"
        );
    }
}
