//! Yokes: over the shoulders, between the fronts and the back under it.

use super::armhole;
use crate::seam::suggest::edge_chain::EdgeChain;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews the yoke of the back on one side of the wearer; with its left side to the back under it.
pub(super) fn sew(garment: &mut GarmentModel, laterality: Laterality, side: &str) {
    let Some(yoke) = armhole::yoke(garment).cloned() else {
        return;
    };
    let drawn_side = yoke.drawn_side_of(laterality);
    let a = garment.chain(
        PanelKind::Bodice,
        FrontBack::Front,
        (EdgeRole::Shoulder, laterality),
        EdgeRole::Neck,
    );
    let b = yoke.role_chain(EdgeRole::Shoulder, Some(drawn_side), EdgeRole::Neck);
    let id = format!("yoke-shoulder-{side}");
    let rationale = SeamRationale::new(&id, "the front meets the yoke at the shoulder");
    garment.sew(rationale, a, b);
    if laterality == Laterality::Left {
        let back = garment.half_ring(PanelKind::Bodice, EdgeRole::Neck, FrontBack::Back);
        let hem = yoke.segment(EdgeRole::Hem, None);
        let hem = hem.map(|s| garment.across(&yoke, s, Laterality::Right));
        let rationale = SeamRationale::new("yoke", "the back hangs from the yoke").gathered();
        garment.sew(rationale, back, hem);
    }
}

/// Returns the neck of the yoke from the wearer's right to the left.
pub(super) fn neck(garment: &GarmentModel) -> Option<EdgeChain> {
    let yoke = armhole::yoke(garment)?;
    let segment = yoke.segment(EdgeRole::Neck, None)?;
    Some(garment.across(yoke, segment, Laterality::Right))
}
