//! Cuffs: at the hem of a sleeve and at the hem of a trouser leg, and what hangs from them.

use super::band::{self, BandEdge, BandSet, Opening};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews the cuffs.
pub(super) fn sew(garment: &mut GarmentModel) {
    for host in [PanelKind::Sleeve, PanelKind::Trouser, PanelKind::Leg] {
        for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
            let mut opening = hem(garment, host, laterality);
            for flared in [false, true] {
                let (Some(at), Some(bands)) =
                    (&opening, cuffs(garment, host, (laterality, flared)))
                else {
                    continue;
                };
                let id = format!("{}-{side}", name(host, flared));
                let rationale = SeamRationale::new(&id, "the cuff goes round the hem").gathered();
                opening = band::sew_around(garment, rationale, at, &bands, BandEdge::Upper);
            }
        }
    }
}

fn name(host: PanelKind, flared: bool) -> &'static str {
    match (host, flared) {
        (PanelKind::Sleeve, false) => "cuff",
        (PanelKind::Sleeve, true) => "frill",
        (_, false) => "leg-cuff",
        (_, true) => "leg-frill",
    }
}

/// Returns the cuffs of one sleeve or leg; `flared` those whose name calls them a skirt.
fn cuffs(
    garment: &GarmentModel,
    host: PanelKind,
    (laterality, flared): (Laterality, bool),
) -> Option<BandSet> {
    let here = |p: &LabeledPanel| {
        let of_leg = p.of.contains(&PanelKind::Trouser) || !garment.has(PanelKind::Sleeve);
        band::is_on(p, laterality)
            && of_leg == (host != PanelKind::Sleeve)
            && p.of.contains(&PanelKind::Skirt) == flared
    };
    band::bands(garment, PanelKind::Cuff, here)
}

/// Returns the hem of one sleeve or leg, its front and its back part.
fn hem(garment: &GarmentModel, kind: PanelKind, laterality: Laterality) -> Option<Opening> {
    let (outer, inner) = if kind == PanelKind::Sleeve {
        (EdgeRole::Top, EdgeRole::Underarm)
    } else {
        (EdgeRole::Side, EdgeRole::Inseam)
    };
    let place = (EdgeRole::Hem, laterality);
    let halves = [
        garment.chain(kind, FrontBack::Front, place, outer),
        garment.chain(kind, FrontBack::Back, place, inner),
    ];
    if let [Some(front), Some(back)] = halves {
        return Some([front, back]);
    }
    let part = garment
        .parts_of(kind)
        .find(|p| !p.half && p.laterality == Some(laterality))?;
    Some([part.chain(part.segment(EdgeRole::Hem, None)?), vec![]])
}
