//! Completeness of a suggested set of seams: panels that must be sewn and are not, edges that stay
//! open, and panels that are another form of one that is sewn.
//!
//! A wrong reading of a garment seldom uses all of its panels. Seams of a set that leaves out what
//! the names say is needed are offers, however well their lengths agree.

use super::edge_chain::EdgeStep;
use super::garment_model::GarmentModel;
use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, PanelKind};
use super::loose::{Loose, role_name, told};
use super::names::NameHints;
use super::suggestion::SuggestedSeam;
use crate::fault::{SeamCode, Warning};
use crate::pattern::{MIRROR, Pattern};
use std::collections::BTreeSet;

/// Share of the confidence that is left where a part of the body of the garment is missing: below
/// one half whatever the seam.
const WITHOUT_BODY: f64 = 0.5;
/// Share that is left where a band, a collar, a cuff or a hood is missing.
const WITHOUT_TRIM: f64 = 0.75;
/// A panel without a telling name is taken to be needed from this share of the area of all on:
/// pockets and facings are smaller.
const NEEDED_AREA: f64 = 0.08;
/// The same where the other panels make a whole garment.
const NEEDED_BESIDE_WHOLE: f64 = 0.2;

/// Area of other forms without telling names, against that of the sewn panels, that is usual at
/// most.
const MAX_FORMS: f64 = 1.5;
/// The same of panels that nothing tells of.
const MAX_UNNEEDED: f64 = 1.0;

/// What a set of seams leaves out.
#[derive(Clone, Debug)]
pub(super) struct Completeness {
    /// Panels that are not sewn, by their index.
    loose: Vec<(usize, Loose)>,
    /// Panels of which an edge is not sewn that must be, by their index, and its role.
    open: Vec<(usize, EdgeRole)>,
    /// Panels that offers name, by their index.
    offered: BTreeSet<usize>,
    /// True if no seam is suggested.
    empty: bool,
}

impl Completeness {
    /// Compares `seams` with the panels of `pattern`, `hints` being those of their names. Offers
    /// are not sewn.
    pub(super) fn of(
        pattern: &Pattern,
        garment: &GarmentModel,
        hints: &[NameHints],
        seams: &[SuggestedSeam],
    ) -> Self {
        let kept = seams.iter().filter(|seam| !seam.is_offer());
        let kept: BTreeSet<&str> = kept.map(|seam| seam.pair.id.as_str()).collect();
        let steps = garment
            .proposed
            .iter()
            .filter(|s| kept.contains(s.id.as_str()));
        let steps = steps.flat_map(|s| s.sides.iter().flatten());
        let steps: Vec<&EdgeStep> = steps.collect();
        let outlines = steps.iter().filter(|step| step.hole.is_none());
        let edges: BTreeSet<(usize, usize)> =
            outlines.map(|step| (step.panel, step.edge)).collect();
        let count = pattern.panels.len();
        let sewn: BTreeSet<usize> = steps.iter().map(|step| step.panel % count.max(1)).collect();
        let mut loose: Vec<(usize, Loose)> = (0..count)
            .filter(|i| !sewn.contains(i))
            .map(|i| {
                (
                    i,
                    form_of(garment, &sewn, i)
                        .or_else(|| band_of(garment, &sewn, i))
                        .unwrap_or_else(|| reason((pattern, garment), hints, &sewn, i)),
                )
            })
            .collect();
        doubt_spare(pattern, hints, &sewn, &mut loose);
        let is_copy = |of: usize, panel: usize| match pattern.panels.get(panel) {
            Some(copy) => copy.copy_of.as_ref() == Some(&pattern.panels[of].id),
            None => panel == of + count,
        };
        let sewn_once = |i: &usize| !steps.iter().any(|step| is_copy(*i, step.panel));
        let lacking = sewn
            .iter()
            .filter(|i| sewn_once(i) && is_cut_again(pattern, garment, hints, **i));
        loose.extend(lacking.map(|i| (*i, Loose::Copy)));
        if seams.is_empty() && garment.rings.len() == count {
            loose
                .iter_mut()
                .for_each(|(_, reason)| *reason = Loose::Worn);
        }
        let mut open: Vec<(usize, EdgeRole)> = vec![];
        for part in garment
            .parts
            .iter()
            .filter(|p| sewn.contains(&(p.panel % count)))
        {
            for role in needed_roles(garment, part) {
                let entry = (part.panel % count, role);
                let is_open = |e: &usize| !edges.contains(&(part.panel, *e));
                let own = part.role_edges(role);
                let lacks = own.is_empty() && lacks_shoulders(garment, part, role);
                if (lacks || own.iter().any(is_open)) && !open.contains(&entry) {
                    open.push(entry);
                }
            }
        }
        let offers = seams.iter().filter(|seam| seam.is_offer());
        let source = |id: &str| pattern.panel_index(id.strip_suffix(MIRROR).unwrap_or(id));
        Self {
            loose,
            open,
            offered: offers
                .flat_map(SuggestedSeam::panels)
                .filter_map(source)
                .collect(),
            empty: seams.is_empty(),
        }
    }

