//! Evidence that two panels without telling names are sewn to each other: edges that are as long as
//! each other to a millimeter were drawn to meet.

use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, PanelKind};

/// Differences of length up to which edges are taken to be drawn for each other: as a share, and
/// \[m\]; the evidence falls off beyond.
const EXACT_SHARE: f64 = 0.004;
const EXACT_M: f64 = 0.002;

/// Usual difference in width of front and back, as a logarithm.
const WIDTH_SPREAD: f64 = 0.25;
/// Share of the evidence that shoulders give by themselves.
const SHOULDER_SHARE: f64 = 0.4;

/// Returns the evidence that the labelings of two panels are right, from 0 to 1: the share of the
/// edges that they would be sewn by that fit. Nothing for panels whose kinds are not sewn to each
/// other, or whose names tell what they are.
pub(super) fn evidence(a: &LabeledPanel, b: &LabeledPanel) -> f64 {
    if a.named && b.named {
        return 0.0;
    }
    directed(a, b).or_else(|| directed(b, a)).unwrap_or(0.0)
}

/// Returns the evidence for kinds in this order.
fn directed(a: &LabeledPanel, b: &LabeledPanel) -> Option<f64> {
    use EdgeRole::{Armhole, Center, Hem, Inseam, Neck, Shoulder, Side, Underarm, Waist};
    let alike = |roles: &[EdgeRole]| {
        let fits = roles
            .iter()
            .map(|role| fit(a.mean_length(*role), b.mean_length(*role)));
        fits.fold(1.0, f64::min)
    };
    match (a.kind, b.kind) {
        (PanelKind::Bodice, PanelKind::Bodice) if has(a, Shoulder) || has(b, Shoulder) => {
            // With a side panel between them they meet at the shoulder alone.
            Some(alike(&[Side, Shoulder]).max(SHOULDER_SHARE * alike(&[Shoulder])))
        }
        (PanelKind::Bodice, PanelKind::Bodice) => Some(0.5 * alike(&[Side])),
        (PanelKind::Skirt, PanelKind::Skirt) => {
            let widths = [a, b].map(|p| p.one_side_length(Waist).max(1e-6));
            let off = (widths[0] / widths[1]).ln() / WIDTH_SPREAD;
            Some(alike(&[Side]) * (-0.5 * off.powi(2)).exp())
        }
        (PanelKind::Trouser, PanelKind::Trouser) => Some(alike(&[Side, Inseam])),
        (PanelKind::Sleeve, PanelKind::Bodice) if is_raglan(a) && is_raglan(b) => {
            let own = b.mean_length(Armhole);
            let fits = a
                .segments_of(Armhole)
                .map(|s| fit(a.features.length(&s.edges), own));
            Some(0.5 * fits.fold(0.0, f64::max))
        }
        (PanelKind::Side, PanelKind::Bodice) => {
            let edges = [Side, Center].map(|role| fit(a.mean_length(role), b.mean_length(Side)));
            Some(edges[0].max(edges[1]))
        }
        (PanelKind::Side, PanelKind::Side) => Some(0.5 * alike(&[Side])),
        (PanelKind::UnderSleeve, PanelKind::Sleeve) => Some(both(a, b, Underarm)),
        (PanelKind::Yoke, PanelKind::Bodice) if b.beside == Some(PanelKind::Yoke) => {
            Some(0.5 * fit(a.one_side_length(Hem), b.one_side_length(Neck)))
        }
        (PanelKind::Yoke, PanelKind::Bodice) => Some(0.4 * alike(&[Shoulder])),
        _ => None,
    }
}

/// Returns true for a panel whose armhole runs up to the neck.
fn is_raglan(part: &LabeledPanel) -> bool {
    has(part, EdgeRole::Armhole) && has(part, EdgeRole::Neck) && !has(part, EdgeRole::Shoulder)
}

fn has(part: &LabeledPanel, role: EdgeRole) -> bool {
    part.segment(role, None).is_some()
}

/// Returns how well both segments of a role fit, each with either of the other panel.
fn both(a: &LabeledPanel, b: &LabeledPanel, role: EdgeRole) -> f64 {
    let lengths = |p: &LabeledPanel| -> Vec<f64> {
        let segments = p.segments_of(role);
        let mut all: Vec<f64> = segments.map(|s| p.features.length(&s.edges)).collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let (a, b) = (lengths(a), lengths(b));
    if a.len() != 2 || b.len() != 2 {
        return 0.0;
    }
    fit(a[0], b[0]).min(fit(a[1], b[1]))
}

/// Returns 1 for lengths that are the same, falling to 0 with their difference.
pub(super) fn fit(a: f64, b: f64) -> f64 {
    if a <= 0.0 || b <= 0.0 {
        return 0.0;
    }
    let off = (a - b).abs() / (EXACT_SHARE * a.max(b) + EXACT_M);
    (-0.5 * off.powi(2)).exp()
}
