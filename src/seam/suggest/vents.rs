//! Vents of jackets: underlaps at the lower end of a seam, which stay open. The outline steps out
//! of the seam and runs beside it down to the hem.

use std::ops::RangeInclusive;

/// Width of the step \[m\].
const STEP_M: RangeInclusive<f64> = 0.01..=0.08;
/// Length of the underlap \[m\].
const UNDERLAP_M: RangeInclusive<f64> = 0.03..=0.3;
/// The outline turns by at least this at the corners of the step and at the hem \[rad\].
const MIN_CORNER: f64 = 0.7;
/// Most edges of an underlap.
const MAX_EDGES: usize = 4;

/// The edges of a vent, one after another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Vent {
    pub(super) first: usize,
    pub(super) count: usize,
}

/// Returns the vents of an outline by the lengths of its edges \[m\] and the turn where each
/// begins, positive where the outline is convex \[rad\].
pub(super) fn vents(lengths: &[f64], turns: &[f64]) -> Vec<Vent> {
    let count = lengths.len();
    let inward = (0..count).filter(|corner| turns[*corner] <= -MIN_CORNER);
    inward
        .flat_map(|corner| {
            let ahead = underlap(count, |k| {
                let edge = (corner + k) % count;
                (lengths[edge], turns[(edge + 1) % count])
            });
            let back = underlap(count, |k| {
                let edge = (corner + 2 * count - 1 - k) % count;
                (lengths[edge], turns[edge])
            });
            let first = back.map(|edges| (corner + count - edges) % count);
            [ahead.map(|edges| (corner, edges)), first.zip(back)]
        })
        .flatten()
        .map(|(first, count)| Vent { first, count })
        .collect()
}

/// Returns the number of edges of the vent that begins at a corner, by the lengths of the edges
/// from there on and the turns where they end.
fn underlap(count: usize, edge: impl Fn(usize) -> (f64, f64)) -> Option<usize> {
    let (step, turn) = edge(0);
    if !STEP_M.contains(&step) || turn < MIN_CORNER {
        return None;
    }
    let mut long = 0.0;
    for k in 1..=MAX_EDGES.min(count - 1) {
        let (length, turn) = edge(k);
        long += length;
        if turn >= MIN_CORNER {
            return UNDERLAP_M.contains(&long).then_some(k + 1);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// A strip whose seam on the right, or on the left, ends in a vent of 30 by 100 mm.
    #[test]
    fn vents_are_found_on_both_sides() {
        let right = [0.6, 0.2, 0.5, 0.03, 0.1, 0.23];
        let turns = [1.0, 1.0, 1.0, -1.0, 1.0, 1.0].map(|turn| turn * FRAC_PI_2);
        assert_eq!(vents(&right, &turns), [Vent { first: 3, count: 2 }]);
        let left = [0.1, 0.03, 0.5, 0.2, 0.6, 0.23];
        let turns = [1.0, 1.0, -1.0, 1.0, 1.0, 1.0].map(|turn| turn * FRAC_PI_2);
        assert_eq!(vents(&left, &turns), [Vent { first: 0, count: 2 }]);
        let wide = [0.6, 0.2, 0.5, 0.1, 0.1, 0.3];
        let turns = [1.0, 1.0, 1.0, -1.0, 1.0, 1.0].map(|turn| turn * FRAC_PI_2);
        assert_eq!(vents(&wide, &turns), []);
    }
}
