//! Nests: all sizes of a piece drawn one in the other.

use super::allowance_width::is_allowance;
use super::dxf_piece::{DxfPiece, NestedSize};
use super::measured::MeasuredChain;
use super::nest_gather::{SIZE_SHARE, is_size_of};
use crate::fault::PatternCode;
use crate::pattern::Outlines;
use crate::pattern::dxf::drawing::size_names::size_order;
use crate::pattern::dxf::findings::DxfFindings;
use std::collections::BTreeSet;

/// A nest has at most this many sizes inside its largest.
const MOST: usize = 60;

/// Returns true if the outlines in that of a piece begin with a sew line: one that keeps the
/// distance of a seam allowance, and none in it.
pub(super) fn has_allowance(outer: &MeasuredChain, inner: &[MeasuredChain]) -> bool {
    matches!(concentric(outer, inner)[..], [only] if is_allowance(outer, &inner[only]))
}

/// Takes the sizes of a piece out of the outlines that lie in its own: those that run inside each
/// other, if they are three or more with its own, or do not keep the distance of a seam allowance.
///
/// Returns the sizes, none if there is no nest, in growing order. `has_sew_lines`: other pieces
/// of the file have them, so that of two outlines the inner one is one too. `layer`: that of the
/// line that an outline begins at.
pub(super) fn take_sizes<'a>(
    piece: &DxfPiece,
    inner: &mut Vec<MeasuredChain>,
    reading: Outlines,
    has_sew_lines: bool,
    layer: impl Fn(&MeasuredChain) -> &'a str,
    findings: &mut DxfFindings,
) -> Vec<NestedSize> {
    if !matches!(reading, Outlines::Auto | Outlines::Sizes) {
        return vec![];
    }
    let nested = concentric(&piece.outline, inner);
    let Some(largest) = nested.first() else {
        return vec![];
    };
    let states_size = piece.labels.get("size").is_some();
    let may_be_two = !has_sew_lines && !is_allowance(&piece.outline, &inner[*largest]);
    let is_nest = reading == Outlines::Sizes || !states_size && (nested.len() > 1 || may_be_two);
    if !is_nest || nested.len() > MOST {
        return vec![];
    }
    let named = names_of_layers(&piece.outline, inner, &nested, &layer);
    let count = nested.len() + 1;
    let names = named.or_else(|| names_of_notes(piece, count));
    let names = names.unwrap_or_else(|| (1..=count).map(|i| i.to_string()).collect());
    let mut outlines: Vec<MeasuredChain> = nested.iter().map(|i| inner[*i].clone()).collect();
    outlines.reverse();
    outlines.push(piece.outline.clone());
    let taken: BTreeSet<usize> = nested.into_iter().collect();
    let mut index = 0..;
    inner.retain(|_| !index.next().is_some_and(|i| taken.contains(&i)));
    let detail = format!(
        "{count} outlines of {:?} lie one in the other and were taken as its sizes {} (size= chooses one; outlines=allowance or lines takes them otherwise)",
        piece.name,
        names.join(", ")
    );
    findings.warn(PatternCode::NestedSizes, piece.outline.chain.line, detail);
    let sizes = names.into_iter().zip(outlines);
    sizes
        .map(|(name, outline)| NestedSize { name, outline })
        .collect()
}

/// Returns the outlines that run inside an outline and inside each other, the largest first.
fn concentric(outer: &MeasuredChain, inner: &[MeasuredChain]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..inner.len()).collect();
    order.sort_by(|a, b| inner[*b].area.total_cmp(&inner[*a].area));
    let mut nested: Vec<usize> = vec![];
    for i in order {
        let around = nested.last().map_or(outer, |last| &inner[*last]);
        let is_inside = inner[i].lies_in(around) && inner[i].follows(around);
        let is_like = inner[i].area >= SIZE_SHARE * around.area;
        if is_like && is_inside || is_size_of(&inner[i], around) {
            nested.push(i);
        }
    }
    nested
}

/// Returns the names of the layers of a nest, the smallest size first, if each is a size.
fn names_of_layers<'a>(
    outer: &MeasuredChain,
    inner: &[MeasuredChain],
    nested: &[usize],
    layer: impl Fn(&MeasuredChain) -> &'a str,
) -> Option<Vec<String>> {
    let outlines = nested.iter().rev().map(|i| &inner[*i]);
    let names: Vec<&str> = outlines.chain([outer]).map(layer).collect();
    let orders: Option<Vec<_>> = names.iter().map(|name| size_order(name)).collect();
    let is_growing = orders?.windows(2).all(|pair| pair[0] < pair[1]);
    is_growing.then(|| names.into_iter().map(str::to_owned).collect())
}

/// Returns the names of sizes among the texts of a piece, in growing order, if there are as many as
/// outlines.
fn names_of_notes(piece: &DxfPiece, count: usize) -> Option<Vec<String>> {
    let notes = piece.labels.notes().map(str::trim);
    let mut names: Vec<&str> = notes.filter(|note| size_order(note).is_some()).collect();
    names.sort_by_key(|name| size_order(name));
    names.dedup();
    (names.len() == count).then(|| names.into_iter().map(str::to_owned).collect())
}

#[cfg(test)]
mod tests {
    use super::super::chain::PathChain;
    use super::*;
    use crate::pattern::Point2;

    fn ring(points: &[Point2]) -> MeasuredChain {
        MeasuredChain::new(PathChain::ring(points))
    }

    fn trapezium(scale: f64) -> MeasuredChain {
        let corners = [[-0.2, 0.3], [0.2, 0.3], [0.26, -0.3], [-0.26, -0.3]];
        ring(&corners.map(|p| p.map(|c| scale * c)))
    }

    #[test]
    fn allowance_keeps_its_distance_and_sizes_do_not() {
        let rectangle =
            |x: f64, low: f64, high: f64| ring(&[[-x, low], [x, low], [x, high], [-x, high]]);
        let cut = rectangle(0.21, -0.34, 0.31);
        assert!(is_allowance(&cut, &rectangle(0.2, -0.33, 0.3)), "one width");
        assert!(is_allowance(&cut, &rectangle(0.2, -0.3, 0.3)), "a wide hem");
        assert!(!is_allowance(&trapezium(1.0), &trapezium(0.96)), "a size");
    }

    #[test]
    fn outlines_in_each_other_are_found() {
        let inner = [trapezium(0.92), trapezium(0.96), trapezium(0.2)];
        assert_eq!(concentric(&trapezium(1.0), &inner), [1, 0]);
    }
}
