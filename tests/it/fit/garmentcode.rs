//! Specifications sewn by their own stitches from their own placements, on a body of the size that
//! they were drafted for.

use super::sewn;
use seamster::config::Limits;
use seamster::fit::{AvatarRef, FitOutcome, Garment, PatternRef};
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster::scene::DressForm;
use seamster::solver::SolverOptions;
use std::path::{Path, PathBuf};

/// The body that `GarmentCode` drafts for where nothing else is said: its mean female.
const MEAN_FEMALE: DressForm = DressForm::new(1.662, 0.974, 0.803, 1.041);
/// Promised bounds of a sewn garment \[m\].
const SEAM_GAP: f64 = 1e-3;
const PENETRATION: f64 = 1e-3;

fn specification(folder: &Path, name: &str) -> Pattern {
    let file = folder.join(format!("dxf/{name}_specification.json"));
    let bytes = std::fs::read(file).expect("the data folder has it");
    import(&bytes, &ImportOptions::default(), &Limits::default()).expect("a specification")
}

/// Sews a pattern by its own seams, nothing else said but the body and the length of mesh edges.
fn sewn_by_its_own_seams(pattern: Pattern) -> FitOutcome {
    let seams = serde_json::json!({ "seams": pattern.seams });
    sewn(Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        avatar: Some(AvatarRef::form(MEAN_FEMALE)),
        simulate: SolverOptions {
            edge_length_m: 0.025,
            ..SolverOptions::default()
        },
        ..serde_json::from_value(seams).expect("a garment needs its seams alone")
    })
}

fn data(left_out: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("SEAMSTER_TEST_DATA is not set: 1 test left out ({left_out})");
    }
    folder
}

fn assert_worn(outcome: &FitOutcome) {
    let report = &outcome.report;
    assert!(report.converged, "{}", report.why);
    assert_eq!(report.support.ok, Some(true), "{}", report.support.because);
    assert!(report.seam_gap_max_m < SEAM_GAP, "{report:#?}");
    assert!(report.penetration_max_m < PENETRATION, "{report:#?}");
}

#[test]
fn shirt_is_sewn_as_its_specification_states() {
    let Some(folder) = data("a shirt from its specification") else {
        return;
    };
    let outcome = sewn_by_its_own_seams(specification(&folder, "gc_tshirt"));
    assert_worn(&outcome);
    // Left is the wearer's own, which is +x where the body looks along +z; fronts lie before backs.
    let middle = |name: &str, axis: usize| {
        let panel = outcome.mesh.panels.iter().find(|panel| panel.panel == name);
        let positions = &panel.expect("the panel").positions;
        positions.iter().map(|p| p[axis]).sum::<f64>() / positions.len() as f64
    };
    for part in ["ftorso", "btorso", "sleeve_f", "sleeve_b"] {
        let [left, right] = ["left", "right"].map(|side| middle(&format!("{side}_{part}"), 0));
        assert!(right < 0.0 && 0.0 < left, "{part}: {left} {right}");
    }
    for side in ["left", "right"] {
        let front = middle(&format!("{side}_ftorso"), 2);
        assert!(front > middle(&format!("{side}_btorso"), 2), "{side}");
    }
}

#[test]
#[ignore = "minutes in a build that is hardly optimized: make soak"]
fn circle_skirt_is_sewn_as_its_specification_states() {
    let Some(folder) = data("a circle skirt from its specification") else {
        return;
    };
    assert_worn(&sewn_by_its_own_seams(specification(
        &folder,
        "gc_circle_skirt",
    )));
}
