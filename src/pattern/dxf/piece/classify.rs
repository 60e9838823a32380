//! Sheets to pieces: the outlines, and the piece that every other line, mark and text lies in.

use super::dxf_piece::{DxfPiece, InnerLine};
use super::lines::SheetLines;
use super::{assign, marks, nest};
use crate::config::Limits;
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::findings::DxfFindings;

/// Returns the pieces of all sheets; outlines that do not close become faults.
pub(crate) fn pieces(
    sheets: &[DxfSheet],
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Vec<DxfPiece> {
    sheets
        .iter()
        .flat_map(|sheet| pieces_of_sheet(sheet, limits.panels, findings))
        .collect()
}

fn pieces_of_sheet(
    sheet: &DxfSheet,
    panel_limit: usize,
    findings: &mut DxfFindings,
) -> Vec<DxfPiece> {
    let lines = SheetLines::of(sheet);
    let outlines = lines.outlines(sheet, findings);
    let taken = outlines.iter().map(|outline| outline.chain.key()).collect();
    // Sizes and letters drawn as outlines make more outlines than panels, but not without end.
    if outlines.len() > 4 * panel_limit {
        let fault = nest::too_many(outlines.len(), panel_limit, sheet.line);
        findings.faults.push(fault);
        return Vec::new();
    }
    let (outer, inner) = nest::nest(nest::drop_duplicates(outlines, findings));
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
    for (owner, inner) in inner {
        let kind = if pieces[owner].outline.is_sewn_on(&inner) {
            InnerLine::Sew
        } else {
            InnerLine::Drawn
        };
        pieces[owner].add_line(inner.chain, kind);
    }
    assign::lines(&lines, &taken, &mut pieces, is_alone, findings);
    marks::assign(sheet, &lines.mirror, &mut pieces, is_alone, findings);
    pieces
}
