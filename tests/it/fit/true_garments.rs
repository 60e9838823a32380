//! Garments that others drafted, sewn by their own seams on a body of the size that they were
//! drafted for.

use super::sewn;
use seamster::export::DrapedPanel;
use seamster::fit::{AvatarRef, FitOutcome, Garment, PatternRef};
use seamster::pattern::{Pattern, SeamPair};
use seamster::scene::DressForm;
use seamster::solver::SolverOptions;
use seamster_fixtures::drafts::{data, garment};
use std::collections::BTreeMap;

/// The body that GarmentCode drafts for where nothing else is said: its mean female (`mean_all` of
/// its data set).
const MEAN_FEMALE: DressForm = DressForm::new(1.662, 0.974, 0.803, 1.041);
const EDGE_LENGTH: f64 = 0.025;
const X: usize = 0;
const Y: usize = 1;
const Z: usize = 2;
/// Promised bounds of a sewn garment \[m\].
const SEAM_GAP: f64 = 1e-3;
const PENETRATION: f64 = 1e-3;

fn asked(pattern: Pattern, pairs: Vec<SeamPair>) -> Garment {
    Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        avatar: Some(AvatarRef::form(MEAN_FEMALE)),
        simulate: SolverOptions {
            edge_length_m: EDGE_LENGTH,
            ..SolverOptions::default()
        },
        ..serde_json::from_value(serde_json::json!({ "seams": pairs }))
            .expect("a garment needs its seams alone")
    }
}

/// The panels of a shape by id, none of whose coordinates is other than a number.
fn panels(outcome: &FitOutcome) -> BTreeMap<&str, &DrapedPanel> {
    let finite = |p: &[f64; 3]| p.iter().all(|x| x.is_finite());
    let panels = outcome.mesh.panels.iter();
    panels
        .inspect(|panel| assert!(panel.positions.iter().all(finite), "{}", panel.panel))
        .map(|panel| (panel.panel.as_str(), panel))
        .collect()
}

/// The least, mean and largest coordinate of a panel along an axis \[m\].
fn extent(panel: &DrapedPanel, axis: usize) -> [f64; 3] {
    let along = || panel.positions.iter().map(|p| p[axis]);
    [
        along().fold(f64::INFINITY, f64::min),
        along().sum::<f64>() / panel.positions.len() as f64,
        along().fold(f64::NEG_INFINITY, f64::max),
    ]
}

#[test]
fn pencil_skirt_is_sewn_and_worn() {
    let Some(folder) = data("a pencil skirt") else {
        return;
    };
    let draft = garment(&folder.join("dxf"), "gc_pencil_skirt__r12_aama");
    let heights = ["skirt_front", "skirt_back"].map(|name| height(&draft.pattern, name));
    let outcome = sewn(asked(draft.pattern, draft.pairs));
    let report = &outcome.report;
    assert!(report.converged, "{}", report.why);
    assert_eq!(report.support.ok, Some(true), "{}", report.support.because);
    assert!(report.seam_gap_max_m < SEAM_GAP, "{report:#?}");
    assert!(report.penetration_max_m < PENETRATION, "{report:#?}");

    let panels = panels(&outcome);
    let body = MEAN_FEMALE.build().expect("a body of plausible size");
    let waist = body.landmarks["waist_front"].y;
    for (front, back) in [("skirt_front", "skirt_back"), ("wb_front", "wb_back")] {
        let [front, back] = [front, back].map(|name| extent(panels[name], Z));
        assert!(front[1] > body.landmarks["waist_side_l"].z, "{front:?}");
        assert!(back[1] < body.landmarks["waist_side_l"].z, "{back:?}");
    }
    // The bands together are as long as the body's waist is round, so that is where they stay.
    for band in ["wb_front", "wb_back"] {
        let [lowest, _, highest] = extent(panels[band], Y);
        assert!((lowest..highest).contains(&waist), "{lowest} {highest}");
    }
    // The back is cut longer by what the seat takes up: the hem of a worn skirt is more level than
    // its pieces.
    let [front, back] = ["skirt_front", "skirt_back"].map(|name| extent(panels[name], Y)[0]);
    assert!((front - back).abs() < (heights[1] - heights[0]).abs());
    for (name, panel) in &panels {
        let [_, middle, _] = extent(panel, X);
        assert!(
            middle.abs() < EDGE_LENGTH / 2.0,
            "{name}: drawn symmetrical"
        );
    }
}

/// Height of a panel as drawn \[m\].
fn height(pattern: &Pattern, name: &str) -> f64 {
    let panel = &pattern.panels[pattern.panel_index(name).expect("a panel of the draft")];
    let corners = || panel.corners.iter().map(|corner| corner.y);
    corners().fold(f64::NEG_INFINITY, f64::max) - corners().fold(f64::INFINITY, f64::min)
}
