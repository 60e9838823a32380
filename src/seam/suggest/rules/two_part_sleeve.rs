//! Sleeves of an upper and an under part, as of a jacket: closed by a seam in front of and one
//! behind the arm, and set into the armhole together.

use super::armhole;
use crate::seam::suggest::edge_chain::{
    CORNER_TOLERANCE_M, EdgeChain, beginning_at, length, reversed,
};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale, ease};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, Laterality, PanelKind};

/// A notch on the cap of an under sleeve marks the underarm if it is this near to its middle, as a
/// share of the cap.
const NEAR_MIDDLE: f64 = 0.3;

/// Gives upper sleeves that are called neither left nor right the side of the wearer that their
/// front belongs to: the left if it lies on the left of the drawing.
pub(super) fn assign_left_right(garment: &mut GarmentModel) {
    let is_upper = |p: &&mut LabeledPanel| p.kind == PanelKind::Sleeve && !p.half;
    for part in garment.parts.iter_mut().filter(is_upper) {
        if let (Some(side), false) = (front_side(part), part.laterality_named) {
            part.laterality = Some(match side {
                DrawnSide::Left => Laterality::Left,
                DrawnSide::Right => Laterality::Right,
            });
        }
    }
    turn_under_sleeves(garment);
}

/// Gives under sleeves that are called neither left nor right the side on which their outer side is
/// out: their front lies on the other side of the drawing than that of the upper sleeve.
fn turn_under_sleeves(garment: &mut GarmentModel) {
    let on_left = |garment: &GarmentModel, kind| {
        let here = |p: &&LabeledPanel| !p.half && p.laterality == Some(Laterality::Left);
        garment.parts_of(kind).find(here).cloned()
    };
    let upper = on_left(garment, PanelKind::Sleeve);
    let under = on_left(garment, PanelKind::UnderSleeve);
    let (Some(upper), Some(under)) = (upper, under) else {
        return;
    };
    if is_crossed(&upper, &under) {
        return;
    }
    let is_unsaid = |p: &&mut LabeledPanel| p.kind == PanelKind::UnderSleeve && !p.laterality_named;
    for part in garment.parts.iter_mut().filter(is_unsaid) {
        part.laterality = part.laterality.map(Laterality::other);
    }
}

/// Sews the two parts of a sleeve to each other and into the armhole.
pub(super) fn sew(garment: &mut GarmentModel, laterality: Laterality, side: &str) {
    let find = |kind| {
        let here = |p: &&LabeledPanel| !p.half && p.laterality == Some(laterality);
        garment.parts_of(kind).find(here).cloned()
    };
    let (Some(upper), Some(under)) = (find(PanelKind::Sleeve), find(PanelKind::UnderSleeve)) else {
        return;
    };
    let crossed = is_crossed(&upper, &under);
    let front = front_side(&upper).unwrap_or_else(|| laterality.usual_front_side());
    for (drawn_side, name) in [(front, "front"), (front.other(), "back")] {
        let other = if crossed {
            drawn_side.other()
        } else {
            drawn_side
        };
        let id = format!("sleeve-{name}-{side}");
        let because = "the upper and the under sleeve meet along the arm";
        let [a, b] = [(&upper, drawn_side), (&under, other)]
            .map(|(part, at)| part.role_chain(EdgeRole::Underarm, Some(at), EdgeRole::Hem));
        garment.sew(SeamRationale::new(&id, because), a, b);
    }
    // From the front of the arm over it, then under it back to the front.
    let over = cap_from(&upper, front);
    let below = cap_from(&under, if crossed { front } else { front.other() });
    let (Some(over), Some(below)) = (over, below) else {
        return;
    };
    let hole = armhole::of(garment, laterality);
    let hole = hole.map(|hole| {
        // Up the front and down the back. The middle of the under sleeve, or a notch near to it,
        // lies at the underarm: so far up the front the seam in front of the arm meets the armhole.
        let ring = reversed(&hole.around_from_underarm());
        let whole = (length(&below) + length(&over)).max(f64::MIN_POSITIVE);
        let before = length(&below) * (1.0 - underarm(&under, &below)) / whole * length(&ring);
        beginning_at(&ring, before, CORNER_TOLERANCE_M)
    });
    let cap = [over, below].concat();
    armhole::set_in(garment, laterality, hole, Some(cap));
}

/// Returns the place of the underarm along the cap of an under sleeve, as a share of it.
fn underarm(under: &LabeledPanel, cap: &EdgeChain) -> f64 {
    let whole = length(cap).max(f64::MIN_POSITIVE);
    let mut before = 0.0;
    let mut marked: Vec<f64> = vec![];
    for step in cap {
        let notches = under.features.notches.iter();
        for (_, at) in notches.filter(|(edge, _)| *edge == step.edge) {
            let along = if step.forward { *at } else { 1.0 - at };
            marked.push((before + along * step.length) / whole);
        }
        before += step.length;
    }
    let off = |at: &f64| (at - 0.5).abs();
    let near = marked.into_iter().filter(|at| off(at) < NEAR_MIDDLE);
    near.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0.5)
}

/// Returns true if the left edge of the upper sleeve as drawn fits the right one of the under
/// sleeve better than the left one.
fn is_crossed(upper: &LabeledPanel, under: &LabeledPanel) -> bool {
    let edge = |part: &LabeledPanel, side| {
        let chain = part.role_chain(EdgeRole::Underarm, Some(side), EdgeRole::Hem);
        chain.unwrap_or_default()
    };
    let [left, right] = [DrawnSide::Left, DrawnSide::Right].map(|side| edge(upper, side));
    let [under_left, under_right] =
        [DrawnSide::Left, DrawnSide::Right].map(|side| edge(under, side));
    let straight = ease(&left, &under_left) + ease(&right, &under_right);
    let crossed = ease(&left, &under_right) + ease(&right, &under_left);
    crossed < straight
}

/// Returns the side of the drawing on which the front of an upper sleeve lies: a vent is at the
/// back; else its seam ends lower on the front, the back one runs up to the height of the shoulder
/// blade.
fn front_side(upper: &LabeledPanel) -> Option<DrawnSide> {
    let edges = |side| Some(&upper.segment(EdgeRole::Underarm, Some(side))?.edges);
    let (left, right) = (edges(DrawnSide::Left)?, edges(DrawnSide::Right)?);
    let vents = [left, right].map(|edges| upper.features.ends_in_vent(edges));
    match vents {
        [true, false] => return Some(DrawnSide::Right),
        [false, true] => return Some(DrawnSide::Left),
        _ => {}
    }
    let [left, right] = [left, right].map(|edges| upper.features.length(edges));
    Some(if left < right {
        DrawnSide::Left
    } else {
        DrawnSide::Right
    })
}

/// Returns the cap of a part from one side of the drawing to the other.
fn cap_from(part: &LabeledPanel, side: DrawnSide) -> Option<EdgeChain> {
    let chain = part.chain(part.segment(EdgeRole::Cap, None)?);
    Some(if part.first_drawn_side() == side {
        chain
    } else {
        reversed(&chain)
    })
}
