//! Raglan: sleeves that run up to the neck, between front and back.

use super::garment::{Garment, Saying};
use super::piece::{Chain, Hand, Kind, Lateral, Piece, Role, Which, length};
use super::sleeve;

/// Sews raglan sleeves to front and back.
pub(super) fn sew(garment: &mut Garment) {
    for (lateral, side) in [(Lateral::Left, "left"), (Lateral::Right, "right")] {
        let Some(piece) = piece(garment, lateral).cloned() else {
            continue;
        };
        let front = front_hand(garment, &piece, lateral);
        for (which, hand, name) in [
            (Which::Front, front, "front"),
            (Which::Back, front.other(), "back"),
        ] {
            let a = piece
                .segment(Role::Armhole, Some(hand))
                .map(|s| piece.chain_from(s, Role::Underarm));
            let b = garment.chain(Kind::Bodice, which, (Role::Armhole, lateral), Role::Side);
            let id = format!("raglan-{name}-{side}");
            let saying = Saying::new(
                &id,
                "the raglan sleeve meets front and back from the underarm to the neck",
            );
            garment.sew(saying, a, b);
        }
    }
}

/// The raglan sleeve of one side.
pub(super) fn piece(garment: &Garment, lateral: Lateral) -> Option<&Piece> {
    let raglan = |p: &&Piece| p.lateral == Some(lateral) && p.segment(Role::Neck, None).is_some();
    garment.of(Kind::Sleeve).find(raglan)
}

/// The hand of a raglan sleeve that fits the front better than the back.
pub(super) fn front_hand(garment: &Garment, piece: &Piece, lateral: Lateral) -> Hand {
    let of = |which| {
        garment
            .chain(Kind::Bodice, which, (Role::Armhole, lateral), Role::Side)
            .map(|c| length(&c))
    };
    let own = |hand| {
        piece
            .segment(Role::Armhole, Some(hand))
            .map(|s| piece.shape.length(&s.edges))
    };
    if let (Some(front), Some(back), Some(a), Some(b)) = (
        of(Which::Front),
        of(Which::Back),
        own(Hand::Left),
        own(Hand::Right),
    ) {
        let differs =
            (front - back).abs() > 0.01 * front.max(back) && (a - b).abs() > 0.01 * a.max(b);
        if differs {
            return if (front < back) == (a < b) {
                Hand::Left
            } else {
                Hand::Right
            };
        }
    }
    sleeve::usual_front_hand(lateral)
}

/// The neck that front, back and both sleeves make, from the wearer's left round the front.
pub(super) fn neck(garment: &Garment) -> Option<Chain> {
    let [left, right] = [Lateral::Left, Lateral::Right].map(|lateral| across(garment, lateral));
    let mut ring = garment.half_ring(Kind::Bodice, Role::Neck, Which::Front)?;
    ring.extend(right?);
    ring.extend(garment.half_ring(Kind::Bodice, Role::Neck, Which::Back)?);
    ring.extend(super::piece::reversed(&left?));
    Some(ring)
}

/// The upper edge of a raglan sleeve from front to back.
fn across(garment: &Garment, lateral: Lateral) -> Option<Chain> {
    let piece = piece(garment, lateral)?;
    let chain = piece.chain(piece.segment(Role::Neck, None)?);
    let front = front_hand(garment, piece, lateral);
    Some(if piece.first_hand() == front {
        chain
    } else {
        super::piece::reversed(&chain)
    })
}
