//! Labels for the panels of a pattern, by their names and by their outlines.

use super::figures::Figures;
use super::labeled_panel::LabeledPanel;
use super::labels::{FrontBack, Laterality, PanelKind};
use super::lexicon::Lexicon;
use super::orientation::OtherForm;
use super::outline_features::OutlineFeatures;
use super::penalties::{Drawn, drawing_penalty, half_penalty, upright};
use super::ring_panel::{self, RingPanel};
use super::{align, assignment, bands, cut_twice, names, orientation, side_panels, strays};
use crate::pattern::{Panel, Pattern};
use std::collections::BTreeSet;
use std::rc::Rc;

const UNNAMED_KINDS: [PanelKind; 5] = [
    PanelKind::Bodice,
    PanelKind::Skirt,
    PanelKind::Trouser,
    PanelKind::Sleeve,
    PanelKind::NeckBand,
];
/// Kinds of a panel without a telling name where other panels of the pattern have one.
const EXTRA_KINDS: [PanelKind; 2] = [PanelKind::Sleeve, PanelKind::NeckBand];
/// Kinds that only a bodice is sewn to: beside these, a panel called front or back is one.
const OF_BODICE: [PanelKind; 7] = [
    PanelKind::Side,
    PanelKind::Yoke,
    PanelKind::Sleeve,
    PanelKind::UnderSleeve,
    PanelKind::Hood,
    PanelKind::CollarStand,
    PanelKind::Collar,
];
/// Number of labelings of a panel that are weighed.
const MAX_LABELINGS: usize = 16;

/// Panels with their labels, and the hints of the names of all panels.
pub(super) struct Classification {
    /// Panels that were recognized, with the mirrored copies that the suggestion adds.
    pub(super) parts: Vec<LabeledPanel>,
    /// Spare panels that are other forms of recognized ones.
    pub(super) forms: Vec<OtherForm>,
    /// Panels that go round the body by a hole; they are no parts.
    pub(super) rings: Vec<RingPanel>,
    /// Hints of the names, in the order of the panels.
    pub(super) hints: Vec<names::NameHints>,
}

/// Labels the panels of a pattern; those without a telling name may also be of `rare` kinds.
pub(super) fn label_panels(pattern: &Pattern, rare: &[PanelKind]) -> Classification {
    let drawn: Vec<&str> = pattern.panels.iter().map(|p| p.name.as_str()).collect();
    let spelled = names::spelled_out(&drawn);
    let names: Vec<&str> = spelled.iter().map(String::as_str).collect();
    let common = names::common_start(&names);
    let shared = names::shared(&names);
    let lexicon = Lexicon::new();
    let figures = Figures::embedded();
    let mut hints: Vec<names::NameHints> = pattern
        .panels
        .iter()
        .zip(&names)
        .map(|(panel, name)| {
            let code = name.get(common..).unwrap_or_default();
            let name = if name.is_empty() { &panel.id } else { *name };
            let mut hints = names::hints(&lexicon, name, code, &shared);
            if panel.copy_of.is_some() {
                hints.laterality = hints.laterality.map(Laterality::other);
            }
            hints
        })
        .collect();
    if names::are_letters_of_a_series(&names) {
        hints = vec![names::NameHints::default(); names.len()];
    }
    names::tell_cuffs_from_fronts(&mut hints);
    let slits = hints.iter().any(|s| s.kind == Some(PanelKind::Godet));
    let of_two_parts = hints.iter().any(|s| s.kind == Some(PanelKind::UnderSleeve));
    let has_vents = |own: &names::NameHints| {
        let is_sleeve = matches!(own.kind, Some(PanelKind::Sleeve | PanelKind::UnderSleeve));
        of_two_parts && (is_sleeve || own.front_back == Some(FrontBack::Back))
    };
    let telling = hints.iter().any(|s| {
        s.front_back.is_some() || s.kind.is_some_and(|kind| PanelKind::BODY.contains(&kind))
    });
    let context = NameContext {
        telling,
        named: hints.iter().filter_map(|s| s.kind).collect(),
        rare,
    };
    let rings = ring_panel::ring_panels(pattern, &hints);
    let is_ring = |index: &usize| rings.iter().any(|ring| ring.panel == *index);
    let candidates: Vec<Vec<LabeledPanel>> = (0..names.len())
        .filter(|index| !is_ring(index))
        .map(|index| {
            let panel = &pattern.panels[index];
            let hints = &hints[index];
            candidates(
                &figures,
                (
                    index,
                    Rc::new(OutlineFeatures::of(panel, slits, has_vents(hints))),
                ),
                hints,
                (panel, &context),
            )
        })
        .collect();
    let mut parts = assignment::assign(candidates, &figures.assignment);
    orientation::assign_front_back(pattern, &mut parts);
    side_panels::assign_front_back(&mut parts);
    strays::drop_strays(&mut parts);
    let turned: Vec<bool> = parts
        .iter()
        .map(|p| orientation::is_drawn_from_inside(pattern, &parts, p))
        .collect();
    for (part, turned) in parts.iter_mut().zip(turned) {
        part.drawn_from_inside = turned;
    }
    bands::assign_openings(&mut parts);
    ring_panel::label_strips(pattern, &hints, &rings, &mut parts);
    let forms = orientation::assign_left_right(pattern, &mut parts);
    cut_twice::assign_front_back(pattern, &mut parts);
    Classification {
        parts,
        forms,
        rings,
        hints,
    }
}

