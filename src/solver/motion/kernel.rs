//! The explicit step in one pass: links, weight, drag and motion of eight particles at a time.
//!
//! V = keep V + gain F / m, then X = X + V h. Every particle gathers from its neighbours (a link is worked out from both of its
//! ends: no two particles write to the same place, and forces on the two ends are exactly opposite), in slices of eight
//! particles of about as many neighbours (SELL-C-σ: M. Kreutzer et al., "A unified sparse matrix data format...", SIAM J. Sci.
//! Comput. 36(5), 2014, with C = 8, σ = 256). Old and new positions are two arrays, so that one pass does it all.
//!
//! # Guarantees
//! No allocation in a step. The same bytes with and without AVX2: loops over lanes are written out, sums are never reordered,
//! and nothing is contracted. Forces equal those of the terms to rounding.
//!
//! # What bounds it
//! Positions are gathered number by number (24 loads for eight neighbours), and a square root and a division are taken for each
//! end of a spring; from about 100 000 particles on, when the tables leave the caches, memory is the bound.

use super::rows::Rows;
use crate::solver::forces::{Link, Stencil};
use crate::solver::system::System;
use nalgebra::Vector3;
use pulp::{Arch, Simd, WithSimd};
use std::ops::Range;

/// Particles worked on at a time.
const LANES: usize = 8;
/// Two weights over mass closer than this, relative, are one gravity.
const SAME: f64 = 1e-12;

type Lanes = [f64; LANES];

/// How one step moves particles: V = `keep` V + `gain` F / m, at most `speed_limit`, then X += V `h`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rule {
    /// Dimensionless.
    pub(crate) keep: f64,
    /// \[s\]
    pub(crate) gain: f64,
    /// \[s\]
    pub(crate) h: f64,
    /// \[m/s\]; infinite for none.
    pub(crate) speed_limit: f64,
}

/// Where the links of eight particles lie.
#[derive(Clone, Debug)]
struct Slice {
    springs: Range<usize>,
    straight: Range<usize>,
}

/// Particles, links and motion, laid out for the step.
pub(crate) struct Kernel {
    /// The particle in each place; places beyond the last particle hold none.
    particle: Vec<usize>,
    slices: Vec<Slice>,
    /// Links with a root to take: the places of the other ends, and their two coefficients.
    spring_ends: Vec<[u32; LANES]>,
    springs: Vec<[Lanes; 2]>,
    /// Links without.
    straight_ends: Vec<[u32; LANES]>,
    straight: Vec<Lanes>,
    /// Positions before and after a step; the fourth number is not used.
    x: Vec<[f64; 4]>,
    x_next: Vec<[f64; 4]>,
    v: Vec<[Lanes; 3]>,
    /// 1 / m, 0 where held \[1/kg\].
    mobility: Vec<Lanes>,
    /// Acceleration that all free particles share \[m/s²\].
    gravity: [f64; 3],
    /// 1 for an axis in which particles move, 0 for one that is held.
    free_axis: [f64; 3],
    /// Forces that particles do not share \[N\]; empty if there are none.
    push: Vec<[Lanes; 3]>,
    constant_push: Vec<Vector3<f64>>,
    arch: Arch,
}

impl Kernel {
    /// Lays out `stencil` for particles of these masses \[kg\]; `more_forces` if other forces will be handed in at each step.
    pub(crate) fn new(system: &System<'_>, stencil: &Stencil, more_forces: bool) -> Self {
        let (mass, held) = (&system.mass, &system.held);
        let rows = Rows::new(&stencil.merged(), mass.len());
        let particle = rows.order();
        let places = particle.len().next_multiple_of(LANES);
        let mobility = (0..places / LANES)
            .map(|slice| {
                lanes(|lane| match particle.get(slice * LANES + lane) {
                    Some(&p) if !held[p] => 1.0 / mass[p],
                    _ => 0.0,
                })
            })
            .collect();
        let gravity = shared_acceleration(&stencil.push, mass);
        let pushed = more_forces || gravity.is_none();
        let mut kernel = Self {
            slices: Vec::with_capacity(places / LANES),
            spring_ends: Vec::new(),
            springs: Vec::new(),
            straight_ends: Vec::new(),
            straight: Vec::new(),
            x: vec![[0.0; 4]; places],
            x_next: vec![[0.0; 4]; places],
            v: vec![[[0.0; LANES]; 3]; places / LANES],
            mobility,
            gravity: gravity.unwrap_or_default().into(),
            free_axis: std::array::from_fn(|axis| f64::from(system.held_axis != Some(axis))),
            push: vec![[[0.0; LANES]; 3]; if pushed { places / LANES } else { 0 }],
            constant_push: match gravity {
                Some(_) => Vec::new(),
                None => stencil.push.clone(),
            },
            arch: Arch::new(),
            particle,
        };
        kernel.lay_out(&rows);
        kernel.set_push(&vec![Vector3::zeros(); mass.len()]);
        kernel
    }

