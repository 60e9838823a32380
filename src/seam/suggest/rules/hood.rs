//! Hoods: two halves sewn together over the head, or to a strip between them, and to the neck.

use super::hood_edges::{edge, neck, neck_role};
use super::hood_of_three;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, Laterality, PanelKind};

/// Sews the hood.
pub(super) fn sew(garment: &mut GarmentModel) {
    let of = |garment: &GarmentModel, laterality| {
        garment
            .parts_of(PanelKind::Hood)
            .find(|p| p.laterality == Some(laterality) && !is_strip(p))
            .cloned()
    };
    let strip = garment.parts_of(PanelKind::Hood).find(|p| is_strip(p));
    let strip = strip.cloned();
    if strip.is_none() && is_of_three_parts(garment) {
        return;
    }
    let [Some(left), Some(right)] = [
        of(garment, Laterality::Left),
        of(garment, Laterality::Right),
    ] else {
        return;
    };
    let rationale = SeamRationale::new("hood-centre", "the halves of the hood meet over the head");
    let neck_role = neck_role(garment, &left, 0.0);
    if let Some(strip) = strip {
        return hood_of_three::sew(garment, [&left, &right], &strip);
    }
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

/// Returns true for the strip between the halves of a hood.
fn is_strip(part: &LabeledPanel) -> bool {
    part.segment(EdgeRole::Long, None).is_some()
}

/// Returns true if names tell of hood panels that are no copies of each other: what goes between
/// the halves is not known.
fn is_of_three_parts(garment: &GarmentModel) -> bool {
    let mut named = garment.parts_of(PanelKind::Hood).filter(|p| p.kind_named);
    let first = named.next();
    first.is_some_and(|first| named.any(|p| !p.features.is_twin(&first.features)))
}
