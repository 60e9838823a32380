//! Motions with a closed form: fall, pendulum, string, hanging chain, sliding and sticking on an
//! incline.
//!
//! Figures and tolerances of `validation.json` of the project's data: textbook formulas, carried in
//! here.

use nalgebra::Vector3;
use seamster::scene::{Analytic, Body, Scene};
use seamster::solver::{Frame, Method};
use seamster_fixtures::motions::{METHODS, motion_options, net, period, run, upward_crossings};
use std::f64::consts::PI;

const GRAVITY: f64 = 9.80665;

fn falling(scene: Scene) -> Scene {
    Scene {
        gravity: Vector3::new(0.0, -GRAVITY, 0.0),
        ..scene
    }
}

/// Without drag Verlet is exact but for rounding; the errors of the two Euler methods are g h t /
/// 2: the mean velocity of a step is taken half a step late. BDF2 is exact but for its first step
/// of implicit Euler, which is off by g h²/2; its formula 4/3 y - 1/3 y₋ carries that on as
/// 1 + 1/3 + 1/9 + ... = 3/2 of it.
#[test]
fn free_fall_matches_its_closed_form() {
    let scene = falling(net(vec![Vector3::new(0.1, 0.2, 0.3)], vec![0.01], &[]));
    let h = 1e-3;
    for method in METHODS {
        let trajectory = run(&scene, &motion_options(method, h, 1.0, 10.0), None);
        assert_eq!(trajectory.frames.len(), 11);
        for frame in &trajectory.frames {
            let t = frame.time_s;
            let fallen = 0.2 - frame.positions[0].y;
            let late = match method {
                Method::Verlet => 0.0,
                Method::Bdf2 if t == 0.0 => 0.0,
                Method::Bdf2 => 0.75 * GRAVITY * h * h,
                _ => 0.5 * GRAVITY * h * t,
            };
            let exact = 0.5 * GRAVITY * t * t + late;
            assert!((fallen - exact).abs() < 1e-10, "{method:?} at {t}");
            assert!((frame.velocities[0].y + GRAVITY * t).abs() < 1e-10);
        }
    }
}

/// With drag c a fall reaches g / c: y = -g/c (t - (1 - exp(-c t)) / c). Errors of second order: at
/// most h² c² of the way.
#[test]
fn fall_with_drag_matches_its_closed_form() {
    let (drag, h) = (4.0, 1e-3);
    let scene = Scene {
        drag: Some(drag),
        ..falling(net(vec![Vector3::zeros()], vec![0.01], &[]))
    };
    let exact = |t: f64| -GRAVITY / drag * (t - (1.0 - (-drag * t).exp()) / drag);
    for method in METHODS {
        let within = match method {
            Method::Verlet | Method::Bdf2 => h * h * drag * drag,
            _ => h * drag,
        };
        let trajectory = run(&scene, &motion_options(method, h, 1.0, 10.0), None);
        let end = trajectory.frames[10].positions[0].y;
        assert!((end / exact(1.0) - 1.0).abs() < within, "{method:?}: {end}");
    }
}

/// T = 2π √(L/g) · 2/π K(sin(a/2)): columns amplitude \[degrees\] and T / T0.
const PENDULUM: [(f64, f64); 3] = [(5.0, 1.000_476), (30.0, 1.017_409), (90.0, 1.180_341)];

/// A bob on a rod that stretches by 1e-4 of its length under the bob's weight: 5e-5 of the period.
#[test]
fn pendulum_has_the_period_of_the_closed_form() {
    for (degrees, ratio) in PENDULUM {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let start = vec![Vector3::zeros(), Vector3::new(sin, -cos, 0.0)];
        let mass = 0.1;
        let rod = mass * GRAVITY / 1e-4;
        let scene = Scene {
            pins: vec![0],
            ..falling(net(start, vec![mass; 2], &[(0, 1, 1.0, rod)]))
        };
        let exact = ratio * 2.0 * PI / GRAVITY.sqrt();
        for method in [Method::SymplecticEuler, Method::Verlet, Method::Bdf2] {
            let trajectory = run(&scene, &motion_options(method, 5e-4, 8.0, 200.0), None);
            let crossings = upward_crossings(&trajectory.frames, |f| f.positions[1].x);
            let found = period(&crossings);
            assert!(
                (found / exact - 1.0).abs() < 0.005,
                "{method:?} at {degrees}: {found} s for {exact} s"
            );
            let first = trajectory.frames[0].energy.total();
            let largest = trajectory.frames.iter().map(|f| f.energy.total() - first);
            let scale = mass * GRAVITY * (1.0 - cos);
            let gained = largest.fold(0.0, f64::max) / scale;
            // Symplectic Euler's energy swings by h ω of the rod, hω = 0.16 here, times the rod's
            // own small share.
            assert!(gained < 0.01, "{method:?}: gained {gained} of its energy");
        }
    }
}

