//! Skirts: sides and centers of front and back, levels below them, gores, or one panel closed on
//! itself.

use super::band::Opening;
use super::{side, top};
use crate::seam::suggest::edge_chain::{EdgeChain, length};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, FrontBack, Laterality, PanelKind};

/// A skirt is gathered to the bodice that it hangs from, and eased at most this far to a wider one.
const MIN_WAIST_TO_HEM: f64 = 0.7;
/// Least number of gores.
const MIN_GORES: usize = 3;

/// Sews the skirt.
pub(super) fn sew(garment: &mut GarmentModel) {
    levels(garment);
    top::center(garment, PanelKind::Skirt, FrontBack::Front);
    top::center(garment, PanelKind::Skirt, FrontBack::Back);
    gores(garment);
    on_itself(garment);
}

/// Returns fronts or backs, the uppermost first, with halves of one side only.
fn stack(
    garment: &GarmentModel,
    front_back: FrontBack,
    laterality: Laterality,
) -> Vec<LabeledPanel> {
    let here = |p: &&LabeledPanel| {
        p.front_back == Some(front_back) && (!p.half || p.laterality == Some(laterality))
    };
    let mut stack: Vec<LabeledPanel> = garment
        .parts_of(PanelKind::Skirt)
        .filter(here)
        .cloned()
        .collect();
    stack.sort_by_key(|p| p.number);
    stack
}

/// Sews the sides of every level, and each level to the one above.
fn levels(garment: &mut GarmentModel) {
    for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
        let fronts = stack(garment, FrontBack::Front, laterality);
        let backs = stack(garment, FrontBack::Back, laterality);
        for (i, (front, back)) in fronts.iter().zip(&backs).enumerate() {
            let of = |p: &LabeledPanel| {
                let drawn_side = if p.half {
                    None
                } else {
                    Some(p.drawn_side_of(laterality))
                };
                p.role_chain(EdgeRole::Side, drawn_side, EdgeRole::Waist)
            };
            let id = if i == 0 {
                format!("skirt-side-{side}")
            } else {
                format!("level-{i}-side-{side}")
            };
            garment.sew(
                SeamRationale::new(&id, "front and back of the skirt meet at the side"),
                of(front),
                of(back),
            );
        }
    }
    for (front_back, name) in [(FrontBack::Front, "front"), (FrontBack::Back, "back")] {
        let stack = stack(garment, front_back, Laterality::Left);
        for (i, pair) in stack
            .windows(2)
            .enumerate()
            .filter(|(_, pair)| !pair[0].half && !pair[1].half)
        {
            let of = |p: &LabeledPanel, role| {
                p.segment(role, None)
                    .map(|s| garment.across(p, s, Laterality::Left))
            };
            let (a, b) = (of(&pair[0], EdgeRole::Hem), of(&pair[1], EdgeRole::Waist));
            let id = format!("level-{}-{name}", i + 1);
            let rationale = SeamRationale::new(
                &id,
                "a level of the skirt hangs from the hem of the one above",
            )
            .gathered();
            garment.sew(rationale, a, b);
        }
    }
}

/// Returns panels all round that are called neither front nor back, in the order of their numbers.
fn all_round(garment: &GarmentModel) -> Vec<LabeledPanel> {
    let mut gores: Vec<LabeledPanel> = garment
        .parts_of(PanelKind::Skirt)
        .filter(|p| p.front_back.is_none() && !p.half)
        .cloned()
        .collect();
    gores.sort_by_key(|p| p.number);
    if gores.len() < MIN_GORES {
        vec![]
    } else {
        gores
    }
}

/// Returns the waist of a skirt of gores.
pub(super) fn gores_waist(garment: &GarmentModel) -> Option<Opening> {
    let gores = all_round(garment);
    let mut ring: EdgeChain = vec![];
    for gore in &gores {
        ring.extend(gore.chain(gore.segment(EdgeRole::Waist, None)?));
    }
    (!ring.is_empty()).then(|| [ring, vec![]])
}

/// Sews gores side to side, the last to the first.
fn gores(garment: &mut GarmentModel) {
    let gores = all_round(garment);
    for (i, gore) in gores.iter().enumerate() {
        let next = &gores[(i + 1) % gores.len()];
        let side = |p: &LabeledPanel, drawn_side| {
            p.role_chain(EdgeRole::Side, Some(drawn_side), EdgeRole::Waist)
        };
        let id = format!("gore-{}", i + 1);
        garment.sew(
            SeamRationale::new(&id, "gores meet side to side"),
            side(gore, DrawnSide::Right),
            side(next, DrawnSide::Left),
        );
    }
}

/// Returns true unless a bodice is there to whose hem the waist of a skirt cannot be gathered.
fn hangs_from_bodice(garment: &GarmentModel, part: &LabeledPanel) -> bool {
    side::hem_ring(garment).is_none_or(|hem| {
        part.role_length(EdgeRole::Waist) >= MIN_WAIST_TO_HEM * length(&hem.concat())
    })
}

/// Closes a skirt of one panel on itself.
fn on_itself(garment: &mut GarmentModel) {
    let panels: Vec<LabeledPanel> = garment.parts_of(PanelKind::Skirt).cloned().collect();
    let [part] = panels.as_slice() else {
        return;
    };
    if part.half || !hangs_from_bodice(garment, part) {
        return;
    }
    let [a, b] = [DrawnSide::Left, DrawnSide::Right]
        .map(|drawn_side| part.role_chain(EdgeRole::Side, Some(drawn_side), EdgeRole::Waist));
    garment.sew(
        SeamRationale::new("skirt-back", "a skirt of one panel is closed on itself"),
        a,
        b,
    );
}
