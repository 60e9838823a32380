//! Darts: two edges of one panel that meet at a tip, sewn together whatever the garment is.

use crate::pattern::Pattern;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, PanelKind};
use crate::seam::suggest::outline_features::Dart;

/// Most darts of one panel that are sewn.
const MAX_DARTS: usize = 40;

/// Sews every dart.
pub(super) fn sew(garment: &mut GarmentModel, pattern: &Pattern) {
    for part in garment.parts.clone() {
        for (i, dart) in part.features.darts.iter().take(MAX_DARTS).enumerate() {
            if garment.is_sewn(part.panel, dart.inward) || is_slit(&part, *dart) {
                continue;
            }
            let id = format!("dart-{}-{}", name(pattern, &part), i + 1);
            let rationale =
                SeamRationale::new(&id, "two edges of the panel that meet at a tip are a dart");
            garment.sew(
                rationale,
                Some(part.edge_chain(dart.inward, true)),
                Some(part.edge_chain(dart.outward, false)),
            );
        }
    }
}

/// Returns true for a dart that opens in the hem of a skirt: a slit to walk in.
fn is_slit(part: &LabeledPanel, dart: Dart) -> bool {
    let count = part.features.edges.len();
    let beside = [
        (dart.inward + count - 1) % count,
        (dart.outward + 1) % count,
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
