//! Ends of open chains in pairs, the nearest first, and the chains joined by them.

use super::chain::PathChain;
use super::free_ends::FreeEnds;
use super::gap::Gap;
use crate::pattern::Point2;
use crate::pattern::point::distance;
use crate::pattern::polyline::length;

/// At most this many open chains are compared with each other.
const COMPARED: usize = 100;

/// Ends of two chains are of one outline if the gap is at most this share of the shorter one.
const GAP_SHARE: f64 = 0.5;

/// Two ends that may be joined. End `2 i` is the head of part `i`, end `2 i + 1` its tail.
struct EndPair {
    gap: f64,
    ends: [usize; 2],
}

/// The partner of each end.
pub(super) struct EndPairs {
    partners: Vec<Option<usize>>,
}

impl EndPairs {
    /// Returns no pairs of the ends of `count` parts.
    pub(super) fn none(count: usize) -> Self {
        Self {
            partners: vec![None; 2 * count],
        }
    }

    /// Pairs the ends of open parts that lie within `tolerance` of each other \[m\].
    pub(super) fn within(tolerance: f64, parts: &[PathChain]) -> Self {
        let mut free = FreeEnds::new(parts, tolerance);
        let mut pairs = Vec::new();
        for end in open_ends(parts, parts.len()) {
            let Some(p) = point(parts, end) else {
                continue;
            };
            for near in free.near(p, parts) {
                let other = 2 * near.part + usize::from(!near.is_head);
                if end < other && may_pair(parts, end, other) {
                    pairs.push(EndPair {
                        gap: near.gap,
                        ends: [end, other],
                    });
                }
            }
        }
        Self::nearest_first(pairs, parts.len())
    }

    /// Pairs the ends of open parts, however far they lie from each other: those of one outline.
    pub(super) fn of_outlines(parts: &[PathChain]) -> Self {
        let lengths: Vec<f64> = parts.iter().map(|part| length(&part.points)).collect();
        let ends: Vec<usize> = open_ends(parts, COMPARED).collect();
        let mut pairs = Vec::new();
        for (i, &a) in ends.iter().enumerate() {
            for &b in &ends[i + 1..] {
                let (Some(p), Some(q)) = (point(parts, a), point(parts, b)) else {
                    continue;
                };
                let gap = distance(p, q);
                let shorter = lengths[a / 2].min(lengths[b / 2]);
                if gap <= GAP_SHARE * shorter && may_pair(parts, a, b) {
                    pairs.push(EndPair { gap, ends: [a, b] });
                }
            }
        }
        Self::nearest_first(pairs, parts.len())
    }

    /// Takes pairs from the nearest on, those with an end that is taken left out.
    fn nearest_first(mut pairs: Vec<EndPair>, part_count: usize) -> Self {
        let mut taken = Self::none(part_count);
        pairs.sort_by(|a, b| a.gap.total_cmp(&b.gap).then(a.ends.cmp(&b.ends)));
        for EndPair { ends: [a, b], .. } in pairs {
            if taken.partners[a].is_none() && taken.partners[b].is_none() {
                taken.partners[a] = Some(b);
                taken.partners[b] = Some(a);
            }
        }
        taken
    }

    /// Joins parts at the pairs, each chain in the place of its first part.
    pub(super) fn join(&self, parts: Vec<PathChain>) -> Vec<PathChain> {
        let mut is_taken = vec![false; parts.len()];
        let mut joined = Vec::new();
        for i in 0..parts.len() {
            if std::mem::replace(&mut is_taken[i], true) {
                continue;
            }
            let mut chain = parts[i].clone();
            if !parts[i].closed {
                self.grow(&mut chain, 2 * i + 1, &parts, &mut is_taken);
            }
            if !chain.closed {
                chain.reverse();
                self.grow(&mut chain, 2 * i, &parts, &mut is_taken);
                chain.reverse();
            }
            joined.push(chain);
        }
        joined
    }

    /// Adds parts to a chain from its last end on, until it closes or the end has no partner.
    fn grow(&self, chain: &mut PathChain, from: usize, parts: &[PathChain], is_taken: &mut [bool]) {
        let mut end = from;
        while let Some(next) = self.partners[end] {
            let (Some(p), Some(q)) = (point(parts, end), point(parts, next)) else {
                return;
            };
            let gap = Gap { ends: [p, q] };
            if std::mem::replace(&mut is_taken[next / 2], true) {
                chain.close(gap);
                return;
            }
            let mut part = parts[next / 2].clone();
            if !next.is_multiple_of(2) {
                part.reverse();
            }
            chain.append(&part, gap);
            end = next ^ 1;
        }
    }
}

/// Returns the ends of the first `count` open parts.
fn open_ends(parts: &[PathChain], count: usize) -> impl Iterator<Item = usize> {
    let open = parts.iter().enumerate().filter(|(_, part)| !part.closed);
    open.take(count).flat_map(|(i, _)| [2 * i, 2 * i + 1])
}

fn point(parts: &[PathChain], end: usize) -> Option<Point2> {
    let points = &parts[end / 2].points;
    let found = if end.is_multiple_of(2) {
        points.first()
    } else {
        points.last()
    };
    found.copied()
}

/// Returns true if two ends are of different parts, or of one that has an area if it is closed.
fn may_pair(parts: &[PathChain], a: usize, b: usize) -> bool {
    a / 2 != b / 2 || parts[a / 2].points.len() > 2
}
