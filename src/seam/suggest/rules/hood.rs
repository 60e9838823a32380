//! Hoods: two halves sewn together over the head, and to the neck.

use crate::seam::suggest::edge_chain::{EdgeChain, length, reversed, up_to};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews the hood.
pub(super) fn sew(garment: &mut GarmentModel) {
    let of = |garment: &GarmentModel, laterality| {
        garment
            .parts_of(PanelKind::Hood)
            .find(|p| p.laterality == Some(laterality))
            .cloned()
    };
    let [Some(left), Some(right)] = [
        of(garment, Laterality::Left),
        of(garment, Laterality::Right),
    ] else {
        return;
    };
    let rationale = SeamRationale::new("hood-centre", "the halves of the hood meet over the head");
    let [a, b] = [&left, &right].map(|p| edge(p, EdgeRole::Center));
    garment.sew(rationale, a, b);
    for (part, laterality, id) in [
        (&left, Laterality::Left, "hood-left"),
        (&right, Laterality::Right, "hood-right"),
    ] {
        let rationale = SeamRationale::new(id, "the hood is sewn to the neck").gathered();
        let neck = neck(garment, laterality);
        garment.sew(rationale, neck, edge(part, EdgeRole::Neck));
    }
}

/// Returns an edge of half a hood from the face on.
fn edge(part: &LabeledPanel, role: EdgeRole) -> Option<EdgeChain> {
    part.role_chain(role, None, EdgeRole::Hem)
}

/// Returns the half of a neck that lies on both sides, from the shoulder to the center.
fn from_shoulder(
    garment: &GarmentModel,
    front_back: FrontBack,
    laterality: Laterality,
) -> Option<EdgeChain> {
    let part = garment.part(PanelKind::Bodice, front_back, laterality)?;
    let chain = garment.across(part, part.segment(EdgeRole::Neck, None)?, laterality);
    Some(up_to(&chain, 0.5 * length(&chain)))
}

/// Returns one half of the neck from the center front over the shoulder to the center back.
fn neck(garment: &GarmentModel, laterality: Laterality) -> Option<EdgeChain> {
    let place = (EdgeRole::Neck, laterality);
    let half = |front_back, from| {
        let chain = garment.chain(PanelKind::Bodice, front_back, place, from);
        chain.or_else(|| from_shoulder(garment, front_back, laterality))
    };
    let mut front = half(FrontBack::Front, EdgeRole::Shoulder)?;
    front = reversed(&front);
    front.extend(half(FrontBack::Back, EdgeRole::Shoulder)?);
    Some(front)
}
