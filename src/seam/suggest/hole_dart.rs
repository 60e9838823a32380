//! Holes that are darts, whose sides are sewn together.

use super::edge_chain::{EdgeChain, EdgeStep, WHOLE};
use crate::pattern::inside_dart;
use crate::pattern::outline::ring_of;
use crate::pattern::{Edge, Hole};

/// Returns true for a hole that is a dart.
pub(super) fn is_dart(hole: &Hole) -> bool {
    sides(0, 0, hole).is_some()
}

/// Returns the two sides of a hole that is a dart, one after the other round it.
pub(super) fn sides(panel: usize, index: usize, hole: &Hole) -> Option<[EdgeChain; 2]> {
    let ring = ring_of(&hole.edges);
    let tips = inside_dart::tips(&ring)?;
    let leaves = |tip: usize| hole.edges.iter().position(|e| e.points[0] == ring[tip]);
    let (from, to) = (leaves(tips[0])?, leaves(tips[1])?);
    let step = |edge: &Edge| EdgeStep {
        panel,
        hole: Some(index),
        edge: edge.index,
        forward: true,
        length: edge.length_m,
        span: WHOLE,
    };
    let mut first: EdgeChain = hole.edges.iter().map(step).collect();
    first.rotate_left(from);
    let count = first.len();
    let second = first.split_off((to + count - from) % count);
    Some([first, second])
}
