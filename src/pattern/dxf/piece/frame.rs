//! Frames of sheets: rectangles about the pieces that are none themselves.

use super::measured::MeasuredChain;
use crate::fault::PatternCode;
use crate::pattern::Outlines;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::polyline::contains;

/// A rectangle covers at least this share of its box.
const RECTANGLE: f64 = 0.999;

/// An outline of at least this area may be a piece; smaller ones are lines drawn on one \[m²\].
const LEAST_PIECE: f64 = 0.004;

/// Pieces cover at least this share of a frame about them.
const COVERED: f64 = 0.15;

/// Words by which layers of frames are named.
const NAMES: [&str; 7] = [
    "frame", "border", "sheet", "margin", "rahmen", "cadre", "marco",
];

/// Returns the outlines without frames, each of which is warned about.
///
/// A frame is a rectangle about two or more pieces beside each other, or about one on a layer of
/// its own that is named so. `layer`: that of the line that an outline begins at.
pub(super) fn without_frames<'a>(
    mut outlines: Vec<MeasuredChain>,
    reading: Outlines,
    layer: impl Fn(&MeasuredChain) -> &'a str,
    findings: &mut DxfFindings,
) -> Vec<MeasuredChain> {
    if !matches!(reading, Outlines::Auto | Outlines::Pieces) {
        return outlines;
    }
    loop {
        let is_frame = |i: &usize| is_frame(&outlines, *i, reading, layer(&outlines[*i]));
        let Some(frame) = (0..outlines.len()).find(is_frame) else {
            return outlines;
        };
        let frame = outlines.remove(frame);
        let [low, high] = frame.bounds.map(|p| p.map(|c| 1000.0 * c));
        let detail = format!(
            "an outline of {:.0} x {:.0} mm about others was taken as the frame of the sheet and left out (outlines=lines or holes takes it as a piece)",
            high[0] - low[0],
            high[1] - low[1]
        );
        findings.warn(PatternCode::Frame, frame.chain.line, detail);
    }
}

fn is_frame(outlines: &[MeasuredChain], i: usize, reading: Outlines, layer: &str) -> bool {
    let frame = &outlines[i];
    let others = outlines.iter().enumerate().filter(|(k, _)| *k != i);
    let others = others.map(|(_, other)| other);
    if !others.clone().any(|other| other.lies_in(frame)) {
        return false;
    }
    if reading == Outlines::Pieces {
        return true;
    }
    let [low, high] = frame.bounds;
    let is_rectangle = frame.area >= RECTANGLE * (high[0] - low[0]) * (high[1] - low[1]);
    if !is_rectangle || others.clone().any(|other| frame.is_sewn_on(other)) {
        return false;
    }
    let pieces = others.filter(|other| other.area >= LEAST_PIECE && other.lies_in(frame));
    let pieces = beside_each_other(pieces);
    let covered: f64 = pieces.iter().map(|piece| piece.area).sum();
    let is_named = NAMES.iter().any(|name| layer.to_lowercase().contains(name));
    let least = if is_named { 1 } else { 2 };
    pieces.len() >= least && (is_named || covered >= COVERED * frame.area)
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