    /// Returns true if all panels are rings that are worn by their holes, without a seam.
    pub(super) fn is_worn_alone(&self) -> bool {
        let mut loose = self.loose.iter();
        !self.loose.is_empty() && loose.all(|(_, reason)| *reason == Loose::Worn)
    }

    /// Returns the share of their confidence that the seams keep.
    pub(super) fn trust(&self) -> f64 {
        let misses = |what: &Loose| self.loose.iter().any(|(_, reason)| reason == what);
        if misses(&Loose::Body) || misses(&Loose::Copy) || !self.open.is_empty() {
            WITHOUT_BODY
        } else if misses(&Loose::Trim) {
            WITHOUT_TRIM
        } else {
            1.0
        }
    }

    /// Returns the panels that are not sewn, or not all round, by their index.
    pub(super) fn unfinished(&self) -> BTreeSet<usize> {
        let loose = self.loose.iter().map(|(panel, _)| *panel);
        loose
            .chain(self.open.iter().map(|(panel, _)| *panel))
            .collect()
    }

    /// Tells of every panel that is not sewn, and why the seams are not to be trusted.
    pub(super) fn warnings(&self, pattern: &Pattern) -> Vec<Warning> {
        let id = |i: &usize| pattern.panels[*i].id.as_str();
        let warn = |detail: String| Warning::new(SeamCode::NotSuggested, "/seams", detail);
        let mut warnings: Vec<Warning> = self
            .loose
            .iter()
            .map(|(i, reason)| match reason {
                Loose::Body | Loose::Trim if self.offered.contains(i) => warn(format!(
                    "only seams of a confidence below 0.5 are suggested for panel `{}`: they are offers, to be looked at and listed",
                    id(i)
                )),
                _ => warn(told(id(i), reason, id)),
            })
            .collect();
        if self.empty {
            return warnings;
        }
        for (panel, role) in &self.open {
            warnings.push(warn(format!(
                "panel `{}` has its {} open, which such panels have sewn: the garment may be another one, and its seams are offers; look at them, or state that seam",
                id(panel),
                role_name(*role)
            )));
        }
        let body: Vec<&str> = self
            .loose
            .iter()
            .filter(|(_, reason)| *reason == Loose::Body)
            .map(|(i, _)| id(i))
            .collect();
        if !body.is_empty() {
            warnings.push(warn(format!(
                "the garment is not recognized as a whole: `{}` must be sewn and no seam that is sure enough was found for it, so that all seams are offers of less than half the confidence; state its seams, or leave the panel out",
                body.join("`, `")
            )));
        }
        warnings
    }
}

/// Doubts that panels are other forms of sewn ones, or not needed, where no names tell so and these
/// are the less: a garment seldom has more of them than of others.
fn doubt_spare(
    pattern: &Pattern,
    hints: &[NameHints],
    sewn: &BTreeSet<usize>,
    loose: &mut [(usize, Loose)],
) {
    let area = |i: usize| pattern.panels[i].area_m2.abs();
    let used: f64 = sewn.iter().map(|i| area(*i)).sum();
    let mut doubt = |is_spare: fn(&Loose) -> bool, most: f64| {
        let of_kind = |(i, reason): &&mut (usize, Loose)| {
            let named = hints[*i].kind.is_some() || hints[*i].front_back.is_some();
            is_spare(reason) && !named
        };
        let mut spare: Vec<&mut (usize, Loose)> = loose.iter_mut().filter(of_kind).collect();
        if spare.iter().map(|(i, _)| area(*i)).sum::<f64>() > most * used {
            for (_, reason) in &mut spare {
                *reason = Loose::Body;
            }
        }
    };
    doubt(|reason| matches!(reason, Loose::Alternative(_)), MAX_FORMS);
    doubt(|reason| *reason == Loose::Unneeded, MAX_UNNEEDED);
}

/// Returns the neck band that is sewn in the place of panel `i`, if that is another one.
fn band_of(garment: &GarmentModel, sewn: &BTreeSet<usize>, i: usize) -> Option<Loose> {
    let is_band = |p: &LabeledPanel| p.kind == PanelKind::NeckBand;
    garment.parts.iter().find(|p| p.panel == i && is_band(p))?;
    let mut others = garment.parts.iter().filter(|p| is_band(p));
    let other = others.find(|p| sewn.contains(&p.panel))?;
    Some(Loose::Alternative(other.panel))
}

/// Returns the sewn panel that panel `i`, whose name does not say what it is, was taken for a form
/// of.
fn form_of(garment: &GarmentModel, sewn: &BTreeSet<usize>, i: usize) -> Option<Loose> {
    let spare = garment.forms.iter().find(|form| form.panel == i);
    if let Some(form) = spare.filter(|form| sewn.contains(&form.of)) {
        return Some(Loose::Alternative(form.of));
    }
    let own = garment.parts.iter().find(|p| p.panel == i && !p.named)?;
    let is_same = |p: &&LabeledPanel| {
        p.kind == own.kind
            && own.front_back.is_some()
            && p.front_back == own.front_back
            && sewn.contains(&p.panel)
    };
    let other = garment.parts.iter().find(is_same)?;
    Some(Loose::Alternative(other.panel))
}

