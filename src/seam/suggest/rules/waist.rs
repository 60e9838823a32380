//! Waists: a waistband on a skirt or trousers, and the dress: bodice and skirt or trousers sewn
//! together.

use super::band::{self, BandEdge, Opening};
use super::skirt;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, PanelKind};

/// Sews bodice, waistband and skirt or trousers together at the waist.
pub(super) fn sew(garment: &mut GarmentModel) {
    let lower = opening(garment, PanelKind::Trouser, EdgeRole::Waist)
        .or_else(|| opening(garment, PanelKind::Skirt, EdgeRole::Waist))
        .or_else(|| skirt::gores_waist(garment));
    let upper = opening(garment, PanelKind::Bodice, EdgeRole::Hem);
    let Some(bands) = band::bands(garment, PanelKind::Waistband, |_| true) else {
        if let (Some(upper), Some(lower)) = (upper, lower) {
            join(garment, &upper, &lower);
        }
        return;
    };
    let both = lower.is_some() && upper.is_some();
    if let Some(lower) = lower {
        let rationale =
            SeamRationale::new("waistband", "the waistband goes round the waist").gathered();
        band::sew_around(
            garment,
            rationale,
            &lower,
            &bands,
            if both {
                BandEdge::Lowest
            } else {
                BandEdge::Lower
            },
        );
    }
    if let Some(upper) = upper {
        let rationale =
            SeamRationale::new("bodice-waistband", "the bodice is sewn to the waistband")
                .gathered();
        band::sew_around(
            garment,
            rationale,
            &upper,
            &bands,
            if both {
                BandEdge::Uppermost
            } else {
                BandEdge::Upper
            },
        );
    }
}

/// Sews the bodice to what hangs from it.
fn join(garment: &mut GarmentModel, upper: &Opening, lower: &Opening) {
    let rationale = SeamRationale::new(
        "waist",
        "the bodice is sewn to what hangs from it at the waist",
    )
    .gathered();
    let (a, b) = (upper.concat(), lower.concat());
    if lower[1].is_empty() || upper[1].is_empty() {
        garment.sew_free_ring(rationale, &a, &b);
    } else {
        garment.sew_ring(rationale, Some(a), Some(b));
    }
}

/// Returns an opening round the body, its front and its back part.
fn opening(garment: &GarmentModel, kind: PanelKind, role: EdgeRole) -> Option<Opening> {
    let both = [FrontBack::Front, FrontBack::Back]
        .map(|front_back| garment.half_ring(kind, role, front_back));
    if let [Some(front), Some(back)] = both {
        return Some([front, back]);
    }
    let mut parts = garment.parts_of(kind);
    let (Some(part), None) = (parts.next(), parts.next()) else {
        return None;
    };
    Some([part.chain(part.segment(role, None)?), vec![]])
}
