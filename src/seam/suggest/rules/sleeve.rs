//! Sleeves: closed under the arm, set into the armhole that front and back make.

use super::{armhole, sleeve_cap, two_part_sleeve};
use crate::seam::suggest::edge_chain::reversed;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews the sleeves and sets them in.
pub(super) fn sew(garment: &mut GarmentModel) {
    assign_left_right(garment);
    if garment.has(PanelKind::UnderSleeve) {
        two_part_sleeve::assign_left_right(garment);
    }
    for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
        if garment
            .part(PanelKind::Sleeve, FrontBack::Front, laterality)
            .is_some()
        {
            halves(garment, laterality, side);
        } else if garment.has(PanelKind::UnderSleeve) {
            two_part_sleeve::sew(garment, laterality, side);
        } else {
            whole(garment, laterality, side);
        }
    }
}

/// Gives sleeves that are called neither left nor right the side that their front belongs to: a
/// sleeve drawn hem down and face up is a left one if its front lies on the left.
fn assign_left_right(garment: &mut GarmentModel) {
    let mut done: Vec<usize> = vec![];
    for i in 0..garment.parts.len() {
        let part = &garment.parts[i];
        if part.kind != PanelKind::Sleeve
            || part.half
            || part.laterality_named
            || part.laterality.is_none()
        {
            continue;
        }
        let partner = done
            .iter()
            .find(|j: &&usize| garment.parts[**j].kind == PanelKind::Sleeve);
        let laterality = match (partner, sleeve_cap::front_side(garment, part)) {
            (Some(j), _) => match garment.parts[*j].laterality {
                Some(laterality) => laterality.other(),
                None => continue,
            },
            (None, Some(DrawnSide::Left)) => Laterality::Left,
            (None, Some(DrawnSide::Right)) => Laterality::Right,
            (None, None) => continue,
        };
        done.push(i);
        garment.parts[i].laterality = Some(laterality);
    }
}

/// Sews a sleeve of a front and a back half.
fn halves(garment: &mut GarmentModel, laterality: Laterality, side: &str) {
    let part = |garment: &GarmentModel, front_back, role, from| {
        garment.chain(PanelKind::Sleeve, front_back, (role, laterality), from)
    };
    for (role, name, because) in [
        (
            EdgeRole::Top,
            "sleeve-top",
            "the halves of the sleeve meet over the arm",
        ),
        (
            EdgeRole::Underarm,
            "underarm",
            "the halves of the sleeve meet under the arm",
        ),
    ] {
        let a = part(garment, FrontBack::Front, role, EdgeRole::Hem);
        let b = part(garment, FrontBack::Back, role, EdgeRole::Hem);
        garment.sew(SeamRationale::new(&format!("{name}-{side}"), because), a, b);
    }
    let cap = part(garment, FrontBack::Front, EdgeRole::Cap, EdgeRole::Top).and_then(|mut cap| {
        cap.extend(part(
            garment,
            FrontBack::Back,
            EdgeRole::Cap,
            EdgeRole::Underarm,
        )?);
        Some(cap)
    });
    let hole = armhole::of(garment, laterality).map(|hole| hole.around_from_shoulder());
    armhole::set_in(garment, laterality, hole, cap);
}

/// Sews a sleeve of one panel.
fn whole(garment: &mut GarmentModel, laterality: Laterality, side: &str) {
    let Some(part) = garment
        .parts_of(PanelKind::Sleeve)
        .find(|p| !p.half && p.laterality == Some(laterality))
    else {
        return;
    };
    let part = part.clone();
    let [a, b] = [DrawnSide::Left, DrawnSide::Right]
        .map(|side| part.role_chain(EdgeRole::Underarm, Some(side), EdgeRole::Hem));
    garment.sew(
        SeamRationale::new(
            &format!("underarm-{side}"),
            "the sleeve is closed under the arm",
        ),
        a,
        b,
    );
    if part.segment(EdgeRole::Cap, None).is_none() {
        return;
    }
    let front = laterality.usual_front_side();
    let hole = armhole::of(garment, laterality).map(|hole| hole.around_from_underarm());
    let cap = part.segment(EdgeRole::Cap, None).map(|segment| {
        let chain = part.chain(segment);
        if part.first_drawn_side() == front {
            reversed(&chain)
        } else {
            chain
        }
    });
    armhole::set_in(garment, laterality, hole, cap);
}
