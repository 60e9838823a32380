//! One reading of a pattern: its panels labeled, sewn by the rules, and judged as a whole.

use super::classify::{self, Classification};
use super::completeness::Completeness;
use super::garment_model::{GarmentModel, ProposedSeam, ease};
use super::labeled_panel::LabeledPanel;
use super::labels::PanelKind;
use super::names::NameHints;
use super::seam_pairs::SeamPairWriter;
use super::suggestion::SuggestedSeam;
use super::{rules, select, trust};
use crate::config::Limits;
use crate::pattern::Pattern;
use std::collections::BTreeSet;

/// Ease up to which two edges are as long as each other: they were drawn to be sewn.
const EXACT_EASE: f64 = 0.012;
/// Ease up to which a sleeve is set into an armhole, or a hood into a neck.
const MAX_SET_IN_EASE: f64 = 0.12;

/// Panels with their labels, the seams that follow, and what they leave out.
pub(super) struct Reading {
    pub(super) garment: GarmentModel,
    pub(super) hints: Vec<NameHints>,
    pub(super) seams: Vec<SuggestedSeam>,
    pub(super) completeness: Completeness,
}

impl Reading {
    /// Reads a pattern whose panels without a telling name may also be of `rare` kinds.
    pub(super) fn of(pattern: &Pattern, limits: &Limits, rare: &[PanelKind]) -> Self {
        let Classification {
            parts,
            forms,
            rings,
            hints,
        } = classify::label_panels(pattern, rare);
        let mut garment = GarmentModel {
            parts,
            forms,
            rings,
            proposed: vec![],
        };
        rules::sew(&mut garment, pattern);
        let writer = SeamPairWriter(pattern);
        let seams = garment.proposed.iter().map(|seam| writer.seam(seam));
        let mut seams = select::select_compatible(pattern, seams.collect(), limits);
        let completeness = trust::judge(pattern, &garment, &hints, &mut seams);
        Self {
            garment,
            hints,
            seams,
            completeness,
        }
    }

    /// Returns the panels of the pattern that sure seams join, mirrored copies as their sources.
    pub(super) fn sewn(&self, pattern: &Pattern) -> BTreeSet<usize> {
        let count = pattern.panels.len().max(1);
        let proposed = self.sure().flat_map(|seam| seam.sides.iter().flatten());
        proposed.map(|step| step.panel % count).collect()
    }

    /// Returns the proposals that are sure.
    fn sure(&self) -> impl Iterator<Item = &ProposedSeam> {
        let sure = self.seams.iter().filter(|seam| !seam.is_offer());
        let sure: BTreeSet<&str> = sure.map(|seam| seam.pair.id.as_str()).collect();
        let proposed = self.garment.proposed.iter();
        proposed.filter(move |seam| sure.contains(seam.id.as_str()))
    }

    /// Returns the mean confidence of its seams.
    pub(super) fn confidence(&self) -> f64 {
        let sum: f64 = self.seams.iter().map(|seam| seam.confidence).sum();
        sum / self.seams.len().max(1) as f64
    }

    /// Returns the share of the area of all panels that is sewn.
    pub(super) fn sewn_share(&self, pattern: &Pattern) -> f64 {
        let area = |i: usize| pattern.panels[i].area_m2.abs();
        let all: f64 = (0..pattern.panels.len()).map(area).sum();
        let sewn: f64 = self.sewn(pattern).into_iter().map(area).sum();
        sewn / all.max(f64::MIN_POSITIVE)
    }

    /// Returns true if every sure seam of two panels, one of them taken for a kind of `rare`, has
    /// edges as long as each other; into armholes and necks they may be eased, and bands stretched.
    pub(super) fn is_exact(&self, rare: &[PanelKind]) -> bool {
        self.sure().all(|seam| self.is_exact_seam(seam, rare))
    }

    fn is_exact_seam(&self, seam: &ProposedSeam, rare: &[PanelKind]) -> bool {
        let part = |panel: usize| self.garment.parts.iter().find(|p| p.panel == panel);
        let steps = seam.sides.iter().flatten();
        let parts: Vec<&LabeledPanel> = steps.filter_map(|s| part(s.panel)).collect();
        let any = |is: &dyn Fn(&LabeledPanel) -> bool| parts.iter().any(|p| is(p));
        let several = parts.windows(2).any(|pair| pair[0].panel != pair[1].panel);
        let is_rare = |p: &LabeledPanel| !p.kind_named && rare.contains(&p.kind);
        if !several || !any(&is_rare) || any(&|p| is_band(p.kind)) {
            return true;
        }
        let most = if any(&is_set_in) && any(&|p| !is_set_in(p)) {
            MAX_SET_IN_EASE
        } else {
            EXACT_EASE
        };
        ease(&seam.sides[0], &seam.sides[1]) <= most
    }
}

/// Returns true for what is set into an opening.
fn is_set_in(part: &LabeledPanel) -> bool {
    matches!(
        part.kind,
        PanelKind::Sleeve | PanelKind::UnderSleeve | PanelKind::Hood
    )
}

fn is_band(kind: PanelKind) -> bool {
    matches!(
        kind,
        PanelKind::NeckBand
            | PanelKind::Waistband
            | PanelKind::Cuff
            | PanelKind::ArmBand
            | PanelKind::Collar
            | PanelKind::CollarStand
    )
}
