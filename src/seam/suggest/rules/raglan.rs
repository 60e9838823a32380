//! Raglan: sleeves that run up to the neck, between front and back.

use crate::seam::suggest::edge_chain::{EdgeChain, length, reversed};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews raglan sleeves to front and back.
pub(super) fn sew(garment: &mut GarmentModel) {
    for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
        let Some(part) = sleeve_on(garment, laterality).cloned() else {
            continue;
        };
        let front = front_side(garment, &part, laterality);
        for (front_back, drawn_side, name) in [
            (FrontBack::Front, front, "front"),
            (FrontBack::Back, front.other(), "back"),
        ] {
            let a = part.role_chain(EdgeRole::Armhole, Some(drawn_side), EdgeRole::Underarm);
            let b = garment.chain(
                PanelKind::Bodice,
                front_back,
                (EdgeRole::Armhole, laterality),
                EdgeRole::Side,
            );
            let id = format!("raglan-{name}-{side}");
            let rationale = SeamRationale::new(
                &id,
                "the raglan sleeve meets front and back from the underarm to the neck",
            );
            garment.sew(rationale, a, b);
        }
    }
}

/// Returns the raglan sleeve of one side.
pub(super) fn sleeve_on(garment: &GarmentModel, laterality: Laterality) -> Option<&LabeledPanel> {
    let raglan = |p: &&LabeledPanel| {
        p.laterality == Some(laterality) && p.segment(EdgeRole::Neck, None).is_some()
    };
    garment.parts_of(PanelKind::Sleeve).find(raglan)
}

/// Returns the side of the drawing of a raglan sleeve that fits the front better than the back.
pub(super) fn front_side(
    garment: &GarmentModel,
    part: &LabeledPanel,
    laterality: Laterality,
) -> DrawnSide {
    let of = |front_back| {
        garment
            .chain(
                PanelKind::Bodice,
                front_back,
                (EdgeRole::Armhole, laterality),
                EdgeRole::Side,
            )
            .map(|c| length(&c))
    };
    let own = |drawn_side| {
        part.segment(EdgeRole::Armhole, Some(drawn_side))
            .map(|s| part.features.length(&s.edges))
    };
    if let (Some(front), Some(back), Some(a), Some(b)) = (
        of(FrontBack::Front),
        of(FrontBack::Back),
        own(DrawnSide::Left),
        own(DrawnSide::Right),
    ) {
        let differs =
            (front - back).abs() > 0.01 * front.max(back) && (a - b).abs() > 0.01 * a.max(b);
        if differs {
            return if (front < back) == (a < b) {
                DrawnSide::Left
            } else {
                DrawnSide::Right
            };
        }
    }
    laterality.usual_front_side()
}

/// Returns the neck that front, back and both sleeves make, from the wearer's left round the front.
pub(super) fn neck(garment: &GarmentModel) -> Option<EdgeChain> {
    let [left, right] =
        [Laterality::Left, Laterality::Right].map(|laterality| across(garment, laterality));
    let mut ring = garment.half_ring(PanelKind::Bodice, EdgeRole::Neck, FrontBack::Front)?;
    ring.extend(right?);
    ring.extend(garment.half_ring(PanelKind::Bodice, EdgeRole::Neck, FrontBack::Back)?);
    ring.extend(reversed(&left?));
    Some(ring)
}

/// Returns the upper edge of a raglan sleeve from front to back.
fn across(garment: &GarmentModel, laterality: Laterality) -> Option<EdgeChain> {
    let part = sleeve_on(garment, laterality)?;
    let chain = part.chain(part.segment(EdgeRole::Neck, None)?);
    let front = front_side(garment, part, laterality);
    Some(if part.first_drawn_side() == front {
        chain
    } else {
        reversed(&chain)
    })
}
