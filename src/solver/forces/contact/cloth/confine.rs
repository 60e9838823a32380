//! Moves cut short where cloth would pass through cloth.

use super::advance::free_share;
use super::candidates::Candidates;
use nalgebra::Vector3;

/// Passes over the pairs in which a move is cut as far as a pair needs; in those that follow, what
/// still would meet does not move at all.
const CUTS: usize = 12;
/// Share of a pair's distance that its particles may take up without a closer look.
const TAKEN: f64 = 0.9;

/// Cuts each particle's move from `from` to `to` so that no pair of `active` candidates meets on
/// the way, which is straight for each.
///
/// A particle is cut for the pairs that it belongs to, and no other: the whole garment does not
/// stop for one of them.
pub(super) fn confine(
    candidates: &Candidates,
    active: &[usize],
    from: &[Vector3<f64>],
    to: &mut [Vector3<f64>],
) {
    let displacement: Vec<_> = from.iter().zip(&*to).map(|(a, b)| b - a).collect();
    let length: Vec<f64> = displacement.iter().map(Vector3::norm).collect();
    let moved = candidates.moved(from);
    let may_meet = |&&k: &&usize| {
        let pair = &candidates.pairs[k];
        TAKEN * (pair.distance - pair.approach(&moved)) <= pair.approach(&length)
    };
    let near: Vec<usize> = active.iter().filter(may_meet).copied().collect();
    let mut share = vec![1.0; from.len()];
    let mut was_cut = vec![true; from.len()];
    // Ends: once a pass is past CUTS, it stops a particle for good or is the last.
    for pass in 0.. {
        let mut is_cut = vec![false; from.len()];
        for &k in &near {
            let pair = &candidates.pairs[k];
            if !pair.corners.iter().any(|&i| was_cut[i]) {
                continue;
            }
            let moves = pair.corners.map(|i| displacement[i] * share[i]);
            let free = free_share(pair.features, &pair.gather(from), &moves);
            if free < 1.0 {
                let free = if pass < CUTS { free } else { 0.0 };
                for i in pair.corners {
                    share[i] *= free;
                    is_cut[i] = true;
                }
            }
        }
        if !is_cut.contains(&true) {
            break;
        }
        was_cut = is_cut;
    }
    for (i, x) in to.iter_mut().enumerate().filter(|(i, _)| share[*i] < 1.0) {
        *x = from[i] + displacement[i] * share[i];
    }
}
