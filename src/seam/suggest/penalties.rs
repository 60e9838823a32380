//! What speaks against a reading of a panel: its name, its symmetry, how it lies in its drawing, how such panels are made.

use super::edge_chain::EdgeStep;
use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, FrontBack, PanelKind};
use super::names;
use super::orientation::outer_drawn_side;
use crate::pattern::Panel;

/// Misfit added where the name or the symmetry of a panel speaks against a reading.
const UNLIKELY: f64 = 3.0;
/// Misfit added for half a skirt panel that no name calls so.
const HALF_SKIRT: f64 = 1.5;
/// Misfit added where a reading contradicts how such panels are made.
const ABSURD: f64 = 1.5;
/// Misfit added for a panel drawn on its side, for one drawn hem up, and for a front drawn as seen through the body.
const ON_ITS_SIDE: f64 = 0.8;
const UPSIDE_DOWN: f64 = 0.8;
const FROM_INSIDE: f64 = 0.3;
/// A waist this much longer than the hem is unusual.
const WIDE_WAIST: f64 = 1.1;
/// An edge that turns less is straight, one that turns more curved \[rad\].
const STRAIGHT: f64 = 0.15;
const CURVED: f64 = 0.6;

/// What speaks against taking a panel for half or for whole.
pub(super) fn half_penalty(
    kind: PanelKind,
    half: bool,
    hints: &names::NameHints,
    symmetric: bool,
) -> f64 {
    let halved = match kind {
        PanelKind::Sleeve => Some(hints.front_back.is_some()),
        PanelKind::Bodice | PanelKind::Skirt if hints.laterality.is_some() => Some(true),
        PanelKind::Bodice | PanelKind::Skirt | PanelKind::Trouser => symmetric.then_some(false),
        _ => None,
    };
    match halved {
        Some(halved) if halved != half => UNLIKELY,
        None if half && kind == PanelKind::Skirt => HALF_SKIRT,
        _ => 0.0,
    }
}

/// What speaks against how a reading says that a panel is drawn: on its side, hem up, or a front as seen through the body.
pub(super) fn drawing_penalty(part: &LabeledPanel, upright: Option<bool>) -> f64 {
    let lower: Vec<usize> = part
        .segments_of(EdgeRole::Hem)
        .chain(part.segments_of(EdgeRole::Long))
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let mut cost = if is_implausible(part) { ABSURD } else { 0.0 };
    if part.kind == PanelKind::Sleeve || lower.is_empty() {
        return cost;
    }
    if upright.is_some_and(|upright| part.features.is_level(&lower) != upright) {
        cost += ON_ITS_SIDE;
    }
    let hem: Vec<usize> = part
        .segments_of(EdgeRole::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let above = part.features.height(&hem) > part.features.height(&part.features.ring);
    if upright == Some(true) && !hem.is_empty() && above {
        cost += UPSIDE_DOWN;
    }
    if part.kind == PanelKind::Skirt && part.number == 0 {
        let length = |role| -> f64 {
            part.segments_of(role)
                .map(|s| part.features.length(&s.edges))
                .sum()
        };
        if length(EdgeRole::Waist) > WIDE_WAIST * length(EdgeRole::Hem) {
            cost += UPSIDE_DOWN;
        }
    }
    let hints = part.laterality.filter(|_| {
        part.half
            && part.front_back == Some(FrontBack::Front)
            && PanelKind::BODY.contains(&part.kind)
    });
    if hints.is_some()
        && outer_drawn_side(part).map(|drawn_side| part.laterality_of(drawn_side)) != hints
    {
        cost += FROM_INSIDE;
    }
    cost
}

/// Whether a reading has what no such panel has: shoulders that rise towards the arm, an underarm longer than the sleeve,
/// a cap that is straight, a hood whose opening is round, slits for godets in the waist.
fn is_implausible(part: &LabeledPanel) -> bool {
    let hem: Vec<usize> = part
        .segments_of(EdgeRole::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let rising = part.segments_of(EdgeRole::Shoulder).any(|shoulder| {
        let chain = part.chain_from(shoulder, EdgeRole::Neck);
        let end = |step: Option<&EdgeStep>, last: bool| {
            step.map(|s| part.features.edges[s.edge].ends[usize::from(s.forward == last)])
        };
        match (end(chain.first(), false), end(chain.last(), true)) {
            (Some(neck), Some(arm)) => {
                part.features.above(&hem, neck) < part.features.above(&hem, arm)
            }
            _ => false,
        }
    });
    let length = |role| -> f64 {
        part.segments_of(role)
            .map(|s| part.features.length(&s.edges))
            .sum()
    };
    let curl = |role| -> f64 {
        part.segments_of(role)
            .map(|s| part.features.curl(&s.edges))
            .sum()
    };
    let straight_cap =
        part.segment(EdgeRole::Cap, None).is_some() && curl(EdgeRole::Cap) < STRAIGHT;
    let curved_face = part.kind == PanelKind::Hood && curl(EdgeRole::Hem) > CURVED;
    let short_top =
        length(EdgeRole::Top) > 0.0 && length(EdgeRole::Underarm) > length(EdgeRole::Top);
    let count = |role| -> usize { part.segments_of(role).map(|s| s.edges.len()).sum() };
    let slit_waist = part.features.slits && count(EdgeRole::Waist) > count(EdgeRole::Hem);
    rising || slit_waist || straight_cap || curved_face || short_top
}

/// Whether a panel stands or lies in its drawing, as far as its grain says.
pub(super) fn upright(panel: &Panel) -> Option<bool> {
    let Some(grain) = panel.grain else {
        return Some(true);
    };
    let from_vertical = (grain.angle_deg - 90.0).abs();
    match from_vertical {
        d if d <= 30.0 => Some(true),
        d if d >= 60.0 => Some(false),
        _ => None,
    }
}
