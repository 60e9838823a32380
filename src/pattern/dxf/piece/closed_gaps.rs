//! Gaps in the outlines of pieces that were closed, as they are told.

use super::dxf_piece::DxfPiece;
use super::gap::listed;
use crate::fault::PatternCode;
use crate::pattern::dxf::findings::DxfFindings;

/// Warns of the gaps in the outlines of pieces that were closed, each with its size and place.
pub(crate) fn warn(pieces: &mut [DxfPiece], findings: &mut DxfFindings) {
    for piece in pieces {
        let gaps = &piece.outline.gaps;
        let (verb, head) = match gaps.len() {
            0 => continue,
            1 => ("was", "a gap".to_owned()),
            count => ("were", format!("{count} gaps")),
        };
        let detail = format!(
            "{head} in the outline of {:?} {verb} closed: {}",
            piece.name,
            listed(gaps)
        );
        let chain = &mut piece.outline.chain;
        findings.warn(PatternCode::GapClosed, chain.line, detail);
        // It is told.
        chain.closed_gap = None;
    }
}
