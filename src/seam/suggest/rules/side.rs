//! Side panels: between front and back, one or several on each side of the wearer, as under the arm
//! of a jacket or beside princess seams.

use crate::seam::suggest::edge_chain::{EdgeChain, reversed};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale, ease};
use crate::seam::suggest::labeled_panel::{LabeledPanel, RoleSegment};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// Side panels of one side that are looked at: their ways to lie are tried one with another.
const MAX_ROW: usize = 4;
/// Difference of the sums of eases of two ways that are as good as each other.
const ALIKE: f64 = 0.01;
/// Ease that counts as much as any greater one: one edge that fits nowhere must not decide alone.
const MAX_EASE: f64 = 0.5;

/// A side panel with the side that faces the front.
#[derive(Clone)]
pub(super) struct LaidSide {
    pub(super) panel: LabeledPanel,
    /// True if the edge before its hem in order of numbers faces the front.
    before_hem: bool,
    /// True if that is a guess: both edges fit on either side, and no name tells left from right.
    pub(super) is_guess: bool,
}

impl LaidSide {
    /// Returns the edge that faces the front or the back.
    fn facing(&self, front_back: FrontBack) -> Option<&RoleSegment> {
        let hem = self.panel.segment(EdgeRole::Hem, None)?;
        let [before, after] = self.panel.beside(hem)?;
        let before_is_asked = self.before_hem == (front_back == FrontBack::Front);
        Some(if before_is_asked { before } else { after })
    }

    /// Returns that edge from the hem up.
    fn chain(&self, front_back: FrontBack) -> Option<EdgeChain> {
        let segment = self.facing(front_back)?;
        Some(self.panel.chain_from(segment, EdgeRole::Hem))
    }

    /// Returns its part of the armhole on the way down the front and up the back.
    pub(super) fn armhole(&self) -> Option<EdgeChain> {
        let segment = self.panel.segment(EdgeRole::Armhole, None)?;
        let chain = self.panel.chain(segment);
        let [before, after] = self.panel.beside(segment)?;
        let facing = |fb: FrontBack, beside: &RoleSegment| {
            self.facing(fb).is_some_and(|s| s.edges == beside.edges)
        };
        let forward = facing(FrontBack::Front, before) || facing(FrontBack::Back, after);
        Some(if forward { chain } else { reversed(&chain) })
    }

    /// Returns its hem from the front to the back.
    fn hem(&self) -> Option<EdgeChain> {
        let chain = self.panel.chain(self.panel.segment(EdgeRole::Hem, None)?);
        Some(if self.before_hem {
            chain
        } else {
            reversed(&chain)
        })
    }

    /// Returns its shoulder from the neck on.
    fn shoulder(&self) -> Option<EdgeChain> {
        self.panel
            .role_chain(EdgeRole::Shoulder, None, EdgeRole::Center)
    }
}

/// Returns the side panels of one side of the wearer from the front to the back, each laid so that
/// their edges agree best in length with those beside them.
pub(super) fn row(garment: &GarmentModel, laterality: Laterality) -> Vec<LaidSide> {
    let order = |part: &LabeledPanel| match part.front_back {
        Some(FrontBack::Front) => 0,
        None => 1,
        Some(FrontBack::Back) => 2,
    };
    let here = |p: &&LabeledPanel| p.laterality == Some(laterality);
    let mut parts: Vec<&LabeledPanel> = garment.parts_of(PanelKind::Side).filter(here).collect();
    parts.sort_by_key(|part| (order(part), part.number));
    parts.truncate(MAX_ROW);
    let laid = |way: usize| -> Vec<LaidSide> {
        let each = parts.iter().enumerate().map(|(i, part)| LaidSide {
            panel: (*part).clone(),
            before_hem: way >> i & 1 == 1,
            is_guess: false,
        });
        each.collect()
    };
    let misfit = |way: &usize| -> f64 {
        let joints = joints(garment, laterality, &laid(*way));
        let cost = |[a, b]: &[Option<EdgeChain>; 2]| match (a, b) {
            (Some(a), Some(b)) => ease(a, b).min(MAX_EASE),
            _ => MAX_EASE,
        };
        joints.iter().map(cost).sum()
    };
    let misfits: Vec<f64> = (0..1_usize << parts.len())
        .map(|way| misfit(&way))
        .collect();
    let least = misfits.iter().copied().fold(f64::INFINITY, f64::min);
    let is_as_good = |way: usize| misfits[way] <= least + ALIKE;
    let drawn = parts.iter().enumerate();
    let front = laterality.usual_front_side();
    let drawn = drawn.map(|(i, part)| usize::from(part.first_drawn_side() != front) << i);
    let drawn: usize = drawn.sum();
    let turned = |way: &usize| (way ^ drawn).count_ones();
    let ways = (0..misfits.len()).filter(|&way| is_as_good(way));
    let Some(best) = ways.min_by_key(turned) else {
        return laid(0);
    };
    let mut row = laid(best);
    for (i, side) in row.iter_mut().enumerate() {
        side.is_guess = is_as_good(best ^ 1 << i) && !side.panel.laterality_named;
    }
    row
}

