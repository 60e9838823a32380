//! Sheets to pieces: the outlines, and the piece that every other line, mark and text lies in.

use super::chain::ChainKey;
use super::dxf_piece::DxfPiece;
use super::lines::SheetLines;
use super::measured::MeasuredChain;
use super::{
    assign, frame, inner_outlines, marks, nest, nest_gather, nest_split, open_sew_lines,
    shared_edges, size_nest,
};
use crate::config::Limits;
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::{ImportOptions, Outlines};
use std::collections::{BTreeMap, BTreeSet};

/// Returns the pieces of all sheets; outlines that do not close become faults.
pub(crate) fn pieces(
    sheets: &[DxfSheet],
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Vec<DxfPiece> {
    let outlines = sheets
        .iter()
        .filter_map(|sheet| SheetOutlines::of(sheet, options.outlines, limits.panels, findings));
    let outlines: Vec<SheetOutlines<'_>> = outlines.collect();
    let has_sew_lines = outlines.iter().any(SheetOutlines::have_sew_lines);
    let pieces = outlines.into_iter();
    pieces
        .flat_map(|outlines| outlines.into_pieces(options.outlines, has_sew_lines, findings))
        .collect()
}

/// The outlines of a sheet.
struct SheetOutlines<'a> {
    sheet: &'a DxfSheet,
    lines: SheetLines,
    /// Those that are outlines, frames among them.
    taken: BTreeSet<ChainKey>,
    layers: LayersOfLines<'a>,
    outer: Vec<MeasuredChain>,
    /// Those in each of the outer ones.
    inner: Vec<Vec<MeasuredChain>>,
}

impl<'a> SheetOutlines<'a> {
    fn of(
        sheet: &'a DxfSheet,
        reading: Outlines,
        panel_limit: usize,
        findings: &mut DxfFindings,
    ) -> Option<Self> {
        let mut lines = SheetLines::of(sheet);
        if reading != Outlines::Lines {
            shared_edges::close(&mut lines, findings);
        }
        open_sew_lines::close(&mut lines, sheet, findings);
        let outlines = lines.outlines(sheet, findings);
        let taken = outlines.iter().map(|outline| outline.chain.key()).collect();
        // Sizes and letters drawn as outlines make more outlines than panels, but not without end.
        if outlines.len() > 4 * panel_limit {
            let fault = nest::too_many(outlines.len(), panel_limit, sheet.line);
            findings.faults.push(fault);
            return None;
        }
        let layers = LayersOfLines::of(sheet, &outlines);
        let layer = |outline: &MeasuredChain| layers.of_line(outline.chain.line);
        let outlines = nest::drop_duplicates(outlines, findings);
        let is_block = sheet.block.is_some();
        let outlines = frame::without_frames(outlines, reading, is_block, layer, findings);
        let (mut outer, mut inner) = nest::nest(outlines);
        if matches!(reading, Outlines::Auto | Outlines::Sizes) {
            (outer, inner) = nest_gather::gather(outer, inner);
        }
        Some(Self {
            sheet,
            lines,
            taken,
            layers,
            outer,
            inner,
        })
    }

    /// Returns true if one of them has a sew line in it.
    fn have_sew_lines(&self) -> bool {
        let mut pairs = self.outer.iter().zip(&self.inner);
        pairs.any(|(outer, inner)| size_nest::has_allowance(outer, inner))
    }

    /// Returns the pieces. `has_sew_lines`: outlines of the file have them inside.
    fn into_pieces(
        self,
        reading: Outlines,
        has_sew_lines: bool,
        findings: &mut DxfFindings,
    ) -> Vec<DxfPiece> {
        let (sheet, lines) = (self.sheet, self.lines);
        let layer = |outline: &MeasuredChain| self.layers.of_line(outline.chain.line);
        let is_alone = self.outer.len() == 1 && sheet.block.is_some();
        let texts = marks::texts(sheet, &self.outer, is_alone, findings);
        let outer = self.outer.into_iter().zip(&texts);
        let mut pieces: Vec<DxfPiece> = outer
            .map(|(outline, own)| DxfPiece::new(sheet, outline, own, is_alone))
            .collect();
        for piece in &mut pieces {
            let line = piece.outline.chain.line;
            piece.is_sewn = lines.sew.iter().any(|sew| sew.line == line);
        }
        for (piece, mut inner) in pieces.iter_mut().zip(self.inner) {
            piece.nest =
                size_nest::take_sizes(piece, &mut inner, reading, has_sew_lines, layer, findings);
            inner_outlines::assign_inner_outlines(piece, inner, reading, layer, findings);
        }
        marks::assign(sheet, &lines.mirror, &mut pieces, is_alone, findings);
        assign::lines(&lines, &self.taken, &mut pieces, is_alone, findings);
        let split = |piece| nest_split::split(piece, findings);
        pieces.into_iter().flat_map(split).collect()
    }
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