/// Returns the reason why panel `i` is not sewn.
fn reason(
    (pattern, garment): (&Pattern, &GarmentModel),
    hints: &[NameHints],
    sewn: &BTreeSet<usize>,
    i: usize,
) -> Loose {
    use PanelKind::{ArmBand, Bodice, Godet, Layer, Placket, Pocket, Side, Skirt, Sleeve};
    let own = &hints[i];
    let is_same = |j: &&usize| {
        let other = &hints[**j];
        let apart = own.laterality.is_some() && other.laterality.is_some();
        own.kind == other.kind
            && own.of == other.of
            && own.front_back == other.front_back
            && (own.laterality == other.laterality || !apart)
    };
    let named = own.kind.is_some() || own.front_back.is_some();
    if named && let Some(other) = sewn.iter().find(is_same) {
        return Loose::Alternative(*other);
    }
    match own.kind {
        Some(Pocket | Placket | Layer | ArmBand) => Loose::Unneeded,
        Some(
            Bodice
            | Skirt
            | PanelKind::Trouser
            | PanelKind::Leg
            | Godet
            | Sleeve
            | PanelKind::UnderSleeve
            | Side
            | PanelKind::Yoke,
        ) => Loose::Body,
        Some(_) => Loose::Trim,
        None if own.front_back.is_some() => Loose::Body,
        None if hints
            .iter()
            .all(|h| h.kind.is_none() && h.front_back.is_none()) =>
        {
            unnamed_reason((pattern, garment), sewn, i)
        }
        None => Loose::Unneeded,
    }
}

/// Returns true for a panel round the body that is cut several times, and whose name does not say
/// front or back: one that says so may be cut as two layers.
fn is_cut_again(pattern: &Pattern, garment: &GarmentModel, hints: &[NameHints], i: usize) -> bool {
    let is_round = |p: &LabeledPanel| matches!(p.kind, PanelKind::Skirt | PanelKind::Bodice);
    let panel = &pattern.panels[i];
    let quantity = panel.quantity;
    panel.copy_of.is_none()
        && quantity.is_some_and(|q| q.left.saturating_add(q.right) > 1)
        && hints[i].front_back.is_none()
        && garment.parts.iter().any(|p| p.panel == i && is_round(p))
}

/// Returns the reason where no name tells anything: large panels are needed. Trousers and tops with
/// sleeves are whole without others, but for hoods and bands; legs in one piece are not: many a
/// panel of a jacket looks like one.
fn unnamed_reason(
    (pattern, garment): (&Pattern, &GarmentModel),
    sewn: &BTreeSet<usize>,
    i: usize,
) -> Loose {
    let area = |panel: usize| pattern.panels[panel].area_m2.abs();
    let share = area(i) / (0..pattern.panels.len()).map(area).sum::<f64>();
    let has = |kind| {
        let mut parts = garment.parts_of(kind);
        parts.any(|p| sewn.contains(&(p.panel % pattern.panels.len())))
    };
    let trousers = has(PanelKind::Trouser);
    let whole = trousers || has(PanelKind::Sleeve) && has(PanelKind::Bodice);
    match share {
        share if share < NEEDED_AREA => Loose::Unneeded,
        share if share >= NEEDED_BESIDE_WHOLE || !whole => Loose::Body,
        _ if trousers => Loose::Unneeded,
        _ => Loose::Trim,
    }
}

/// Returns the roles whose edges must be sewn in a panel of a garment.
fn needed_roles(garment: &GarmentModel, part: &LabeledPanel) -> Vec<EdgeRole> {
    let mut roles = match part.kind {
        PanelKind::Bodice => vec![EdgeRole::Side, EdgeRole::Shoulder],
        PanelKind::Skirt => vec![EdgeRole::Side],
        PanelKind::Trouser | PanelKind::Leg => {
            vec![EdgeRole::Side, EdgeRole::Inseam, EdgeRole::Crotch]
        }
        PanelKind::Sleeve => vec![
            EdgeRole::Cap,
            EdgeRole::Underarm,
            EdgeRole::Top,
            EdgeRole::Armhole,
        ],
        PanelKind::UnderSleeve => vec![EdgeRole::Cap, EdgeRole::Underarm],
        PanelKind::Side => vec![EdgeRole::Side, EdgeRole::Center],
        PanelKind::Yoke => vec![EdgeRole::Hem, EdgeRole::Shoulder],
        _ => vec![],
    };
    if part.kind == PanelKind::Bodice && garment.has(PanelKind::Sleeve) {
        roles.push(EdgeRole::Armhole);
    }
    roles
}

/// Returns true if the role is the shoulder, and a panel was read without one though sleeves are
/// set in beside it: those have none that run up to the neck.
fn lacks_shoulders(garment: &GarmentModel, part: &LabeledPanel, role: EdgeRole) -> bool {
    let mut sleeves = garment.parts_of(PanelKind::Sleeve);
    part.kind == PanelKind::Bodice
        && role == EdgeRole::Shoulder
        && part.beside.is_none()
        && sleeves.any(|p| p.segment(EdgeRole::Cap, None).is_some())
}
