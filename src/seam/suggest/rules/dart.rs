//! Darts: two edges of one panel that meet at a tip, sewn together whatever the garment is.

use crate::pattern::Pattern;
use crate::seam::suggest::edge_chain::{EdgeChain, EdgeStep};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{EdgeRole, PanelKind};
use crate::seam::suggest::outline_features::Dart;

/// Most darts of one panel that are sewn.
const MOST: usize = 40;

/// Sews every dart.
pub(super) fn sew(garment: &mut GarmentModel, pattern: &Pattern) {
    for part in garment.parts.clone() {
        for (i, dart) in part.features.darts.iter().take(MOST).enumerate() {
            if garment.is_sewn(part.panel, dart.inward) || is_slit(&part, *dart) {
                continue;
            }
            let id = format!("dart-{}-{}", name(pattern, &part), i + 1);
            let rationale =
                SeamRationale::new(&id, "two edges of the panel that meet at a tip are a dart");
            let leg = |edge: usize, forward| -> EdgeChain {
                vec![EdgeStep {
                    panel: part.panel,
                    edge,
                    forward,
                    length: part.features.edges[edge].length,
                }]
            };
            garment.sew(
                rationale,
                Some(leg(dart.inward, true)),
                Some(leg(dart.outward, false)),
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
    let hem: Vec<usize> = part
        .segments_of(EdgeRole::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
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
