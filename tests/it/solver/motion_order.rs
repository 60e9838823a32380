//! Each trajectory method converges as theory says, keeps what theory says it keeps, and refuses
//! what would not be stable.

use nalgebra::Vector3;
use seamster::scene::Scene;
use seamster::solver::{Method, SolverOptions};
use seamster_fixtures::motions::{
    METHODS, apart, attempt, grid, motion_options, net, run, slope, stirred,
};

fn order(method: Method) -> f64 {
    match method {
        Method::SymplecticEuler | Method::ImplicitEuler => 1.0,
        _ => 2.0,
    }
}

/// Three particles on soft springs, which swing and stretch slowly, with weight and drag.
fn smooth() -> Scene {
    let points = [[0.0, 0.0, 0.0], [0.5, 0.1, 0.0], [1.0, 0.0, 0.3]];
    let springs = [(0, 1, 0.4, 3.0), (1, 2, 0.45, 2.0), (0, 2, 1.0, 1.0)];
    Scene {
        gravity: Vector3::new(0.0, -9.8, 0.0),
        drag: Some(0.6),
        pins: vec![0],
        ..net(
            points.map(Vector3::from).to_vec(),
            vec![0.1, 0.1, 0.15],
            &springs,
        )
    }
}

/// Acceleration of the particles of `scene`, written out from P8.
fn acceleration(scene: &Scene, x: &[Vector3<f64>], v: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let mut force: Vec<_> = scene.mass.iter().map(|m| scene.gravity * *m).collect();
    for s in scene.membrane.springs() {
        let d = x[s.b] - x[s.a];
        let f = d.normalize() * (s.stiffness_n_m * (d.norm() - s.rest_length_m));
        force[s.a] += f;
        force[s.b] -= f;
    }
    (0..x.len())
        .map(|i| {
            if scene.pins.contains(&i) {
                Vector3::zeros()
            } else {
                force[i] / scene.mass[i] - v[i] * scene.drag.unwrap_or(0.0)
            }
        })
        .collect()
}

/// The motion by the classical Runge-Kutta method, whose error at these steps is below 1e-10 m.
fn exact(scene: &Scene, duration: f64) -> Vec<Vector3<f64>> {
    let steps = 4000;
    let h = duration / f64::from(steps);
    let mut x = scene.start.clone();
    let mut v = vec![Vector3::zeros(); x.len()];
    let moved = |x: &[Vector3<f64>], d: &[Vector3<f64>], by: f64| -> Vec<Vector3<f64>> {
        x.iter().zip(d).map(|(x, d)| x + d * by).collect()
    };
    for _ in 0..steps {
        let (v1, a1) = (v.clone(), acceleration(scene, &x, &v));
        let v2 = moved(&v, &a1, 0.5 * h);
        let a2 = acceleration(scene, &moved(&x, &v1, 0.5 * h), &v2);
        let v3 = moved(&v, &a2, 0.5 * h);
        let a3 = acceleration(scene, &moved(&x, &v2, 0.5 * h), &v3);
        let v4 = moved(&v, &a3, h);
        let a4 = acceleration(scene, &moved(&x, &v3, h), &v4);
        for i in 0..x.len() {
            x[i] += (v1[i] + (v2[i] + v3[i]) * 2.0 + v4[i]) * (h / 6.0);
            v[i] += (a1[i] + (a2[i] + a3[i]) * 2.0 + a4[i]) * (h / 6.0);
        }
    }
    x
}

/// The slope tends to the order; at these steps (h ω from 0.03 down) the next term of the error is
/// a few per cent of the first.
#[test]
fn observed_order_is_that_of_theory() {
    let (scene, duration) = (smooth(), 0.5);
    let exact = exact(&scene, duration);
    for method in METHODS {
        let steps = [0.5 / 100.0, 0.5 / 200.0, 0.5 / 400.0, 0.5 / 800.0];
        let errors = steps.map(|h| {
            let trajectory = run(
                &scene,
                &motion_options(method, h, duration, 1.0 / duration),
                None,
            );
            assert_eq!(trajectory.frames.len(), 2);
            apart(&trajectory.frames[1].positions, &exact)
        });
        let observed = slope(&steps, &errors);
        let theory = order(method);
        assert!(
            (observed - theory).abs() < 0.1,
            "{method:?}: order {observed:.3}, errors {errors:?}"
        );
    }
}

