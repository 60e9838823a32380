//! Waists: a waistband on a skirt or trousers, and the dress: bodice and skirt or trousers sewn together.

use super::band::{self, Opening, Rim};
use super::garment::{Garment, Saying};
use super::piece::{Kind, Role, Which};
use super::skirt;

/// Sews what meets at the waist.
pub(super) fn sew(garment: &mut Garment) {
    let lower = opening(garment, Kind::Trouser, Role::Waist)
        .or_else(|| opening(garment, Kind::Skirt, Role::Waist))
        .or_else(|| skirt::gores_waist(garment));
    let upper = opening(garment, Kind::Bodice, Role::Hem);
    let Some(bands) = band::bands(garment, Kind::Waistband, |_| true) else {
        if let (Some(upper), Some(lower)) = (upper, lower) {
            join(garment, &upper, &lower);
        }
        return;
    };
    let both = lower.is_some() && upper.is_some();
    if let Some(lower) = lower {
        let saying = Saying::new("waistband", "the waistband goes round the waist").gathered();
        band::round(
            garment,
            saying,
            &lower,
            &bands,
            if both { Rim::Lowest } else { Rim::Lower },
        );
    }
    if let Some(upper) = upper {
        let saying =
            Saying::new("bodice-waistband", "the bodice is sewn to the waistband").gathered();
        band::round(
            garment,
            saying,
            &upper,
            &bands,
            if both { Rim::Uppermost } else { Rim::Upper },
        );
    }
}

/// The bodice sewn to what hangs from it.
fn join(garment: &mut Garment, upper: &Opening, lower: &Opening) {
    let saying = Saying::new(
        "waist",
        "the bodice is sewn to what hangs from it at the waist",
    )
    .gathered();
    let (a, b) = (upper.concat(), lower.concat());
    if lower[1].is_empty() || upper[1].is_empty() {
        garment.sew_anyhow(saying, &a, &b);
    } else {
        garment.sew_round(saying, Some(a), Some(b));
    }
}

/// An opening round the body, its front and its back part.
fn opening(garment: &Garment, kind: Kind, role: Role) -> Option<Opening> {
    let both = [Which::Front, Which::Back].map(|which| garment.half_ring(kind, role, which));
    if let [Some(front), Some(back)] = both {
        return Some([front, back]);
    }
    let mut pieces = garment.of(kind);
    let (Some(piece), None) = (pieces.next(), pieces.next()) else {
        return None;
    };
    Some([piece.chain(piece.segment(role, None)?), vec![]])
}