/// The other names of a pattern, in whose company a name is read.
struct NameContext<'a> {
    /// True if a name tells of the front, the back or the kind of a body panel.
    telling: bool,
    /// Kinds that names tell of.
    named: BTreeSet<PanelKind>,
    /// Kinds that panels without a telling name may also be.
    rare: &'a [PanelKind],
}

impl NameContext<'_> {
    /// Returns the kinds that a panel may be.
    fn kinds(&self, hints: &names::NameHints) -> Vec<PanelKind> {
        let of_bodice = BTreeSet::from(OF_BODICE);
        match (hints.kind, hints.front_back) {
            (Some(PanelKind::Side), Some(_)) => vec![PanelKind::Side, PanelKind::Bodice],
            (Some(PanelKind::Trouser), None) => vec![PanelKind::Trouser, PanelKind::Leg],
            (Some(kind), _) => vec![kind],
            (None, Some(_)) if !of_bodice.is_disjoint(&self.named) => vec![PanelKind::Bodice],
            (None, Some(_)) => PanelKind::BODY.to_vec(),
            (None, None) if self.telling => [&EXTRA_KINDS, self.rare].concat(),
            (None, None) => [&UNNAMED_KINDS, self.rare].concat(),
        }
    }

    /// Returns the kinds that may be there.
    fn there(&self) -> BTreeSet<PanelKind> {
        self.named.iter().chain(self.rare).copied().collect()
    }
}

/// Returns the labelings of a panel, the likeliest first.
fn candidates(
    figures: &Figures,
    (panel, features): (usize, Rc<OutlineFeatures>),
    hints: &names::NameHints,
    (drawing, context): (&Panel, &NameContext<'_>),
) -> Vec<LabeledPanel> {
    let kinds = context.kinds(hints);
    let kinds_there = context.there();
    let named = hints.kind.is_some() || hints.front_back.is_some();
    let upright = upright(drawing);
    let drawn = match (drawing.unfolded, features.is_symmetric()) {
        (true, true) => Drawn::Unfolded,
        (_, true) => Drawn::Symmetric,
        _ => Drawn::Uneven,
    };
    let mut found: Vec<LabeledPanel> = vec![];
    for kind in kinds {
        // A yoke takes the shoulders of the back; the front keeps its own.
        let takes = |other: &&PanelKind| {
            let back = hints.front_back != Some(FrontBack::Front);
            kind == PanelKind::Bodice && (**other != PanelKind::Yoke || back)
        };
        let beside = kinds_there.iter().filter(takes);
        let beside = beside.flat_map(|other| {
            let templates = figures.beside(*other);
            templates.map(|template| (template, Some(*other)))
        });
        let own = figures.templates(kind).map(|template| (template, None));
        for (template, beside) in own.chain(beside) {
            let against = template.rarity
                + half_penalty((kind, template.half), hints, drawn, &figures.penalties);
            if against.is_infinite() {
                continue;
            }
            for alignment in align::align(&features, template, &figures.alignment)
                .into_iter()
                .take(MAX_LABELINGS)
            {
                let mut part = LabeledPanel {
                    panel,
                    kind,
                    of: hints.of.clone(),
                    number: hints.number,
                    front_back: hints.front_back,
                    laterality: hints.laterality,
                    laterality_named: hints.laterality.is_some(),
                    half: template.half,
                    drawn_from_inside: false,
                    beside,
                    features: Rc::clone(&features),
                    segments: alignment.segments,
                    cost: alignment.cost + against,
                    named,
                    kind_named: hints.kind.is_some(),
                };
                part.cost += drawing_penalty(&part, upright, &figures.penalties);
                found.push(part);
            }
        }
    }
    let limits = figures.recognition;
    let large = features.size >= limits.min_unnamed_size_m;
    found.retain(|part| {
        let most = if context.rare.contains(&part.kind) {
            limits.max_rare_cost
        } else {
            limits.max_unnamed_cost
        };
        named || large && part.cost < most
    });
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found.truncate(MAX_LABELINGS * (1 + context.rare.len()));
    found
}