/// Local errors that add up to the tolerance make about as large an error: here, over less than a
/// period, at most three times.
#[test]
fn chosen_steps_meet_the_tolerance_and_shrink_with_it() {
    let (scene, duration) = (smooth(), 0.5);
    let exact = exact(&scene, duration);
    for method in METHODS {
        let tolerances = if order(method) > 1.0 {
            [1e-3, 1e-4, 1e-5]
        } else {
            [1e-1, 1e-2, 1e-3]
        };
        let mut steps = vec![];
        for tolerance in tolerances {
            let options = SolverOptions {
                step_s: None,
                tolerance,
                ..motion_options(method, 0.0, duration, 10.0)
            };
            let trajectory = run(&scene, &options, None);
            let error = apart(&trajectory.frames[5].positions, &exact);
            assert!(
                error < 3.0 * tolerance * duration,
                "{method:?} at {tolerance:e}: {error:e}"
            );
            let report = trajectory.report;
            assert!(report.local_errors_m <= tolerance * duration * (1.0 + 1e-9));
            steps.push(report.steps);
        }
        assert!(steps[0] <= steps[1] && steps[1] < steps[2], "{steps:?}");
    }
}

fn momentum(scene: &Scene, v: &[Vector3<f64>]) -> Vector3<f64> {
    v.iter().zip(&scene.mass).map(|(v, m)| v * *m).sum()
}

fn angular_momentum(scene: &Scene, x: &[Vector3<f64>], v: &[Vector3<f64>]) -> Vector3<f64> {
    let parts = x.iter().zip(v).zip(&scene.mass);
    parts.map(|((x, v), m)| x.cross(v) * *m).sum()
}

/// Springs pull both of their ends alike, so that nothing but rounding changes the sum of momenta.
#[test]
fn linear_momentum_of_free_flight_is_kept_by_every_method() {
    let scene = grid(5, 50.0);
    let velocities = stirred(25, 0.3);
    let start = momentum(&scene, &velocities);
    let size: f64 = velocities.iter().map(|v| 1e-3 * v.norm()).sum();
    for method in METHODS {
        let options = motion_options(method, 1e-3, 1.0, 10.0);
        let trajectory = run(&scene, &options, Some(velocities.clone()));
        for frame in &trajectory.frames {
            let drift = (momentum(&scene, &frame.velocities) - start).norm();
            assert!(drift < 1e-10 * size, "{method:?}: {:e}", drift / size);
        }
    }
}

/// Both methods are symplectic, and forces along springs turn nothing.
#[test]
fn angular_momentum_of_free_flight_is_kept_by_symplectic_methods() {
    let scene = grid(5, 50.0);
    let velocities = stirred(25, 0.3);
    let start = angular_momentum(&scene, &scene.start, &velocities);
    let size: f64 = scene
        .start
        .iter()
        .zip(&velocities)
        .map(|(x, v)| 1e-3 * x.norm() * v.norm())
        .sum();
    for method in [Method::SymplecticEuler, Method::Verlet] {
        let options = motion_options(method, 1e-3, 1.0, 10.0);
        let trajectory = run(&scene, &options, Some(velocities.clone()));
        for frame in &trajectory.frames {
            let now = angular_momentum(&scene, &frame.positions, &frame.velocities);
            let drift = (now - start).norm();
            assert!(drift < 1e-10 * size, "{method:?}: {:e}", drift / size);
        }
    }
}

