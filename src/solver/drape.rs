//! A fit from start to end: the coarsest level is sewn and draped, and each finer one begins with the shape of the last.

use super::ask::{Method, Simulate};
use super::cascade::Cascade;
use super::level::Level;
use super::measure::{self, rms_distance};
use super::report::Report;
use super::stage::{Bounds, push_once};
use super::summary::{left_out, worn};
use super::trace::Trace;
use super::{Context, Drape, collapsed, motion, unfinished};
use crate::scene::Scene;
use nalgebra::Vector3;

/// Residual to which the coarser levels are solved: their shapes are off by their mesh error anyway.
const COARSE_TOLERANCE: f64 = 1e-3;

/// Residual at which a drape stops at the latest, in round-off floors; a continued one goes on to the lower of the two, below
/// which rounding decides.
const FLOORS: f64 = 10.0;
const LEAST_FLOORS: f64 = 3.0;

/// Sews and drapes.
///
/// # Guarantees
/// Ends within the limits of the context and never with a shape that is not finite; the report says whether the shape is at
/// rest, and why not where it is not.
///
/// # Limitations
/// Rest shapes are not unique: cloth folds one way or another. Cloth passes through cloth.
pub fn drape(scene: &Scene, ask: &Simulate, context: &mut Context<'_>) -> Drape {
    let cascade = match ask.method {
        Method::Auto | Method::Newton => Cascade::new(scene),
        // Motion is that of the mesh asked for.
        _ => Cascade::single(scene),
    };
    run(&cascade, ask, None, context)
}

/// Drapes on from a shape \[m; `#V`\] whose seams are closed, without sewing.
pub fn drape_on(
    scene: &Scene,
    ask: &Simulate,
    shape: &[Vector3<f64>],
    context: &mut Context<'_>,
) -> Drape {
    run(&Cascade::single(scene), ask, Some(shape), context)
}

fn run(
    cascade: &Cascade<'_>,
    ask: &Simulate,
    closed: Option<&[Vector3<f64>]>,
    context: &mut Context<'_>,
) -> Drape {
    let scene = cascade.scene(0);
    let bounds = Bounds {
        iterations: context.limits.iterations,
        steps: context.limits.steps,
    };
    let clock = context.cpu_s;
    let mut trace = Trace::new(context, ask.time_limit_s);
    let mut report = Report {
        method: name(ask).to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        ..Report::default()
    };
    let refused = motion::refuse(scene, ask, bounds.steps, clock);
    let coarsest = cascade.coarsest();
    let mut x = closed.unwrap_or(&cascade.scene(coarsest).start).to_vec();
    if closed.is_none() && refused.is_none() {
        collapsed::scatter(cascade.scene(coarsest), &mut x);
    }
    let mut sewn = closed.is_some();
    let mut sunk = 0.0;
    let mut handed_on: Option<Vec<Vector3<f64>>> = None;
    for number in (0..=coarsest).rev().filter(|_| refused.is_none()) {
        trace.level = coarsest - number;
        let mut level = Level {
            scene: cascade.scene(number),
            ask,
            clock,
            bounds,
            trace: &mut trace,
            tolerance: if number == 0 {
                ask.tolerance
            } else {
                ask.tolerance.max(COARSE_TOLERANCE)
            },
            floors: if closed.is_some() {
                LEAST_FLOORS
            } else {
                FLOORS
            },
            finest: number == 0,
            near: number < coarsest || closed.is_some(),
        };
        let rest = level.run(&mut x, sewn, &mut report);
        sewn |= rest.sewn;
        sunk += rest.sunk;
        if number == 0 {
            break;
        }
        if trace.is_over() || rest.fell {
            x = cascade.to_finest(number, x);
            break;
        }
        x = cascade.refine(number, &x);
        if cascade.is_softer(number) {
            push_once(&mut report.ladder, "softer_cloth");
        } else {
            handed_on = report.converged.then(|| x.clone());
        }
    }
    if !x.iter().all(|p| p.iter().all(|c| c.is_finite())) {
        x.clone_from(&scene.start);
    }
    if let Some(why) = refused {
        report.why = why;
        report.residual = f64::NAN;
    }
    if !report.residual.is_finite() {
        unfinished::describe(scene, ask, &x, clock, &mut report);
    }
    measure_all(scene, &x, &mut report);
    report.worn = worn(scene, &report, sunk);
    report.cpu_s.total = trace.cpu_s();
    report.mesh_error_m = handed_on.map(|coarse| rms_distance(&coarse, &x));
    report.error_against_run_time = trace.error_against_run_time(&x);
    Drape {
        positions: x,
        canceled: trace.canceled,
        report,
    }
}

fn name(ask: &Simulate) -> &'static str {
    match ask.method {
        Method::SymplecticEuler => "symplectic_euler",
        Method::Verlet => "verlet",
        Method::ImplicitEuler => "implicit_euler",
        Method::Bdf2 => "bdf2",
        Method::Auto | Method::Newton => "newton",
    }
}

/// Fills in what can be measured on the shape alone.
fn measure_all(scene: &Scene, x: &[Vector3<f64>], report: &mut Report) {
    let mesh = &scene.mesh;
    let stitches: Vec<_> = mesh.stitches.iter().map(|s| (s.a, s.b)).collect();
    report.seam_gap_max_m = measure::seam_gap(&stitches, x);
    report.strain_max = measure::strain(scene, x);
    report.penetration_max_m = measure::penetration(scene, x);
    report.vertices = mesh.uv.len();
    report.triangles = mesh.triangles.len();
    report.stitches = mesh.stitches.len();
    report.left_out = left_out(scene);
}
