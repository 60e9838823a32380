//! Fronts and backs that are alike and drawn once: a whole panel round the body that is cut twice.

use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, FrontBack, PanelKind};
use super::orientation::mirrored;
use crate::pattern::Pattern;

/// Makes a front and a back of the only panel of its kind where it is its own mirror image, cut
/// twice, and no name says which it is. A bodice must have shoulders.
pub(super) fn assign_front_back(pattern: &Pattern, parts: &mut Vec<LabeledPanel>) {
    for kind in [PanelKind::Bodice, PanelKind::Skirt] {
        let of_kind: Vec<usize> = (0..parts.len())
            .filter(|i| parts[*i].kind == kind)
            .collect();
        let Some(&first) = of_kind.first() else {
            continue;
        };
        let part = &parts[first];
        // Of a rectangle nothing tells where the arms come out.
        if kind == PanelKind::Bodice && part.segment(EdgeRole::Shoulder, None).is_none() {
            continue;
        }
        if part.half || part.front_back.is_some() || !part.features.is_symmetric() {
            continue;
        }
        let back = match of_kind[1..] {
            [] if is_cut_again(pattern, part.panel) => {
                parts.push(LabeledPanel {
                    panel: part.panel + pattern.panels.len(),
                    drawn_from_inside: false,
                    ..mirrored(part)
                });
                parts.len() - 1
            }
            [copy] if is_copy(pattern, &parts[copy], part) => copy,
            _ => continue,
        };
        parts[first].front_back = Some(FrontBack::Front);
        parts[back].front_back = Some(FrontBack::Back);
    }
}

/// Returns true if a front and a back among the panels of a seam are one that is cut twice: whole,
/// and the mirror image of each other.
pub(super) fn are_front_and_back(parts: &[&LabeledPanel]) -> bool {
    let whole = |front_back| {
        let here = |p: &&&LabeledPanel| p.front_back == Some(front_back) && !p.half;
        parts.iter().find(here)
    };
    let (Some(front), Some(back)) = (whole(FrontBack::Front), whole(FrontBack::Back)) else {
        return false;
    };
    let of_body = matches!(front.kind, PanelKind::Bodice | PanelKind::Skirt);
    of_body
        && front.kind == back.kind
        && front.features.mirrored != back.features.mirrored
        && front.features.is_twin(&back.features)
}

fn is_cut_again(pattern: &Pattern, panel: usize) -> bool {
    let quantity = pattern.panels[panel].quantity;
    quantity.is_some_and(|quantity| quantity.left.saturating_add(quantity.right) == 2)
}

fn is_copy(pattern: &Pattern, copy: &LabeledPanel, source: &LabeledPanel) -> bool {
    pattern.panels[copy.panel].copy_of.as_ref() == Some(&pattern.panels[source.panel].id)
}
