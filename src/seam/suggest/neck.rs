//! Necks and armholes: bands, bindings and collars round them.

use super::band::{self, Bands, Laid, Opening, Rim};
use super::garment::{Garment, Saying, ease};
use super::piece::{Kind, Lateral, Piece, Role, Which};
use super::raglan;

/// What may be sewn to a neck, what is nearest to the body first.
const ROUND_NECKS: [Kind; 3] = [Kind::NeckBand, Kind::CollarStand, Kind::Collar];
/// A band may be shorter than the neck by this, to be stretched on.
const MOST_EASE: f64 = 0.36;
/// How much looking like no band counts against ease.
const LOOK: f64 = 0.05;

/// Sews what goes round the neck and round armholes without sleeves.
pub(super) fn sew(garment: &mut Garment) {
    if !quarters(garment) {
        neckband(garment);
    }
    for (lateral, side) in [(Lateral::Left, "left"), (Lateral::Right, "right")] {
        armhole(garment, lateral, side);
    }
}

/// The neck's front and back part.
fn neck(garment: &Garment) -> Option<Opening> {
    if let Some(ring) = raglan::neck(garment) {
        return Some([ring, vec![]]);
    }
    let both =
        [Which::Front, Which::Back].map(|which| garment.half_ring(Kind::Bodice, Role::Neck, which));
    match both {
        [Some(front), Some(back)] => Some([front, back]),
        _ => None,
    }
}

/// The band or collar that fits the neck best.
fn neckband(garment: &mut Garment) {
    let Some(neck) = neck(garment) else { return };
    let whole = neck.concat();
    let mut found: Vec<(f64, &Piece)> = vec![];
    for kind in ROUND_NECKS {
        for piece in garment.of(kind).filter(|p| p.which.is_none()) {
            if let Some(laid) = band::lay(garment, &whole, piece, Rim::Lower) {
                found.push((ease(&whole, &laid.chain), piece));
            }
        }
    }
    let one = found
        .into_iter()
        .min_by(|a, b| (a.0 + LOOK * a.1.cost).total_cmp(&(b.0 + LOOK * b.1.cost)));
    let bands = match one {
        Some((ease, piece)) if ease <= MOST_EASE => Some(Bands::One(Box::new(piece.clone()))),
        _ => ROUND_NECKS
            .iter()
            .find_map(|kind| band::bands(garment, *kind, |p| p.which.is_some())),
    };
    if let Some(bands) = bands {
        band::round(
            garment,
            Saying::new("neckband", "it goes round the neck").gathered(),
            &neck,
            &bands,
            Rim::Lower,
        );
    }
}

/// A collar of four parts: left and right, front and back.
fn quarters(garment: &mut Garment) -> bool {
    let lay = |garment: &Garment, which, lateral| -> Option<Laid> {
        let here = |p: &&Piece| p.which == Some(which) && p.lateral == Some(lateral);
        let part = garment.of(Kind::Collar).find(here)?;
        let neck = garment.chain(Kind::Bodice, which, (Role::Neck, lateral), Role::Shoulder)?;
        band::lay(garment, &neck, part, Rim::Lower)
    };
    let sides = [(Lateral::Left, "left"), (Lateral::Right, "right")];
    let mut laid: Vec<[Option<Laid>; 2]> = vec![];
    let mut any = false;
    for (lateral, side) in sides {
        let parts = [Which::Front, Which::Back].map(|which| lay(garment, which, lateral));
        for (which, name, part) in [
            (Which::Front, "front", &parts[0]),
            (Which::Back, "back", &parts[1]),
        ] {
            let neck = garment.chain(Kind::Bodice, which, (Role::Neck, lateral), Role::Shoulder);
            let id = format!("collar-{name}-{side}");
            any |= garment.sew(
                Saying::new(&id, "the collar goes round the neck").gathered(),
                neck,
                part.as_ref().map(|l| l.chain.clone()),
            );
        }
        let shoulder = parts
            .each_ref()
            .map(|p| p.as_ref().and_then(|l| l.end(true)));
        let [a, b] = shoulder;
        let id = format!("collar-shoulder-{side}");
        garment.sew(band::ends(&id), a, b);
        laid.push(parts);
    }
    for (i, id) in ["collar-centre-front", "collar-centre-back"]
        .into_iter()
        .enumerate()
    {
        let of = |side: usize| laid[side][i].as_ref().and_then(|l| l.end(false));
        garment.sew(band::ends(id), of(0), of(1));
    }
    any
}

fn armhole(garment: &mut Garment, lateral: Lateral, side: &str) {
    let place = (Role::Armhole, lateral);
    let front = garment.chain(Kind::Bodice, Which::Front, place, Role::Shoulder);
    let back = garment.chain(Kind::Bodice, Which::Back, place, Role::Side);
    let band = garment
        .of(Kind::ArmBand)
        .find(|p| p.lateral == Some(lateral))
        .cloned();
    if let (Some(front), Some(back), Some(band)) = (front, back, band) {
        let id = format!("armband-{side}");
        let saying = Saying::new(&id, "the band goes round the armhole").gathered();
        band::round(
            garment,
            saying,
            &[front, back],
            &Bands::One(Box::new(band)),
            Rim::Lower,
        );
    }
}
