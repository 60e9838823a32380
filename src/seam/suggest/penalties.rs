//! Penalties of a labeling of a panel: by its name, its symmetry, its drawing, and how such panels
//! are made.

use super::edge_chain::EdgeStep;
use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, FrontBack, PanelKind};
use super::names;
use super::orientation::outer_drawn_side;
use crate::pattern::Panel;
use serde::Deserialize;

/// Misfit added for what speaks against a labeling, and the bounds of what is usual.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PenaltyWeights {
    /// The name or the symmetry of a panel speaks against half or whole.
    half_mismatch: f64,
    /// Half a skirt panel that no name calls so.
    unnamed_half_skirt: f64,
    /// A labeling contradicts how such panels are made.
    implausible: f64,
    /// A panel is drawn on its side.
    on_its_side: f64,
    /// A panel is drawn hem up, or a skirt has a waist far longer than its hem.
    upside_down: f64,
    /// A front is drawn as seen through the body.
    front_from_inside: f64,
    /// Longest usual waist over hem.
    max_waist_to_hem: f64,
    /// A cap that turns less is straight \[rad\].
    min_cap_curl_rad: f64,
    /// The face edge of a hood that turns more is curved \[rad\].
    max_hood_face_curl_rad: f64,
}

/// How a panel was drawn, as far as it tells half panels from whole ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Drawn {
    /// On the fold: what is there is all of it.
    Unfolded,
    /// It is its own mirror image.
    Symmetric,
    Uneven,
}

/// Returns the penalty for taking a panel for half or for whole.
pub(super) fn half_penalty(
    (kind, half): (PanelKind, bool),
    hints: &names::NameHints,
    drawn: Drawn,
    weights: &PenaltyWeights,
) -> f64 {
    let symmetric = drawn != Drawn::Uneven;
    let sided = hints.laterality.is_some();
    if half && (drawn == Drawn::Unfolded || symmetric && kind == PanelKind::Bodice && !sided) {
        return f64::INFINITY;
    }
    let halved = match kind {
        PanelKind::Sleeve => Some(hints.front_back.is_some()),
        PanelKind::Bodice | PanelKind::Skirt if hints.laterality.is_some() => Some(true),
        PanelKind::Bodice | PanelKind::Skirt | PanelKind::Trouser => symmetric.then_some(false),
        _ => None,
    };
    match halved {
        Some(halved) if halved != half => weights.half_mismatch,
        None if half && kind == PanelKind::Skirt => weights.unnamed_half_skirt,
        _ => 0.0,
    }
}

/// Returns the penalty for how a panel would be drawn: on its side, hem up, or a front as seen
/// through the body.
pub(super) fn drawing_penalty(
    part: &LabeledPanel,
    upright: Option<bool>,
    weights: &PenaltyWeights,
) -> f64 {
    let mut lower = part.role_edges(EdgeRole::Hem);
    lower.extend(part.role_edges(EdgeRole::Long));
    let mut cost = if is_implausible(part, weights) {
        weights.implausible
    } else {
        0.0
    };
    if part.kind == PanelKind::Sleeve || lower.is_empty() {
        return cost;
    }
    // Bands are cut along the grain or across it.
    let is_band = part.segment(EdgeRole::Long, None).is_some() || part.kind == PanelKind::Cuff;
    let lies = upright.is_some_and(|upright| part.features.is_level(&lower) != upright);
    if lies && !is_band {
        cost += weights.on_its_side;
    }
    let hem = part.role_edges(EdgeRole::Hem);
    let above = part.features.height(&hem) > part.features.height(&part.features.ring);
    if upright == Some(true) && !hem.is_empty() && above {
        cost += weights.upside_down;
    }
    let widest_waist = weights.max_waist_to_hem * part.role_length(EdgeRole::Hem);
    let is_skirt = part.kind == PanelKind::Skirt && part.number == 0;
    if is_skirt && part.role_length(EdgeRole::Waist) > widest_waist {
        cost += weights.upside_down;
    }
    let hints = part.laterality.filter(|_| {
        part.half
            && part.front_back == Some(FrontBack::Front)
            && PanelKind::BODY.contains(&part.kind)
    });
    if hints.is_some()
        && outer_drawn_side(part).map(|drawn_side| part.laterality_of(drawn_side)) != hints
    {
        cost += weights.front_from_inside;
    }
    cost
}

/// Returns true if a labeling has what no such panel has: shoulders that rise towards the arm, an
/// underarm longer than the sleeve, a cap that is straight, a hood whose opening is round, slits
/// for godets in the waist.
fn is_implausible(part: &LabeledPanel, weights: &PenaltyWeights) -> bool {
    let hem = part.role_edges(EdgeRole::Hem);
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
    let curl = |role| -> f64 {
        let segments = part.segments_of(role);
        segments.map(|s| part.features.curl(&s.edges)).sum()
    };
    let straight_cap = part.segment(EdgeRole::Cap, None).is_some()
        && curl(EdgeRole::Cap) < weights.min_cap_curl_rad;
    let curved_face =
        part.kind == PanelKind::Hood && curl(EdgeRole::Hem) > weights.max_hood_face_curl_rad;
    let short_top = part.role_length(EdgeRole::Top) > 0.0
        && part.role_length(EdgeRole::Underarm) > part.role_length(EdgeRole::Top);
    let count = |role| part.role_edges(role).len();
    let slit_waist = part.features.slits && count(EdgeRole::Waist) > count(EdgeRole::Hem);
    rising || slit_waist || straight_cap || curved_face || short_top
}

/// Returns true if a panel stands in its drawing, false if it lies, as far as its grain says.
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
