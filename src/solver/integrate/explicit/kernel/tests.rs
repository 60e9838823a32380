//! The fused step against the terms that it stands for.

use crate::solver::forces::{BendForce, BendPatch, Gravity, Potential, Spring, SpringForce};
use crate::solver::integrate::explicit::kernel::*;
use crate::solver::model::system::TimedTerm;

fn number(seed: &mut u32) -> f64 {
    *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    f64::from(*seed >> 8) / f64::from(1 << 24)
}

/// A scattered net of `n` particles of unlike mass: springs, patches that bend, weight, some held.
fn system(n: usize) -> System<'static> {
    let mut seed = 5;
    let mut springs = vec![];
    let mut patches = vec![];
    for i in 0..n {
        for step in [1, 2, 7, 11] {
            if i + step < n && number(&mut seed) < 0.8 {
                springs.push(Spring {
                    a: i,
                    b: i + step,
                    rest_length: 0.05 + number(&mut seed),
                    stiffness: 100.0 * number(&mut seed),
                });
            }
        }
        if i + 8 < n {
            let rest = [[0.0, 0.0], [1.0, 0.0], [0.3, 0.9]];
            let wings = [
                Some((i + 1, [1.2, 0.9])),
                Some((i + 7, [-0.6, 0.7])),
                (i % 3 > 0).then_some((i + 2, [0.6, -0.8])),
            ];
            patches.extend(BendPatch::new([i, i + 4, i + 8], rest, wings, [0.3, 0.2]));
        }
    }
    let mass: Vec<f64> = (0..n).map(|_| 0.01 + number(&mut seed)).collect();
    let weight = mass.iter().map(|m| Vector3::new(0.1, -9.8, 0.2) * *m);
    let gravity = Gravity {
        weight: weight.collect(),
        start: vec![Vector3::zeros(); n],
    };
    let forces: [Box<dyn Potential>; 3] = [
        Box::new(SpringForce::new(springs)),
        Box::new(BendForce::new(patches)),
        Box::new(gravity),
    ];
    System {
        is_fixed: (0..n).map(|i| i % 13 == 4).collect(),
        mass,
        fixed_axis: None,
        terms: forces
            .into_iter()
            .map(|potential| TimedTerm {
                potential,
                cpu_s: 0.0,
            })
            .collect(),
        clock: &|| 0.0,
    }
}

fn scattered(n: usize, size: f64, mut seed: u32) -> Vec<Vector3<f64>> {
    let mut part = || (number(&mut seed) - 0.5) * size;
    (0..n)
        .map(|_| Vector3::new(part(), part(), part()))
        .collect()
}

fn kernel(system: &System<'_>, more: bool) -> Kernel {
    let mut pair_forces = PairForces::new(system.mass.len());
    let known = |term: &TimedTerm| term.potential.add_to_pair_forces(&mut pair_forces);
    assert!(system.terms.iter().map(known).fold(true, |a, b| a & b));
    Kernel::new(system, &pair_forces, more)
}

const RULE: StepRule = StepRule {
    keep: 0.9,
    gain: 1e-3,
    h: 2e-3,
    speed_limit: f64::INFINITY,
};

/// Sums of a dozen forces, each rounded to eps of the largest; what is compared is V, gained from
/// them over eps.
#[test]
fn a_step_is_that_of_the_terms_to_rounding() {
    for (n, more, axis) in [(1, false, None), (23, false, None), (300, true, Some(1))] {
        let mut system = system(n);
        system.fixed_axis = axis;
        let x = scattered(n, 1.0, 9);
        let mut v = scattered(n, 0.1, 11);
        system.zero_fixed(&mut v);
        let push = scattered(n, if more { 2.0 } else { 0.0 }, 13);
        let mut force = vec![Vector3::zeros(); n];
        system.net_force(&x, &mut force);
        let mut kernel = kernel(&system, more);
        kernel.load(&x, &v);
        kernel.set_push(&push);
        kernel.step(RULE);
        let (mut x1, mut v1) = (x.clone(), v.clone());
        kernel.positions(&mut x1);
        kernel.velocities(&mut v1);
        let mut free = push;
        system.zero_fixed(&mut free);
        let size = force.iter().map(Vector3::norm).fold(0.0, f64::max);
        for i in 0..n {
            let f = force[i] + free[i];
            let expected = v[i] * RULE.keep + f * (RULE.gain / system.mass[i]);
            let rounding = 30.0 * f64::EPSILON * (1.0 + size * RULE.gain / system.mass[i]);
            assert!((v1[i] - expected).norm() < rounding, "{i} of {n}");
            assert!((x1[i] - (x[i] + expected * RULE.h)).norm() < rounding);
            assert!(!system.is_fixed[i] || x1[i] == x[i]);
        }
    }
}

#[test]
fn every_instruction_set_gives_the_same_bytes() {
    let system = system(200);
    let run = |arch: Arch| {
        let mut kernel = kernel(&system, false);
        kernel.arch = arch;
        kernel.load(&scattered(200, 1.0, 9), &scattered(200, 0.1, 11));
        (0..50).for_each(|_| kernel.step(RULE));
        (kernel.x, kernel.v)
    };
    assert!(run(Arch::new()) == run(Arch::Scalar));
}

#[test]
fn no_particle_is_faster_than_the_limit() {
    let system = system(40);
    let rule = StepRule {
        speed_limit: 0.5,
        ..RULE
    };
    let mut kernel = kernel(&system, false);
    let mut v = vec![Vector3::zeros(); 40];
    kernel.load(&scattered(40, 1.0, 9), &scattered(40, 10.0, 11));
    for _ in 0..20 {
        kernel.step(rule);
        kernel.velocities(&mut v);
        assert!(v.iter().all(|v| v.norm() <= 0.5 * (1.0 + 1e-12)));
    }
    assert!(v.iter().any(|v| v.norm() > 0.499));
}

#[test]
fn a_spring_of_no_length_pulls_nowhere() {
    let mut system = system(1);
    system.mass = vec![1.0; 2];
    system.is_fixed = vec![false; 2];
    let spring = Spring {
        a: 0,
        b: 1,
        rest_length: 1.0,
        stiffness: 10.0,
    };
    let potential = Box::new(SpringForce::new(vec![spring]));
    system.terms = vec![TimedTerm {
        potential,
        cpu_s: 0.0,
    }];
    let mut kernel = kernel(&system, false);
    let mut x = vec![Vector3::repeat(0.5); 2];
    kernel.load(&x, &[Vector3::zeros(); 2]);
    kernel.step(RULE);
    kernel.positions(&mut x);
    assert_eq!(x, [Vector3::repeat(0.5); 2]);
}
