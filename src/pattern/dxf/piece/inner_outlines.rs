//! Closed outlines inside the outline of a piece, on a layer of outlines: a sew line, a hole, or a
//! line drawn on the cloth.

use super::dxf_piece::{DxfPiece, InnerLine};
use super::measured::MeasuredChain;
use crate::pattern::Outlines;
use crate::pattern::dxf::drawing::layers::{LayerRole, role};
use crate::pattern::dxf::findings::DxfFindings;

/// Gives the outlines that lie in that of a piece to it. What the layers do not tell is warned
/// about.
///
/// One that runs beside the outline is the sew line. Another one is a hole on a layer of what is
/// cut and a drawn line elsewhere. `layer`: that of the line that an outline begins at.
pub(super) fn assign_inner_outlines<'a>(
    piece: &mut DxfPiece,
    inner: Vec<MeasuredChain>,
    reading: Outlines,
    layer: impl Fn(&MeasuredChain) -> &'a str,
    findings: &mut DxfFindings,
) {
    for outline in inner {
        let is_cut = role(layer(&outline)) == LayerRole::Boundary;
        let kind = match reading {
            Outlines::Holes => InnerLine::Hole,
            Outlines::Lines => InnerLine::Drawn,
            _ if piece.outline.is_sewn_on(&outline) => InnerLine::Sew,
            _ if is_cut => InnerLine::Hole,
            _ => InnerLine::Drawn,
        };
        if reading == Outlines::Auto && role(layer(&outline)) != LayerRole::Sew {
            findings.note_inside(taken_as(kind), outline.chain.line);
        }
        piece.add_line(outline.chain, kind);
    }
}

/// Returns the words for an outline in another, with the readings that take it otherwise.
fn taken_as(kind: InnerLine) -> &'static str {
    match kind {
        InnerLine::Sew => "sew lines (outlines=sizes, holes or lines takes them otherwise)",
        InnerLine::Hole => "holes (outlines=lines takes them otherwise)",
        InnerLine::Drawn => "drawn lines (outlines=holes or pieces takes them otherwise)",
    }
}
