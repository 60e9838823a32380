//! Edges of hoods, and the halves of the neck that they are sewn to.

use crate::seam::suggest::edge_chain::{EdgeChain, length, reversed, up_to};
use crate::seam::suggest::garment_model::GarmentModel;
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// The edge that looks like the face is that at the neck if it fits by this much ease better.
const MIN_BETTER: f64 = 0.1;

/// Returns the role of the edge of a hood that fits the neck: its face and its neck look alike.
/// A strip between the halves takes up so much of the neck on each side \[m\].
pub(super) fn neck_role(garment: &GarmentModel, part: &LabeledPanel, strip: f64) -> EdgeRole {
    let neck = neck(garment, Laterality::Left).unwrap_or_default();
    let wanted = (length(&neck) - strip).max(f64::MIN_POSITIVE);
    let off = |role| {
        let own = length(&edge(part, role, role).unwrap_or_default());
        own.max(wanted) / own.min(wanted).max(f64::MIN_POSITIVE) - 1.0
    };
    if off(EdgeRole::Hem) + MIN_BETTER < off(EdgeRole::Neck) {
        EdgeRole::Hem
    } else {
        EdgeRole::Neck
    }
}

/// Returns an edge of half a hood from the face on, `neck` being the role of its edge at the neck.
pub(super) fn edge(part: &LabeledPanel, role: EdgeRole, neck: EdgeRole) -> Option<EdgeChain> {
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
pub(super) fn neck(garment: &GarmentModel, laterality: Laterality) -> Option<EdgeChain> {
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
