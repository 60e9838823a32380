//! Rings: skirts, ponchos, round yokes and flounces that go round the body by a hole. A band goes
//! round the hole, or the hole goes round a hem, an outline or a neck; the outline of a yoke goes
//! round a neck.

use super::band::{self, BandEdge, BandSet};
use super::{neck, side};
use crate::seam::suggest::edge_chain::{EdgeChain, length, reversed};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, FrontBack, PanelKind};
use crate::seam::suggest::ring_panel::{RingPanel, RingPlace};

/// Kinds of bands of a neck.
const AT_NECK: [PanelKind; 3] = [
    PanelKind::NeckBand,
    PanelKind::CollarStand,
    PanelKind::Collar,
];
/// Shares of the length of a hole that its band may have: to be stretched on, or to lie over
/// itself.
const BAND: [f64; 2] = [0.70, 1.12];
/// Logarithm of the ratio of lengths up to which two loops are sewn to each other.
const MAX_LOOP_MISFIT: f64 = 0.05;

/// Sews bands round the holes of rings, the largest ring first.
pub(super) fn sew_bands(garment: &mut GarmentModel) {
    let mut order: Vec<usize> = (0..garment.rings.len()).collect();
    order.sort_by(|a, b| garment.rings[*b].area.total_cmp(&garment.rings[*a].area));
    for index in order {
        let ring = garment.rings[index].clone();
        let Some((kind, bands)) = best_band(garment, &ring) else {
            continue;
        };
        let is_waist = ring.kind == Some(PanelKind::Skirt)
            || ring.kind.is_none() && kind == PanelKind::Waistband;
        let (id, because) = if is_waist {
            ("waistband", "the waistband goes round the hole")
        } else {
            ("neckband", "it goes round the hole")
        };
        let is_taken = garment.proposed.iter().any(|seam| seam.id.starts_with(id));
        let id = match is_taken {
            true => format!("{id}-{}", index + 1),
            false => id.to_owned(),
        };
        let rationale = SeamRationale::new(&id, because);
        let place = if is_waist {
            RingPlace::Waist(0.0)
        } else {
            RingPlace::Neck
        };
        place_bands(garment, &bands, is_waist);
        let opening = [ring.hole, vec![]];
        band::sew_around(
            garment,
            rationale.gathered(),
            &opening,
            &bands,
            BandEdge::Lower,
        );
        garment.rings[index].place = place;
    }
}

/// Returns the band that fits the hole of a ring best, with its kind; none that belongs to panels
/// which are no rings.
fn best_band(garment: &GarmentModel, ring: &RingPanel) -> Option<(PanelKind, BandSet)> {
    let has_lower = [PanelKind::Skirt, PanelKind::Trouser, PanelKind::Leg]
        .into_iter()
        .any(|kind| garment.has(kind));
    let is_yoke = ring.kind == Some(PanelKind::Yoke);
    let neck_is_free = is_yoke || !garment.has(PanelKind::Bodice);
    let at_waist = (!has_lower && !is_yoke).then_some(PanelKind::Waistband);
    // A skirt has no collar: one that fits is of a body that was not recognized.
    let is_skirt = ring.kind == Some(PanelKind::Skirt);
    let may_be = |kind: &PanelKind| neck_is_free && (!is_skirt || *kind == PanelKind::NeckBand);
    let at_neck = AT_NECK.into_iter().filter(may_be);
    let sets = at_waist.into_iter().chain(at_neck).filter_map(|kind| {
        let is_free = |part: &LabeledPanel| is_free(garment, part);
        let set = band::bands(garment, kind, is_free)?;
        let share = long_edges(&set) / length(&ring.hole);
        let fits = (BAND[0]..=BAND[1]).contains(&share);
        fits.then_some((share.ln().abs(), kind, set))
    });
    let best = sets.min_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, kind, set)| (kind, set))
}

fn is_free(garment: &GarmentModel, part: &LabeledPanel) -> bool {
    let mut edges = part.segments.iter().flat_map(|segment| &segment.edges);
    !edges.any(|edge| garment.is_sewn(part.panel, *edge))
}

/// Returns the length of the long edges of bands, one of each \[m\].
fn long_edges(bands: &BandSet) -> f64 {
    let long = |part: &LabeledPanel| {
        let roles = [EdgeRole::Long, EdgeRole::Hem, EdgeRole::Waist];
        let segments = roles.into_iter().flat_map(|role| part.segments_of(role));
        segments
            .map(|segment| part.features.length(&segment.edges))
            .fold(0.0, f64::max)
    };
    match bands {
        BandSet::One(part) => long(part),
        BandSet::Two(pair) => pair.iter().map(long).sum(),
    }
}

/// Makes bands waistbands or neck bands, as the place of their ring has it.
fn place_bands(garment: &mut GarmentModel, bands: &BandSet, is_waist: bool) {
    let panels: Vec<usize> = match bands {
        BandSet::One(part) => vec![part.panel],
        BandSet::Two(pair) => pair.iter().map(|part| part.panel).collect(),
    };
    let of_set = garment
        .parts
        .iter_mut()
        .filter(|part| panels.contains(&part.panel));
    for part in of_set {
        let is_at_neck = AT_NECK.contains(&part.kind);
        if is_waist {
            part.kind = PanelKind::Waistband;
        } else if !is_at_neck {
            part.kind = PanelKind::NeckBand;
        }
    }
}

/// A closed line that a ring may be sewn to, and where the ring then is.
struct Loop {
    id: &'static str,
    because: &'static str,
    chain: EdgeChain,
    place: RingPlace,
    /// The ring whose outline it is.
    ring: Option<usize>,
}

