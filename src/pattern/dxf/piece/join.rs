//! Paths joined head to tail: outlines come as several open paths, in file order or in none.
//!
//! From each free path on, the free path whose end lies nearest is added, as long as it lies within
//! the tolerance; where several lie equally near, the first in the file.

use super::chain::{JOINED, PathChain};
use super::free_ends::FreeEnds;
use crate::pattern::dxf::entity::geometry::EntityPath;
use crate::pattern::point::distance;

/// Ends closer than this are joined with a warning: a slip of the drawing hand that no cutter would
/// notice \[m\].
const REPAIRED: f64 = 5e-4;

/// Joins paths, each with its line, to as few chains as their ends allow, in the order of the file
/// where several would fit. `repair`: small gaps are closed too, as outlines need it.
pub(super) fn join_paths(paths: &[(&EntityPath, usize)], repair: bool) -> Vec<PathChain> {
    let are_exploded = paths.iter().all(|(path, _)| path.straight);
    let single: Vec<PathChain> = paths
        .iter()
        .filter(|(path, _)| !path.points.is_empty())
        .map(|(path, line)| PathChain::of_path(path, *line))
        .collect();
    let mut joined = join(single, JOINED);
    if repair && joined.iter().any(|chain| !chain.closed) {
        joined = join(joined, REPAIRED);
    }
    if are_exploded {
        for chain in &mut joined {
            chain.path_end.fill(false);
        }
    }
    joined
}

/// Joins chains whose ends lie within `tolerance` \[m\].
fn join(parts: Vec<PathChain>, tolerance: f64) -> Vec<PathChain> {
    let mut ends = FreeEnds::new(&parts, tolerance);
    let mut joined = Vec::new();
    for (i, part) in parts.iter().enumerate() {
        if part.closed {
            joined.push(part.clone());
        } else if ends.take(i) {
            let mut chain = part.clone();
            grow(&mut chain, &parts, &mut ends, tolerance);
            if !chain.closed {
                chain.reverse();
                grow(&mut chain, &parts, &mut ends, tolerance);
                chain.reverse();
            }
            joined.push(chain);
        }
    }
    joined
}

/// Adds parts to the end of `chain` until it closes or nothing fits.
fn grow(chain: &mut PathChain, parts: &[PathChain], ends: &mut FreeEnds, tolerance: f64) {
    loop {
        let (Some(&first), Some(&last)) = (chain.points.first(), chain.points.last()) else {
            return;
        };
        let next = ends.nearest(last, parts);
        let gap = distance(first, last);
        let closes = chain.points.len() > 2 && gap <= tolerance;
        if closes && next.is_none_or(|end| gap <= end.gap) {
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
        chain.append(&part, end.gap);
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
        assert!(found[0].closed && found[0].closed_gap.is_none());
        assert_eq!(
            found[0].points,
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.5], [0.0, 1.0]]
        );
        assert_eq!(found[0].path_end, [true, true, true, false, true]);
    }

    #[test]
    fn small_gap_is_closed_and_said() {
        let found = joined(&[
            path(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]),
            path(&[[1.0, 1.0002], [0.0, 0.0]]),
        ]);
        assert!(found[0].closed);
        assert!((found[0].closed_gap.expect("a gap") - 2e-4).abs() < 1e-12);
    }

    #[test]
    fn large_gap_stays_open() {
        let found = joined(&[path(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.05, 0.0]])]);
        assert!(!found[0].closed);
        assert!((found[0].gap() - 0.05).abs() < 1e-12);
    }
}
