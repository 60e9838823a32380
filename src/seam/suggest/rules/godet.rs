//! Godets: wedges set into slits of a hem.

use crate::seam::suggest::darts::Dart;
use crate::seam::suggest::edge_chain::length;
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labeled_panel::LabeledPanel;
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, PanelKind};

/// Largest difference of the side of a godet and of its slit, as a share.
const MAX_DIFFERENCE: f64 = 0.03;

/// Sets every godet into a slit.
pub(super) fn sew(garment: &mut GarmentModel) {
    let mut godets: Vec<LabeledPanel> = garment.parts_of(PanelKind::Godet).cloned().collect();
    godets.sort_by_key(|p| (p.front_back, p.number));
    for godet in godets {
        let Some((host, slit)) = slit(garment, &godet) else {
            continue;
        };
        let right = if host.features.mirrored {
            DrawnSide::Left
        } else {
            DrawnSide::Right
        };
        // The slit's first leg meets the side of the godet that lies on the right: both outer sides
        // are out.
        let [first, second] = host.dart_legs(slit);
        for (leg, drawn_side, name) in [(first, right, "a"), (second, right.other(), "b")] {
            let side = godet.role_chain(EdgeRole::Side, Some(drawn_side), EdgeRole::Hem);
            let id = format!("godet-{}-{name}", godet.panel);
            let rationale = SeamRationale::new(&id, "the godet is set into the slit");
            garment.sew(rationale, Some(leg), side);
        }
    }
}

/// Returns the first free slit that fits a godet, from the left of its panel.
fn slit(garment: &GarmentModel, godet: &LabeledPanel) -> Option<(LabeledPanel, Dart)> {
    let side = length(&godet.chain(godet.segment(EdgeRole::Side, None)?));
    let mut found: Vec<(f64, LabeledPanel, Dart)> = vec![];
    for host in garment
        .parts_of(PanelKind::Skirt)
        .filter(|p| p.front_back == godet.front_back || godet.front_back.is_none())
    {
        for dart in &host.features.darts {
            let [leg, _] = host.dart_legs(*dart);
            if (length(&leg) - side).abs() <= MAX_DIFFERENCE * side
                && !garment.is_sewn(host.panel, dart.inward)
            {
                let tip = host.features.edges[dart.inward].ends[1];
                found.push((tip[0], host.clone(), *dart));
            }
        }
    }
    let first = found.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((first.1, first.2))
}