/// f1 = 1 / (2 L) √(T/μ) for tension 20 N/m, 0.2 kg/m², 1 m: 5.000 Hz. Of 40 lumps the first mode
/// is low by π²/24 40² = 3e-4, and a stretch of 10 % keeps the tension the same for small swings.
#[test]
fn stretched_string_has_the_frequency_of_the_closed_form() {
    let n = 40;
    let length = 1.0 / f64::from(n);
    let rest = length / 1.1;
    let stiffness = 20.0 / (length - rest);
    let springs: Vec<_> = (0..n as usize)
        .map(|i| (i, i + 1, rest, stiffness))
        .collect();
    let start = (0..=n)
        .map(|i| {
            let x = f64::from(i) * length;
            Vector3::new(x, 1e-3 * (PI * x).sin(), 0.0)
        })
        .collect();
    let mass = vec![0.2 * length; n as usize + 1];
    let scene = Scene {
        pins: vec![0, n as usize],
        ..net(start, mass, &springs)
    };
    for (method, h) in [
        (Method::SymplecticEuler, 2e-4),
        (Method::Verlet, 2e-4),
        (Method::Bdf2, 1e-3),
    ] {
        let trajectory = run(&scene, &motion_options(method, h, 1.5, 1000.0), None);
        let middle = |f: &Frame| f.positions[n as usize / 2].y;
        let found = 1.0 / period(&upward_crossings(&trajectory.frames, middle));
        assert!((found / 5.0 - 1.0).abs() < 0.005, "{method:?}: {found} Hz");
    }
}

/// Zeros of J0.
const ZEROS: [f64; 4] = [2.404_826, 5.520_078, 8.653_728, 11.791_534];

/// The Bessel function J0 by its power series, good to 1e-10 up to 12.
fn bessel_j0(x: f64) -> f64 {
    let (mut sum, mut term) = (1.0, 1.0);
    for k in 1..60 {
        term *= -0.25 * x * x / f64::from(k * k);
        sum += term;
    }
    sum
}

/// `ω_n = (j0n / 2) √(g/L)` within 1 %. The chain hangs in balance but for its n-th mode, of
/// amplitude 0.1 mm.
#[test]
fn hanging_chain_has_the_frequencies_of_the_closed_form() {
    let n = 100_usize;
    let link = 1.0 / n as f64;
    // 0.1 kg/m; the last particle is half a link. The top link stretches by 1e-5 of its length.
    let (lump, stiffness) = (0.1 * link, 0.1 * GRAVITY / (1e-5 * link));
    let mut mass = vec![lump; n + 1];
    mass[n] = 0.5 * lump;
    for (mode, zero) in ZEROS.into_iter().enumerate() {
        let shape: Vec<f64> = (0..=n)
            .map(|i| bessel_j0(zero * (1.0 - i as f64 * link).sqrt()))
            .collect();
        let mut y = 0.0;
        let mut start = vec![Vector3::zeros()];
        for i in 1..=n {
            let below: f64 = mass[i..].iter().sum();
            y -= link + below * GRAVITY / stiffness;
            start.push(Vector3::new(1e-4 * shape[i], y, 0.0));
        }
        let springs: Vec<_> = (0..n).map(|i| (i, i + 1, link, stiffness)).collect();
        let scene = Scene {
            pins: vec![0],
            ..falling(net(start, mass.clone(), &springs))
        };
        let omega = 0.5 * zero * GRAVITY.sqrt();
        let duration = 3.5 * 2.0 * PI / omega;
        let options = motion_options(Method::Bdf2, duration / 1400.0, duration, 200.0 / duration);
        let trajectory = run(&scene, &options, None);
        let amount =
            |f: &Frame| -> f64 { (0..=n).map(|i| mass[i] * shape[i] * f.positions[i].x).sum() };
        let found = 2.0 * PI / period(&upward_crossings(&trajectory.frames, amount));
        assert!(
            (found / omega - 1.0).abs() < 0.01,
            "mode {}: {found} for {omega}",
            mode + 1
        );
    }
}

