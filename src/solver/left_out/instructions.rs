//! Terms that a scene lacks are never entered: its drape takes the instructions of a program that
//! has only its terms.
//!
//! Each program is a test of its own that is run alone, in a process under callgrind. What the
//! report takes is left out of the comparison (see [`REPORT`]); `make instructions` tells what that
//! is of a whole fit.

use crate::config::Limits;
use crate::progress::CancelToken;
use crate::scene::Scene;
use crate::solver::drape;
use crate::solver::drape::drag::{RELAXATION_DRAG, RELAXATION_SPEED_LIMIT};
use crate::solver::drape::relax::SADDLE;
use crate::solver::integrate::dynamic_relaxation::{self, DynamicRelaxation};
use crate::solver::left_out::by_hand::{self, no_clock};
use crate::solver::left_out::scenes::{Has, scene};
use crate::solver::optimize::iterate::{Iterate, Termination};
use crate::solver::optimize::newton::Newton;
use crate::solver::optimize::pseudo_transient::FIRST_GAMMA;
use crate::solver::{Context, Drape, Method, SolverOptions};
use nalgebra::Vector3;
use seamster_fixtures::callgrind::{self, Profile, REPORT};
use std::ops::ControlFlow;

/// Cells along a sheet; both sheets together are too small for a coarser mesh.
const CELLS: usize = 13;
/// The same of the scene that has everything.
const CELLS_OF_ALL: usize = 4;
/// Residual to reach, far above the round-off floor.
const TOLERANCE: f64 = 1e-3;
/// Steps of motion: enough to see what they take, not to come to rest.
const STEPS: u64 = 400;
/// Largest share of instructions that a drape by motion may take beyond those by hand.
const MORE: f64 = 0.01;

/// Source files of what the plain scene lacks.
const LACKS: [&str; 6] = [
    "src/solver/forces/wind.rs",
    "src/solver/forces/contact",
    "src/solver/forces/bending.rs",
    "src/solver/model/bending.rs",
    "src/solver/forces/sewing.rs",
    "src/export",
];

fn options_of(method: Method) -> SolverOptions {
    SolverOptions {
        method,
        // By motion it may not come to rest; a lower one would be refused.
        tolerance: if method == Method::Newton {
            TOLERANCE
        } else {
            0.9
        },
        ..SolverOptions::default()
    }
}

#[inline(never)]
fn as_a_scene(scene: &Scene, options: &SolverOptions) -> Drape {
    let limits = Limits {
        steps: STEPS,
        ..Limits::default()
    };
    let cancel = CancelToken::new();
    let mut context = Context {
        cpu_s: &no_clock,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    };
    drape(scene, options, &mut context)
}

#[inline(never)]
fn bare(scene: &Scene, options: &SolverOptions) -> Vec<Vector3<f64>> {
    let mut system = by_hand::system(scene, true);
    let mut x = scene.start.clone();
    let mut callback = |i: Iterate<'_>| {
        let share = if i.convex { 1.0 } else { SADDLE };
        if i.residual <= share * options.tolerance {
            ControlFlow::Break(Termination::Reached)
        } else {
            ControlFlow::Continue(())
        }
    };
    if options.method == Method::Newton {
        let mut newton = Newton::new(&mut system, FIRST_GAMMA).expect("memory for a small matrix");
        let limit = Limits::default().iterations;
        let stop = newton.run(&mut system, &mut x, limit, &mut callback);
        assert_eq!(stop, Termination::Reached);
    } else {
        let motion = DynamicRelaxation {
            method: options.method,
            drag: RELAXATION_DRAG,
            speed_limit: RELAXATION_SPEED_LIMIT,
            step: None,
            tolerance: options.tolerance,
        };
        let moved = dynamic_relaxation::run(&mut system, &mut x, motion, STEPS, &mut callback);
        assert!(moved.is_ok(), "{moved:?}");
    }
    x
}

#[test]
#[ignore = "run under callgrind by the tests below"]
fn drape_by_newton() {
    as_a_scene(&scene(Has::WEIGHT, CELLS), &options_of(Method::Newton));
}

#[test]
#[ignore = "run under callgrind by the tests below"]
fn bare_newton() {
    bare(&scene(Has::WEIGHT, CELLS), &options_of(Method::Newton));
}

