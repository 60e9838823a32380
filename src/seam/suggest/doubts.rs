//! What speaks against a reading of a panel: its name, its symmetry, how it lies in its drawing, how such panels are made.

use super::classify::BODY;
use super::piece::{Kind, Piece, Role, Step, Which};
use super::sides::side_hand;
use super::words;
use crate::pattern::Panel;

/// Misfit added where the name or the symmetry of a panel speaks against a reading.
const UNLIKELY: f64 = 3.0;
/// Misfit added for half a skirt panel that no name calls so.
const HALF_SKIRT: f64 = 1.5;
/// Misfit added where a reading contradicts how such panels are made.
const ABSURD: f64 = 1.5;
/// Misfit added for a panel drawn on its side, for one drawn hem up, and for a front drawn as seen through the body.
const ON_ITS_SIDE: f64 = 0.8;
const UPSIDE_DOWN: f64 = 0.8;
const FROM_INSIDE: f64 = 0.3;
/// A waist this much longer than the hem is unusual.
const WIDE_WAIST: f64 = 1.1;
/// An edge that turns less is straight, one that turns more curved \[rad\].
const STRAIGHT: f64 = 0.15;
const CURVED: f64 = 0.6;

/// What speaks against taking a panel for half or for whole.
pub(super) fn unlikely(kind: Kind, half: bool, said: &words::Said, symmetric: bool) -> f64 {
    let halved = match kind {
        Kind::Sleeve => Some(said.which.is_some()),
        Kind::Bodice | Kind::Skirt if said.lateral.is_some() => Some(true),
        Kind::Bodice | Kind::Skirt | Kind::Trouser => symmetric.then_some(false),
        _ => None,
    };
    match halved {
        Some(halved) if halved != half => UNLIKELY,
        None if half && kind == Kind::Skirt => HALF_SKIRT,
        _ => 0.0,
    }
}

/// What speaks against how a reading says that a panel is drawn: on its side, hem up, or a front as seen through the body.
pub(super) fn unusual(piece: &Piece, upright: Option<bool>) -> f64 {
    let lower: Vec<usize> = piece
        .all(Role::Hem)
        .chain(piece.all(Role::Long))
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let mut cost = if is_absurd(piece) { ABSURD } else { 0.0 };
    if piece.kind == Kind::Sleeve || lower.is_empty() {
        return cost;
    }
    if upright.is_some_and(|upright| piece.shape.is_level(&lower) != upright) {
        cost += ON_ITS_SIDE;
    }
    let hem: Vec<usize> = piece
        .all(Role::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let above = piece.shape.height(&hem) > piece.shape.height(&piece.shape.ring);
    if upright == Some(true) && !hem.is_empty() && above {
        cost += UPSIDE_DOWN;
    }
    if piece.kind == Kind::Skirt && piece.number == 0 {
        let length = |role| -> f64 { piece.all(role).map(|s| piece.shape.length(&s.edges)).sum() };
        if length(Role::Waist) > WIDE_WAIST * length(Role::Hem) {
            cost += UPSIDE_DOWN;
        }
    }
    let said = piece
        .lateral
        .filter(|_| piece.half && piece.which == Some(Which::Front) && BODY.contains(&piece.kind));
    if said.is_some() && side_hand(piece).map(|hand| piece.lateral_of(hand)) != said {
        cost += FROM_INSIDE;
    }
    cost
}

/// Whether a reading has what no such panel has: shoulders that rise towards the arm, an underarm longer than the sleeve,
/// a cap that is straight, a hood whose opening is round, slits for godets in the waist.
fn is_absurd(piece: &Piece) -> bool {
    let hem: Vec<usize> = piece
        .all(Role::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let rising = piece.all(Role::Shoulder).any(|shoulder| {
        let chain = piece.chain_from(shoulder, Role::Neck);
        let end = |step: Option<&Step>, last: bool| {
            step.map(|s| piece.shape.edges[s.edge].ends[usize::from(s.forward == last)])
        };
        match (end(chain.first(), false), end(chain.last(), true)) {
            (Some(neck), Some(arm)) => piece.shape.above(&hem, neck) < piece.shape.above(&hem, arm),
            _ => false,
        }
    });
    let length = |role| -> f64 { piece.all(role).map(|s| piece.shape.length(&s.edges)).sum() };
    let curl = |role| -> f64 { piece.all(role).map(|s| piece.shape.curl(&s.edges)).sum() };
    let straight_cap = piece.segment(Role::Cap, None).is_some() && curl(Role::Cap) < STRAIGHT;
    let curved_face = piece.kind == Kind::Hood && curl(Role::Hem) > CURVED;
    let short_top = length(Role::Top) > 0.0 && length(Role::Underarm) > length(Role::Top);
    let count = |role| -> usize { piece.all(role).map(|s| s.edges.len()).sum() };
    let slit_waist = piece.shape.slits && count(Role::Waist) > count(Role::Hem);
    rising || slit_waist || straight_cap || curved_face || short_top
}

/// Whether a panel stands or lies in its drawing, as far as its grain says.
pub(super) fn upright(panel: &Panel) -> Option<bool> {
    let Some(grain) = panel.grain else {
        return Some(true);
    };
    let from_vertical = (grain.angle_deg - 90.0).abs();
    match from_vertical {
        d if d <= 30.0 => Some(true),
        d if d >= 60.0 => Some(false),
        _ => None,
    }
}
