//! Nests: all sizes of a piece drawn one in the other.

use super::chain::PathChain;
use super::dxf_piece::{DxfPiece, InnerLine, NestedSize, NotchMark};
use super::measured::MeasuredChain;
use crate::fault::PatternCode;
use crate::pattern::dxf::drawing::size_names::size_order;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::point::{distance, lerp};
use crate::pattern::polyline::{nearest, segments, signed_area};
use crate::pattern::{Outlines, Point2};
use std::collections::BTreeSet;

/// Sizes of a nest differ in area by less than this share.
const SIZE_SHARE: f64 = 0.4;

/// The width of a seam allowance is a multiple of one of these: millimeters and sixteenths of an
/// inch \[m\] ...
const UNITS_OF_WIDTH: [f64; 2] = [1e-3, 0.0254 / 16.0];
/// ... to within this \[m\].
const ROUND: f64 = 1e-4;

/// Distances that differ by less than this are the same width \[m\].
const SAME_WIDTH: f64 = 4e-4;

/// Of the distances of a seam allowance at least this share are one of few widths.
const ALONG: f64 = 0.85;

/// An allowance has at most this many widths.
const WIDTHS: usize = 3;

/// At most about this many sides of two outlines are compared.
const SAMPLES: usize = 400;

/// Sides that are nearer to each other lie on a fold, where nothing is sewn \[m\].
const FOLD: f64 = 0.001;

/// At most this many notches of a nest are read.
const MOST_NOTCHES: usize = 1000;

/// A nest has at most this many sizes inside its largest.
const MOST: usize = 60;

/// At most so many points of lines are copied to the sizes of a nest.
const COPIED_POINTS: usize = 2_000_000;

/// Returns true if the outlines in that of a piece begin with a sew line: one that keeps the
/// distance of a seam allowance, and none in it.
pub(super) fn has_allowance(outer: &MeasuredChain, inner: &[MeasuredChain]) -> bool {
    matches!(concentric(outer, inner)[..], [only] if is_allowance(outer, &inner[only]))
}

/// Takes the sizes of a piece out of the outlines that lie in its own: those that run inside each
/// other, if they are three or more with its own, or do not keep the distance of a seam allowance.
///
/// Returns the sizes, none if there is no nest, in growing order. `is_sewn`: other pieces of the
/// sheet have sew lines, so that of two outlines the inner one is one too. `layer`: that of the
/// line that an outline begins at.
pub(super) fn take_sizes<'a>(
    piece: &DxfPiece,
    inner: &mut Vec<MeasuredChain>,
    reading: Outlines,
    is_sewn: bool,
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
    let may_be_two = !is_sewn && !is_allowance(&piece.outline, &inner[*largest]);
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

/// Returns the pieces of all sizes of a piece: itself if it has one. Notches belong to the size
/// that they lie nearest to, sew and cut lines to the one that they run beside; of as many holes as
/// sizes each has one, by their areas.
pub(super) fn split(mut piece: DxfPiece, findings: &mut DxfFindings) -> Vec<DxfPiece> {
    if piece.nest.is_empty() {
        return vec![piece];
    }
    let sizes = std::mem::take(&mut piece.nest);
    let lines = [piece.sew.take(), piece.cut.take()].into_iter().flatten();
    let lines: Vec<MeasuredChain> = lines
        .chain(std::mem::take(&mut piece.internal))
        .map(MeasuredChain::new)
        .collect();
    let points: usize = lines.iter().map(|line| line.chain.points.len()).sum();
    let is_copied = points * sizes.len() <= COPIED_POINTS;
    if !is_copied {
        let count = lines.iter().map(|line| line.chain.path_count).sum();
        findings.skip_many("line inside a nest of sizes", piece.line, count);
    }
    let lines = if is_copied { lines } else { vec![] };
    let notches = nearest_sizes(&piece, &sizes);
    let mut cutouts = std::mem::take(&mut piece.cutouts);
    let area = |chain: &PathChain| signed_area(&chain.points).abs();
    cutouts.sort_by(|a, b| area(a).total_cmp(&area(b)));
    let parts = NestParts {
        lines: &lines,
        notches: &notches,
        cutouts: &cutouts,
    };
    (0..sizes.len())
        .map(|k| piece_of_size(&piece, &sizes, k, &parts))
        .collect()
}

/// What the sizes of a nest share.
struct NestParts<'a> {
    lines: &'a [MeasuredChain],
    /// The size of each notch.
    notches: &'a [usize],
    /// Holes, the smallest first.
    cutouts: &'a [PathChain],
}

/// Returns the size whose outline each notch lies nearest to.
fn nearest_sizes(piece: &DxfPiece, sizes: &[NestedSize]) -> Vec<usize> {
    let of_notch = |notch: &NotchMark| {
        let at = notch.points[0];
        let distance = |k: &usize| distance_to(&sizes[*k].outline.chain.points, at);
        let nearest = |a: &usize, b: &usize| distance(a).total_cmp(&distance(b));
        (0..sizes.len()).min_by(nearest).unwrap_or_default()
    };
    piece
        .marks
        .notches
        .iter()
        .take(MOST_NOTCHES)
        .map(of_notch)
        .collect()
}

