//! The pass itself: loops over eight lanes, written out so that they become vector instructions.

use crate::solver::integrate::explicit::kernel::{Kernel, LANES, Lanes, StepRule};
use pulp::{Simd, WithSimd};

/// A pass, compiled for each instruction set that the machine may have.
struct KernelPass<'k> {
    kernel: &'k mut Kernel,
    rule: StepRule,
}

impl WithSimd for KernelPass<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) {
        let KernelPass { kernel, rule } = self;
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

/// Returns the differences from the particles at `at` to those at the places `ends`.
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

impl Kernel {
    /// Takes one step.
    pub(crate) fn step(&mut self, rule: StepRule) {
        let arch = self.arch;
        arch.dispatch(KernelPass { kernel: self, rule });
        std::mem::swap(&mut self.x, &mut self.x_next);
    }

    /// Moves every particle once: sums up its pair forces and its push.
    #[inline(always)]
    fn pass<const PUSHED: bool, const LIMITED: bool>(&mut self, rule: StepRule) {
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
                    // A spring of no length has no direction to push in: its scale is finite, and
                    // times 0.
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