/// Returns both sides of the seams from the front over the side panels to the back, from the hem
/// up.
fn joints(
    garment: &GarmentModel,
    laterality: Laterality,
    row: &[LaidSide],
) -> Vec<[Option<EdgeChain>; 2]> {
    let body = |front_back| {
        let place = (EdgeRole::Side, laterality);
        garment.chain(PanelKind::Bodice, front_back, place, EdgeRole::Hem)
    };
    let mut before = body(FrontBack::Front);
    let mut joints = vec![];
    for laid in row {
        joints.push([before, laid.chain(FrontBack::Front)]);
        before = laid.chain(FrontBack::Back);
    }
    joints.push([before, body(FrontBack::Back)]);
    joints
}

/// Sews the sides of a bodice: front to back, or each to the side panels between them.
pub(super) fn sew(garment: &mut GarmentModel, laterality: Laterality, side: &str) {
    let row = row(garment, laterality);
    let joints = joints(garment, laterality, &row);
    let several = joints.len() > 1;
    let is_guess = row.iter().any(|laid| laid.is_guess);
    for (i, [a, b]) in joints.into_iter().enumerate() {
        let (id, because) = if several {
            let id = format!("side-{side}-{}", i + 1);
            let because = if is_guess {
                "panels round the body meet side to side, hem to hem; either edge of a side panel fits in front, and which does is a guess: if it is the other, exchange the two"
            } else {
                "panels round the body meet side to side, hem to hem"
            };
            (id, because)
        } else {
            let because = "front and back meet at the side, hem to hem and armhole to armhole";
            (format!("side-{side}"), because)
        };
        let rationale = SeamRationale::new(&id, because).guessed(is_guess);
        garment.sew(rationale, a, b);
    }
}

/// Returns the shoulder of the front or the back on one side, from the neck on, with the part that
/// a side panel has of it.
pub(super) fn shoulder(
    garment: &GarmentModel,
    front_back: FrontBack,
    laterality: Laterality,
) -> Option<EdgeChain> {
    let place = (EdgeRole::Shoulder, laterality);
    let own = garment.chain(PanelKind::Bodice, front_back, place, EdgeRole::Neck);
    let here = |laid: &LaidSide| laid.panel.front_back == Some(front_back);
    let beside = row(garment, laterality).into_iter().filter(here);
    let chain: EdgeChain = [own]
        .into_iter()
        .chain(beside.map(|laid| laid.shoulder()))
        .flatten()
        .flatten()
        .collect();
    (!chain.is_empty()).then_some(chain)
}

/// Returns the hem of a bodice round the body, its front from the wearer's left on and its back,
/// each with the side panels beside it; one between them goes with the front.
pub(super) fn hem_ring(garment: &GarmentModel) -> Option<[EdgeChain; 2]> {
    let half = |front_back| garment.half_ring(PanelKind::Bodice, EdgeRole::Hem, front_back);
    let (front, back) = (half(FrontBack::Front)?, half(FrontBack::Back)?);
    let sides = |laterality, is_behind: bool| -> Option<EdgeChain> {
        let beside =
            |laid: &LaidSide| (laid.panel.front_back == Some(FrontBack::Back)) == is_behind;
        let row = row(garment, laterality).into_iter().filter(beside);
        Some(
            row.map(|laid| laid.hem())
                .collect::<Option<Vec<_>>>()?
                .concat(),
        )
    };
    let to_front = |behind| Some(reversed(&sides(Laterality::Left, behind)?));
    let to_back = |behind| sides(Laterality::Right, behind);
    Some([
        [to_front(false)?, front, to_back(false)?].concat(),
        [to_back(true)?, back, to_front(true)?].concat(),
    ])
}