    fn lay_out(&mut self, rows: &Rows) {
        let mut place = vec![0; self.particle.len()];
        for (to, &p) in self.particle.iter().enumerate() {
            place[p] = u32::try_from(to).expect("meshes are bounded far below 2^32 vertices");
        }
        for first in (0..self.x.len()).step_by(LANES) {
            let own = |lane: usize| self.particle.get(first + lane).copied();
            let (springs, straight) = (self.springs.len(), self.straight.len());
            for kind in 0..2 {
                let row = |lane| own(lane).map_or(&[][..], |p| rows.of(p, kind));
                let most = (0..LANES).map(|lane| row(lane).len()).max();
                for k in 0..most.unwrap_or(0) {
                    // A lane that has no more neighbours is its own, and pulls by nothing.
                    let ends = std::array::from_fn(|lane| {
                        row(lane).get(k).map_or_else(
                            || u32::try_from(first + lane).unwrap_or(u32::MAX),
                            |end| place[end.b],
                        )
                    });
                    let part = |get: fn(&Link) -> f64| lanes(|l| row(l).get(k).map_or(0.0, get));
                    if kind == 0 {
                        self.spring_ends.push(ends);
                        self.springs.push([part(|e| e.straight), part(|e| e.bent)]);
                    } else {
                        self.straight_ends.push(ends);
                        self.straight.push(part(|e| e.straight));
                    }
                }
            }
            self.slices.push(Slice {
                springs: springs..self.springs.len(),
                straight: straight..self.straight.len(),
            });
        }
    }

    /// Takes positions and velocities in; held particles stand still.
    pub(crate) fn load(&mut self, x: &[Vector3<f64>], v: &[Vector3<f64>]) {
        for (place, &p) in self.particle.iter().enumerate() {
            let (slice, lane) = (place / LANES, place % LANES);
            self.x[place][..3].copy_from_slice(x[p].as_slice());
            let free = self.mobility[slice][lane] > 0.0;
            for axis in 0..3 {
                self.v[slice][axis][lane] = if free { v[p][axis] } else { 0.0 };
            }
        }
    }

    /// Hands positions out.
    pub(crate) fn positions(&self, x: &mut [Vector3<f64>]) {
        for (&p, from) in self.particle.iter().zip(&self.x) {
            x[p].copy_from_slice(&from[..3]);
        }
    }

    /// Hands velocities out.
    pub(crate) fn velocities(&self, v: &mut [Vector3<f64>]) {
        for (place, &p) in self.particle.iter().enumerate() {
            let lanes = &self.v[place / LANES];
            v[p] = Vector3::from_fn(|axis, _| lanes[axis][place % LANES]);
        }
    }

    /// Takes in what pushes particles besides links and gravity in the next step \[N\].
    pub(crate) fn set_push(&mut self, more: &[Vector3<f64>]) {
        if self.push.is_empty() {
            return;
        }
        for (place, &p) in self.particle.iter().enumerate() {
            let constant = self.constant_push.get(p).copied().unwrap_or_default();
            for axis in 0..3 {
                self.push[place / LANES][axis][place % LANES] = more[p][axis] + constant[axis];
            }
        }
    }

    /// One step.
    pub(crate) fn step(&mut self, rule: Rule) {
        let arch = self.arch;
        arch.dispatch(Step { kernel: self, rule });
        std::mem::swap(&mut self.x, &mut self.x_next);
    }

    /// Operations of a step: a root and a division count as eight each.
    pub(crate) fn operations(&self) -> f64 {
        let lanes = LANES as f64;
        lanes
            * (32.0 * self.springs.len() as f64
                + 9.0 * self.straight.len() as f64
                + 20.0 * self.slices.len() as f64)
    }

    /// Bytes of all arrays that a step reads or writes, each counted once.
    pub(crate) fn bytes(&self) -> usize {
        let slices = self.v.len();
        size_of::<[u32; LANES]>() * (self.spring_ends.len() + self.straight_ends.len())
            + size_of::<Lanes>() * (2 * self.springs.len() + self.straight.len())
            + size_of::<[f64; 4]>() * (self.x.len() + self.x_next.len())
            + size_of::<[Lanes; 3]>() * (slices + self.push.len())
            + (size_of::<Lanes>() + size_of::<Slice>()) * slices
    }

