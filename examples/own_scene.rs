//! Finds the rest shape of particles on springs, without a pattern: a rope bridge under its own
//! weight, loaded in its middle: `cargo run --release --example own_scene`.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::progress::CancelToken;
use seamster::scene::{NetSpring, RawScene};
use seamster::solver::{Context, SolverOptions, drape};

/// Particles of the rope.
const PARTICLES: usize = 21;
/// Distance of the ends \[m\].
const SPAN: f64 = 2.0;

fn main() -> Result<(), Faults> {
    let limits = Limits::default();
    let cell = SPAN / (PARTICLES - 1) as f64;
    let mut mass_kg = vec![0.02; PARTICLES];
    mass_kg[PARTICLES / 2] = 0.5;
    let springs = (1..PARTICLES).map(|b| NetSpring {
        a: b - 1,
        b,
        // Longer than the cell: the rope sags.
        rest_length_m: 1.1 * cell,
        stiffness_n_m: 5_000.0,
    });
    let scene = RawScene {
        start_m: (0..PARTICLES)
            .map(|i| [i as f64 * cell, 0.0, 0.0])
            .collect(),
        mass_kg,
        springs: springs.collect(),
        pins: vec![0, PARTICLES - 1],
        gravity_m_s2: [0.0, -9.81, 0.0],
        ..RawScene::default()
    };
    let scene = scene.into_scene(&limits)?;

    let mut context = Context {
        cpu_s: &|| 0.0,
        cancel: &CancelToken::new(),
        progress: &mut |_| {},
        limits: &limits,
    };
    let options = SolverOptions {
        tolerance: 1e-9,
        ..SolverOptions::default()
    };
    let rest = drape(&scene, &options, &mut context);
    println!(
        "converged: {}, residual {:.1e}",
        rest.report.converged, rest.report.residual
    );
    for position in &rest.positions {
        println!("{:8.4} {:8.4} {:8.4}", position.x, position.y, position.z);
    }
    Ok(())
}
