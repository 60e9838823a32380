//! Pleats by seams: cloth that is folded over on the edge it is sewn to.
//!
//! Of the plies of a fold every second one lies wrong side up, so that it would contradict the
//! faces of its panels without a twist.

use super::parity::{FaceRelation, ParityUnionFind};
use super::plies::{Plies, Ply, PlyEnd};
use super::{RoutedSeam, routed_seam};
use crate::pattern::{Match, Pattern, SeamPair};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// Ends of plies at one point that each is compared with: more than any pleat lays there, and a
/// bound on the work.
const MAX_NEIGHBORS: usize = 32;

/// Share by which the plies of one way must be longer in sum than those of the other to be taken
/// for the upper side: far above rounding, and below the ease of a seam.
const MAJORITY_SHARE: f64 = 0.01;

/// Plies that lie wrong side up, by position of the seam in the request and index of its matched
/// pair of stretches.
pub(super) type FoldedPlies = BTreeSet<(usize, usize)>;

/// A chain of plies that go on from one to the next, and the panels of cloth and base.
type ChainKey = (usize, usize, usize);

/// Returns the plies of folds that lie wrong side up, with seams as picked.
pub(super) fn find(pattern: &Pattern, pairs: &[SeamPair], seams: &[RoutedSeam]) -> FoldedPlies {
    find_in(pattern, pairs, seams.iter().map(Cow::Borrowed))
}

/// Returns the same with those layered seams reversed that have no ply in `picked`.
pub(super) fn find_reversed(
    pattern: &Pattern,
    pairs: &[SeamPair],
    seams: &[RoutedSeam],
    picked: &FoldedPlies,
) -> FoldedPlies {
    let is_reversed = |seam: &RoutedSeam| pairs[seam.index].layered && !has_ply(picked, seam.index);
    let order = |seam| match is_reversed(seam) {
        true => Cow::Owned(seam.reversed()),
        false => Cow::Borrowed(seam),
    };
    let mut found = find_in(pattern, pairs, seams.iter().map(order));
    let reversed: BTreeSet<usize> = seams
        .iter()
        .filter(|seam| is_reversed(seam))
        .map(|seam| seam.index)
        .collect();
    found.retain(|(seam, _)| reversed.contains(seam));
    found
}

/// Returns true if a ply of this seam lies wrong side up.
pub(super) fn has_ply(folded: &FoldedPlies, seam: usize) -> bool {
    folded
        .range((seam, 0)..=(seam, usize::MAX))
        .next()
        .is_some()
}

fn find_in<'a>(
    pattern: &Pattern,
    pairs: &[SeamPair],
    seams: impl Iterator<Item = Cow<'a, RoutedSeam>>,
) -> FoldedPlies {
    if !pairs.iter().any(|pair| pair.layered) {
        return FoldedPlies::new();
    }
    let plies = Plies::new(pattern, seams);
    let mut chains = ParityUnionFind::new(plies.plies.len());
    let mut folded = BTreeSet::new();
    for ends in plies.ends_by_cloth_node() {
        for (position, &(i, one)) in ends.iter().enumerate() {
            for &(j, other) in ends.iter().skip(position + 1).take(MAX_NEIGHBORS) {
                let both = [i, j].map(|ply| &plies.plies[ply]);
                let is_open = both.iter().all(|ply| is_auto(&pairs[ply.seam]));
                if is_open || !both[0].has_base_track_of(both[1]) || !goes_on(&one, &other) {
                    continue;
                }
                chains.join(FaceRelation {
                    ends: [i, j],
                    same: true,
                });
                if one.base_ahead == other.base_ahead {
                    folded.extend([i, j]);
                }
            }
        }
    }
    if folded.is_empty() {
        return FoldedPlies::new();
    }
    let upper_ways = upper_ways(pattern, &plies, &mut chains);
    let mut wrong = FoldedPlies::new();
    for i in folded {
        let ply = &plies.plies[i];
        let upper = upper_ways.get(&chain_key(&mut chains, &plies, i)).copied();
        let is_wrong = match (way(pattern, ply), upper.flatten()) {
            (Some(way), Some(upper)) => way != upper,
            (Some(_), None) => pairs[ply.seam].layered,
            (None, _) => false,
        };
        if is_wrong {
            wrong.insert((ply.seam, ply.pair));
        }
    }
    wrong
}

/// Returns true if the order of a seam is open: two such say nothing about each other.
fn is_auto(pair: &SeamPair) -> bool {
    pair.matching == Match::Auto
}

/// Returns true if the cloth goes on from one ply to the other, at one point of the base: beside it
/// there, or folded back.
fn goes_on(one: &PlyEnd, other: &PlyEnd) -> bool {
    one.base_node == other.base_node
        && one.cloth_ahead != other.cloth_ahead
        && one.base_node != one.cloth_node
}

/// Returns the relation of faces that a ply has: the same, or opposite.
fn way(pattern: &Pattern, ply: &Ply) -> Option<bool> {
    let relations = routed_seam::face_relations(pattern, &[[ply.cloth, ply.base]]);
    relations.first().map(|relation| relation.same)
}

fn chain_key(chains: &mut ParityUnionFind, plies: &Plies, ply: usize) -> ChainKey {
    let (head, _) = chains.find(ply);
    let ply = &plies.plies[ply];
    (head, ply.cloth.panel, ply.base.panel)
}

/// Returns the relation of the longer part of the cloth by chain and panels; nothing where both
/// parts are as long.
fn upper_ways(
    pattern: &Pattern,
    plies: &Plies,
    chains: &mut ParityUnionFind,
) -> BTreeMap<ChainKey, Option<bool>> {
    let mut lengths: BTreeMap<ChainKey, [f64; 2]> = BTreeMap::new();
    for (i, ply) in plies.plies.iter().enumerate() {
        if let Some(way) = way(pattern, ply) {
            let key = chain_key(chains, plies, i);
            lengths.entry(key).or_default()[usize::from(way)] += ply.cloth.length(pattern);
        }
    }
    let longer = |[opposite, same]: [f64; 2]| {
        let is_plain = (same - opposite).abs() > MAJORITY_SHARE * same.max(opposite);
        is_plain.then_some(same > opposite)
    };
    lengths
        .into_iter()
        .map(|(key, both)| (key, longer(both)))
        .collect()
}
