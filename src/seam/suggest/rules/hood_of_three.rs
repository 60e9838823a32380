//! Hoods of three parts: a strip from the nape over the head to the face, and a part on each side
//! of it.

use super::hood_edges::{edge, neck, neck_role};
use crate::seam::suggest::edge_chain::{EdgeChain, length, reversed, up_to};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale, ease};
use crate::seam::suggest::labeled_panel::{LabeledPanel, RoleSegment};
use crate::seam::suggest::labels::{EdgeRole, Laterality};

/// Most by which a strip and the edge beside it differ.
const MAX_EASE: f64 = 0.06;

/// Sews the strip to both sides, and all three to the neck.
pub(super) fn sew(garment: &mut GarmentModel, sides: [&LabeledPanel; 2], strip: &LabeledPanel) {
    let ends = strip.segments_of(EdgeRole::End);
    let lengths = ends.map(|end| strip.features.length(&end.edges));
    let narrow = lengths.fold(f64::INFINITY, f64::min);
    let role = neck_role(garment, sides[0], 0.5 * narrow);
    let Some(nape) = nape(garment, (sides[0], role), strip) else {
        return;
    };
    let Some([right, left]) = strip.beside(nape) else {
        return;
    };
    // With its outer side up and the nape on the left, the wearer's left is above: after the nape
    // in clockwise order.
    let away = [strip.chain(left), reversed(&strip.chain(right))];
    let centers = sides.map(|part| edge(part, EdgeRole::Center, role).unwrap_or_default());
    if centers
        .iter()
        .zip(&away)
        .any(|(a, b)| ease(a, b) > MAX_EASE)
    {
        return; // It is no strip of this hood.
    }
    let across = strip.chain(nape);
    let ends = [reversed(&across), across];
    let names = [Laterality::Left, Laterality::Right];
    for (i, (part, laterality)) in sides.into_iter().zip(names).enumerate() {
        let name = if i == 0 { "left" } else { "right" };
        let id = format!("hood-strip-{name}");
        let because = "the side of the hood meets the strip over the head";
        let center = edge(part, EdgeRole::Center, role).map(|chain| reversed(&chain));
        garment.sew(
            SeamRationale::new(&id, because),
            center,
            Some(away[i].clone()),
        );
        let id = format!("hood-{name}");
        let rationale = SeamRationale::new(&id, "the hood is sewn to the neck").gathered();
        let half = up_to(&ends[i], 0.5 * length(&ends[i]));
        let own: Option<EdgeChain> = edge(part, role, role).map(|own| [own, half].concat());
        garment.sew(rationale, neck(garment, laterality), own);
    }
}

/// Returns the end of a strip at the nape: that which fits what the sides leave of the neck.
fn nape<'a>(
    garment: &GarmentModel,
    (side, role): (&LabeledPanel, EdgeRole),
    strip: &'a LabeledPanel,
) -> Option<&'a RoleSegment> {
    let own = length(&edge(side, role, role)?);
    let left = 2.0 * (length(&neck(garment, Laterality::Left)?) - own);
    let off = |end: &&RoleSegment| (strip.features.length(&end.edges) - left).abs();
    strip
        .segments_of(EdgeRole::End)
        .min_by(|a, b| off(a).total_cmp(&off(b)))
}
