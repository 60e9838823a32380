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
    let saying = Saying {
        id: "hood-centre",
        because: "the halves of the hood meet over the head",
        stage: 0,
        gather: false,
    };
    let [a, b] = [&left, &right].map(|p| edge(p, Role::Centre));
    garment.sew(saying, a, b);
    for (piece, lateral, id) in [
        (&left, Lateral::Left, "hood-left"),
        (&right, Lateral::Right, "hood-right"),
    ] {
        let saying = Saying {
            id,
            because: "the hood is sewn to the neck",
            stage: 0,
            gather: true,
        };
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
