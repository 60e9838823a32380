//! The order of panels from the body outwards, from start to report.

use super::sewn;
use seamster::config::Limits;
use seamster::fit::{self, FitOutcome, Garment, PatternRef, ShippedAssets};
use seamster::progress::CancelToken;
use seamster::solver::Shortcoming;
use seamster_fixtures::panels::{pattern, polygon, rectangle, with_hole};
use seamster_fixtures::samples::with_context;
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

/// Two ponchos laid level at the neck: the one of the upper layer starts above the other.
#[test]
fn level_panels_start_above_those_of_lower_layers() {
    let poncho = |id: &str| {
        let square = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        let neck = [[0.4, 0.4], [0.6, 0.4], [0.6, 0.6], [0.4, 0.6]];
        with_hole(polygon(id, &square), &neck)
    };
    let at = |layer: i32| json!({"layer": layer, "placement": {"at": "neck", "wrap": "level"}});
    for layers in [[0, 1], [1, 0]] {
        let fields = json!({
            "seams": [],
            "panels": {"first": at(layers[0]), "second": at(layers[1])},
            "simulate": {"edge_length_m": 0.08},
        });
        let panels = pattern(vec![poncho("first"), poncho("second")]);
        let garment = Garment {
            pattern: Some(PatternRef::Whole(Box::new(panels))),
            ..serde_json::from_value(fields).expect("a garment")
        };
        let (limits, cancel) = (Limits::default(), CancelToken::new());
        let prepared = fit::resolve(garment, &ShippedAssets, &limits).expect("it can be sewn");
        let scene = with_context(&limits, &cancel, |_| {}, |c| fit::scene(&prepared, c));
        let scene = scene.expect("it can be sewn");
        let heights = scene.mesh.panels.iter().map(|panel| {
            let start = &scene.start[panel.vertices.clone()];
            let mean = start.iter().map(|p| p.y).sum::<f64>() / start.len() as f64;
            assert!(start.iter().all(|p| (p.y - mean).abs() < 1e-9), "level");
            mean
        });
        let heights: Vec<f64> = heights.collect();
        let upper = usize::from(layers[1] > layers[0]);
        assert!(heights[upper] > heights[1 - upper] + 5e-3, "{heights:?}");
    }
}
