//! Garments on bodies of their size and of others: worn, too small, too large.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster::config::Limits;
use seamster::fit::{Garment, PatternRef};
use seamster::pattern::{ImportOptions, import};
use seamster::scene::DressForm;
use seamster::solver::DrapeReport;
use seamster_fixtures::drafting::{SamplePattern, samples_for};
use seamster_fixtures::panels::{pattern, polygon};
use serde_json::{Value, json};

const SKIRT: usize = 0;
const TOP: usize = 1;

fn form(measures: [f64; 3]) -> DressForm {
    let [bust_m, waist_m, hip_m] = measures;
    DressForm {
        bust_m,
        waist_m,
        hip_m,
        ..DressForm::default()
    }
}

/// Sews a sample that is drafted for one form on another.
fn sewn_on(sample: &SamplePattern, body: &DressForm, simulate: Value) -> DrapeReport {
    let limits = Limits::default();
    let mut garment: Value = serde_json::from_str(&sample.garment).unwrap();
    garment["avatar"] = json!({ "form": body });
    garment["simulate"] = simulate;
    let mut garment: Garment = serde_json::from_value(garment).unwrap();
    let pattern = import(sample.dxf.as_bytes(), &ImportOptions::default(), &limits).unwrap();
    garment.pattern = Some(PatternRef::Whole(Box::new(pattern)));
    super::sewn(garment).report
}

fn has_warning(report: &DrapeReport, code: &str) -> bool {
    let mut warnings = report.warnings.iter();
    warnings.any(|warning| warning.code.as_str() == code)
}

/// Time that is up before anything is sewn: what is told beforehand is told.
fn unsewn() -> Value {
    json!({ "edge_length_m": 0.03, "time_limit_s": 1e-3 })
}

/// From the smallest to the largest size that is sold.
#[test]
fn garments_of_their_size_are_neither_too_small_nor_too_large() {
    for measures in [[0.75, 0.6, 0.82], [0.92, 0.74, 0.98], [1.4, 1.28, 1.42]] {
        let body = form(measures);
        for sample in samples_for(&body) {
            let report = sewn_on(&sample, &body, unsewn());
            let sizes = ["fit/too_small", "fit/too_large"];
            let is_told = sizes.iter().any(|code| has_warning(&report, code));
            assert!(!is_told, "{measures:?}: {:?}", report.warnings);
        }
    }
}

#[test]
fn skirts_of_their_size_are_worn_by_slight_and_by_stout_bodies() {
    for measures in [[0.75, 0.6, 0.82], [1.4, 1.28, 1.42]] {
        let body = form(measures);
        let skirt = &samples_for(&body)[SKIRT];
        let report = sewn_on(skirt, &body, json!({ "edge_length_m": 0.04 }));
        let good = report.good.unwrap();
        let why = (&report.why, &good.because);
        assert!(report.converged && good.ok, "{measures:?}: {why:?}");
    }
}

/// Two sizes of 4 cm (EN 13402-3).
#[test]
fn a_skirt_two_sizes_too_small_is_told_and_not_worn() {
    let body = DressForm::default();
    let smaller = [body.bust_m, body.waist_m, body.hip_m].map(|girth| girth - 0.08);
    let report = sewn_on(
        &samples_for(&form(smaller))[SKIRT],
        &body,
        json!({ "edge_length_m": 0.03 }),
    );
    assert!(
        has_warning(&report, "fit/too_small"),
        "{:?}",
        report.warnings
    );
    assert_ne!(report.support.ok, Some(true), "{}", report.support.because);
    let good = report.good.unwrap();
    assert!(!report.converged || !good.ok, "{:?}", good.because);
}

#[test]
fn a_skirt_of_a_stout_body_is_too_large_for_a_slight_one() {
    let skirt = &samples_for(&form([1.2, 1.08, 1.24]))[SKIRT];
    let report = sewn_on(skirt, &DressForm::default(), unsewn());
    assert!(
        has_warning(&report, "fit/too_large"),
        "{:?}",
        report.warnings
    );
}

#[test]
fn a_top_of_a_child_is_told() {
    let body = DressForm::default();
    let smaller = [body.bust_m, body.waist_m, body.hip_m].map(|girth| girth - 0.22);
    let report = sewn_on(&samples_for(&form(smaller))[TOP], &body, unsewn());
    assert!(
        has_warning(&report, "fit/too_small"),
        "{:?}",
        report.warnings
    );
}

/// Two panels with a square neck of this width \[m\], sewn at shoulders and sides.
fn top_with_neck(width: f64) -> DrapeReport {
    let (left, right) = (0.45 - 0.5 * width, 0.45 + 0.5 * width);
    let corners = [
        [0.0, 0.0],
        [0.0, 0.6],
        [left, 0.6],
        [left, 0.45],
        [right, 0.45],
        [right, 0.6],
        [0.9, 0.6],
        [0.9, 0.0],
    ];
    let panels = ["front", "back"].map(|id| polygon(id, &corners));
    // Seen from outside, the left of the front is sewn to the right of the back.
    let pairs = [[0, 1], [1, 2], [5, 6], [6, 7]].map(|[from, to]| {
        json!({
            "id": format!("seam-{from}"),
            "a": { "panel": "front", "from": from, "to": to },
            "b": { "panel": "back", "from": 7 - from, "to": 7 - to },
        })
    });
    let stated = json!({
        "schema": "seamster/garment/1",
        "panels": {
            "front": { "placement": { "at": "torso_front" } },
            "back": { "placement": { "at": "torso_back" } },
        },
        "seams": pairs,
        "avatar": { "form": DressForm::default() },
        "simulate": unsewn(),
    });
    let garment = Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern(panels.to_vec())))),
        ..serde_json::from_value(stated).unwrap()
    };
    super::sewn(garment).report
}

/// The shoulders of the form are 38 cm wide.
#[test]
fn a_neck_wider_than_the_shoulders_is_too_large() {
    let told = |width| has_warning(&top_with_neck(width), "fit/too_large");
    assert!(!told(0.3));
    assert!(told(0.5));
}
