//! The holes of a panel, from the cutouts of its piece.

use super::corners::CorneredRing;
use super::dxf_piece::DxfPiece;
use super::fold::FoldLine;
use super::rings;
use crate::config::Limits;
use crate::pattern::Hole;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::outline::Outline;

/// Returns the holes, counter-clockwise; on a half piece the mirror image of each as well.
pub(super) fn holes(
    piece: &DxfPiece,
    fold: Option<FoldLine>,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Vec<Hole> {
    let mut holes = Vec::new();
    for chain in &piece.cutouts {
        let Some(ring) = rings::checked(piece, chain, limits, findings) else {
            continue;
        };
        let image = fold.map(|fold| CorneredRing {
            points: ring.points.iter().map(|p| fold.mirror(*p)).collect(),
            is_corner: ring.is_corner.clone(),
        });
        for ring in [Some(ring), image].into_iter().flatten() {
            if rings::is_simple(piece, &ring, findings) {
                holes.push(hole(ring));
            }
        }
    }
    holes
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
