//! Bands: waistbands, cuffs, collars, bindings. A long edge goes round an opening, the ends meet
//! each other.

use crate::seam::suggest::bands;
use crate::seam::suggest::edge_chain::{EdgeChain, EdgeStep, reversed};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale, ease};
use crate::seam::suggest::join;
use crate::seam::suggest::labeled_panel::{LabeledPanel, RoleSegment};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Long edge that is sewn where nothing else tells, as drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BandEdge {
    Lower,
    Upper,
    /// Both long edges are sewn: as drawn, whatever else.
    Lowest,
    Uppermost,
}

impl BandEdge {
    fn is_lower(self) -> bool {
        matches!(self, Self::Lower | Self::Lowest)
    }

    fn weight(self) -> f64 {
        match self {
            Self::Lower | Self::Upper => DRAWN_WEIGHT,
            Self::Lowest | Self::Uppermost => 100.0,
        }
    }
}

/// Weights of ease and of the way a band is drawn, against one corner that meets.
const EASE_WEIGHT: f64 = 6.0;
const DRAWN_WEIGHT: f64 = 0.4;
/// Weight of corners that are cut off, and the turn from which a corner is one \[rad\].
const CLIPPED_WEIGHT: f64 = 1.0;
const SHARP_CORNER_RAD: f64 = 0.5;
/// Weight of both bands of an opening being sewn at the same edge as drawn.
const ALIKE_WEIGHT: f64 = 1.5;

/// An opening that something goes round, as the part in front and the part behind; all in the first
/// where it is not known which part is in front.
pub(super) type Opening = [EdgeChain; 2];

/// Bands that go round one opening: one, or a front and a back one.
#[derive(Clone, Debug)]
pub(super) enum BandSet {
    One(Box<LabeledPanel>),
    Two(Box<[LabeledPanel; 2]>),
}

/// Returns the bands of a kind that `fits` picks, the least numbered first.
pub(super) fn bands(
    garment: &GarmentModel,
    kind: PanelKind,
    fits: impl Fn(&LabeledPanel) -> bool,
) -> Option<BandSet> {
    let of = |front_back: Option<FrontBack>| {
        garment
            .parts_of(kind)
            .filter(|p| fits(p) && (front_back.is_none() || p.front_back == front_back))
            .min_by_key(|p| p.number)
            .cloned()
    };
    match (of(Some(FrontBack::Front)), of(Some(FrontBack::Back))) {
        (Some(front), Some(back)) => Some(BandSet::Two(Box::new([front, back]))),
        _ => of(None).map(|band| BandSet::One(Box::new(band))),
    }
}

/// Returns true if a panel is worn on this side of the wearer, or on no side in particular.
pub(super) fn is_on(part: &LabeledPanel, laterality: Laterality) -> bool {
    part.laterality.is_none() || part.laterality == Some(laterality)
}

/// A long edge of a band laid along an opening.
#[derive(Clone, Debug)]
pub(super) struct LaidBand {
    band: LabeledPanel,
    long: RoleSegment,
    pub(super) chain: EdgeChain,
}

/// Sews bands round an opening, and their ends to each other; returns the opening that their free
/// long edges make.
pub(super) fn sew_around(
    garment: &mut GarmentModel,
    rationale: SeamRationale<'_>,
    opening: &Opening,
    bands: &BandSet,
    band_edge: BandEdge,
) -> Option<Opening> {
    match bands {
        BandSet::One(band) => sew_single(garment, rationale, &opening.concat(), band, band_edge),
        BandSet::Two(pair) => {
            let [front, back] = pair.as_ref();
            if opening[1].is_empty() {
                sew_pair_on_ring(garment, rationale, &opening[0], [front, back], band_edge)
            } else {
                sew_pair(garment, rationale, opening, [front, back], band_edge)
            }
        }
    }
}

/// Sews one band, closed on itself.
fn sew_single(
    garment: &mut GarmentModel,
    rationale: SeamRationale<'_>,
    opening: &EdgeChain,
    band: &LabeledPanel,
    band_edge: BandEdge,
) -> Option<Opening> {
    let laid = lay(garment, opening, band, band_edge)?;
    if !garment.sew_ring(rationale, Some(opening.clone()), Some(laid.chain.clone())) {
        return None;
    }
    let (a, b) = (laid.end(true), laid.end(false));
    let id = format!("{}-ends", rationale.id);
    let ends = match ends(garment, band) {
        Ends::Sewn => Some(ends_rationale(&id)),
        Ends::Offered => Some(ends_rationale(&id).offered()),
        Ends::Free => None,
    };
    if let Some(ends) = ends.filter(|_| !is_sewn(garment, a.as_ref())) {
        garment.sew(ends, a, b);
    }
    Some([laid.free()?, vec![]])
}