#[test]
#[ignore = "run under callgrind by the tests below"]
fn drape_by_explicit_steps() {
    as_a_scene(
        &scene(Has::WEIGHT, CELLS),
        &options_of(Method::SymplecticEuler),
    );
}

#[test]
#[ignore = "run under callgrind by the tests below"]
fn bare_explicit_steps() {
    bare(
        &scene(Has::WEIGHT, CELLS),
        &options_of(Method::SymplecticEuler),
    );
}

#[test]
#[ignore = "run under callgrind by the tests below"]
fn drape_of_everything() {
    as_a_scene(&scene(Has::ALL, CELLS_OF_ALL), &options_of(Method::Newton));
}

/// The profile of the test `name` of this module.
fn profile(name: &str) -> Profile {
    let module = module_path!().split_once("::");
    let test = format!("{}::{name}", module.expect("within the crate").1);
    let arguments = ["--exact", &test, "--ignored", "--test-threads=1"];
    callgrind::run(&arguments).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// Instructions of the drape `name` without its report, of the program `by_hand`, and of the
/// report.
fn compare(name: &str, by_hand: &str) -> (Profile, [u64; 3]) {
    let (profile_of_drape, by_hand) = (profile(name), profile(by_hand));
    let report: u64 = REPORT.iter().filter_map(|f| profile_of_drape.of(f)).sum();
    let whole = profile_of_drape
        .of("instructions::as_a_scene")
        .expect("it ran");
    let bare = by_hand.of("instructions::bare").expect("it ran");
    let more = (whole - report) as f64 / bare as f64 - 1.0;
    println!(
        "| {} | {bare} | {} | {:+.2} % | {report} |",
        name.replace('_', " "),
        whole - report,
        100.0 * more
    );
    (profile_of_drape, [whole - report, bare, report])
}

#[test]
fn a_plain_drape_takes_the_instructions_of_its_terms() {
    let (plain, options) = (scene(Has::WEIGHT, CELLS), options_of(Method::Newton));
    let drape = as_a_scene(&plain, &options);
    assert!(drape.report.converged, "{}", drape.report.why);
    assert_eq!(drape.positions, bare(&plain, &options));
    let iterations = drape.report.newton_iterations as f64;
    let (profile, [drape, bare, _]) = compare("drape_by_newton", "bare_newton");
    for function in REPORT.iter().filter(|f| !f.ends_with("find_infeasibility")) {
        assert!(profile.of(function).is_some(), "{function} did not run");
    }
    // Beside its iterations it measures the start and the end once, which is less than one.
    let most = (1.0 + 1.0 / iterations) * bare as f64;
    assert!(drape as f64 <= most, "{drape} {bare} {iterations}");
    enters_nothing_that_it_lacks(&profile);
}

#[test]
fn plain_explicit_steps_take_the_instructions_of_their_terms() {
    let (plain, options) = (
        scene(Has::WEIGHT, CELLS),
        options_of(Method::SymplecticEuler),
    );
    assert_eq!(
        as_a_scene(&plain, &options).positions,
        bare(&plain, &options)
    );
    let (profile, [drape, bare, _]) = compare("drape_by_explicit_steps", "bare_explicit_steps");
    assert!(profile.of(REPORT[0]).is_some(), "{} did not run", REPORT[0]);
    assert!(drape as f64 <= (1.0 + MORE) * bare as f64, "{drape} {bare}");
    enters_nothing_that_it_lacks(&profile);
}

/// Returns true if code of a file was run for a cloth of so many cells a side: an instruction for
/// each cell at least. Functions of equal code are merged into one, whose few instructions count
/// for either file.
fn is_entered(profile: &Profile, file: &str, cells: usize) -> bool {
    profile.in_file(file) >= (cells * cells) as u64
}

fn enters_nothing_that_it_lacks(profile: &Profile) {
    assert!(is_entered(profile, "src/solver/forces/membrane.rs", CELLS));
    for file in LACKS {
        let count = profile.in_file(file);
        assert!(!is_entered(profile, file, CELLS), "{file}: {count}");
    }
}

/// So that the tests above can fail.
#[test]
fn what_a_scene_has_is_entered() {
    let profile = profile("drape_of_everything");
    for file in LACKS.iter().filter(|file| **file != "src/export") {
        assert!(is_entered(&profile, file, CELLS_OF_ALL), "{file}");
    }
}
