//! Pleats by seams: cloth that is folded over on the edge it is sewn to.
//!
//! Of the plies of a fold every second one lies wrong side up, so that it would contradict the
//! faces of its panels without a twist.

use super::parity::{FaceRelation, ParityUnionFind};
use super::seam_sides::{SeamSide, SeamSideEnd, SeamSides};
use super::{RoutedSeam, routed_seam};
use crate::pattern::{Match, Pattern, SeamPair};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// Of plies whose faces are as those of the base and plies with opposite ones, the upper are those
/// that are longer together, by at least this share: far above rounding, below the ease of a seam.
const MAJORITY_SHARE: f64 = 0.01;

/// Sides of seams in a pleat that lie wrong side up, by position of the seam in the request and
/// index of its matched pair of stretches.
pub(super) type FoldedPairs = BTreeSet<(usize, usize)>;

/// A chain of plies that go on from one to the next, and the panels of cloth and base.
type PleatKey = (usize, usize, usize);

/// Returns the plies of folds that lie wrong side up, with seams as picked.
pub(super) fn find(pattern: &Pattern, pairs: &[SeamPair], seams: &[RoutedSeam]) -> FoldedPairs {
    find_in(pattern, pairs, seams.iter().map(Cow::Borrowed))
}

/// Returns the plies of folds that lie wrong side up where layered seams that have none in `picked`
/// are reversed: those of such seams alone.
pub(super) fn find_reversed(
    pattern: &Pattern,
    pairs: &[SeamPair],
    seams: &[RoutedSeam],
    picked: &FoldedPairs,
) -> FoldedPairs {
    let is_reversed =
        |seam: &RoutedSeam| pairs[seam.index].layered && !is_folded(picked, seam.index);
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
pub(super) fn is_folded(folded: &FoldedPairs, seam: usize) -> bool {
    folded
        .range((seam, 0)..=(seam, usize::MAX))
        .next()
        .is_some()
}

fn find_in<'a>(
    pattern: &Pattern,
    pairs: &[SeamPair],
    seams: impl Iterator<Item = Cow<'a, RoutedSeam>>,
) -> FoldedPairs {
    if !pairs.iter().any(|pair| pair.layered) {
        return FoldedPairs::new();
    }
    let sides = SeamSides::new(pattern, seams);
    let mut chains = ParityUnionFind::new(sides.sides.len());
    let mut folded = BTreeSet::new();
    for [(i, one), (j, other)] in sides.meeting_ends() {
        let both = [i, j].map(|ply| &sides.sides[ply]);
        let is_open = both.iter().all(|ply| is_auto(&pairs[ply.seam]));
        if is_open || !both[0].has_base_track_of(both[1]) || !is_continued(&one, &other) {
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
    if folded.is_empty() {
        return FoldedPairs::new();
    }
    let upper_relations = upper_relations(pattern, &sides, &mut chains);
    let mut wrong = FoldedPairs::new();
    for i in folded {
        let ply = &sides.sides[i];
        let upper = upper_relations
            .get(&chain_key(&mut chains, &sides, i))
            .copied();
        let is_wrong = match (face_relation(pattern, ply), upper.flatten()) {
            (Some(own), Some(upper)) => own != upper,
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
fn is_continued(one: &SeamSideEnd, other: &SeamSideEnd) -> bool {
    one.base_node == other.base_node
        && one.cloth_ahead != other.cloth_ahead
        && one.base_node != one.cloth_node
}

/// Returns the relation of faces that a ply has: the same, or opposite.
fn face_relation(pattern: &Pattern, ply: &SeamSide) -> Option<bool> {
    let relations = routed_seam::face_relations(pattern, &[[ply.cloth, ply.base]]);
    relations.first().map(|relation| relation.same)
}

fn chain_key(chains: &mut ParityUnionFind, sides: &SeamSides, ply: usize) -> PleatKey {
    let (head, _) = chains.find(ply);
    let ply = &sides.sides[ply];
    (head, ply.cloth.panel, ply.base.panel)
}

/// Returns the relation of the longer part of the cloth by chain and panels; nothing where both
/// parts are as long.
fn upper_relations(
    pattern: &Pattern,
    sides: &SeamSides,
    chains: &mut ParityUnionFind,
) -> BTreeMap<PleatKey, Option<bool>> {
    let mut lengths: BTreeMap<PleatKey, [f64; 2]> = BTreeMap::new();
    for (i, ply) in sides.sides.iter().enumerate() {
        if let Some(same) = face_relation(pattern, ply) {
            let key = chain_key(chains, sides, i);
            lengths.entry(key).or_default()[usize::from(same)] += ply.cloth.length(pattern);
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
