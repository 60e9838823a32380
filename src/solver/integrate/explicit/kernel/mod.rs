//! The explicit step in one pass: pair forces, weight, drag and motion of eight particles at a
//! time.
//!
//! V = keep V + gain F / m, then X = X + V h. Every particle gathers from its neighbors (a pair
//! force is computed from both of its ends: no two particles write to the same place, and forces on
//! the two ends are exactly opposite), in slices of eight particles of about as many neighbors
//! (SELL-C-σ: M. Kreutzer et al., "A unified sparse matrix data format...", SIAM J. Sci. Comput.
//! 36(5), 2014, with C = 8, σ = 256). Old and new positions are two arrays, so that one pass does
//! it all.
//!
//! # Guarantees
//! No allocation in a step. The same bytes with and without AVX2: loops over lanes are written out,
//! sums are never reordered, and nothing is contracted. Forces equal those of the terms to
//! rounding.
//!
//! # Performance
//! Positions are gathered number by number (24 loads for eight neighbors), and a square root and a
//! division are taken for each end of a spring; from about 100 000 particles on, when the tables
//! leave the caches, memory is the bound.

mod pass;
mod rows;

use crate::solver::forces::{PairForce, PairForces};
use crate::solver::integrate::explicit::kernel::rows::PairRows;
use crate::solver::model::system::System;
use nalgebra::Vector3;
use pulp::Arch;
use std::ops::Range;

/// Particles worked on at a time.
const LANES: usize = 8;
/// Two weights over mass closer than this, relative, are one gravity.
const SAME: f64 = 1e-12;

type Lanes = [f64; LANES];

/// Rule by which a step moves particles: V = `keep` V + `gain` F / m, at most `speed_limit`, then X
/// += V `h`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StepRule {
    /// Dimensionless.
    pub(crate) keep: f64,
    /// \[s\]
    pub(crate) gain: f64,
    /// \[s\]
    pub(crate) h: f64,
    /// \[m/s\]; infinite for none.
    pub(crate) speed_limit: f64,
}

/// Ranges of the pair forces of eight particles.
#[derive(Clone, Debug)]
struct LaneSlice {
    springs: Range<usize>,
    straight: Range<usize>,
}

/// Particles, pair forces and motion, laid out for the step.
pub(crate) struct Kernel {
    /// The particle in each place; places beyond the last particle hold none.
    particle: Vec<usize>,
    slices: Vec<LaneSlice>,
    /// Pair forces with a root to take: the places of the other ends, and their two coefficients.
    spring_ends: Vec<[u32; LANES]>,
    springs: Vec<[Lanes; 2]>,
    /// Pair forces without.
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
    /// Lays out `pair_forces` for particles of these masses \[kg\]; `more_forces` if other forces
    /// will be handed in at each step.
    pub(crate) fn new(system: &System<'_>, pair_forces: &PairForces, more_forces: bool) -> Self {
        let (mass, is_fixed) = (&system.mass, &system.is_fixed);
        let rows = PairRows::new(&pair_forces.merged(), mass.len());
        let particle = rows.order();
        let places = particle.len().next_multiple_of(LANES);
        let mobility = (0..places / LANES)
            .map(|slice| {
                lanes(|lane| match particle.get(slice * LANES + lane) {
                    Some(&p) if !is_fixed[p] => 1.0 / mass[p],
                    _ => 0.0,
                })
            })
            .collect();
        let gravity = shared_acceleration(&pair_forces.constant, mass);
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
            free_axis: std::array::from_fn(|axis| f64::from(system.fixed_axis != Some(axis))),
            push: vec![[[0.0; LANES]; 3]; if pushed { places / LANES } else { 0 }],
            constant_push: match gravity {
                Some(_) => Vec::new(),
                None => pair_forces.constant.clone(),
            },
            arch: Arch::new(),
            particle,
        };
        kernel.lay_out(&rows);
        kernel.set_push(&vec![Vector3::zeros(); mass.len()]);
        kernel
    }

    fn lay_out(&mut self, rows: &PairRows) {
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
                    // A lane that has no more neighbors is its own, and pulls by nothing.
                    let ends = std::array::from_fn(|lane| {
                        row(lane).get(k).map_or_else(
                            || u32::try_from(first + lane).unwrap_or(u32::MAX),
                            |end| place[end.b],
                        )
                    });
                    let part =
                        |get: fn(&PairForce) -> f64| lanes(|l| row(l).get(k).map_or(0.0, get));
                    if kind == 0 {
                        self.spring_ends.push(ends);
                        self.springs
                            .push([part(|e| e.stiffness), part(|e| e.stiffness_times_rest)]);
                    } else {
                        self.straight_ends.push(ends);
                        self.straight.push(part(|e| e.stiffness));
                    }
                }
            }
            self.slices.push(LaneSlice {
                springs: springs..self.springs.len(),
                straight: straight..self.straight.len(),
            });
        }
    }

    /// Copies positions and velocities from `x` and `v`; held particles stand still.
    pub(crate) fn load(&mut self, x: &[Vector3<f64>], v: &[Vector3<f64>]) {
        for (place, &p) in self.particle.iter().enumerate() {
            let (slice, lane) = (place / LANES, place % LANES);
            self.x[place][..3].copy_from_slice(x[p].as_slice());
            let free = self.mobility[slice][lane] > 0.0;
            for (lanes, v) in self.v[slice].iter_mut().zip(v[p].iter()) {
                lanes[lane] = if free { *v } else { 0.0 };
            }
        }
    }

    /// Copies positions to `x`.
    pub(crate) fn positions(&self, x: &mut [Vector3<f64>]) {
        for (&p, from) in self.particle.iter().zip(&self.x) {
            x[p].copy_from_slice(&from[..3]);
        }
    }

    /// Copies velocities to `v`.
    pub(crate) fn velocities(&self, v: &mut [Vector3<f64>]) {
        for (place, &p) in self.particle.iter().enumerate() {
            let lanes = &self.v[place / LANES];
            v[p] = Vector3::from_fn(|axis, _| lanes[axis][place % LANES]);
        }
    }

    /// Sets the forces on particles besides pair forces and gravity in the next step \[N\].
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

    /// Returns the operations of a step: a root and a division count as eight each.
    pub(crate) fn operations(&self) -> f64 {
        let lanes = LANES as f64;
        lanes
            * (32.0 * self.springs.len() as f64
                + 9.0 * self.straight.len() as f64
                + 20.0 * self.slices.len() as f64)
    }

    /// Returns the bytes of all arrays that a step reads or writes, each counted once.
    pub(crate) fn bytes(&self) -> usize {
        let slices = self.v.len();
        size_of::<[u32; LANES]>() * (self.spring_ends.len() + self.straight_ends.len())
            + size_of::<Lanes>() * (2 * self.springs.len() + self.straight.len())
            + size_of::<[f64; 4]>() * (self.x.len() + self.x_next.len())
            + size_of::<[Lanes; 3]>() * (slices + self.push.len())
            + (size_of::<Lanes>() + size_of::<LaneSlice>()) * slices
    }
}

fn lanes(value: impl Fn(usize) -> f64) -> Lanes {
    std::array::from_fn(value)
}

/// Returns the acceleration that `push` is for every particle, if it is the same one.
fn shared_acceleration(push: &[Vector3<f64>], mass: &[f64]) -> Option<Vector3<f64>> {
    let first = push.first()? / *mass.first()?;
    let same = |(f, m): (&Vector3<f64>, &f64)| (f - first * *m).norm() <= SAME * f.norm();
    push.iter().zip(mass).all(same).then_some(first)
}

#[cfg(test)]
mod tests;
