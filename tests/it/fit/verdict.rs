//! The verdict on whole garments: crossings counted at the end of a fit.

use super::sewn;
use seamster::fit::{FitOutcome, Garment, PatternRef};
use seamster::solver::{IntersectionKind, Shortcoming};
use seamster_fixtures::panels::{pattern, rectangle};
use serde_json::{Value, json};

/// Two curtains on rails that stand at `degrees` to each other and meet in the middle.
fn curtains(degrees: f64, self_contact: &str) -> FitOutcome {
    let panels = pattern(vec![
        rectangle("one", 0.3, 0.3),
        rectangle("other", 0.3, 0.3),
    ]);
    let pin = |panel: &str, corner: usize| json!({"panel": panel, "corner": corner});
    let at = |degrees: f64, z: f64| -> Value {
        json!({"placement": {"at": "origin", "offset_m": [0.0, 0.0, z], "rotate_deg": [0.0, degrees, 0.0]}})
    };
    let garment = json!({
        "seams": [], "avatar": null, "self_contact": self_contact,
        "pins": [pin("one", 1), pin("one", 2), pin("other", 1), pin("other", 2)],
        "panels": {"one": at(0.0, 0.0), "other": at(degrees, if degrees == 0.0 { 0.1 } else { 0.0 })},
        "simulate": {"edge_length_m": 0.05},
    });
    sewn(Garment {
        pattern: Some(PatternRef::Whole(Box::new(panels))),
        ..serde_json::from_value(garment).expect("a garment")
    })
}

#[test]
fn curtains_through_each_other_come_to_rest_and_are_not_good() {
    let report = curtains(90.0, "auto").report;
    assert!(report.converged, "{}", report.why);
    assert!(report.self_intersections > Some(0));
    let good = report.good.expect("a fit is judged");
    assert_eq!(good.failed, [Shortcoming::Crossings], "{:?}", good.because);
    let place = &report.intersections[0];
    assert_eq!(place.kind, IntersectionKind::Cloth);
    assert_eq!(place.panels, ["one", "other"]);
    // The rails meet in the middle of both, and so do the curtains: 3 cm is a place's own width.
    let [x, _, z] = place.at;
    assert!(x.hypot(z) < 0.03, "{:?}", place.at);
    let counted: usize = report.intersections.iter().map(|place| place.count).sum();
    assert_eq!(Some(counted), report.self_intersections);
}

#[test]
fn curtains_that_may_pass_through_each_other_are_counted_and_good() {
    let report = curtains(90.0, "off").report;
    assert!(report.self_intersections > Some(0));
    assert!(report.good.expect("a fit is judged").ok);
}

#[test]
fn curtains_side_by_side_are_good() {
    let report = curtains(0.0, "auto").report;
    assert_eq!(report.self_intersections, Some(0));
    assert_eq!(report.degenerate_triangles, Some(0));
    // There is no body.
    assert_eq!(report.body_intersections, None);
    assert!(report.good.expect("a fit is judged").ok);
    assert!(report.intersections.is_empty());
}
