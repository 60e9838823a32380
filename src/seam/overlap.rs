//! Stretches that are sewn twice: seams that lie over one another, and seams sewn to themselves.

use super::place::snap_distance;
use super::{RoutedSeam, Stretch, Track};
use crate::fault::{Fault, SeamCode};
use crate::pattern::{Pattern, SeamPair};
use std::collections::{BTreeMap, BTreeSet};

/// A stretch that a seam covers, in whichever direction.
#[derive(Clone, Copy)]
struct Coverage<'a> {
    low: f64,
    high: f64,
    seam: usize,
    side: usize,
    pointer: &'a str,
}

/// Returns faults by index of the seam that they are about: the later one where two lie over one
/// another.
pub(super) fn find_faults(
    pattern: &Pattern,
    pairs: &[SeamPair],
    seams: &[RoutedSeam],
) -> Vec<(usize, Fault)> {
    let mut found = vec![];
    for seam in seams {
        let mut reported = BTreeSet::new();
        for [one, other] in overlaps(pattern, coverages(seam)) {
            if reported.insert((one.side, other.side)) {
                found.push((seam.index, self_overlap_fault(pattern, pairs, one, other)));
            }
        }
    }
    let plain = seams.iter().filter(|seam| !pairs[seam.index].layered);
    let mut reported = BTreeSet::new();
    for [one, other] in overlaps(pattern, plain.flat_map(coverages)) {
        let (earlier, later) = if one.seam < other.seam {
            (one, other)
        } else {
            (other, one)
        };
        if earlier.seam != later.seam && reported.insert((earlier.seam, later.seam)) {
            found.push((later.seam, overlap_fault(pairs, earlier, later)));
        }
    }
    found
}

/// Panel, track and edge.
type EdgeKey = (usize, Track, usize);

type EdgeCoverage<'a> = (EdgeKey, Coverage<'a>);

fn coverages(seam: &RoutedSeam) -> impl Iterator<Item = EdgeCoverage<'_>> {
    seam.sides.iter().enumerate().flat_map(move |(side, runs)| {
        runs.iter().flat_map(move |run| {
            let pointer = run.pointer.as_str();
            run.stretches.iter().map(
                move |&Stretch {
                          panel,
                          track,
                          edge,
                          from,
                          to,
                      }| {
                    let (low, high) = (from.min(to), from.max(to));
                    (
                        (panel, track, edge),
                        Coverage {
                            low,
                            high,
                            seam: seam.index,
                            side,
                            pointer,
                        },
                    )
                },
            )
        })
    })
}

/// Returns pairs of coverages of one edge that share more than a point. Each is compared with the
/// one before it that reaches farthest, so there are at most as many pairs as coverages.
fn overlaps<'a>(
    pattern: &Pattern,
    coverages: impl Iterator<Item = EdgeCoverage<'a>>,
) -> Vec<[Coverage<'a>; 2]> {
    let mut by_edge: BTreeMap<EdgeKey, Vec<Coverage<'a>>> = BTreeMap::new();
    for (edge, coverage) in coverages {
        by_edge.entry(edge).or_default().push(coverage);
    }
    let mut found = vec![];
    for ((panel, track, edge), mut coverages) in by_edge {
        coverages.sort_by(|a, b| a.low.total_cmp(&b.low));
        let length = track.length(&pattern.panels[panel], edge);
        let touching = snap_distance(length) / length;
        let mut farthest = coverages[0];
        for &coverage in &coverages[1..] {
            if coverage.low < farthest.high - touching {
                found.push([farthest, coverage]);
            }
            if coverage.high > farthest.high {
                farthest = coverage;
            }
        }
    }
    found
}

fn self_overlap_fault(
    pattern: &Pattern,
    pairs: &[SeamPair],
    one: Coverage<'_>,
    other: Coverage<'_>,
) -> Fault {
    let pair = &pairs[one.seam];
    let name = |coverage: Coverage<'_>| if coverage.side == 0 { "a" } else { "b" };
    if one.side == other.side {
        return Fault::new(
            SeamCode::Overlap,
            other.pointer,
            format!(
                "side {} of seam `{}` goes twice over the same stretch",
                name(one),
                pair.id
            ),
        )
        .fix("let each run of the list begin where the one before it ends");
    }
    let later = if one.side > other.side { one } else { other };
    let panel = pair_panel(pattern, pair);
    Fault::new(
        SeamCode::SewnToItself,
        later.pointer,
        format!("seam `{}` sews a stretch of {panel} to itself", pair.id),
    )
    .fix("pick a different edge for side b; to close a folded edge, pick its one half for a and its other half for b")
}

fn pair_panel(pattern: &Pattern, pair: &SeamPair) -> String {
    let run = pair.a.runs().first();
    let index = run.and_then(|run| pattern.panel_index(&run.panel));
    index.map_or_else(
        || "a panel".to_owned(),
        |i| format!("`{}`", pattern.panels[i].id),
    )
}

fn overlap_fault(pairs: &[SeamPair], earlier: Coverage<'_>, later: Coverage<'_>) -> Fault {
    let (first, second) = (&pairs[earlier.seam].id, &pairs[later.seam].id);
    Fault::new(
        SeamCode::Overlap,
        later.pointer,
        format!("seam `{second}` lies over seam `{first}`: the same stretch of edge is sewn twice"),
    )
    .fix(format!(
        "pick another edge, or set `layered` on `{second}` if three plies are to be sewn together there"
    ))
}
