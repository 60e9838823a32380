//! Strays: panels without telling names that were taken for parts of another garment than the
//! others make, as a pocket bag of trousers for a sleeve.

use super::labeled_panel::LabeledPanel;
use super::labels::{FrontBack, PanelKind};

/// Takes the parts that no name tells of and that the rest of the garment has no place for away.
pub(super) fn drop_strays(parts: &mut Vec<LabeledPanel>) {
    let has = |kind, front_back| {
        let is_there = |p: &LabeledPanel| p.kind == kind && p.front_back == Some(front_back);
        parts.iter().any(is_there)
    };
    let both = |kind| has(kind, FrontBack::Front) && has(kind, FrontBack::Back);
    let [halves, skirt] = [PanelKind::Trouser, PanelKind::Skirt].map(both);
    let trousers = halves || parts.iter().any(|p| p.kind == PanelKind::Leg);
    let bodice = parts.iter().any(|p| p.kind == PanelKind::Bodice);
    parts.retain(|part| {
        let of_bodice = matches!(
            part.kind,
            PanelKind::Sleeve | PanelKind::UnderSleeve | PanelKind::Hood | PanelKind::Side
        );
        let stray = of_bodice && !bodice && (trousers || skirt)
            || part.kind == PanelKind::Skirt && trousers;
        part.named || !stray
    });
}
