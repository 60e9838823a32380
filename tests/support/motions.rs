//! Nets of particles and springs to set in motion, and what is measured on their motion.

#![allow(
    dead_code,
    reason = "each test program takes what it needs of these builders"
)]

use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::mesh::{ClothMesh, PanelRange};
use seamster::progress::CancelToken;
use seamster::scene::{NetSpring, Scene};
use seamster::solver::{Context, Frame, Method, Simulate, Start, Trajectory, Want, trajectory};

pub(crate) const METHODS: [Method; 4] = [
    Method::SymplecticEuler,
    Method::Verlet,
    Method::ImplicitEuler,
    Method::Bdf2,
];

/// Particles at `start`, joined by springs `(a, b, rest length, stiffness)`, without gravity or drag.
pub(crate) fn net(
    start: Vec<Vector3<f64>>,
    mass: Vec<f64>,
    springs: &[(usize, usize, f64, f64)],
) -> Scene {
    let uv: Vec<[f64; 2]> = start.iter().map(|p| [p.x, p.y]).collect();
    let panel = PanelRange {
        vertices: 0..uv.len(),
        triangles: 0..0,
        corners: vec![],
    };
    let spring = |&(a, b, rest_length_m, stiffness_n_m): &(usize, usize, f64, f64)| NetSpring {
        a,
        b,
        rest_length_m,
        stiffness_n_m,
    };
    Scene {
        mesh: ClothMesh {
            uv,
            triangles: vec![],
            panels: vec![panel],
            stitches: vec![],
        },
        start,
        mass,
        fabrics: vec![],
        cut: vec![],
        net: Some(springs.iter().map(spring).collect()),
        fibres: None,
        least_bending_n_m: 0.0,
        body: None,
        friction: 0.0,
        gravity: Vector3::zeros(),
        drag: Some(0.0),
        pins: vec![],
        held_axis: None,
        wind: None,
    }
}

/// A grid of `n` x `n` particles of 1 g, 0.1 m apart, with springs of `stiffness` \[N/m\] along its lines and half of that across.
pub(crate) fn grid(n: usize, stiffness: f64) -> Scene {
    let at = |i: usize, j: usize| i + n * j;
    let mut springs = vec![];
    for j in 0..n {
        for i in 0..n {
            if i + 1 < n {
                springs.push((at(i, j), at(i + 1, j), 0.1, stiffness));
            }
            if j + 1 < n {
                springs.push((at(i, j), at(i, j + 1), 0.1, stiffness));
            }
            if i + 1 < n && j + 1 < n {
                let across = 0.1 * 2.0_f64.sqrt();
                springs.push((at(i, j), at(i + 1, j + 1), across, 0.5 * stiffness));
                springs.push((at(i + 1, j), at(i, j + 1), across, 0.5 * stiffness));
            }
        }
    }
    let start = (0..n * n)
        .map(|p| Vector3::new((p % n) as f64 * 0.1, (p / n) as f64 * 0.1, 0.0))
        .collect();
    net(start, vec![1e-3; n * n], &springs)
}

/// Velocities of up to `speed` \[m/s\] in all directions, the same every time.
pub(crate) fn stirred(count: usize, speed: f64) -> Vec<Vector3<f64>> {
    let mut seed = 12_345_u32;
    let mut number = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 23) - 1.0
    };
    (0..count)
        .map(|_| Vector3::new(number(), number(), number()) * speed)
        .collect()
}

/// What is asked for: a motion of `duration` \[s\] in steps of `step` \[s\], solved as exactly as rounding allows.
pub(crate) fn ask(method: Method, step: f64, duration: f64, frame_rate: f64) -> Simulate {
    Simulate {
        want: Want::Motion,
        method,
        step_s: Some(step),
        tolerance: 1e-12,
        duration_s: Some(duration),
        frame_rate_hz: Some(frame_rate),
        ..Simulate::default()
    }
}

/// The motion from the scene's start with these velocities, whether it was completed or not.
pub(crate) fn attempt(
    scene: &Scene,
    ask: &Simulate,
    velocities: Option<Vec<Vector3<f64>>>,
) -> Trajectory {
    let start = Start {
        positions: None,
        velocities,
    };
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    let mut context = Context {
        cpu_s: &|| 0.0,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    };
    trajectory(scene, ask, start, &mut context)
}

/// The same, which must be completed.
pub(crate) fn run(
    scene: &Scene,
    ask: &Simulate,
    velocities: Option<Vec<Vector3<f64>>>,
) -> Trajectory {
    let trajectory = attempt(scene, ask, velocities);
    assert!(
        trajectory.report.complete,
        "{:?}: {}",
        ask.method, trajectory.report.why
    );
    trajectory
}

/// The slope of `errors` over `steps` in logarithms, by least squares: the observed order.
pub(crate) fn slope(steps: &[f64], errors: &[f64]) -> f64 {
    let n = steps.len() as f64;
    let logs: Vec<(f64, f64)> = steps
        .iter()
        .zip(errors)
        .map(|(h, e)| (h.ln(), e.ln()))
        .collect();
    let (x, y) = (
        logs.iter().map(|l| l.0).sum::<f64>() / n,
        logs.iter().map(|l| l.1).sum::<f64>() / n,
    );
    let above: f64 = logs.iter().map(|l| (l.0 - x) * (l.1 - y)).sum();
    above / logs.iter().map(|l| (l.0 - x).powi(2)).sum::<f64>()
}

/// RMS distance between two shapes \[m\].
pub(crate) fn apart(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b).norm_squared()).sum();
    (square / a.len() as f64).sqrt()
}

/// Times at which a coordinate goes through zero upwards, by straight lines between frames \[s\].
pub(crate) fn upward_crossings(frames: &[Frame], of: impl Fn(&Frame) -> f64) -> Vec<f64> {
    frames
        .windows(2)
        .filter_map(|pair| {
            let (a, b) = (of(&pair[0]), of(&pair[1]));
            let share = a / (a - b);
            (a < 0.0 && b >= 0.0)
                .then(|| pair[0].time_s + share * (pair[1].time_s - pair[0].time_s))
        })
        .collect()
}

/// Mean time between the crossings \[s\].
pub(crate) fn period(crossings: &[f64]) -> f64 {
    assert!(crossings.len() > 1, "not one period: {crossings:?}");
    (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64
}
