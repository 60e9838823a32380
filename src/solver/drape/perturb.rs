//! Perturbation of a degenerate start: particles in one point, or on a line, have no direction to
//! be pushed apart in.
//!
//! The force of a spring of no length is zero and so is that of a triangle without area, so such a
//! start may be a shape at rest (a maximum or a saddle of the energy) that no method leaves. Moving
//! its particles by a hundredth of an edge, the same way every time, lets it be left.

use crate::scene::Scene;
use nalgebra::Vector3;

/// Length of an edge over its rest length below which it is degenerate.
const DEGENERATE: f64 = 1e-3;
/// Distance by which its ends are moved, over its rest length.
const PERTURBATION: f64 = 0.01;

/// Moves the ends of degenerate edges of `x`, except pins.
pub(crate) fn perturb_degenerate(scene: &Scene, x: &mut [Vector3<f64>]) {
    let mut by = vec![0.0_f64; x.len()];
    let mut widen = |a: usize, b: usize, rest: f64| {
        if (x[a] - x[b]).norm() < DEGENERATE * rest {
            by[a] = by[a].max(PERTURBATION * rest);
            by[b] = by[b].max(PERTURBATION * rest);
        }
    };
    for spring in scene.membrane.springs() {
        widen(spring.a, spring.b, spring.rest_length_m);
    }
    for t in &scene.mesh.triangles {
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            let [p, q] = [a, b].map(|v| scene.mesh.uv[v]);
            widen(a, b, (p[0] - q[0]).hypot(p[1] - q[1]));
        }
    }
    for &pin in &scene.pins {
        by[pin] = 0.0;
    }
    let mut random = random_numbers();
    for (x, by) in x.iter_mut().zip(by) {
        let mut d = Vector3::new(random(), random(), random()) * by;
        if let Some(axis) = scene.fixed_axis {
            d[axis] = 0.0;
        }
        *x += d;
    }
}

/// Generates pseudo-random numbers from -1 to 1, the same every time (the linear congruential
/// generator of D. E. Knuth's MMIX).
fn random_numbers() -> impl FnMut() -> f64 {
    let mut seed = 1_u64;
    move || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / (1_u64 << 30) as f64 - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Limits;
    use crate::scene::{NetSpring, RawScene};

    /// Three vertices in one point and one apart, in a plane, the first of them pinned.
    #[test]
    fn particles_in_one_point_are_moved_apart_except_pins() {
        let spring = |a, b| NetSpring {
            a,
            b,
            rest_length_m: 0.1,
            stiffness_n_m: 1.0,
        };
        let raw = RawScene {
            start_m: vec![[0.0; 3], [0.0; 3], [0.0; 3], [0.1, 0.0, 0.0]],
            mass_kg: vec![1.0; 4],
            springs: vec![spring(0, 1), spring(1, 2), spring(2, 3)],
            pins: vec![0],
            fixed_axis: Some(2),
            ..RawScene::default()
        };
        let scene = raw
            .into_scene(&Limits::default())
            .expect("a right scene of four vertices");
        let mut x = scene.start.clone();
        perturb_degenerate(&scene, &mut x);
        assert_eq!((x[0], x[3]), (scene.start[0], scene.start[3]));
        for i in [1, 2] {
            assert!(x[i] != scene.start[i] && x[i].z == 0.0);
            assert!(x[i].norm() <= 0.01 * 0.1 * 2f64.sqrt());
        }
        let mut again = scene.start.clone();
        perturb_degenerate(&scene, &mut again);
        assert_eq!(x, again);
    }
}
