//! Lines given to the pieces that they lie in.

use super::chain::{ChainKey, PathChain};
use super::dxf_piece::{DxfPiece, InnerLine, outlines, owner};
use super::gap::closed_in_words;
use super::lines::SheetLines;
use super::measured::MeasuredChain;
use crate::fault::PatternCode;
use crate::pattern::dxf::findings::DxfFindings;
use std::collections::BTreeSet;

/// At most this many lines are compared with the outlines about them; more are taken as drawn
/// lines.
const COMPARED: usize = 1000;

/// Gives every line that is not among the outlines to the piece that it lies in; one that lies in
/// none is warned about.
pub(super) fn lines(
    lines: &SheetLines,
    outlines: &BTreeSet<ChainKey>,
    pieces: &mut [DxfPiece],
    is_alone: bool,
    findings: &mut DxfFindings,
) {
    let mut assigner = LineAssigner {
        pieces,
        is_alone,
        findings,
    };
    let is_free = |chain: &&PathChain| !outlines.contains(&chain.key());
    for chain in lines.sew.iter().filter(is_free) {
        assigner.give(chain, Some(InnerLine::Sew));
    }
    for chain in &lines.cutout {
        assigner.give(chain, Some(InnerLine::Hole));
    }
    for (i, chain) in lines.internal.iter().enumerate() {
        assigner.give(chain, (i >= COMPARED).then_some(InnerLine::Drawn));
    }
    let drawn = lines.boundary.iter().chain(&lines.general);
    for (i, chain) in drawn.filter(is_free).enumerate() {
        let may_cut = i < COMPARED && (!chain.closed || lines.seam_first);
        if !(may_cut && assigner.give_cut_line(chain)) {
            assigner.give(chain, Some(InnerLine::Drawn));
        }
    }
}

/// The pieces of a sheet as lines are given to them.
struct LineAssigner<'a> {
    pieces: &'a mut [DxfPiece],
    /// True if the sheet holds one piece.
    is_alone: bool,
    findings: &'a mut DxfFindings,
}

impl LineAssigner<'_> {
    /// Gives a line to the first piece without a cut line that it runs about as one; false if there
    /// is none.
    fn give_cut_line(&mut self, chain: &PathChain) -> bool {
        let mut pieces = self.pieces.iter_mut();
        let Some(piece) = pieces.find(|p| p.cut.is_none() && p.outline.is_cut_along(chain)) else {
            return false;
        };
        piece.cut = Some(chain.clone());
        self.warn_of_gap(chain);
        true
    }

    /// Gives a chain to the piece that it lies in. Without a kind, it is a sew line where its
    /// course is that of one.
    fn give(&mut self, chain: &PathChain, kind: Option<InnerLine>) {
        let middle = chain.points.get(chain.points.len() / 2).copied();
        let owner = middle.and_then(|p| owner(outlines(self.pieces), p, self.is_alone));
        let Some(owner) = owner else {
            let kind = "line outside the pieces";
            self.findings.skip_many(kind, chain.line, chain.path_count);
            return;
        };
        if chain.points.len() < 2 {
            self.findings.skip("line of a single point", chain.line);
            return;
        }
        let kind = kind.unwrap_or_else(|| kind_by_course(&self.pieces[owner], chain));
        if kind == InnerLine::Drawn {
            self.warn_of_gap(chain);
        }
        self.pieces[owner].add_line(chain.clone(), kind);
    }

    /// Warns of a gap in a line that no outline is made of; those of outlines are reported with
    /// their panel.
    fn warn_of_gap(&mut self, chain: &PathChain) {
        if let Some(detail) = closed_in_words(&chain.gaps, "a line") {
            self.findings
                .warn(PatternCode::GapClosed, chain.line, detail);
        }
    }
}

/// Returns `Sew` where a line runs along the outline of a piece without a sew line, else `Drawn`.
fn kind_by_course(piece: &DxfPiece, chain: &PathChain) -> InnerLine {
    let may_be_sewn = chain.closed && piece.sew.is_none() && !piece.is_sewn;
    if may_be_sewn && piece.outline.is_sewn_on(&MeasuredChain::new(chain.clone())) {
        InnerLine::Sew
    } else {
        InnerLine::Drawn
    }
}
