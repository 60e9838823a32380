//! Cuffs: at the hem of a sleeve and at the hem of a trouser leg, and what hangs from them.

use super::band::{self, Bands, Opening, Rim};
use super::garment::{Garment, Saying};
use super::piece::{Kind, Lateral, Piece, Role, Which};

/// Sews the cuffs.
pub(super) fn sew(garment: &mut Garment) {
    for host in [Kind::Sleeve, Kind::Trouser] {
        for (lateral, side) in [(Lateral::Left, "left"), (Lateral::Right, "right")] {
            let mut opening = hem(garment, host, lateral);
            for flared in [false, true] {
                let (Some(at), Some(bands)) = (&opening, cuffs(garment, host, (lateral, flared)))
                else {
                    continue;
                };
                let id = format!("{}-{side}", name(host, flared));
                let saying = Saying::new(&id, "the cuff goes round the hem").gathered();
                opening = band::round(garment, saying, at, &bands, Rim::Upper);
            }
        }
    }
}

fn name(host: Kind, flared: bool) -> &'static str {
    match (host, flared) {
        (Kind::Trouser, false) => "leg-cuff",
        (Kind::Trouser, true) => "leg-frill",
        (_, false) => "cuff",
        (_, true) => "frill",
    }
}

/// The cuffs of one sleeve or leg; `flared` those whose name calls them a skirt.
fn cuffs(garment: &Garment, host: Kind, (lateral, flared): (Lateral, bool)) -> Option<Bands> {
    let here = |p: &Piece| {
        let of_leg = p.of.contains(&Kind::Trouser) || !garment.has(Kind::Sleeve);
        band::is_on(p, lateral)
            && of_leg == (host == Kind::Trouser)
            && p.of.contains(&Kind::Skirt) == flared
    };
    band::bands(garment, Kind::Cuff, here)
}

/// The hem of one sleeve or leg, its front and its back part.
fn hem(garment: &Garment, kind: Kind, lateral: Lateral) -> Option<Opening> {
    let (outer, inner) = if kind == Kind::Sleeve {
        (Role::Top, Role::Underarm)
    } else {
        (Role::Side, Role::Inseam)
    };
    let place = (Role::Hem, lateral);
    let halves = [
        garment.chain(kind, Which::Front, place, outer),
        garment.chain(kind, Which::Back, place, inner),
    ];
    if let [Some(front), Some(back)] = halves {
        return Some([front, back]);
    }
    let piece = garment
        .of(kind)
        .find(|p| !p.half && p.lateral == Some(lateral))?;
    Some([piece.chain(piece.segment(Role::Hem, None)?), vec![]])
}
