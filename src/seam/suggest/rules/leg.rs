//! Legs in one piece, front and back together, as of leggings: each closed on its inside, then both
//! sewn together at the crotch.

use crate::seam::suggest::edge_chain::{EdgeChain, reversed};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, Laterality, PanelKind};
use crate::seam::suggest::orientation;

/// Sews the legs.
pub(super) fn sew(garment: &mut GarmentModel) {
    for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
        let Some(leg) = leg(garment, laterality) else {
            continue;
        };
        let [a, b] = [DrawnSide::Left, DrawnSide::Right]
            .map(|side| leg.role_chain(EdgeRole::Inseam, Some(side), EdgeRole::Hem));
        let id = format!("inseam-{side}");
        let rationale = SeamRationale::new(&id, "the leg is closed on its inside");
        garment.sew(rationale, a, b);
    }
    let (Some(left), Some(right)) = (
        leg(garment, Laterality::Left),
        leg(garment, Laterality::Right),
    ) else {
        return;
    };
    for (is_front, id, because) in [
        (
            true,
            "crotch-front",
            "the legs meet at the crotch, in front where it is shorter",
        ),
        (
            false,
            "crotch-back",
            "the legs meet at the crotch, behind where it is longer",
        ),
    ] {
        let [a, b] = [&left, &right].map(|leg| {
            let front = front_side(leg);
            let side = if is_front { front } else { front.other() };
            leg.role_chain(EdgeRole::Crotch, Some(side), EdgeRole::Waist)
        });
        garment.sew(SeamRationale::new(id, because), a, b);
    }
}

/// Returns the waist of both legs, from the center back over the left side to the front and on over
/// the right side. Either leg is front and back.
pub(super) fn waist(garment: &GarmentModel) -> Option<[EdgeChain; 2]> {
    let around = |laterality, begins_in_front: bool| {
        let leg = leg(garment, laterality)?;
        let chain = leg.chain(leg.segment(EdgeRole::Waist, None)?);
        let is_from_front = leg.first_drawn_side() == front_side(&leg);
        Some(if is_from_front == begins_in_front {
            chain
        } else {
            reversed(&chain)
        })
    };
    let mut ring = around(Laterality::Left, false)?;
    ring.extend(around(Laterality::Right, true)?);
    Some([ring, vec![]])
}

fn leg(garment: &GarmentModel, laterality: Laterality) -> Option<LabeledPanel> {
    let mut legs = garment.parts_of(PanelKind::Leg);
    legs.find(|p| p.laterality == Some(laterality)).cloned()
}

/// Returns the side of the drawing on which the front of a leg lies.
fn front_side(leg: &LabeledPanel) -> DrawnSide {
    let usual = leg
        .laterality
        .unwrap_or(Laterality::Left)
        .usual_front_side();
    orientation::shorter_crotch(leg).unwrap_or(usual)
}
