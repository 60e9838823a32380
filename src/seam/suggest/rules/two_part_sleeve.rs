//! Sleeves of an upper and an under part, as of a jacket: closed by a seam in front of and one
//! behind the arm, and set into the armhole together.

use super::armhole;
use crate::seam::suggest::edge_chain::{EdgeChain, beginning_at, length, reversed};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale, ease};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, Laterality, PanelKind};

/// An armhole may begin at a corner this far from where the middle of the under sleeve meets it
/// \[m\].
const CORNER_TOLERANCE_M: f64 = 0.004;

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
    let front = front_side(&upper).unwrap_or_else(|| armhole::usual_front_side(laterality));
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
    let (Some(over), Some(mut below)) = (over, below) else {
        return;
    };
    if crossed {
        below = reversed(&below);
    }
    let hole = armhole::of(garment, laterality);
    let hole = hole.map(|hole| {
        // Up the front and down the back. The middle of the under sleeve lies at the underarm, so
        // that the seam in front of the arm meets the armhole half its width up the front.
        let ring = reversed(&hole.around_from_underarm());
        let whole = (length(&below) + length(&over)).max(f64::MIN_POSITIVE);
        let before = 0.5 * length(&below) / whole * length(&ring);
        beginning_at(&ring, before, CORNER_TOLERANCE_M)
    });
    let cap = [over, below].concat();
    armhole::set_in(garment, side, hole, Some(cap));
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

/// Returns the side of the drawing on which the front of an upper sleeve lies: its seam ends lower
/// on the front, the back one runs up to the height of the shoulder blade.
fn front_side(upper: &LabeledPanel) -> Option<DrawnSide> {
    let length = |side| {
        let segment = upper.segment(EdgeRole::Underarm, Some(side))?;
        Some(upper.features.length(&segment.edges))
    };
    let (left, right) = (length(DrawnSide::Left)?, length(DrawnSide::Right)?);
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
