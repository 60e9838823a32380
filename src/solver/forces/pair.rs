//! Pair forces: forces between two particles and constant forces.
//!
//! A pair force pulls particle `a` with (`stiffness` - `stiffness_times_rest` / |d|) d, d = xb -
//! xa, and `b` with the opposite. A spring of stiffness k and rest length L is the pair (k, k L). A
//! row of quadratic bending, energy `|sum w_i x_i|² / 2` with `sum w_i = 0`, is the pairs
//! `(-w_i w_j, 0)` of all pairs: its force `-w_i sum w_j x_j` is the same as
//! `-sum w_i w_j (x_j - x_i)`. So springs and bending between the same two particles are one pair,
//! and the differences lose less to rounding than the positions would.

use nalgebra::Vector3;

/// Pair forces and constant forces of the terms that consist of them.
#[derive(Clone, Debug)]
pub(crate) struct PairForces {
    /// In any order; several may join the same two particles.
    pub(crate) pairs: Vec<PairForce>,
    /// Constant force on each particle \[N\]; `#P`.
    pub(crate) constant: Vec<Vector3<f64>>,
}

/// Central force between two particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PairForce {
    pub(crate) a: usize,
    pub(crate) b: usize,
    /// \[N/m\]
    pub(crate) stiffness: f64,
    /// \[N\]
    pub(crate) stiffness_times_rest: f64,
}

impl PairForces {
    /// Returns no forces, for this many particles.
    pub(crate) fn new(particle_count: usize) -> Self {
        Self {
            pairs: Vec::new(),
            constant: vec![Vector3::zeros(); particle_count],
        }
    }

    /// Returns one force for each two particles, the lower index first, in order.
    pub(crate) fn merged(&self) -> Vec<PairForce> {
        let mut pairs: Vec<PairForce> = self
            .pairs
            .iter()
            .filter(|pair| pair.a != pair.b)
            .map(|pair| PairForce {
                a: pair.a.min(pair.b),
                b: pair.a.max(pair.b),
                ..*pair
            })
            .collect();
        // Stable, so that sums are always taken in the same order.
        pairs.sort_by_key(|pair| (pair.a, pair.b));
        pairs.dedup_by(|next, kept| {
            let same = (next.a, next.b) == (kept.a, kept.b);
            if same {
                kept.stiffness += next.stiffness;
                kept.stiffness_times_rest += next.stiffness_times_rest;
            }
            same
        });
        pairs
    }
}