/// Sews what is open of the rings to hems, necks and to each other, those first whose lengths agree
/// best.
pub(super) fn sew_loops(garment: &mut GarmentModel) {
    for _ in 0..2 * garment.rings.len() {
        let Some((index, chain, found)) = best_loop(garment) else {
            break;
        };
        let laid = facing(garment, &found.chain, chain);
        let id = format!("{}-{}", found.id, index + 1);
        let rationale = SeamRationale::new(&id, found.because);
        if !garment.sew_free_ring(rationale, &found.chain, &laid) {
            break;
        }
        let host = found.ring.map(|ring| garment.rings[ring].place);
        garment.rings[index].place = host.unwrap_or(found.place);
    }
}

/// Returns the ring and its loop that fit another loop best, and that.
fn best_loop(garment: &GarmentModel) -> Option<(usize, EdgeChain, Loop)> {
    let mut best: Option<(f64, usize, EdgeChain, Loop)> = None;
    for (index, ring) in garment.rings.iter().enumerate() {
        let of_hole = hems(garment, index)
            .into_iter()
            .chain(collar_neck(garment, ring));
        let of_hole = of_hole.map(|found| (&ring.hole, found));
        let of_outer = yoke_neck(garment, ring).map(|found| (&ring.outer, found));
        for (chain, found) in of_hole.chain(of_outer) {
            let misfit = (length(chain) / length(&found.chain)).ln().abs();
            let is_open = !is_taken(garment, chain) && !is_taken(garment, &found.chain);
            let is_better = best.as_ref().is_none_or(|(least, ..)| misfit < *least);
            if is_open && misfit <= MAX_LOOP_MISFIT && is_better {
                best = Some((misfit, index, chain.clone(), found));
            }
        }
    }
    best.map(|(_, index, chain, found)| (index, chain, found))
}

fn is_taken(garment: &GarmentModel, chain: &EdgeChain) -> bool {
    let mut steps = chain.iter();
    steps.any(|step| garment.is_step_sewn(step))
}

/// Returns the hems that the hole of a ring may go round.
fn hems(garment: &GarmentModel, own: usize) -> Vec<Loop> {
    let around = |kind| -> Option<EdgeChain> {
        if kind == PanelKind::Bodice
            && let Some(hem) = side::hem_ring(garment)
        {
            return Some(hem.concat());
        }
        let both = [FrontBack::Front, FrontBack::Back]
            .map(|front_back| garment.half_ring(kind, EdgeRole::Hem, front_back));
        if let [Some(front), Some(back)] = both {
            return Some([front, back].concat());
        }
        let mut parts = garment.parts_of(kind);
        let (Some(part), None) = (parts.next(), parts.next()) else {
            return None;
        };
        Some(part.chain(part.segment(EdgeRole::Hem, None)?))
    };
    let bodice = around(PanelKind::Bodice).map(|chain| Loop {
        id: "waist",
        because: "the ring hangs from the hem of the bodice by its hole",
        chain,
        place: RingPlace::BodiceHem,
        ring: None,
    });
    let skirt = around(PanelKind::Skirt).map(|chain| Loop {
        id: "flounce",
        because: "the ring hangs from the hem of the skirt by its hole",
        chain,
        place: RingPlace::Waist(skirt_length(garment)),
        ring: None,
    });
    let others = garment.rings.iter().enumerate().filter(|(i, _)| *i != own);
    let others = others.map(|(i, ring)| Loop {
        id: "flounce",
        because: "the hole of a ring goes round the outline of another",
        chain: ring.outer.clone(),
        place: ring.place,
        ring: Some(i),
    });
    bodice.into_iter().chain(skirt).chain(others).collect()
}

/// Returns the length of the skirts from waist to hem \[m\].
fn skirt_length(garment: &GarmentModel) -> f64 {
    let sides = garment
        .parts_of(PanelKind::Skirt)
        .map(|part| part.mean_length(EdgeRole::Side));
    sides.fold(0.0, f64::max)
}

/// Returns the neck that the hole of a ring collar goes round.
fn collar_neck(garment: &GarmentModel, ring: &RingPanel) -> Option<Loop> {
    let is_at_neck = !matches!(ring.kind, Some(PanelKind::Skirt | PanelKind::Yoke));
    let [front, back] = neck::neck(garment).filter(|_| is_at_neck)?;
    Some(Loop {
        id: "collar",
        because: "the ring goes round the neck by its hole",
        chain: [front, back].concat(),
        place: RingPlace::Neck,
        ring: None,
    })
}

/// Returns the neck that the outline of a round yoke fills.
fn yoke_neck(garment: &GarmentModel, ring: &RingPanel) -> Option<Loop> {
    let is_at_neck = ring.kind != Some(PanelKind::Skirt);
    let [front, back] = neck::neck(garment).filter(|_| is_at_neck)?;
    Some(Loop {
        id: "yoke",
        because: "what hangs from a round yoke goes round its outline",
        chain: [front, back].concat(),
        place: RingPlace::Neck,
        ring: None,
    })
}

/// Returns the loop of a ring in the direction that has both outer sides out: against the order of
/// numbers where what it is sewn to goes with it, unless that is drawn from inside.
fn facing(garment: &GarmentModel, opening: &EdgeChain, chain: EdgeChain) -> EdgeChain {
    let Some(first) = opening.first() else {
        return chain;
    };
    let host = garment.parts.iter().find(|part| part.panel == first.panel);
    let is_inside = host.is_some_and(|host| host.features.mirrored != host.drawn_from_inside);
    if first.forward == is_inside {
        chain
    } else {
        reversed(&chain)
    }
}
