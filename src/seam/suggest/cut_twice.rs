//! Fronts and backs that are alike and drawn once: a whole panel round the body that is cut twice.

use super::labeled_panel::LabeledPanel;
use super::labels::{FrontBack, PanelKind};
use super::orientation::mirrored;
use crate::pattern::Pattern;

/// Makes a front and a back of the only panel of its kind where it is its own mirror image, cut
/// twice, and no name says which it is.
pub(super) fn assign_front_back(pattern: &Pattern, parts: &mut Vec<LabeledPanel>) {
    for kind in [PanelKind::Bodice, PanelKind::Skirt] {
        let of_kind: Vec<usize> = (0..parts.len())
            .filter(|i| parts[*i].kind == kind)
            .collect();
        let Some(&first) = of_kind.first() else {
            continue;
        };
        let part = &parts[first];
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

fn is_cut_again(pattern: &Pattern, panel: usize) -> bool {
    let quantity = pattern.panels[panel].quantity;
    quantity.is_some_and(|quantity| quantity.left.saturating_add(quantity.right) == 2)
}

fn is_copy(pattern: &Pattern, copy: &LabeledPanel, source: &LabeledPanel) -> bool {
    pattern.panels[copy.panel].copy_of.as_ref() == Some(&pattern.panels[source.panel].id)
}
