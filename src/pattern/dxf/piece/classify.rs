//! Sheets to pieces: the outlines, and the piece that every other line, mark and text lies in.

use super::dxf_piece::DxfPiece;
use super::lines::SheetLines;
use super::measured::MeasuredChain;
use super::{assign, frame, inner_outlines, marks, nest, shared_edges, size_nest};
use crate::config::Limits;
use crate::pattern::ImportOptions;
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::findings::DxfFindings;
use std::collections::{BTreeMap, BTreeSet};

/// Returns the pieces of all sheets; outlines that do not close become faults.
pub(crate) fn pieces(
    sheets: &[DxfSheet],
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Vec<DxfPiece> {
    sheets
        .iter()
        .flat_map(|sheet| pieces_of_sheet(sheet, options, limits.panels, findings))
        .collect()
}

fn pieces_of_sheet(
    sheet: &DxfSheet,
    options: &ImportOptions,
    panel_limit: usize,
    findings: &mut DxfFindings,
) -> Vec<DxfPiece> {
    let reading = options.outlines;
    let mut lines = SheetLines::of(sheet);
    shared_edges::close(&mut lines, findings);
    let outlines = lines.outlines(sheet, findings);
    let taken = outlines.iter().map(|outline| outline.chain.key()).collect();
    // Sizes and letters drawn as outlines make more outlines than panels, but not without end.
    if outlines.len() > 4 * panel_limit {
        let fault = nest::too_many(outlines.len(), panel_limit, sheet.line);
        findings.faults.push(fault);
        return Vec::new();
    }
    let layers = LayersOfLines::of(sheet, &outlines);
    let layer = |outline: &MeasuredChain| layers.of_line(outline.chain.line);
    let outlines = nest::drop_duplicates(outlines, findings);
    let outlines = frame::without_frames(outlines, reading, layer, findings);
    let (outer, inner) = nest::nest(outlines);
    let is_alone = outer.len() == 1 && sheet.block.is_some();
    let texts = marks::texts(sheet, &outer, is_alone, findings);
    let mut pieces: Vec<DxfPiece> = outer
        .into_iter()
        .zip(&texts)
        .map(|(outline, own)| DxfPiece::new(sheet, outline, own, is_alone))
        .collect();
    for piece in &mut pieces {
        let line = piece.outline.chain.line;
        piece.is_sewn = lines.sew.iter().any(|sew| sew.line == line);
    }
    let mut pairs = pieces.iter().zip(&inner);
    let is_sewn = pairs.any(|(piece, inner)| size_nest::has_allowance(&piece.outline, inner));
    for (piece, mut inner) in pieces.iter_mut().zip(inner) {
        piece.nest = size_nest::take_sizes(piece, &mut inner, reading, is_sewn, layer, findings);
        inner_outlines::give(piece, inner, reading, layer, findings);
    }
    marks::assign(sheet, &lines.mirror, &mut pieces, is_alone, findings);
    assign::lines(&lines, &taken, &mut pieces, is_alone, findings);
    pieces.into_iter().flat_map(size_nest::split).collect()
}

/// The layers of the lines that outlines begin at.
struct LayersOfLines<'a>(BTreeMap<usize, &'a str>);

impl<'a> LayersOfLines<'a> {
    fn of(sheet: &'a DxfSheet, outlines: &[MeasuredChain]) -> Self {
        let wanted: BTreeSet<usize> = outlines.iter().map(|o| o.chain.line).collect();
        let entities = sheet.entities.iter();
        let found = entities.filter(|entity| wanted.contains(&entity.line));
        Self(found.map(|entity| (entity.line, &*entity.layer)).collect())
    }

    fn of_line(&self, line: usize) -> &'a str {
        self.0.get(&line).copied().unwrap_or("")
    }
}
