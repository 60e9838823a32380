//! Hoods: two halves sewn together over the head, and to the neck.

use super::garment::{Garment, Saying};
use super::piece::{Chain, Kind, Lateral, Piece, Role, Which};

/// Sews the hood.
pub(super) fn sew(garment: &mut Garment) {
    let of = |garment: &Garment, lateral| {
        garment
            .of(Kind::Hood)
            .find(|p| p.lateral == Some(lateral))
            .cloned()
    };
    let [Some(left), Some(right)] = [of(garment, Lateral::Left), of(garment, Lateral::Right)]
    else {
        return;
    };
    let saying = Saying::new("hood-centre", "the halves of the hood meet over the head");
    let [a, b] = [&left, &right].map(|p| edge(p, Role::Centre));
    garment.sew(saying, a, b);
    for (piece, lateral, id) in [
        (&left, Lateral::Left, "hood-left"),
        (&right, Lateral::Right, "hood-right"),
    ] {
        let saying = Saying::new(id, "the hood is sewn to the neck").gathered();
        let neck = neck(garment, lateral);
        garment.sew(saying, neck, edge(piece, Role::Neck));
    }
}

/// An edge of half a hood from the face on.
fn edge(piece: &Piece, role: Role) -> Option<Chain> {
    Some(piece.chain_from(piece.segment(role, None)?, Role::Hem))
}

/// One half of the neck from the centre front over the shoulder to the centre back.
fn neck(garment: &Garment, lateral: Lateral) -> Option<Chain> {
    let place = (Role::Neck, lateral);
    let mut neck = garment.chain(Kind::Bodice, Which::Front, place, Role::Centre)?;
    neck.extend(garment.chain(Kind::Bodice, Which::Back, place, Role::Shoulder)?);
    Some(neck)
}
