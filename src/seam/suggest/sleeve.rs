//! Sleeves: closed under the arm, set into the armhole that front and back make.

use super::cap;
use super::garment::{Garment, Saying};
use super::piece::{Chain, Hand, Kind, Lateral, Role, Which, reversed};

/// Sews the sleeves and sets them in.
pub(super) fn sew(garment: &mut Garment) {
    tell_left_from_right(garment);
    for (lateral, side) in [(Lateral::Left, "left"), (Lateral::Right, "right")] {
        if garment.piece(Kind::Sleeve, Which::Front, lateral).is_some() {
            halves(garment, lateral, side);
        } else {
            whole(garment, lateral, side);
        }
    }
}

/// Gives sleeves that are called neither left nor right the side that their front belongs to: a sleeve drawn hem down
/// and face up is a left one if its front lies on the left.
fn tell_left_from_right(garment: &mut Garment) {
    let mut done: Vec<usize> = vec![];
    for i in 0..garment.pieces.len() {
        let piece = &garment.pieces[i];
        if piece.kind != Kind::Sleeve || piece.half || piece.lateral_said || piece.lateral.is_none()
        {
            continue;
        }
        let partner = done
            .iter()
            .find(|j: &&usize| garment.pieces[**j].kind == Kind::Sleeve);
        let lateral = match (partner, cap::front_hand(garment, piece)) {
            (Some(j), _) => match garment.pieces[*j].lateral {
                Some(lateral) => lateral.other(),
                None => continue,
            },
            (None, Some(Hand::Left)) => Lateral::Left,
            (None, Some(Hand::Right)) => Lateral::Right,
            (None, None) => continue,
        };
        done.push(i);
        garment.pieces[i].lateral = Some(lateral);
    }
}

/// The armhole from the shoulder down the front and up the back.
fn armhole(garment: &Garment, lateral: Lateral) -> Option<Chain> {
    let place = (Role::Armhole, lateral);
    let mut ring = garment.chain(Kind::Bodice, Which::Front, place, Role::Shoulder)?;
    ring.extend(garment.chain(Kind::Bodice, Which::Back, place, Role::Side)?);
    Some(ring)
}

/// A sleeve of a front and a back half.
fn halves(garment: &mut Garment, lateral: Lateral, side: &str) {
    let part = |garment: &Garment, which, role, from| {
        garment.chain(Kind::Sleeve, which, (role, lateral), from)
    };
    for (role, name, because) in [
        (
            Role::Top,
            "sleeve-top",
            "the halves of the sleeve meet over the arm",
        ),
        (
            Role::Underarm,
            "underarm",
            "the halves of the sleeve meet under the arm",
        ),
    ] {
        let a = part(garment, Which::Front, role, Role::Hem);
        let b = part(garment, Which::Back, role, Role::Hem);
        garment.sew(Saying::new(&format!("{name}-{side}"), because), a, b);
    }
    let cap = part(garment, Which::Front, Role::Cap, Role::Top).and_then(|mut cap| {
        cap.extend(part(garment, Which::Back, Role::Cap, Role::Underarm)?);
        Some(cap)
    });
    let hole = armhole(garment, lateral);
    set_in(garment, side, hole, cap);
}

fn set_in(garment: &mut Garment, side: &str, hole: Option<Chain>, cap: Option<Chain>) {
    let id = format!("armhole-{side}");
    let because = "the sleeve is set into the armhole, front to front and underarm to underarm";
    garment.sew_round(Saying::new(&id, because).gathered(), hole, cap);
}

/// A sleeve in one piece.
fn whole(garment: &mut Garment, lateral: Lateral, side: &str) {
    let Some(piece) = garment
        .of(Kind::Sleeve)
        .find(|p| !p.half && p.lateral == Some(lateral))
    else {
        return;
    };
    let piece = piece.clone();
    let under = |hand| {
        piece
            .segment(Role::Underarm, Some(hand))
            .map(|s| piece.chain_from(s, Role::Hem))
    };
    let (a, b) = (under(Hand::Left), under(Hand::Right));
    garment.sew(
        Saying::new(
            &format!("underarm-{side}"),
            "the sleeve is closed under the arm",
        ),
        a,
        b,
    );
    if piece.segment(Role::Cap, None).is_none() {
        return;
    }
    let front = usual_front_hand(lateral);
    let hole = armhole(garment, lateral);
    let cap = piece.segment(Role::Cap, None).map(|segment| {
        let chain = piece.chain(segment);
        if piece.first_hand() == front {
            reversed(&chain)
        } else {
            chain
        }
    });
    // From the underarm up the back: the armhole turned to begin there.
    let hole = hole.map(|hole| from_underarm(garment, lateral, hole));
    set_in(garment, side, hole, cap);
}

/// The armhole from the underarm up the back and down the front.
fn from_underarm(garment: &Garment, lateral: Lateral, hole: Chain) -> Chain {
    let back = garment.segment(Kind::Bodice, Which::Back, (Role::Armhole, lateral));
    let count = hole.len() - back.map_or(0, |(_, s)| s.edges.len());
    let mut turned = hole;
    turned.rotate_left(count);
    turned
}

/// On which hand the front of a sleeve lies that is drawn hem down and face up: on the left for a left sleeve.
pub(super) fn usual_front_hand(lateral: Lateral) -> Hand {
    match lateral {
        Lateral::Left => Hand::Left,
        Lateral::Right => Hand::Right,
    }
}
