//! Features that nearly meet moved apart, so that contact does not begin with forces without bound.

use super::candidates::Candidates;
use super::confine::confine;
use super::surface::ContactSurface;
use super::swept_boxes::SweptMotion;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Share of the thickness that features are moved apart to.
const APART: f64 = 0.2;
/// Times that they are moved.
const ROUNDS: usize = 10;
/// Distance beside its way that a particle may move \[m\].
const SLACK: f64 = 1e-3;

/// Moves the particles of `x` that are not fixed, where features are much nearer to each other than
/// the cloth is thick.
pub(super) fn separate(surface: &ContactSurface, x: &mut [Vector3<f64>], is_fixed: &[bool]) {
    let mut candidates = Candidates::default();
    for _ in 0..ROUNDS {
        let motion = |to| SweptMotion {
            from: x,
            to,
            slack: SLACK,
        };
        candidates.rebuild(surface, &motion(x));
        let mut to = x.to_vec();
        let moves = moves(&candidates, x, is_fixed);
        if moves.is_empty() {
            return;
        }
        for (i, move_) in moves {
            to[i] += move_;
        }
        candidates.rebuild(surface, &motion(&to));
        let all: Vec<usize> = (0..candidates.pairs.len()).collect();
        confine(&candidates, &all, x, &mut to);
        x.copy_from_slice(&to);
    }
}

/// Returns the moves of particles that are not fixed which part what is too near, each the mean of
/// those that its pairs ask for.
fn moves(
    candidates: &Candidates,
    x: &[Vector3<f64>],
    is_fixed: &[bool],
) -> BTreeMap<usize, Vector3<f64>> {
    let mut moves: BTreeMap<usize, (Vector3<f64>, f64)> = BTreeMap::new();
    for pair in &candidates.pairs {
        let lacking = APART * pair.thickness - pair.distance;
        if lacking <= 0.0 {
            continue;
        }
        let proximity = pair.proximity(x);
        let shares = pair.corners.into_iter().zip(proximity.coefficients);
        let shares = shares.filter(|(i, _)| !is_fixed[*i]);
        let square: f64 = shares.clone().map(|(_, c)| c * c).sum();
        let by = proximity.normal() * (lacking / square);
        for (i, c) in shares.filter(|_| square > 0.0) {
            let (sum, weight) = moves.entry(i).or_default();
            *sum += by * c;
            *weight += c.abs();
        }
    }
    let mean = |(i, (sum, weight)): (usize, (Vector3<f64>, f64))| (i, sum / weight.max(1.0));
    moves.into_iter().map(mean).collect()
}
