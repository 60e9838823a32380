//! Trousers: outer and inner leg seams, then the crotch.

use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews the trousers.
pub(super) fn sew(garment: &mut GarmentModel) {
    for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
        for (role, name, because) in [
            (
                EdgeRole::Side,
                "outseam",
                "front and back leg meet at the outside",
            ),
            (
                EdgeRole::Inseam,
                "inseam",
                "front and back leg meet at the inside",
            ),
        ] {
            let [a, b] = [FrontBack::Front, FrontBack::Back].map(|front_back| {
                garment.chain(
                    PanelKind::Trouser,
                    front_back,
                    (role, laterality),
                    EdgeRole::Hem,
                )
            });
            garment.sew(SeamRationale::new(&format!("{name}-{side}"), because), a, b);
        }
    }
    for (front_back, name) in [
        (FrontBack::Front, "crotch-front"),
        (FrontBack::Back, "crotch-back"),
    ] {
        let [a, b] = [Laterality::Left, Laterality::Right].map(|laterality| {
            garment.chain(
                PanelKind::Trouser,
                front_back,
                (EdgeRole::Crotch, laterality),
                EdgeRole::Waist,
            )
        });
        garment.sew(
            SeamRationale::new(name, "the left and the right leg meet at the crotch"),
            a,
            b,
        );
    }
}
