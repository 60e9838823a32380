//! Frames of sheets: rectangles about the pieces that are none themselves.

use super::measured::MeasuredChain;
use crate::fault::PatternCode;
use crate::pattern::Outlines;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::polyline::contains;

/// A rectangle covers at least this share of its box.
const RECTANGLE: f64 = 0.999;

/// An outline of at least this area may be a piece; smaller ones are lines drawn on one \[m²\].
const LEAST_PIECE: f64 = 0.01;

/// Sides this near to that of a frame lie on it \[m\].
const ON_FRAME: f64 = 1e-3;

/// Pieces cover at least this share of a frame about them.
const COVERED: f64 = 0.15;

/// Words by which layers of frames are named.
const NAMES: [&str; 7] = [
    "frame", "border", "sheet", "margin", "rahmen", "cadre", "marco",
];

/// Returns the outlines without frames, each of which is warned about.
///
/// A frame is a rectangle about two or more pieces beside each other, or about one on a layer of
/// its own that is named so. With it go rectangles at two sides of it: title blocks. `is_block`:
/// the sheet is a block, which is a piece, unless a layer names a frame. `layer`: that of the line
/// that an outline begins at.
pub(super) fn without_frames<'a>(
    mut outlines: Vec<MeasuredChain>,
    reading: Outlines,
    is_block: bool,
    layer: impl Fn(&MeasuredChain) -> &'a str,
    findings: &mut DxfFindings,
) -> Vec<MeasuredChain> {
    if !matches!(reading, Outlines::Auto | Outlines::Pieces) {
        return outlines;
    }
    loop {
        let is_frame = |i: &usize| {
            let is_named = is_name_of_frame(layer(&outlines[*i]));
            (is_named || !is_block || reading == Outlines::Pieces)
                && is_frame(&outlines, *i, reading, is_named)
        };
        let Some(frame) = (0..outlines.len()).find(is_frame) else {
            return outlines;
        };
        let frame = outlines.remove(frame);
        outlines.retain(|outline| !is_title_block(outline, &frame));
        let [low, high] = frame.bounds.map(|p| p.map(|c| 1000.0 * c));
        let detail = format!(
            "an outline of {:.0} x {:.0} mm about others was taken as the frame of the sheet and left out (outlines=lines or holes takes it as a piece, and what lies in it as such)",
            high[0] - low[0],
            high[1] - low[1]
        );
        findings.warn(PatternCode::Frame, frame.chain.line, detail);
    }
}

fn is_frame(outlines: &[MeasuredChain], i: usize, reading: Outlines, is_named: bool) -> bool {
    let frame = &outlines[i];
    let others = outlines.iter().enumerate().filter(|(k, _)| *k != i);
    let others = others.map(|(_, other)| other);
    if !others.clone().any(|other| other.lies_in(frame)) {
        return false;
    }
    if reading == Outlines::Pieces {
        return true;
    }
    if !is_rectangle(frame) || others.clone().any(|other| frame.is_sewn_on(other)) {
        return false;
    }
    let pieces = others.filter(|other| other.area >= LEAST_PIECE && other.lies_in(frame));
    let pieces = beside_each_other(pieces);
    let covered: f64 = pieces.iter().map(|piece| piece.area).sum();
    let least = if is_named { 1 } else { 2 };
    pieces.len() >= least && (is_named || covered >= COVERED * frame.area)
}

fn is_name_of_frame(layer: &str) -> bool {
    let layer = layer.to_lowercase();
    NAMES.iter().any(|name| layer.contains(name))
}

fn is_rectangle(outline: &MeasuredChain) -> bool {
    let [low, high] = outline.bounds;
    outline.area >= RECTANGLE * (high[0] - low[0]) * (high[1] - low[1])
}

/// Returns true if an outline is a rectangle with two sides or more on those of a frame.
fn is_title_block(outline: &MeasuredChain, frame: &MeasuredChain) -> bool {
    let sides = (0..2).flat_map(|i| (0..2).map(move |k| [i, k]));
    let shared =
        sides.filter(|[i, k]| (outline.bounds[*i][*k] - frame.bounds[*i][*k]).abs() <= ON_FRAME);
    is_rectangle(outline) && shared.count() >= 2
}

/// Returns those of some outlines that lie in no other of them.
fn beside_each_other<'a>(
    outlines: impl Iterator<Item = &'a MeasuredChain>,
) -> Vec<&'a MeasuredChain> {
    let mut by_area: Vec<&MeasuredChain> = outlines.collect();
    by_area.sort_by(|a, b| b.area.total_cmp(&a.area));
    let mut kept: Vec<&MeasuredChain> = vec![];
    for outline in by_area {
        let is_in = |other: &&MeasuredChain| contains(&other.chain.points, outline.chain.points[0]);
        if !kept.iter().any(is_in) {
            kept.push(outline);
        }
    }
    kept
}
