//! One surface against another that is no body: it has no inside.

use crate::limits::{PairsLeft, SearchLimits, TooManyPairs};
use crate::predicates;
use crate::report::{Crossing, CrossingList};
use crate::surface::Surface;
use crate::tree::BoxTree;

/// Finds the pairs of a triangle of `cloth` and one of `other` that have a common point, be it that
/// they touch or overlap in a plane. Nothing joins the two surfaces, whatever their stitches.
///
/// # Errors
/// [`TooManyPairs`] if the limit of pairs does not do.
pub fn find_crossings_between(
    cloth: &Surface<'_>,
    other: &Surface<'_>,
    limits: SearchLimits,
) -> Result<CrossingList, TooManyPairs> {
    let mut left = PairsLeft(limits.pairs);
    let tree = BoxTree::new(&other.bounds());
    let mut list = CrossingList::default();
    let mut near = vec![];
    for (t, bounds) in (0..).zip(cloth.bounds()) {
        near.clear();
        tree.visit(&bounds, |u| near.push(u));
        left.take(near.len())?;
        near.sort_unstable();
        let corners = cloth.corners(t);
        for &u in &near {
            if let Some(point) = predicates::common_point(&corners, &other.corners(u)) {
                let triangles = [t, u];
                list.push(Crossing { triangles, point }, limits.kept);
            }
        }
    }
    Ok(list)
}
