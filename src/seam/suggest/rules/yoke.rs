//! Yokes: over the shoulders, between the fronts and the back under it.

use crate::seam::suggest::edge_chain::EdgeChain;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews the yoke of the back on one side of the wearer; with its left side to the back under it.
pub(super) fn sew(garment: &mut GarmentModel, laterality: Laterality, side: &str) {
    let place = (EdgeRole::Shoulder, laterality);
    let shoulder = |garment: &GarmentModel, kind, front_back| {
        garment.chain(kind, front_back, place, EdgeRole::Neck)
    };
    let a = shoulder(garment, PanelKind::Bodice, FrontBack::Front);
    let b = shoulder(garment, PanelKind::Yoke, FrontBack::Back);
    let id = format!("yoke-shoulder-{side}");
    let rationale = SeamRationale::new(&id, "the front meets the yoke at the shoulder");
    garment.sew(rationale, a, b);
    if laterality == Laterality::Left {
        let back = garment.half_ring(PanelKind::Bodice, EdgeRole::Neck, FrontBack::Back);
        let hem = garment.half_ring(PanelKind::Yoke, EdgeRole::Hem, FrontBack::Back);
        let rationale = SeamRationale::new("yoke", "the back hangs from the yoke").gathered();
        garment.sew(rationale, back, hem);
        halves(garment);
    }
}

/// Sews the two halves of a yoke to each other; one drawn whole has no center.
fn halves(garment: &mut GarmentModel) {
    let [a, b] = [Laterality::Left, Laterality::Right].map(|laterality| {
        let place = (EdgeRole::Center, laterality);
        garment.chain(PanelKind::Yoke, FrontBack::Back, place, EdgeRole::Hem)
    });
    let because = "the left and the right half of the yoke meet at the center";
    garment.sew(SeamRationale::new("yoke-center", because), a, b);
}

/// Returns the neck of the yoke from the wearer's right to the left.
pub(super) fn neck(garment: &GarmentModel) -> Option<EdgeChain> {
    garment.half_ring(PanelKind::Yoke, EdgeRole::Neck, FrontBack::Back)
}