/// Ends of a band that goes round an opening by itself.
enum Ends {
    Sewn,
    /// They may as well lie side by side at the center front.
    Offered,
    Free,
}

/// Returns the state of the ends of a band. Those of collars meet at the center front and are not
/// sewn, but for collars drawn as a tube is: rectangles. At the neck of a front of two halves
/// nothing is closed that the front leaves open.
fn ends(garment: &GarmentModel, band: &LabeledPanel) -> Ends {
    let at_neck = matches!(
        band.kind,
        PanelKind::NeckBand | PanelKind::Collar | PanelKind::CollarStand
    );
    let front = garment.part(PanelKind::Bodice, FrontBack::Front, Laterality::Left);
    let opens = front.is_some_and(|front| front.half);
    match (at_neck, opens, bands::is_rectangle(band)) {
        (false, ..) => Ends::Sewn,
        (true, true, _) if band.kind == PanelKind::NeckBand => Ends::Offered,
        (true, true, _) => Ends::Free,
        (true, false, true) if band.kind == PanelKind::NeckBand => Ends::Sewn,
        (true, false, true) => Ends::Offered,
        (true, false, false) if band.kind == PanelKind::NeckBand && band.kind_named => Ends::Sewn,
        (true, false, false) => Ends::Free,
    }
}

/// Sews two bands, each along its part of the opening.
fn sew_pair(
    garment: &mut GarmentModel,
    rationale: SeamRationale<'_>,
    opening: &Opening,
    bands: [&LabeledPanel; 2],
    band_edge: BandEdge,
) -> Option<Opening> {
    let [a, b] = lay_pair(garment, [&opening[0], &opening[1]], bands, band_edge)?;
    let whole = (
        opening.concat(),
        [a.chain.clone(), b.chain.clone()].concat(),
    );
    let apart = join::split_at_corners(&opening[0], &a.chain).len()
        + join::split_at_corners(&opening[1], &b.chain).len();
    if join::split_ring(&whole.0, &whole.1).len() > apart {
        // Their ends meet elsewhere than front and back of the opening do.
        garment.sew_ring(rationale, Some(whole.0), Some(whole.1));
    } else {
        for (name, part, laid) in [("front", &opening[0], &a), ("back", &opening[1], &b)] {
            let id = format!("{}-{name}", rationale.id);
            garment.sew(
                SeamRationale {
                    id: &id,
                    ..rationale
                },
                Some(part.clone()),
                Some(laid.chain.clone()),
            );
        }
    }
    sew_ends(garment, rationale, &a, &b);
    Some([a.free()?, b.free()?])
}

/// Sews two bands round an opening of which it is not known what is in front.
fn sew_pair_on_ring(
    garment: &mut GarmentModel,
    rationale: SeamRationale<'_>,
    opening: &EdgeChain,
    bands: [&LabeledPanel; 2],
    band_edge: BandEdge,
) -> Option<Opening> {
    let [a, b] = lay_pair(garment, [opening, opening], bands, band_edge)?;
    let both = [a.chain.clone(), b.chain.clone()].concat();
    garment.sew_free_ring(rationale, opening, &both);
    sew_ends(garment, rationale, &a, &b);
    Some([a.free()?, b.free()?])
}

/// Sews the ends of two bands to each other.
fn sew_ends(garment: &mut GarmentModel, rationale: SeamRationale<'_>, a: &LaidBand, b: &LaidBand) {
    for (name, first, second) in [
        ("left", a.end(true), b.end(false)),
        ("right", a.end(false), b.end(true)),
    ] {
        if is_sewn(garment, first.as_ref()) {
            continue;
        }
        garment.sew(
            ends_rationale(&format!("{}-end-{name}", rationale.id)),
            first,
            second,
        );
    }
}

/// Returns true if the end of a band is part of a seam already: a band that goes round two openings
/// has it sewn once.
fn is_sewn(garment: &GarmentModel, end: Option<&EdgeChain>) -> bool {
    let first = end.and_then(|chain| chain.first());
    first.is_some_and(|step| garment.is_sewn(step.panel, step.edge))
}

pub(super) fn ends_rationale(id: &str) -> SeamRationale<'_> {
    SeamRationale::new(id, "the ends of the band meet")
}

/// Returns the long edge that fits an opening best, laid so that both outer sides are out.
pub(super) fn lay(
    garment: &GarmentModel,
    opening: &EdgeChain,
    band: &LabeledPanel,
    band_edge: BandEdge,
) -> Option<LaidBand> {
    let ways = layouts(garment, opening, band, band_edge).into_iter();
    ways.max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, laid)| laid)
}

