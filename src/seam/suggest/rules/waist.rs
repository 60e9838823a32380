//! Waists: a waistband on a skirt or trousers, and the dress: bodice and skirt or trousers sewn
//! together.

use super::band::{self, BandEdge, Opening};
use super::{leg, side, skirt};
use crate::seam::suggest::edge_chain::EdgeStep;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Sews bodice, waistband and skirt or trousers together at the waist.
pub(super) fn sew(garment: &mut GarmentModel) {
    let lower = opening(garment, PanelKind::Trouser, EdgeRole::Waist)
        .or_else(|| leg::waist(garment))
        .or_else(|| opening(garment, PanelKind::Skirt, EdgeRole::Waist))
        .or_else(|| skirt::gores_waist(garment));
    let upper = opening(garment, PanelKind::Bodice, EdgeRole::Hem);
    if left_and_right(garment, lower.as_ref().or(upper.as_ref())) {
        return;
    }
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

/// Sews a waistband of a left and a right half; returns true if there is one.
fn left_and_right(garment: &mut GarmentModel, opening: Option<&Opening>) -> bool {
    let half = |laterality| {
        let here = |p: &&LabeledPanel| p.front_back.is_none() && p.laterality == Some(laterality);
        garment.parts_of(PanelKind::Waistband).find(here).cloned()
    };
    let halves = [half(Laterality::Left), half(Laterality::Right)];
    let ([Some(left), Some(right)], Some(opening)) = (halves, opening) else {
        return false;
    };
    // From the center back over the left side to the front, and on over the right side.
    let mut ring = opening.concat();
    let behind = middle(&opening[1], opening[0].len());
    ring.rotate_left(behind);
    let lay = |part: &LabeledPanel| band::lay(garment, &ring, part, BandEdge::Lower);
    let (Some(left), Some(right)) = (lay(&left), lay(&right)) else {
        return false;
    };
    let both = [left.chain.clone(), right.chain.clone()].concat();
    let rationale = SeamRationale::new("waistband", "both halves of the band go round the waist");
    if !garment.sew_ring(rationale.gathered(), Some(ring), Some(both)) {
        return false;
    }
    for (id, a, b) in [
        ("waistband-end-front", left.end(false), right.end(true)),
        ("waistband-end-back", right.end(false), left.end(true)),
    ] {
        garment.sew(band::ends_rationale(id), a, b);
    }
    true
}

/// Returns the number of steps to the middle of a part of an opening that `before` steps precede.
fn middle(part: &[EdgeStep], before: usize) -> usize {
    let mut so_far = 0.0;
    let whole: f64 = part.iter().map(|step| step.length).sum();
    let passed = part.iter().take_while(|step| {
        so_far += step.length;
        so_far <= 0.5 * whole + 1e-3
    });
    before + passed.count()
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
    if kind == PanelKind::Bodice
        && let Some(hem) = side::hem_ring(garment)
    {
        return Some(hem);
    }
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
