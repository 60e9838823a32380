//! The settings of each panel: its own, or those of the panel that it mirrors.

use super::garment::{Garment, PanelSpec};
use crate::pattern::{Panel, Pattern};
use crate::seam::FaceRequest;

/// Returns the settings of each panel, in the pattern's order.
///
/// A mirrored copy takes from its source, reflected, whatever the garment does not state of the
/// copy itself.
pub(super) fn panel_specs(garment: &Garment, pattern: &Pattern) -> Vec<PanelSpec> {
    let panels = pattern.panels.iter();
    panels.map(|panel| panel_spec(garment, panel)).collect()
}

fn panel_spec(garment: &Garment, panel: &Panel) -> PanelSpec {
    let own = garment.panels.get(&panel.id).cloned().unwrap_or_default();
    let source = panel.copy_of.as_ref().and_then(|id| garment.panels.get(id));
    match source {
        Some(source) => with_defaults_of(own, source.clone()),
        None => own,
    }
}

/// Fills what `own` leaves open from the settings of the panel that it mirrors.
fn with_defaults_of(own: PanelSpec, source: PanelSpec) -> PanelSpec {
    let mirrored_grain = source
        .grain_deg
        .map(|angle| (180.0 - angle).rem_euclid(180.0));
    PanelSpec {
        fabric: own.fabric.or(source.fabric),
        texture: own.texture.or(source.texture),
        face: if own.face == FaceRequest::Auto {
            source.face
        } else {
            own.face
        },
        layer: if own.layer == 0 {
            source.layer
        } else {
            own.layer
        },
        grain_deg: own.grain_deg.or(mirrored_grain),
        seam_allowance_m: if own.seam_allowance_m == 0.0 {
            source.seam_allowance_m
        } else {
            own.seam_allowance_m
        },
        elastic: if own.elastic.is_empty() {
            source.elastic
        } else {
            own.elastic
        },
        placement: own
            .placement
            .or_else(|| source.placement.map(|p| p.mirrored())),
    }
}

/// Writes the settings of mirrored copies into the garment, so that the saved file states them by
/// the copies' own ids.
pub(super) fn spell_out_copies(garment: &mut Garment, pattern: &Pattern, specs: &[PanelSpec]) {
    for (panel, spec) in pattern.panels.iter().zip(specs) {
        if panel.copy_of.is_some() && *spec != PanelSpec::default() {
            garment.panels.insert(panel.id.clone(), spec.clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::sewing_pattern::tests::{garment, pattern_with_copies};
    use serde_json::json;

    #[test]
    fn a_copy_has_the_settings_of_its_source_unless_it_has_its_own() {
        let mut garment = garment(json!({"sleeve": {
            "fabric": "denim", "grain_deg": 60.0, "face": "down", "seam_allowance_m": 0.01,
            "placement": {"at": "origin", "offset_m": [0.5, 1.0, 0.1], "rotate_deg": [0.0, 10.0, 20.0]}}}));
        let pattern = pattern_with_copies(&garment);
        let copy = panel_spec(&garment, &pattern.panels[1]);
        assert_eq!(copy.fabric.as_deref(), Some("denim"));
        assert_eq!(
            (copy.grain_deg, copy.face),
            (Some(120.0), FaceRequest::Down)
        );
        let placement = copy.placement.expect("the image of its source's");
        assert_eq!(placement.offset_m, [-0.5, 1.0, 0.1]);
        assert_eq!(placement.rotate_deg, [0.0, -10.0, -20.0]);
        let own = PanelSpec {
            fabric: Some("voile".into()),
            ..PanelSpec::default()
        };
        garment.panels.insert("sleeve~mirror".into(), own);
        let specs = panel_specs(&garment, &pattern);
        spell_out_copies(&mut garment, &pattern, &specs);
        let copy = &garment.panels["sleeve~mirror"];
        assert_eq!(copy.fabric.as_deref(), Some("voile"));
        assert!((copy.seam_allowance_m - 0.01).abs() < f64::EPSILON);
    }
}
