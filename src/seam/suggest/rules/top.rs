//! Tops: shoulders, sides and centers of a bodice, as every class of top has them.

use super::{side, yoke};
use crate::seam::suggest::edge_chain::{EdgeChain, EdgeStep};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Turn from which a corner within the center of a skirt is that of a vent \[rad\].
const VENT_CORNER_RAD: f64 = 0.6;

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
    let [a, b] = if kind == PanelKind::Skirt {
        halves.map(|half| Some(above_vent(garment, half?)))
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

/// Returns what lies above a vent of the center of a skirt, given from the hem: all up to its first
/// sharp corner from the waist.
fn above_vent(garment: &GarmentModel, center: EdgeChain) -> EdgeChain {
    let Some(part) = center
        .first()
        .and_then(|step| garment.parts.iter().find(|p| p.panel == step.panel))
    else {
        return center;
    };
    let joint = |a: &EdgeStep, b: &EdgeStep| {
        let first = if a.forward { a.edge } else { b.edge };
        let ring = &part.features.ring;
        let at = ring.iter().position(|edge| *edge == first);
        at.map_or(0.0, |at| part.features.joints[at].abs())
    };
    let sharp = center
        .windows(2)
        .rposition(|pair| joint(&pair[0], &pair[1]) > VENT_CORNER_RAD);
    sharp.map_or(center.clone(), |at| center[at + 1..].to_vec())
}