/// A patch of 3 x 3 particles, 20 mm wide and of 0.2 kg/m², on a plane that rises by 30 degrees, as
/// far above it as contact holds cloth without thickness.
fn on_incline(friction: f64) -> Scene {
    let (sin, cos) = (PI / 6.0).sin_cos();
    let (along, normal) = (Vector3::new(cos, sin, 0.0), Vector3::new(-sin, cos, 0.0));
    let side = 0.01;
    let mut start = vec![];
    for j in 0..3 {
        for i in 0..3 {
            let across = Vector3::z() * (f64::from(j) * side);
            start.push(along * (f64::from(i) * side) + across + normal * 2e-3);
        }
    }
    let mut springs = vec![];
    for j in 0..3 {
        for i in 0..3 {
            let p = i + 3 * j;
            if i < 2 {
                springs.push((p, p + 1, side, 100.0));
            }
            if j < 2 {
                springs.push((p, p + 3, side, 100.0));
            }
        }
    }
    Scene {
        body: Some(Body::Analytic(Analytic::HalfSpace {
            c: [0.0; 3],
            normal: normal.into(),
        })),
        friction,
        ..falling(net(start, vec![0.2 * side * side; 9], &springs))
    }
}

/// The patch at rest in the layer that keeps it off the plane, held there by more friction than it
/// needs.
fn settled() -> Vec<Vector3<f64>> {
    let scene = Scene {
        drag: Some(200.0),
        ..on_incline(2.0)
    };
    let trajectory = run(&scene, &motion_options(Method::Bdf2, 1e-3, 0.3, 10.0), None);
    trajectory.frames[3].positions.clone()
}

/// \[s\]
fn step_on_incline(method: Method) -> f64 {
    match method {
        Method::SymplecticEuler | Method::Verlet => 1e-4,
        _ => 1e-3,
    }
}

/// Distance that the patch slid down in 1 s \[m\].
fn slide(method: Method, friction: f64, drag: f64) -> f64 {
    let mut scene = Scene {
        drag: Some(drag),
        ..on_incline(friction)
    };
    scene.start = settled();
    let step = step_on_incline(method);
    let trajectory = run(&scene, &motion_options(method, step, 1.0, 10.0), None);
    let (sin, cos) = (PI / 6.0).sin_cos();
    let down = -Vector3::new(cos, sin, 0.0);
    let middle = |f: &Frame| f.positions.iter().sum::<Vector3<f64>>() / 9.0;
    let frames = &trajectory.frames;
    (middle(&frames[10]) - middle(&frames[0])).dot(&down)
}

/// x = g (sin a - μ cos a) t²/2: 1.178 m at 30 degrees, μ = 0.3, in 1 s; within 1 %.
#[test]
fn a_patch_slides_down_an_incline_as_far_as_coulomb_says() {
    let (sin, cos) = (PI / 6.0).sin_cos();
    let exact = 0.5 * GRAVITY * (sin - 0.3 * cos);
    assert!((exact - 1.178).abs() < 1e-3);
    for method in METHODS {
        let found = slide(method, 0.3, 0.0);
        assert!((found / exact - 1.0).abs() < 0.01, "{method:?}: {found} m");
    }
}

/// It sticks while tan a <= μ: at 30 degrees at 0.58 but not at 0.57 (tan 30° = 0.57735).
///
/// With drag 1/s it slides g (sin a - μ cos a) (t - 1 + exp(-t)): 23 mm in 1 s at 0.57. Friction
/// begins with the give of its spring, u = μ N / k; sticking under much drag, the patch gives by m
/// g sin a / k, which shows N / k. Until then it is half of μ N on average, so that the patch has
/// gained v² = 2 g u (sin a - μ cos a / 2). At 0.57 it keeps v but for drag; at 0.58 friction ends
/// it after v² / 2 g (μ cos a - sin a).
#[test]
fn a_patch_sticks_to_an_incline_above_the_threshold_and_slides_below() {
    let (sin, cos) = (PI / 6.0).sin_cos();
    let pressed = slide(Method::Bdf2, 2.0, 200.0) * cos / sin;
    assert!(pressed > 0.0);
    let kick = |friction: f64| 2.0 * GRAVITY * friction * pressed * (sin - 0.5 * friction * cos);
    let left = (-1.0_f64).exp();
    let exact = GRAVITY * (sin - 0.57 * cos) * left;
    let more = kick(0.57).sqrt() * (1.0 - left);
    let most = 0.58 * pressed + kick(0.58) / (2.0 * GRAVITY * (0.58 * cos - sin));
    for method in METHODS {
        let slid = slide(method, 0.57, 1.0);
        assert!(
            slid > 0.99 * exact && slid < 1.01 * (exact + more),
            "{method:?}: {slid} for {exact} and {more}"
        );
        let stuck = slide(method, 0.58, 1.0).abs();
        assert!(stuck < 1.01 * most, "{method:?}: crept {stuck}, not {most}");
        assert!(
            stuck < 0.1 * slid,
            "{method:?}: {stuck} is no less than {slid}"
        );
    }
}
