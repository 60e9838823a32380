//! Vents: slits with an underlap at the lower end of a seam, which stay open.

use crate::seam::suggest::edge_chain::{EdgeChain, EdgeStep, length};
use crate::seam::suggest::garment_model::GarmentModel;

/// Turn from which a corner within a seam is that of a vent \[rad\].
const CORNER_RAD: f64 = 0.6;

/// Returns what lies above a vent of a side of a seam, given from the hem: all up to its first
/// sharp corner from the upper end, if that is the longer part.
pub(super) fn above(garment: &GarmentModel, side: EdgeChain) -> EdgeChain {
    let Some(part) = side
        .first()
        .and_then(|step| garment.parts.iter().find(|p| p.panel == step.panel))
    else {
        return side;
    };
    let joint = |a: &EdgeStep, b: &EdgeStep| {
        let first = if a.forward { a.edge } else { b.edge };
        let ring = &part.features.ring;
        let at = ring.iter().position(|edge| *edge == first);
        at.map_or(0.0, |at| part.features.joints[at].abs())
    };
    let sharp = side
        .windows(2)
        .rposition(|pair| joint(&pair[0], &pair[1]) > CORNER_RAD);
    match sharp.map(|at| side.split_at(at + 1)) {
        Some((below, above)) if length(above) >= length(below) => above.to_vec(),
        _ => side,
    }
}