    #[inline(always)]
    fn pass<const PUSHED: bool, const LIMITED: bool>(&mut self, rule: Rule) {
        let x = &self.x[..];
        let own = x.as_chunks::<LANES>().0.iter();
        let next = self.x_next.as_chunks_mut::<LANES>().0.iter_mut();
        let moved = own.zip(next).zip(self.v.iter_mut().zip(&self.mobility));
        for (i, (slice, ((own, next), (v, mobility)))) in self.slices.iter().zip(moved).enumerate()
        {
            let mut at = transposed(own);
            let mut sum = [[0.0; LANES]; 3];
            let springs = slice.springs.clone();
            let ends = &self.spring_ends[springs.clone()];
            for (ends, [straight, bent]) in ends.iter().zip(&self.springs[springs]) {
                let d = differences(x, ends, &at);
                let mut scale = [0.0; LANES];
                for l in 0..LANES {
                    let square = d[0][l] * d[0][l] + d[1][l] * d[1][l] + d[2][l] * d[2][l];
                    // A spring of no length has no direction to push in: its scale is finite, and times 0.
                    scale[l] = straight[l] - bent[l] / square.max(f64::MIN_POSITIVE).sqrt();
                }
                add(&mut sum, &scale, &d);
            }
            let straight = slice.straight.clone();
            let ends = &self.straight_ends[straight.clone()];
            for (ends, scale) in ends.iter().zip(&self.straight[straight]) {
                add(&mut sum, scale, &differences(x, ends, &at));
            }
            if PUSHED {
                add(&mut sum, &[1.0; LANES], &self.push[i]);
            }
            for axis in 0..3 {
                let gain = rule.gain * self.free_axis[axis];
                for l in 0..LANES {
                    let free = if mobility[l] > 0.0 { 1.0 } else { 0.0 };
                    let a = sum[axis][l] * mobility[l] + free * self.gravity[axis];
                    v[axis][l] = rule.keep * v[axis][l] + gain * a;
                }
            }
            if LIMITED {
                limit(v, rule.speed_limit * rule.speed_limit);
            }
            for axis in 0..3 {
                for l in 0..LANES {
                    at[axis][l] += v[axis][l] * rule.h;
                }
            }
            for (l, next) in next.iter_mut().enumerate() {
                *next = [at[0][l], at[1][l], at[2][l], 0.0];
            }
        }
    }
}

/// One pass, compiled for each instruction set that the machine may have.
struct Step<'k> {
    kernel: &'k mut Kernel,
    rule: Rule,
}

impl WithSimd for Step<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) {
        let Step { kernel, rule } = self;
        match (kernel.push.is_empty(), rule.speed_limit.is_finite()) {
            (true, false) => kernel.pass::<false, false>(rule),
            (true, true) => kernel.pass::<false, true>(rule),
            (false, false) => kernel.pass::<true, false>(rule),
            (false, true) => kernel.pass::<true, true>(rule),
        }
    }
}

#[inline(always)]
fn transposed(points: &[[f64; 4]; LANES]) -> [Lanes; 3] {
    let mut lanes = [[0.0; LANES]; 3];
    for l in 0..LANES {
        for axis in 0..3 {
            lanes[axis][l] = points[l][axis];
        }
    }
    lanes
}

/// The ways from the particles at `at` to those at the places `ends`.
#[inline(always)]
fn differences(x: &[[f64; 4]], ends: &[u32; LANES], at: &[Lanes; 3]) -> [Lanes; 3] {
    let mut d = [[0.0; LANES]; 3];
    for l in 0..LANES {
        let end = &x[ends[l] as usize];
        for axis in 0..3 {
            d[axis][l] = end[axis];
        }
    }
    for axis in 0..3 {
        for l in 0..LANES {
            d[axis][l] -= at[axis][l];
        }
    }
    d
}

#[inline(always)]
fn add(sum: &mut [Lanes; 3], scale: &Lanes, d: &[Lanes; 3]) {
    for axis in 0..3 {
        for l in 0..LANES {
            sum[axis][l] += scale[l] * d[axis][l];
        }
    }
}

#[inline(always)]
fn limit(v: &mut [Lanes; 3], square_limit: f64) {
    for l in 0..LANES {
        let square = v[0][l] * v[0][l] + v[1][l] * v[1][l] + v[2][l] * v[2][l];
        let share = (square_limit / square.max(square_limit)).sqrt();
        for lanes in v.iter_mut() {
            lanes[l] *= share;
        }
    }
}

