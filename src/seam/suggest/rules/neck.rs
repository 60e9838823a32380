//! Necks and armholes: bands, bindings and collars round them.

use super::band::{self, BandEdge, BandSet, LaidBand, Opening};
use super::{raglan, yoke};
use crate::seam::suggest::edge_chain::{EdgeChain, EdgeStep, length, reversed, up_to};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale, ease};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Kinds that may be sewn to a neck, the nearest to the body first.
const ROUND_NECKS: [PanelKind; 3] = [
    PanelKind::NeckBand,
    PanelKind::CollarStand,
    PanelKind::Collar,
];
/// A band may be shorter than the neck by this, to be stretched on.
const MAX_EASE: f64 = 0.36;
/// A stand that reaches less beyond its collar ends with it \[m\].
const MIN_BEYOND_M: f64 = 0.004;
/// A collar has at least this share of the length of its stand.
const MIN_FALL: f64 = 0.8;
/// Weight of a band's misfit against ease.
const MISFIT_WEIGHT: f64 = 0.05;

/// Sews what goes round the neck and round armholes without sleeves.
pub(super) fn sew(garment: &mut GarmentModel) {
    if !quarters(garment) {
        neckband(garment);
    }
    for (laterality, side) in [(Laterality::Left, "left"), (Laterality::Right, "right")] {
        armhole(garment, laterality, side);
    }
}

/// Returns the neck's front and back part.
pub(super) fn neck(garment: &GarmentModel) -> Option<Opening> {
    if let Some(ring) = raglan::neck(garment) {
        return Some([ring, vec![]]);
    }
    let both = [FrontBack::Front, FrontBack::Back]
        .map(|front_back| garment.half_ring(PanelKind::Bodice, EdgeRole::Neck, front_back));
    match both {
        [Some(front), Some(back)] => Some([front, yoke::neck(garment).unwrap_or(back)]),
        [Some(front), None] => Some([front, yoke::neck(garment)?]),
        _ => None,
    }
}

/// Sews the band or collar that fits the neck best.
fn neckband(garment: &mut GarmentModel) {
    let Some(neck) = neck(garment) else { return };
    let whole = neck.concat();
    // A round yoke or a ring collar is sewn to it.
    if whole.iter().any(|step| garment.is_step_sewn(step)) && !garment.rings.is_empty() {
        return;
    }
    // What goes round the neck beside a hood covers its seam.
    if garment.has(PanelKind::Hood) || collar_on_stand(garment, &neck) {
        return;
    }
    let mut found: Vec<(f64, &LabeledPanel)> = vec![];
    for kind in ROUND_NECKS {
        for part in garment.parts_of(kind).filter(|p| p.front_back.is_none()) {
            if let Some(laid) = band::lay(garment, &whole, part, BandEdge::Lower) {
                found.push((ease(&whole, &laid.chain), part));
            }
        }
    }
    let one = found.into_iter().min_by(|a, b| {
        (a.0 + MISFIT_WEIGHT * a.1.cost).total_cmp(&(b.0 + MISFIT_WEIGHT * b.1.cost))
    });
    let bands = match one {
        Some((ease, part)) if ease <= MAX_EASE => Some(BandSet::One(Box::new(part.clone()))),
        _ => ROUND_NECKS
            .iter()
            .find_map(|kind| band::bands(garment, *kind, |p| p.front_back.is_some())),
    };
    if let Some(bands) = bands {
        band::sew_around(
            garment,
            SeamRationale::new("neckband", "it goes round the neck").gathered(),
            &neck,
            &bands,
            BandEdge::Lower,
        );
    }
}

/// Sews a stand to the neck and a collar to the stand; returns true if there are both. Their ends
/// stay free: they lie at the front edges.
fn collar_on_stand(garment: &mut GarmentModel, neck: &Opening) -> bool {
    let find = |kind| {
        let whole = |p: &&LabeledPanel| p.front_back.is_none() && p.laterality.is_none();
        garment.parts_of(kind).find(whole).cloned()
    };
    // Some names call a collar by the word for anything at the neck.
    let collar = find(PanelKind::Collar).or_else(|| find(PanelKind::NeckBand));
    let (Some(stand), Some(collar)) = (find(PanelKind::CollarStand), collar) else {
        return false;
    };
    let neck = from_opening(garment, neck);
    let Some(laid) = band::lay(garment, &neck, &stand, BandEdge::Lower) else {
        return false;
    };
    let rationale = SeamRationale::new("collar-stand", "the stand goes round the neck");
    // The round ends of a stand without corners lie beyond the neck.
    let lower = if stand.segments.len() == 2 {
        middle(&laid.chain, length(&neck))
    } else {
        laid.chain.clone()
    };
    garment.sew(rationale, Some(neck), Some(lower));
    let Some(free) = laid.free() else { return true };
    // The collar may be shorter than its stand: its edges are compared with the middle of that.
    let long = collar.segments_of(EdgeRole::Long);
    let lengths = long.map(|s| collar.features.length(&s.edges));
    let shortest = lengths.fold(length(&free), f64::min);
    let between = middle(&free, shortest.max(MIN_FALL * length(&free)));
    if let Some(fall) = band::lay(garment, &between, &collar, BandEdge::Lower) {
        let rationale = SeamRationale::new("collar", "the collar is sewn to its stand");
        let free = middle(&free, length(&fall.chain));
        garment.sew(rationale, Some(free), Some(fall.chain));
    }
    true
}