/// Returns every free long edge of a band along an opening, with how well it fits.
fn layouts(
    garment: &GarmentModel,
    opening: &EdgeChain,
    band: &LabeledPanel,
    band_edge: BandEdge,
) -> Vec<(f64, LaidBand)> {
    let free = |long: &&RoleSegment| !long.edges.iter().any(|e| garment.is_sewn(band.panel, *e));
    let long = band
        .segments
        .iter()
        .filter(|s| matches!(s.role, EdgeRole::Long | EdgeRole::Hem | EdgeRole::Waist));
    let laid = long.filter(free).map(|long| LaidBand {
        band: band.clone(),
        long: long.clone(),
        chain: oriented(garment, opening, band, long),
    });
    let with_score = laid.map(|laid| (laid.fits(opening, band_edge), laid));
    with_score.collect()
}

/// Returns the long edges of two bands that fit their openings best, and each other: front and back
/// are drawn alike.
fn lay_pair(
    garment: &GarmentModel,
    openings: [&EdgeChain; 2],
    bands: [&LabeledPanel; 2],
    band_edge: BandEdge,
) -> Option<[LaidBand; 2]> {
    let [first, second] = [0, 1].map(|i| layouts(garment, openings[i], bands[i], band_edge));
    let mut best: Option<(f64, [&LaidBand; 2])> = None;
    for (a, x) in &first {
        for (b, y) in &second {
            let alike = if x.is_lower() == y.is_lower() {
                ALIKE_WEIGHT
            } else {
                0.0
            };
            if best.is_none_or(|(most, _)| a + b + alike > most) {
                best = Some((a + b + alike, [x, y]));
            }
        }
    }
    best.map(|(_, both)| both.map(LaidBand::clone))
}

/// Returns a long edge in the direction that has both outer sides out: against the order of numbers
/// where the opening goes with it, unless one of the two is drawn mirrored or as seen through the
/// body.
fn oriented(
    garment: &GarmentModel,
    opening: &[EdgeStep],
    band: &LabeledPanel,
    long: &RoleSegment,
) -> EdgeChain {
    let chain = band.chain(long);
    let Some(first) = opening.first() else {
        return chain;
    };
    let seen_from_inside = |p: &LabeledPanel| p.features.mirrored != p.drawn_from_inside;
    let host = garment.parts.iter().find(|p| p.panel == first.panel);
    let differ = host.is_some_and(|host| seen_from_inside(host) != seen_from_inside(band));
    if first.forward == differ {
        chain
    } else {
        reversed(&chain)
    }
}

impl LaidBand {
    /// Returns how well it fits an opening, more being better.
    fn fits(&self, opening: &EdgeChain, band_edge: BandEdge) -> f64 {
        let drawn = if band_edge.is_lower() == self.is_lower() {
            band_edge.weight()
        } else {
            0.0
        };
        let ease = ease(opening, &self.chain).min(0.5);
        let clipped = if self.is_clipped() {
            CLIPPED_WEIGHT
        } else {
            0.0
        };
        join::agreement(opening, &self.chain) - EASE_WEIGHT * ease + drawn - clipped
    }

    /// Returns true if it is the edge of a cuff with sharp corners within: the free one, whose
    /// corners are cut off.
    fn is_clipped(&self) -> bool {
        let features = &self.band.features;
        let within = self
            .long
            .edges
            .split_last()
            .map_or(&[][..], |(_, rest)| rest);
        self.band.kind == PanelKind::Cuff
            && within.iter().any(|edge| {
                let at = features.ring.iter().position(|e| e == edge);
                at.is_some_and(|at| features.joints[at] > SHARP_CORNER_RAD)
            })
    }

    /// Returns true if the edge lies in the lower half of the band as drawn.
    fn is_lower(&self) -> bool {
        self.band.features.height(&self.long.edges)
            < self.band.features.height(&self.band.features.ring)
    }

    /// Returns the end of the band where the laid edge begins or ends, going away from that edge.
    pub(super) fn end(&self, at_start: bool) -> Option<EdgeChain> {
        let forward = self.chain.first()?.forward;
        let next = at_start != forward;
        let neighbor = self.neighbor(next, 1)?;
        if !matches!(neighbor.role, EdgeRole::End | EdgeRole::Side) {
            return None;
        }
        let chain = self.band.chain(neighbor);
        Some(if next { chain } else { reversed(&chain) })
    }

    /// Returns the other long edge, in the same direction.
    pub(super) fn free(&self) -> Option<EdgeChain> {
        let forward = self.chain.first()?.forward;
        // A stand with round ends has but its two long edges.
        let apart = if self.band.segments.len() > 2 { 2 } else { 1 };
        let chain = self.band.chain(self.neighbor(true, apart)?);
        Some(if forward { reversed(&chain) } else { chain })
    }

    fn neighbor(&self, next: bool, by: usize) -> Option<&RoleSegment> {
        let all = &self.band.segments;
        let at = all.iter().position(|s| s.edges == self.long.edges)?;
        let count = all.len();
        all.get(if next { at + by } else { at + count - by } % count)
    }
}
