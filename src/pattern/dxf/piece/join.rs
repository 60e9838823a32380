//! Paths joined head to tail: outlines come as several open paths, in file order or in none.
//!
//! Paths whose ends meet are joined first: from each free path on, the one whose end lies nearest,
//! of several the first in the file. Ends that a small gap parts are then joined in pairs, the
//! nearest first.

use super::chain::{JOINED, PathChain};
use super::end_pairs::EndPairs;
use super::free_ends::FreeEnds;
use super::gap::{Gap, REPAIRED};
use crate::pattern::dxf::entity::geometry::EntityPath;

/// Joins paths, each with its line, to as few chains as their ends allow, in the order of the file
/// where several would fit. `repair`: small gaps are closed too, as outlines need it.
pub(super) fn join_paths(paths: &[(&EntityPath, usize)], repair: bool) -> Vec<PathChain> {
    let are_exploded = paths.iter().all(|(path, _)| path.straight);
    let single: Vec<PathChain> = paths
        .iter()
        .filter(|(path, _)| !path.points.is_empty())
        .map(|(path, line)| PathChain::of_path(path, *line))
        .collect();
    let joined = join(&single);
    let pairs = if repair && joined.iter().any(|chain| !chain.closed) {
        EndPairs::within(REPAIRED, &joined)
    } else {
        EndPairs::none(joined.len())
    };
    let mut joined = pairs.join(joined);
    if are_exploded {
        for chain in &mut joined {
            chain.path_end.fill(false);
        }
    }
    joined
}

/// Joins chains whose ends meet.
fn join(parts: &[PathChain]) -> Vec<PathChain> {
    let mut ends = FreeEnds::new(parts, JOINED);
    let mut joined = Vec::new();
    for (i, part) in parts.iter().enumerate() {
        if part.closed {
            joined.push(part.clone());
        } else if ends.take(i) {
            let mut chain = part.clone();
            grow(&mut chain, parts, &mut ends);
            if !chain.closed {
                chain.reverse();
                grow(&mut chain, parts, &mut ends);
                chain.reverse();
            }
            joined.push(chain);
        }
    }
    joined
}

/// Adds parts to the end of `chain` until it closes or nothing fits.
fn grow(chain: &mut PathChain, parts: &[PathChain], ends: &mut FreeEnds) {
    loop {
        let (Some(&first), Some(&last)) = (chain.points.first(), chain.points.last()) else {
            return;
        };
        let next = ends.nearest(last, parts);
        let gap = Gap {
            ends: [last, first],
        };
        let closes = chain.points.len() > 2 && gap.size() <= JOINED;
        if closes && next.is_none_or(|end| gap.size() <= end.gap) {
            chain.close(gap);
            return;
        }
        let Some(end) = next else {
            return;
        };
        ends.take(end.part);
        let mut part = parts[end.part].clone();
        if !end.is_head {
            part.reverse();
        }
        let ends = [last, part.points[0]];
        chain.append(&part, Gap { ends });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::Point2;

    fn path(points: &[Point2]) -> EntityPath {
        EntityPath {
            points: points.to_vec(),
            closed: false,
            straight: false,
            sampled: Vec::new(),
        }
    }

    fn joined(paths: &[EntityPath]) -> Vec<PathChain> {
        join_paths(&paths.iter().map(|p| (p, 1)).collect::<Vec<_>>(), true)
    }

    #[test]
    fn paths_in_any_order_and_direction_close() {
        let found = joined(&[
            path(&[[0.0, 0.0], [1.0, 0.0]]),
            path(&[[0.0, 1.0], [0.0, 0.0]]),
            path(&[[0.0, 1.0], [0.5, 1.5], [1.0, 1.0]]),
            path(&[[1.0, 0.0], [1.0, 1.0]]),
        ]);
        assert_eq!(found.len(), 1);
        let chain = &found[0];
        assert!(chain.closed && chain.gaps.is_empty());
        assert_eq!(
            chain.points,
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.5], [0.0, 1.0]]
        );
        assert_eq!(chain.path_end, [true, true, true, false, true]);
    }

    #[test]
    fn small_gaps_are_closed_and_said() {
        let found = joined(&[
            path(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]),
            path(&[[1.0, 1.0002], [0.0, 0.0001]]),
        ]);
        assert!(found[0].closed);
        let sizes: Vec<f64> = found[0].gaps.iter().map(Gap::size).collect();
        assert_eq!(sizes.len(), 2);
        assert!((sizes[0] - 2e-4).abs() < 1e-12 && (sizes[1] - 1e-4).abs() < 1e-12);
    }

    #[test]
    fn nearest_ends_are_joined_whatever_their_order() {
        // The second line begins near both ends of the first gap; the third closes it.
        let found = joined(&[
            path(&[[0.0, 0.0], [1.0, 0.0]]),
            path(&[[1.0004, 0.0], [2.0, 0.0]]),
            path(&[[1.0, 0.0001], [0.5, 1.0], [0.0, 0.0]]),
        ]);
        assert_eq!(found.len(), 2);
        assert!(found[0].closed && !found[1].closed);
    }

    #[test]
    fn large_gap_stays_open() {
        let found = joined(&[path(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.05, 0.0]])]);
        assert!(!found[0].closed && found[0].gaps.is_empty());
    }
}
