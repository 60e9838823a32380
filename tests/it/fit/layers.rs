//! The order of panels from the body outwards, from start to report.

use super::sewn;
use seamster::fit::{FitOutcome, Garment, PatternRef};
use seamster::solver::Shortcoming;
use seamster_fixtures::panels::{pattern, rectangle};
use serde_json::{Value, json};

/// Two patches that hang from their upper corners in front of the default dress form, in the layers
/// 0 and 1, and that the wind blows against it; the upper one starts so much further out \[m\].
fn patches(further: f64) -> FitOutcome {
    let panels = pattern(vec![
        rectangle("lower", 0.2, 0.2),
        rectangle("upper", 0.12, 0.12),
    ]);
    let pin = |panel: &str, corner: usize| json!({"panel": panel, "corner": corner});
    let at = |layer: i32, down: f64, out: f64| -> Value {
        json!({"layer": layer, "placement": {"at": "torso_front", "offset_m": [0.0, -down, out]}})
    };
    let garment = json!({
        "seams": [],
        "pins": [pin("lower", 1), pin("lower", 2), pin("upper", 1), pin("upper", 2)],
        "panels": {"lower": at(0, 0.1, -0.03), "upper": at(1, 0.12, further - 0.03)},
        "wind": {"velocity_m_s": [0.0, 0.0, -3.0]},
        "simulate": {"edge_length_m": 0.02, "tolerance": 1e-3},
    });
    sewn(Garment {
        pattern: Some(PatternRef::Whole(Box::new(panels))),
        ..serde_json::from_value(garment).expect("a garment")
    })
}

#[test]
fn a_patch_on_another_ends_on_it() {
    let report = patches(0.0).report;
    assert!(report.converged, "{}", report.why);
    assert_eq!(report.layers_wrong_area_m2, Some(0.0));
    let good = report.good.expect("a fit is judged");
    assert!(good.ok, "{:?}", good.because);
}

/// Started on the other side of it, it stays there: nothing tells contact to pull it through.
#[test]
fn a_patch_that_starts_beneath_the_one_that_it_belongs_on_is_a_fault() {
    let report = patches(-0.02).report;
    let wrong = report.layers_wrong_area_m2.expect("there are layers");
    // All of the patch, give or take the strain of cloth in a breeze.
    assert!((wrong / (0.12 * 0.12) - 1.0).abs() < 0.1, "{wrong}");
    let good = report.good.expect("a fit is judged");
    assert_eq!(good.failed, [Shortcoming::Layers], "{:?}", good.because);
}
