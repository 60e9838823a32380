//! Skirts: sides and centres of front and back, levels below them, gores, or one panel closed on itself.

use super::band::Opening;
use super::garment::{Garment, Saying};
use super::piece::{Chain, Hand, Kind, Lateral, Piece, Role, Which};
use super::top;

/// Gores are at least so many.
const GORES: usize = 3;

/// Sews the skirt.
pub(super) fn sew(garment: &mut Garment) {
    levels(garment);
    top::centre(garment, Kind::Skirt, Which::Front);
    top::centre(garment, Kind::Skirt, Which::Back);
    gores(garment);
    on_itself(garment);
}

/// Fronts and backs, the uppermost first, with halves of one side only.
fn stack(garment: &Garment, which: Which, lateral: Lateral) -> Vec<Piece> {
    let here = |p: &&Piece| p.which == Some(which) && (!p.half || p.lateral == Some(lateral));
    let mut stack: Vec<Piece> = garment.of(Kind::Skirt).filter(here).cloned().collect();
    stack.sort_by_key(|p| p.number);
    stack
}

/// Sides of every level, and each level to the one above.
fn levels(garment: &mut Garment) {
    for (lateral, side) in [(Lateral::Left, "left"), (Lateral::Right, "right")] {
        let fronts = stack(garment, Which::Front, lateral);
        let backs = stack(garment, Which::Back, lateral);
        for (i, (front, back)) in fronts.iter().zip(&backs).enumerate() {
            let of = |p: &Piece| {
                let hand = if p.half {
                    None
                } else {
                    Some(p.hand_of(lateral))
                };
                p.segment(Role::Side, hand)
                    .map(|s| p.chain_from(s, Role::Waist))
            };
            let id = if i == 0 {
                format!("skirt-side-{side}")
            } else {
                format!("level-{i}-side-{side}")
            };
            garment.sew(
                Saying::new(&id, "front and back of the skirt meet at the side"),
                of(front),
                of(back),
            );
        }
    }
    for (which, name) in [(Which::Front, "front"), (Which::Back, "back")] {
        let stack = stack(garment, which, Lateral::Left);
        for (i, pair) in stack
            .windows(2)
            .enumerate()
            .filter(|(_, pair)| !pair[0].half && !pair[1].half)
        {
            let of = |p: &Piece, role| {
                p.segment(role, None)
                    .map(|s| garment.across(p, s, Lateral::Left))
            };
            let (a, b) = (of(&pair[0], Role::Hem), of(&pair[1], Role::Waist));
            let id = format!("level-{}-{name}", i + 1);
            let saying = Saying::new(
                &id,
                "a level of the skirt hangs from the hem of the one above",
            )
            .gathered();
            garment.sew(saying, a, b);
        }
    }
}

/// Panels all round that are called neither front nor back, in the order of their numbers.
fn all_round(garment: &Garment) -> Vec<Piece> {
    let mut gores: Vec<Piece> = garment
        .of(Kind::Skirt)
        .filter(|p| p.which.is_none() && !p.half)
        .cloned()
        .collect();
    gores.sort_by_key(|p| p.number);
    if gores.len() < GORES { vec![] } else { gores }
}

/// The waist of a skirt of gores.
pub(super) fn gores_waist(garment: &Garment) -> Option<Opening> {
    let gores = all_round(garment);
    let mut ring: Chain = vec![];
    for gore in &gores {
        ring.extend(gore.chain(gore.segment(Role::Waist, None)?));
    }
    (!ring.is_empty()).then(|| [ring, vec![]])
}

/// Gores are sewn side to side, the last to the first.
fn gores(garment: &mut Garment) {
    let gores = all_round(garment);
    for (i, gore) in gores.iter().enumerate() {
        let next = &gores[(i + 1) % gores.len()];
        let side = |p: &Piece, hand| {
            p.segment(Role::Side, Some(hand))
                .map(|s| p.chain_from(s, Role::Waist))
        };
        let id = format!("gore-{}", i + 1);
        garment.sew(
            Saying::new(&id, "gores meet side to side"),
            side(gore, Hand::Right),
            side(next, Hand::Left),
        );
    }
}

/// A skirt of one panel is closed on itself.
fn on_itself(garment: &mut Garment) {
    let panels: Vec<Piece> = garment.of(Kind::Skirt).cloned().collect();
    let [piece] = panels.as_slice() else {
        return;
    };
    if piece.half {
        return;
    }
    let [a, b] = [Hand::Left, Hand::Right].map(|hand| {
        piece
            .segment(Role::Side, Some(hand))
            .map(|s| piece.chain_from(s, Role::Waist))
    });
    garment.sew(
        Saying::new("skirt-back", "a skirt of one panel is closed on itself"),
        a,
        b,
    );
}
