//! Tops: shoulders, sides and centers of a bodice, as every class of top has them.

use super::{side, vent, yoke};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews the bodice.
pub(super) fn sew(garment: &mut GarmentModel) {
    for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
        yoke::sew(garment, laterality, side);
        let [a, b] = [FrontBack::Front, FrontBack::Back]
            .map(|front_back| side::shoulder(garment, front_back, laterality));
        let id = format!("shoulder-{side}");
        let rationale = SeamRationale::new(&id, "front and back meet at the shoulder");
        garment.sew(rationale, a, b);
        side::sew(garment, laterality, side);
    }
    center(garment, PanelKind::Bodice, FrontBack::Front);
    center(garment, PanelKind::Bodice, FrontBack::Back);
}

/// Sews the two halves of a front or back together. A front with a placket stays open.
pub(super) fn center(garment: &mut GarmentModel, kind: PanelKind, front_back: FrontBack) {
    if front_back == FrontBack::Front && garment.has(PanelKind::Placket) {
        return;
    }
    let halves = [Laterality::Left, Laterality::Right].map(|laterality| {
        garment.chain(
            kind,
            front_back,
            (EdgeRole::Center, laterality),
            EdgeRole::Hem,
        )
    });
    let [a, b] = if kind == PanelKind::Skirt || front_back == FrontBack::Back {
        halves.map(|half| Some(vent::above(garment, half?)))
    } else {
        halves
    };
    let id = match (kind, front_back) {
        (PanelKind::Skirt, FrontBack::Front) => "skirt-centre-front",
        (PanelKind::Skirt, FrontBack::Back) => "skirt-centre-back",
        (_, FrontBack::Front) => "centre-front",
        (_, FrontBack::Back) => "centre-back",
    };
    let rationale = SeamRationale::new(id, "the left and the right half meet at the centre");
    garment.sew(rationale, a, b);
}