/// Returns the middle of a chain, of this length \[m\]: a stand reaches beyond its collar at both
/// ends, where it is buttoned. All of a chain that is not longer.
fn middle(chain: &[EdgeStep], wanted: f64) -> EdgeChain {
    let beyond = 0.5 * (length(chain) - wanted);
    if beyond <= MIN_BEYOND_M {
        return chain.to_vec();
    }
    let to_end = up_to(chain, length(chain) - beyond);
    reversed(&up_to(&reversed(&to_end), wanted))
}

/// Returns the neck from the center front on where the front is of two halves.
fn from_opening(garment: &GarmentModel, neck: &Opening) -> EdgeChain {
    let mut ring = neck.concat();
    let left = garment.part(PanelKind::Bodice, FrontBack::Front, Laterality::Left);
    if let Some(left) = left.filter(|left| left.half) {
        ring.rotate_left(left.role_edges(EdgeRole::Neck).len());
    }
    ring
}

/// Sews a collar of four parts: left and right, front and back; returns true if there is one.
fn quarters(garment: &mut GarmentModel) -> bool {
    let lay = |garment: &GarmentModel, front_back, laterality| -> Option<LaidBand> {
        let here = |p: &&LabeledPanel| {
            p.front_back == Some(front_back) && p.laterality == Some(laterality)
        };
        let part = garment.parts_of(PanelKind::Collar).find(here)?;
        let neck = garment.chain(
            PanelKind::Bodice,
            front_back,
            (EdgeRole::Neck, laterality),
            EdgeRole::Shoulder,
        )?;
        band::lay(garment, &neck, part, BandEdge::Lower)
    };
    let sides = [(Laterality::Left, "left"), (Laterality::Right, "right")];
    let mut laid: Vec<[Option<LaidBand>; 2]> = vec![];
    let mut any = false;
    for (laterality, side) in sides {
        let parts = [FrontBack::Front, FrontBack::Back]
            .map(|front_back| lay(garment, front_back, laterality));
        for (front_back, name, part) in [
            (FrontBack::Front, "front", &parts[0]),
            (FrontBack::Back, "back", &parts[1]),
        ] {
            let neck = garment.chain(
                PanelKind::Bodice,
                front_back,
                (EdgeRole::Neck, laterality),
                EdgeRole::Shoulder,
            );
            let id = format!("collar-{name}-{side}");
            any |= garment.sew(
                SeamRationale::new(&id, "the collar goes round the neck").gathered(),
                neck,
                part.as_ref().map(|l| l.chain.clone()),
            );
        }
        let shoulder = parts
            .each_ref()
            .map(|p| p.as_ref().and_then(|l| l.end(true)));
        let [a, b] = shoulder;
        let id = format!("collar-shoulder-{side}");
        garment.sew(band::ends_rationale(&id), a, b);
        laid.push(parts);
    }
    for (i, id) in ["collar-centre-front", "collar-centre-back"]
        .into_iter()
        .enumerate()
    {
        let of = |side: usize| laid[side][i].as_ref().and_then(|l| l.end(false));
        garment.sew(band::ends_rationale(id), of(0), of(1));
    }
    any
}

fn armhole(garment: &mut GarmentModel, laterality: Laterality, side: &str) {
    let hole = super::armhole::of(garment, laterality);
    let band = garment
        .parts_of(PanelKind::ArmBand)
        .find(|p| p.laterality == Some(laterality))
        .cloned();
    if let (Some(hole), Some(band)) = (hole, band) {
        let id = format!("armband-{side}");
        let rationale = SeamRationale::new(&id, "the band goes round the armhole").gathered();
        band::sew_around(
            garment,
            rationale,
            &[hole.down, hole.up],
            &BandSet::One(Box::new(band)),
            BandEdge::Lower,
        );
    }
}