/// Implicit Euler loses h² sum m |v x a| a step, BDF2 an order more: over a fixed time
/// orders 1 and 2.
#[test]
fn angular_momentum_drifts_by_the_order_of_implicit_methods() {
    let scene = grid(3, 2.0);
    // A spin about the middle, and a stretch.
    let velocities: Vec<_> = scene
        .start
        .iter()
        .map(|x| {
            let from = x - Vector3::new(0.1, 0.1, 0.0);
            Vector3::z().cross(&from) * 5.0 + from * 2.0
        })
        .collect();
    let start = angular_momentum(&scene, &scene.start, &velocities);
    for method in [Method::ImplicitEuler, Method::Bdf2] {
        let steps = [1e-3, 0.5e-3, 0.25e-3, 0.125e-3];
        let drifts = steps.map(|h| {
            let trajectory = run(
                &scene,
                &motion_options(method, h, 0.2, 5.0),
                Some(velocities.clone()),
            );
            let end = &trajectory.frames[1];
            (angular_momentum(&scene, &end.positions, &end.velocities) - start).norm()
        });
        let observed = slope(&steps, &drifts);
        assert!(
            (observed - order(method)).abs() < 0.1,
            "{method:?}: order {observed:.3}, drifts {drifts:?}"
        );
    }
}

/// `Φ(x) = E(x) + |x - x̂|²_M / 2h²` with x̂ = x + h v, worked out here from the frames: one frame
/// is one step.
#[test]
fn each_step_of_implicit_euler_lowers_its_incremental_potential() {
    let mut scene = grid(5, 200.0);
    scene.gravity = Vector3::new(0.0, -9.8, 0.0);
    scene.pins = vec![20, 24];
    for h in [1e-3, 1e-2, 0.05] {
        let options = motion_options(Method::ImplicitEuler, h, 40.0 * h, 1.0 / h);
        let trajectory = run(&scene, &options, Some(stirred(25, 1.0)));
        assert_eq!(trajectory.report.steps, 40);
        for pair in trajectory.frames.windows(2) {
            let potential = |x: &[Vector3<f64>], energy: f64| {
                let target = pair[0].positions.iter().zip(&pair[0].velocities);
                let square: f64 = x
                    .iter()
                    .zip(target)
                    .zip(&scene.mass)
                    .map(|((x, (x0, v)), m)| m * (x - x0 - v * h).norm_squared())
                    .sum();
                energy + square / (2.0 * h * h)
            };
            let energy = |k: usize| pair[k].energy.total() - pair[k].energy.kinetic;
            let before = potential(&pair[0].positions, energy(0));
            let after = potential(&pair[1].positions, energy(1));
            assert!(after < before, "step {h}: {before} to {after}");
        }
    }
}

/// Bounds on the energy of a linear oscillator, over that at the start.
///
/// Symplectic Euler keeps v² + ω²x² - h ω² x v, Verlet (1 - h²ω²/4) ω²x² + v²: with h ω = 1.8 the
/// energy goes up to (1 + 0.9) / (1 - 0.9) and 1 / (1 - 0.81) times what it was. Implicit Euler
/// never gains. BDF2 keeps its G-norm from rising (Dahlquist 1978),
/// `|y_n|²/4 <= |(y_1, y_0)|²_G <= 10/4 max |y|²`.
fn largest_gain(method: Method) -> f64 {
    match method {
        Method::SymplecticEuler => 19.0,
        Method::Verlet => 5.27,
        Method::ImplicitEuler => 1.0,
        _ => 10.0,
    }
}

#[test]
fn no_energy_grows_over_1e5_steps_within_the_stability_limit() {
    let scene = grid(2, 100.0);
    // Strains of 1e-3: the springs are nearly linear.
    let velocities = stirred(4, 0.03);
    for method in METHODS {
        let limit = attempt(
            &scene,
            &motion_options(Method::Verlet, 1e-6, 1e-6, 1e6),
            None,
        )
        .report
        .stability_limit_s
        .expect("Verlet has a limit");
        let h = 0.9 * limit;
        let duration = 1e5 * h;
        let options = motion_options(method, h, duration, 1000.0 / duration);
        let trajectory = run(&scene, &options, Some(velocities.clone()));
        assert!(trajectory.report.steps >= 100_000);
        assert!(trajectory.report.within_limits);
        let first = trajectory.frames[0].energy.total();
        for frame in &trajectory.frames {
            let gain = frame.energy.total() / first;
            assert!(
                gain <= largest_gain(method) * (1.0 + 1e-9),
                "{method:?}: {gain} at {}",
                frame.time_s
            );
        }
    }
}

