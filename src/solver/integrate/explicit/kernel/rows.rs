//! The pair forces of each particle in one row, and an order in which particles next to each other
//! have about as many.

use crate::solver::forces::PairForce;

/// Particles among which those of like counts are put together; few enough to stay neighbors in
/// memory.
const WINDOW: usize = 256;

/// The pair forces of each particle, from its own end: springs first.
pub(crate) struct PairRows {
    start: Vec<[usize; 2]>,
    ends: Vec<PairForce>,
}

impl PairRows {
    pub(crate) fn new(links: &[PairForce], particle_count: usize) -> Self {
        let mut ends: Vec<PairForce> = links
            .iter()
            .flat_map(|&link| {
                [
                    link,
                    PairForce {
                        a: link.b,
                        b: link.a,
                        ..link
                    },
                ]
            })
            .collect();
        ends.sort_by_key(|end| (end.a, end.stiffness_times_rest == 0.0, end.b));
        let mut start = Vec::with_capacity(particle_count + 1);
        let mut k = 0;
        for p in 0..particle_count {
            let first = k;
            while k < ends.len() && ends[k].a == p && ends[k].stiffness_times_rest != 0.0 {
                k += 1;
            }
            start.push([first, k]);
            while k < ends.len() && ends[k].a == p {
                k += 1;
            }
        }
        start.push([k, k]);
        Self { start, ends }
    }

    /// Returns the springs (`kind` 0) or the pair forces without a root (1) of particle `p`.
    pub(crate) fn of(&self, p: usize, kind: usize) -> &[PairForce] {
        let [springs, straight] = self.start[p];
        match kind {
            0 => &self.ends[springs..straight],
            _ => &self.ends[straight..self.start[p + 1][0]],
        }
    }

    /// Particles in their own order, but those of like counts together within each window.
    pub(crate) fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.start.len() - 1).collect();
        for window in order.chunks_mut(WINDOW) {
            window.sort_by_key(|&p| (self.of(p, 0).len(), self.of(p, 1).len()));
        }
        order
    }
}