fn lanes(value: impl Fn(usize) -> f64) -> Lanes {
    std::array::from_fn(value)
}

/// The acceleration that `push` is for every particle, if it is the same one.
fn shared_acceleration(push: &[Vector3<f64>], mass: &[f64]) -> Option<Vector3<f64>> {
    let first = push.first()? / *mass.first()?;
    let same = |(f, m): (&Vector3<f64>, &f64)| (f - first * *m).norm() <= SAME * f.norm();
    push.iter().zip(mass).all(same).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::forces::{BendForce, Force, Gravity, Hinge, HingeSide, Spring, SpringForce};
    use crate::solver::system::TimedForce;

    fn number(seed: &mut u32) -> f64 {
        *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(*seed >> 8) / f64::from(1 << 24)
    }

    /// A scattered net of `n` particles of unlike mass: springs, hinges over some of them, weight, some held.
    fn system(n: usize) -> System<'static> {
        let mut seed = 5;
        let mut springs = vec![];
        let mut hinges = vec![];
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
                let mut side = || HingeSide {
                    cotangents: [number(&mut seed), number(&mut seed)],
                    area: 0.1 + number(&mut seed),
                };
                let sides = [side(), side()];
                hinges.push(Hinge::new([i, i + 1, i + 7, i + 8], sides, 0.3));
            }
        }
        let mass: Vec<f64> = (0..n).map(|_| 0.01 + number(&mut seed)).collect();
        let weight = mass.iter().map(|m| Vector3::new(0.1, -9.8, 0.2) * *m);
        let gravity = Gravity {
            weight: weight.collect(),
            start: vec![Vector3::zeros(); n],
        };
        let forces: [Box<dyn Force>; 3] = [
            Box::new(SpringForce::new(springs)),
            Box::new(BendForce::new(hinges)),
            Box::new(gravity),
        ];
        System {
            held: (0..n).map(|i| i % 13 == 4).collect(),
            mass,
            held_axis: None,
            terms: forces
                .into_iter()
                .map(|force| TimedForce { force, cpu_s: 0.0 })
                .collect(),
            contact: None,
            contact_cpu_s: 0.0,
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
        let mut stencil = Stencil::new(system.mass.len());
        let known = |term: &TimedForce| term.force.add_to_stencil(&mut stencil);
        assert!(system.terms.iter().map(known).fold(true, |a, b| a & b));
        Kernel::new(system, &stencil, more)
    }

    const RULE: Rule = Rule {
        keep: 0.9,
        gain: 1e-3,
        h: 2e-3,
        speed_limit: f64::INFINITY,
    };

    /// Sums of a dozen forces, each rounded to eps of the largest; what is compared is V, gained from them over eps.
    #[test]
    fn a_step_is_that_of_the_terms_to_rounding() {
        for (n, more, axis) in [(1, false, None), (23, false, None), (300, true, Some(1))] {
            let mut system = system(n);
            system.held_axis = axis;
            let x = scattered(n, 1.0, 9);
            let mut v = scattered(n, 0.1, 11);
            system.hold_still(&mut v);
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
            system.hold_still(&mut free);
            let size = force.iter().map(Vector3::norm).fold(0.0, f64::max);
            for i in 0..n {
                let f = force[i] + free[i];
                let expected = v[i] * RULE.keep + f * (RULE.gain / system.mass[i]);
                let rounding = 30.0 * f64::EPSILON * (1.0 + size * RULE.gain / system.mass[i]);
                assert!((v1[i] - expected).norm() < rounding, "{i} of {n}");
                assert!((x1[i] - (x[i] + expected * RULE.h)).norm() < rounding);
                assert!(!system.held[i] || x1[i] == x[i]);
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
        let rule = Rule {
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
        system.held = vec![false; 2];
        let spring = Spring {
            a: 0,
            b: 1,
            rest_length: 1.0,
            stiffness: 10.0,
        };
        let force = Box::new(SpringForce::new(vec![spring]));
        system.terms = vec![TimedForce { force, cpu_s: 0.0 }];
        let mut kernel = kernel(&system, false);
        let mut x = vec![Vector3::repeat(0.5); 2];
        kernel.load(&x, &[Vector3::zeros(); 2]);
        kernel.step(RULE);
        kernel.positions(&mut x);
        assert_eq!(x, [Vector3::repeat(0.5); 2]);
    }
}