/// Two particles of mass m on a spring k swing with ω² = 2 k / m.
#[test]
fn a_step_above_the_stability_limit_is_refused_and_the_limit_named() {
    let ends = vec![Vector3::zeros(), Vector3::new(1.0, 0.0, 0.0)];
    let scene = net(ends, vec![0.01; 2], &[(0, 1, 1.0, 800.0)]);
    let exact = 2.0 / (2.0 * 800.0_f64 / 0.01).sqrt();
    for method in [Method::SymplecticEuler, Method::Verlet] {
        let refused = attempt(
            &scene,
            &motion_options(method, 1.01 * exact, 1.0, 10.0),
            None,
        );
        assert!(!refused.report.complete);
        assert_eq!((refused.frames.len(), refused.report.steps), (1, 0));
        let limit = refused.report.stability_limit_s.expect("it has one");
        // Kept 5 % of ω² below what it may stiffen to.
        assert!(limit <= exact && limit > 0.95 * exact, "{limit} {exact}");
        let named = format!("{limit:.2e} s");
        assert!(
            refused.report.why.contains(&named),
            "{}",
            refused.report.why
        );
        let below = run(
            &scene,
            &motion_options(method, 0.99 * limit, 1.0, 10.0),
            None,
        );
        assert!(below.report.step_max_s <= limit);
    }
    for method in [Method::ImplicitEuler, Method::Bdf2] {
        run(
            &scene,
            &motion_options(method, 10.0 * exact, 1.0, 10.0),
            None,
        );
    }
}

#[test]
fn the_limit_of_a_larger_net_is_a_little_below_the_true_one() {
    let scene = grid(20, 100.0);
    let report = attempt(
        &scene,
        &motion_options(Method::Verlet, 1e-6, 1e-6, 1e6),
        None,
    )
    .report;
    let limit = report.stability_limit_s.expect("Verlet has a limit");
    // ω² by power iteration on M⁻¹ H of the flat rest shape, in the net's plane: springs are stiff
    // along themselves only.
    let n = scene.start.len();
    let mut z = stirred(n, 1.0);
    let mut square = 0.0;
    for _ in 0..3000 {
        let mut product = vec![Vector3::zeros(); n];
        for s in scene.membrane.springs() {
            let along = (scene.start[s.b] - scene.start[s.a]).normalize();
            let f = along * (s.stiffness_n_m * along.dot(&(z[s.a] - z[s.b])));
            product[s.a] += f / scene.mass[s.a];
            product[s.b] -= f / scene.mass[s.b];
        }
        let norm = |z: &[Vector3<f64>]| z.iter().map(Vector3::norm_squared).sum::<f64>().sqrt();
        square = norm(&product) / norm(&z);
        let size = norm(&product);
        z = product.into_iter().map(|p| p / size).collect();
    }
    let exact = 2.0 / f64::sqrt(square);
    assert!(limit <= exact && limit > 0.85 * exact, "{limit} {exact}");
}

#[test]
fn the_same_motion_is_the_same_bytes() {
    let scene = grid(4, 80.0);
    for method in METHODS {
        let motion = || {
            run(
                &scene,
                &motion_options(method, 1e-3, 0.1, 10.0),
                Some(stirred(16, 0.5)),
            )
        };
        assert_eq!(motion().frames, motion().frames);
    }
}

#[test]
fn auto_counts_and_says_so() {
    let pick = |stiffness: f64| {
        let scene = Scene {
            gravity: Vector3::new(0.0, -9.8, 0.0),
            pins: vec![0],
            ..grid(5, stiffness)
        };
        let options = SolverOptions {
            step_s: None,
            tolerance: 1e-3,
            ..motion_options(Method::Auto, 0.0, 0.05, 20.0)
        };
        run(&scene, &options, None).report
    };
    let (soft, stiff) = (pick(20.0), pick(2e7));
    assert_eq!(
        (soft.method.as_str(), stiff.method.as_str()),
        ("verlet", "bdf2")
    );
    assert!(
        soft.method_because
            .is_some_and(|why| why.contains("operations"))
    );
}
