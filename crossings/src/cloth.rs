//! Cloth against itself.

use crate::limits::{PairsLeft, TooManyPairs};
use crate::predicates::{self, Point, Triangle};
use crate::report::{Crossing, CrossingList};
use crate::surface::Surface;
use crate::tree::BoxTree;

/// Finds the pairs of triangles that meet; `is_degenerate` tells of each triangle if it has no
/// area.
///
/// # Errors
/// [`TooManyPairs`] if more pairs have to be looked at than are left.
pub(crate) fn find(
    cloth: &Surface<'_>,
    is_degenerate: &[bool],
    kept: usize,
    left: &mut PairsLeft,
) -> Result<CrossingList, TooManyPairs> {
    let bounds = cloth.bounds();
    let tree = BoxTree::new(&bounds);
    let mut list = CrossingList::default();
    let mut others = vec![];
    for i in 0..cloth.triangle_count() {
        // Of two triangles without area both are faults already: all cloth at one point would be
        // nothing but such pairs.
        if is_degenerate[i as usize] {
            continue;
        }
        others.clear();
        tree.visit(&bounds[i as usize], |j| {
            if i < j || is_degenerate[j as usize] {
                others.push(j);
            }
        });
        left.take(others.len())?;
        others.sort_unstable();
        for &j in &others {
            if let Some(point) = meeting_point(cloth, [i, j], is_degenerate[j as usize]) {
                let triangles = [i.min(j), i.max(j)];
                list.push(Crossing { triangles, point }, kept);
            }
        }
    }
    Ok(list)
}

/// Returns a place to mark if two triangles count as crossing; the second may have no area.
fn meeting_point(cloth: &Surface<'_>, pair: [u32; 2], is_degenerate: bool) -> Option<Point> {
    let [a, b] = pair.map(|t| cloth.corners(t));
    let amid = || predicates::between(&predicates::mean(&a), &predicates::mean(&b), 0.5);
    let (shared, count) = shared_corners(pair.map(|t| cloth.welded_corners(t)));
    match &shared[..count] {
        [] => predicates::common_point(&a, &b),
        // All its points are on its edges, which are its neighbors' as well.
        _ if is_degenerate => None,
        [[i, j]] => predicates::point_on_segment(opposite_edge(&a, *i), &b)
            .or_else(|| predicates::point_on_segment(opposite_edge(&b, *j), &a)),
        [[i, j], [k, l]] => {
            let (third_a, third_b) = (&a[3 - i - k], &b[3 - j - l]);
            // Where springs hold the seam there are two copies of the edge.
            let is_folded = predicates::is_folded([a[*i], a[*k]], third_a, third_b)
                || predicates::is_folded([b[*j], b[*l]], third_a, third_b);
            is_folded.then(amid)
        }
        _ => Some(amid()),
    }
}

/// Returns the pairs of corners, one of each triangle, that are one welded vertex, and their count.
fn shared_corners([a, b]: [[u32; 3]; 2]) -> ([[usize; 2]; 3], usize) {
    let (mut shared, mut count) = ([[0; 2]; 3], 0);
    for (i, v) in a.iter().enumerate() {
        if let Some(j) = b.iter().position(|w| w == v) {
            shared[count] = [i, j];
            count += 1;
        }
    }
    (shared, count)
}

fn opposite_edge(triangle: &Triangle, corner: usize) -> [Point; 2] {
    [triangle[(corner + 1) % 3], triangle[(corner + 2) % 3]]
}
