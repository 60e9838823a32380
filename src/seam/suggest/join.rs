//! Lays two chains of edges along each other and splits them where corners of both meet.

use super::edge_chain::{EdgeChain, EdgeStep, length};

/// Corners count as meeting up to this share of the whole length, or this distance \[m\].
const TOLERANCE_SHARE: f64 = 0.012;
const TOLERANCE_M: f64 = 0.004;
/// A closed seam may begin this share of its length away from where it is expected before that
/// counts like a corner missed.
const USUAL_OFFSET: f64 = 0.06;
/// Closed seams of more corners than this, those of both sides multiplied, are not turned: each way
/// costs their product again.
const MAX_ROTATIONS: usize = 2_500;

/// Two chains of edges that are sewn together, beginning at the same point.
pub(super) type JoinedParts = [EdgeChain; 2];

/// Splits two chains that begin and end together wherever a corner of the one meets a corner of the
/// other.
pub(super) fn split_at_corners(a: &[EdgeStep], b: &[EdgeStep]) -> Vec<JoinedParts> {
    let cuts = matching_corners(&corners(a), &corners(b), tolerance(a, b));
    let mut parts = vec![];
    let mut from = [0, 0];
    for to in cuts.into_iter().chain([[a.len(), b.len()]]) {
        parts.push([a[from[0]..to[0]].to_vec(), b[from[1]..to[1]].to_vec()]);
        from = to;
    }
    parts
}

/// Splits two closed chains, which are expected to begin together but may be rotated against each
/// other where their corners then meet better.
pub(super) fn split_ring(a: &[EdgeStep], b: &[EdgeStep]) -> Vec<JoinedParts> {
    split_rotated(a, b, USUAL_OFFSET)
}

/// Splits two closed chains of which it is not known how they lie against each other.
pub(super) fn split_free_ring(a: &[EdgeStep], b: &[EdgeStep]) -> Vec<JoinedParts> {
    split_rotated(a, b, f64::INFINITY)
}

fn split_rotated(a: &[EdgeStep], b: &[EdgeStep], usual: f64) -> Vec<JoinedParts> {
    let (at_a, at_b) = (corners(a), corners(b));
    let tolerance = tolerance(a, b);
    let mut best = (score(&at_a, &at_b, 0.0, tolerance), 0, 0);
    let few = a.len() * b.len() <= MAX_ROTATIONS;
    for i in (0..a.len()).filter(|_| few) {
        for j in 0..b.len() {
            let start = |at: &[f64], k: usize| if k == 0 { 0.0 } else { at[k - 1] };
            let away = start(&at_a, i) - start(&at_b, j);
            let away = (away + 0.5).rem_euclid(1.0) - 0.5;
            let (rotated_a, rotated_b) = (rotated(a, i), rotated(b, j));
            let found = score(
                &corners(&rotated_a),
                &corners(&rotated_b),
                away / usual,
                tolerance,
            );
            if found > best.0 + 1e-9 {
                best = (found, i, j);
            }
        }
    }
    split_at_corners(&rotated(a, best.1), &rotated(b, best.2))
}

/// Returns how well the corners of two chains meet: the number that do, less the square of how
/// unusual their beginning is.
pub(super) fn score(a: &[f64], b: &[f64], away: f64, tolerance: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a handful of corners")]
    let met = matching_corners(a, b, tolerance).len() as f64;
    met - away.powi(2)
}

/// Returns how well the corners of two chains meet as they are.
pub(super) fn agreement(a: &[EdgeStep], b: &[EdgeStep]) -> f64 {
    score(&corners(a), &corners(b), 0.0, tolerance(a, b))
}

fn rotated(chain: &[EdgeStep], start: usize) -> EdgeChain {
    chain[start..]
        .iter()
        .chain(&chain[..start])
        .copied()
        .collect()
}

/// Returns the positions of the inner corners of a chain, as fractions of its length.
fn corners(chain: &[EdgeStep]) -> Vec<f64> {
    let whole = length(chain).max(f64::MIN_POSITIVE);
    let mut so_far = 0.0;
    let mut at: Vec<f64> = vec![];
    for step in chain {
        so_far += step.length;
        at.push(so_far / whole);
    }
    at.pop();
    at
}

fn tolerance(a: &[EdgeStep], b: &[EdgeStep]) -> f64 {
    let shorter = length(a).min(length(b)).max(f64::MIN_POSITIVE);
    TOLERANCE_SHARE.max(TOLERANCE_M / shorter).min(0.1)
}

/// Returns pairs of corners each of which is the nearest of the other, as numbers of steps before
/// them.
fn matching_corners(a: &[f64], b: &[f64], tolerance: f64) -> Vec<[usize; 2]> {
    let nearest = |x: f64, of: &[f64]| {
        (0..of.len()).min_by(|i, j| (of[*i] - x).abs().total_cmp(&(of[*j] - x).abs()))
    };
    let mut found: Vec<[usize; 2]> = vec![];
    for (i, x) in a.iter().enumerate() {
        let Some(j) = nearest(*x, b) else { continue };
        let ordered = found.last().is_none_or(|last| last[1] < j + 1);
        if (b[j] - x).abs() <= tolerance && nearest(b[j], a) == Some(i) && ordered {
            found.push([i + 1, j + 1]);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(panel: usize, lengths: &[f64]) -> EdgeChain {
        let step = |(edge, &length): (usize, &f64)| EdgeStep {
            panel,
            hole: None,
            edge,
            forward: true,
            length,
            span: crate::seam::suggest::edge_chain::WHOLE,
        };
        lengths.iter().enumerate().map(step).collect()
    }

    fn lengths(joints: &[JoinedParts]) -> Vec<[usize; 2]> {
        joints.iter().map(|j| [j[0].len(), j[1].len()]).collect()
    }

    #[test]
    fn chains_part_where_corners_meet() {
        let joints = split_at_corners(&chain(0, &[0.2, 0.1, 0.3]), &chain(1, &[0.3, 0.31]));
        assert_eq!(lengths(&joints), [[2, 1], [1, 1]]);
    }

    #[test]
    fn closed_chains_turn_until_corners_meet() {
        let a = chain(0, &[0.01, 0.30, 0.29]);
        let b = chain(1, &[0.30, 0.29, 0.01]);
        let joints = split_ring(&a, &b);
        assert_eq!(lengths(&joints), [[1, 1], [1, 1], [1, 1]]);
        for [a, b] in joints {
            assert!((a[0].length - b[0].length).abs() < 1e-12);
        }
    }
}
