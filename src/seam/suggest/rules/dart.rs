//! Darts: two edges of one panel that meet at a tip, or the sides of a narrow hole, sewn together
//! whatever the garment is.

use crate::pattern::Pattern;
use crate::seam::suggest::darts::Dart;
use crate::seam::suggest::edge_chain::reversed;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::hole_dart;
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, PanelKind};

/// Most darts of one panel that are sewn.
const MAX_DARTS: usize = 40;

/// Sews every dart.
pub(super) fn sew(garment: &mut GarmentModel, pattern: &Pattern) {
    for part in garment.parts.clone() {
        sew_inside(garment, pattern, &part);
        for (i, dart) in part.features.darts.iter().take(MAX_DARTS).enumerate() {
            if garment.is_sewn(part.panel, dart.inward) || is_slit(&part, *dart) {
                continue;
            }
            let id = format!("dart-{}-{}", name(pattern, &part), i + 1);
            let rationale =
                SeamRationale::new(&id, "two edges of the panel that meet at a tip are a dart");
            let [a, b] = part.dart_legs(*dart);
            garment.sew(rationale, Some(a), Some(b));
        }
    }
}

/// Sews the sides of every hole that is a dart inside a panel.
fn sew_inside(garment: &mut GarmentModel, pattern: &Pattern, part: &LabeledPanel) {
    let holes = &pattern.panels[part.panel % pattern.panels.len()].holes;
    for (i, hole) in holes.iter().enumerate().take(MAX_DARTS) {
        let Some([there, back]) = hole_dart::sides(part.panel, i, hole) else {
            continue;
        };
        let id = format!("dart-{}-inside-{}", name(pattern, part), i + 1);
        let rationale = SeamRationale::new(&id, "a narrow hole with two tips is a dart");
        garment.sew(rationale, Some(there), Some(reversed(&back)));
    }
}

/// Returns true for a dart that opens in the hem of a skirt: a slit to walk in.
fn is_slit(part: &LabeledPanel, dart: Dart) -> bool {
    let count = part.features.edges.len();
    let beside = [
        (dart.inward + count - dart.per_leg) % count,
        (dart.outward + dart.per_leg) % count,
    ];
    let hem = part.role_edges(EdgeRole::Hem);
    part.kind == PanelKind::Skirt && beside.iter().all(|edge| hem.contains(edge))
}

fn name(pattern: &Pattern, part: &LabeledPanel) -> String {
    let count = pattern.panels.len();
    let id = &pattern.panels[part.panel % count].id;
    if part.panel < count {
        id.clone()
    } else {
        format!("{id}~mirror")
    }
}
