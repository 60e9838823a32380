//! Hoods: two halves sewn together over the head, and to the neck. Hoods of three parts are not
//! sewn.

use crate::seam::suggest::edge_chain::{EdgeChain, length, reversed, up_to};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale, ease};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// The edge that looks like the face is that at the neck if it fits by this much ease better.
const MIN_BETTER: f64 = 0.1;

/// Sews the hood.
pub(super) fn sew(garment: &mut GarmentModel) {
    if is_of_three_parts(garment) {
        return;
    }
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
    let neck_role = neck_role(garment, &left);
    let [a, b] = [&left, &right].map(|p| edge(p, EdgeRole::Center, neck_role));
    garment.sew(rationale, a, b);
    for (part, laterality, id) in [
        (&left, Laterality::Left, "hood-left"),
        (&right, Laterality::Right, "hood-right"),
    ] {
        let rationale = SeamRationale::new(id, "the hood is sewn to the neck").gathered();
        let neck = neck(garment, laterality);
        garment.sew(rationale, neck, edge(part, neck_role, neck_role));
    }
}

/// Returns true if names tell of hood panels that are no copies of each other: what goes between
/// the halves is not known.
fn is_of_three_parts(garment: &GarmentModel) -> bool {
    let mut named = garment.parts_of(PanelKind::Hood).filter(|p| p.kind_named);
    let first = named.next();
    first.is_some_and(|first| named.any(|p| !p.features.is_twin(&first.features)))
}

/// Returns the role of the edge of a hood that fits the neck: its face and its neck look alike.
fn neck_role(garment: &GarmentModel, part: &LabeledPanel) -> EdgeRole {
    let neck = neck(garment, Laterality::Left).unwrap_or_default();
    let off = |role| {
        let chain = edge(part, role, role).unwrap_or_default();
        ease(&neck, &chain)
    };
    if off(EdgeRole::Hem) + MIN_BETTER < off(EdgeRole::Neck) {
        EdgeRole::Hem
    } else {
        EdgeRole::Neck
    }
}

/// Returns an edge of half a hood from the face on, `neck` being the role of its edge at the neck.
fn edge(part: &LabeledPanel, role: EdgeRole, neck: EdgeRole) -> Option<EdgeChain> {
    let face = if neck == EdgeRole::Neck {
        EdgeRole::Hem
    } else {
        EdgeRole::Neck
    };
    part.role_chain(role, None, face)
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
