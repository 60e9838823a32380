//! A nest taken apart: a piece of each size.

use super::allowance_width::distance_to;
use super::chain::PathChain;
use super::dxf_piece::{DxfPiece, InnerLine, NestedSize, NotchMark};
use super::measured::MeasuredChain;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::polyline::signed_area;

/// At most this many notches of a nest are read.
const MOST_NOTCHES: usize = 1000;

/// At most so many points of lines are copied to the sizes of a nest.
const COPIED_POINTS: usize = 2_000_000;

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
    let beyond = piece.marks.notches.iter().skip(MOST_NOTCHES);
    for notch in beyond {
        findings.skip("notch beyond the first 1000 of a piece", notch.line);
    }
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
