//! The holes of a panel, from the cutouts of its piece.

use super::corners::CorneredRing;
use super::dxf_piece::DxfPiece;
use super::folds::Folds;
use super::rings::{self, RingOf};
use crate::config::Limits;
use crate::pattern::Hole;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::outline::Outline;

/// Returns the holes, counter-clockwise: the cutouts of a piece, with `bays` that unfolding closed;
/// of a piece on the fold, those of the whole.
pub(super) fn holes(
    piece: &DxfPiece,
    folds: &Folds,
    bays: Vec<CorneredRing>,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Vec<Hole> {
    let bays = bays.into_iter().map(|ring| (piece.line, ring));
    let mut rings: Vec<(usize, CorneredRing)> = bays.collect();
    for chain in &piece.cutouts {
        let part = RingOf::Hole(piece, chain.line);
        if let Some(ring) = rings::checked(part, chain, limits, findings) {
            let whole = folds.unfolded_holes(ring).into_iter();
            rings.extend(whole.map(|ring| (chain.line, ring)));
        }
    }
    let simple = |(line, ring)| rings::simple(RingOf::Hole(piece, line), ring, findings);
    rings.into_iter().filter_map(simple).map(hole).collect()
}

fn hole(ring: CorneredRing) -> Hole {
    let mut ring = ring.into_clockwise();
    ring.points[1..].reverse();
    ring.is_corner[1..].reverse();
    let outline = Outline::cut(&ring.points, &ring.is_corner);
    Hole {
        corners: outline.corners,
        edges: outline.edges,
    }
}
