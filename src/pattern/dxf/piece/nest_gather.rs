//! Nests about a common point: sizes that stick out of each other.

use super::measured::MeasuredChain;

/// Sizes of a nest differ in area by less than this share.
pub(super) const SIZE_SHARE: f64 = 0.4;

/// Sheets of more outlines are no nests.
const GATHERED: usize = 400;

/// The boxes of two sizes overlap by at least this share.
const OVERLAP: f64 = 0.8;

/// An outline with those that lie in it, and its place among others.
type OutlineGroup = (usize, MeasuredChain, Vec<MeasuredChain>);

/// Moves outlines that are sizes of others but stick out of them, as in nests about a common point,
/// into those, with what lies in them; only where that makes three sizes.
pub(super) fn gather(
    outer: Vec<MeasuredChain>,
    inner: Vec<Vec<MeasuredChain>>,
) -> (Vec<MeasuredChain>, Vec<Vec<MeasuredChain>>) {
    let pairs = outer.into_iter().zip(inner).enumerate();
    let mut groups: Vec<OutlineGroup> = pairs.map(|(i, (o, inside))| (i, o, inside)).collect();
    if groups.len() <= GATHERED {
        groups = gathered(groups);
    }
    groups.sort_by_key(|(i, ..)| *i);
    groups.into_iter().map(|(_, o, inside)| (o, inside)).unzip()
}

fn gathered(mut groups: Vec<OutlineGroup>) -> Vec<OutlineGroup> {
    groups.sort_by(|(_, a, _), (_, b, _)| b.area.total_cmp(&a.area));
    let mut nests: Vec<Vec<OutlineGroup>> = vec![];
    for group in groups {
        let is_size = |(_, other, _): &OutlineGroup| is_size_of(&group.1, other);
        match nests.iter_mut().find(|nest| nest.iter().any(is_size)) {
            Some(nest) => nest.push(group),
            None => nests.push(vec![group]),
        }
    }
    let joined = nests.into_iter().flat_map(|nest| {
        if nest.len() < 3 {
            return nest;
        }
        let mut sizes = nest.into_iter();
        let mut largest: Vec<OutlineGroup> = sizes.by_ref().take(1).collect();
        for (_, _, inside) in &mut largest {
            for (_, outline, own) in sizes.by_ref() {
                inside.push(outline);
                inside.extend(own);
            }
        }
        largest
    });
    joined.collect()
}

/// Returns true if an outline lies where a larger one does and runs beside all of it.
pub(super) fn is_size_of(smaller: &MeasuredChain, larger: &MeasuredChain) -> bool {
    let side = |k: usize| {
        let low = smaller.bounds[0][k].max(larger.bounds[0][k]);
        let high = smaller.bounds[1][k].min(larger.bounds[1][k]);
        (high - low).max(0.0)
    };
    let [low, high] = smaller.bounds;
    let shared = side(0) * side(1);
    shared >= OVERLAP * (high[0] - low[0]) * (high[1] - low[1])
        && smaller.area >= SIZE_SHARE * larger.area
        && smaller.follows(larger)
        && larger.follows(smaller)
}