/// Returns the piece of one size.
fn piece_of_size(
    piece: &DxfPiece,
    sizes: &[NestedSize],
    k: usize,
    parts: &NestParts<'_>,
) -> DxfPiece {
    let size = &sizes[k];
    let mut own = piece.clone();
    own.outline = size.outline.clone();
    own.labels.set("size", &size.name, size.outline.chain.line);
    let notches = piece.marks.notches.iter().zip(parts.notches);
    let notches = notches.filter(|(_, of)| **of == k);
    own.marks.notches = notches.map(|(notch, _)| notch.clone()).collect();
    own.cutouts = match parts.cutouts {
        cutouts if cutouts.len() == sizes.len() => vec![cutouts[k].clone()],
        cutouts => cutouts.to_vec(),
    };
    let is_sewn = |line: &&MeasuredChain| line.chain.closed && size.outline.is_sewn_on(line);
    let sewn = parts.lines.iter().filter(is_sewn);
    let sew = sewn.max_by(|a, b| a.area.total_cmp(&b.area));
    own.sew = sew.map(|line| line.chain.clone());
    let is_cut = |line: &&MeasuredChain| line.chain.closed && line.is_sewn_on(&size.outline);
    let around = parts.lines.iter().filter(is_cut);
    let cut = around.min_by(|a, b| a.area.total_cmp(&b.area));
    own.cut = cut.map(|line| line.chain.clone());
    for line in parts.lines {
        let is_used = sew
            .into_iter()
            .chain(cut)
            .any(|used| std::ptr::eq(used, line));
        let is_of_others = line.chain.closed
            && sizes
                .iter()
                .any(|other| other.outline.is_sewn_on(line) || line.is_sewn_on(&other.outline));
        if !is_used && !is_of_others && line.lies_in(&size.outline) {
            own.add_line(line.chain.clone(), InnerLine::Drawn);
        }
    }
    own
}

/// Returns the outlines that run inside an outline and inside each other, the largest first.
fn concentric(outer: &MeasuredChain, inner: &[MeasuredChain]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..inner.len()).collect();
    order.sort_by(|a, b| inner[*b].area.total_cmp(&inner[*a].area));
    let mut nested: Vec<usize> = vec![];
    for i in order {
        let around = nested.last().map_or(outer, |last| &inner[*last]);
        let runs_inside = inner[i].area >= SIZE_SHARE * around.area
            && inner[i].lies_in(around)
            && inner[i].follows(around);
        if runs_inside {
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

/// Returns true if `inner` runs at the distance of a seam allowance inside `outer`: one width all
/// round, or a few round ones. Along a fold there is none.
fn is_allowance(outer: &MeasuredChain, inner: &MeasuredChain) -> bool {
    let outline = &outer.chain.points;
    let step = inner.chain.points.len().div_ceil(SAMPLES).max(1);
    let sides = segments(&inner.chain.points).step_by(step);
    let mut sides: Vec<(f64, f64)> = sides
        .map(|(a, b)| (distance_to(outline, lerp(a, b, 0.5)), distance(a, b)))
        .filter(|(width, _)| *width > FOLD)
        .collect();
    sides.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = sides.iter().map(|(_, length)| length).sum();
    // The widths, each with the length along which it is kept.
    let mut widths: Vec<(f64, f64)> = vec![];
    for (width, length) in sides {
        match widths.last_mut() {
            Some((same, along)) if width - *same <= SAME_WIDTH => *along += length,
            _ => widths.push((width, length)),
        }
    }
    widths.sort_by(|a, b| b.1.total_cmp(&a.1));
    widths.truncate(WIDTHS);
    let covers = |widths: &[(f64, f64)]| {
        let along: f64 = widths.iter().map(|(_, along)| along).sum();
        along >= ALONG * total
    };
    let is_one = covers(&widths[..widths.len().min(1)]);
    is_one || covers(&widths) && widths.iter().all(|(width, _)| is_round(*width))
}

/// Returns true if a width is one that allowances have.
fn is_round(width: f64) -> bool {
    let is_multiple = |unit: &f64| (width / unit - (width / unit).round()).abs() * unit <= ROUND;
    UNITS_OF_WIDTH.iter().any(is_multiple)
}

fn distance_to(ring: &[Point2], p: Point2) -> f64 {
    nearest(segments(ring), p).map_or(f64::INFINITY, |foot| foot.distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[Point2]) -> MeasuredChain {
        MeasuredChain::new(PathChain {
            path_end: vec![false; points.len()],
            sampled: vec![false; points.len()],
            points: points.to_vec(),
            closed: true,
            closed_gap: None,
            line: 1,
            path_count: 1,
        })
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
