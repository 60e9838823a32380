//! Garments on bodies of their size and of others: worn, too small, too large.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster::config::Limits;
use seamster::fit::{Garment, PatternRef};
use seamster::pattern::{ImportOptions, import};
use seamster::scene::DressForm;
use seamster::solver::DrapeReport;
use seamster_fixtures::drafting::{SamplePattern, samples_for};
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
fn sewn_on(sample: &SamplePattern, body: &DressForm, edge_length: f64) -> DrapeReport {
    let limits = Limits::default();
    let mut garment: Value = serde_json::from_str(&sample.garment).unwrap();
    garment["avatar"] = json!({ "form": body });
    garment["simulate"] = json!({ "edge_length_m": edge_length });
    let mut garment: Garment = serde_json::from_value(garment).unwrap();
    let pattern = import(sample.dxf.as_bytes(), &ImportOptions::default(), &limits).unwrap();
    garment.pattern = Some(PatternRef::Whole(Box::new(pattern)));
    super::sewn(garment).report
}

fn has_warning(report: &DrapeReport, code: &str) -> bool {
    let mut warnings = report.warnings.iter();
    warnings.any(|warning| warning.code.as_str() == code)
}

/// From the smallest to the largest size that is sold.
#[test]
fn garments_of_their_size_are_worn_by_slight_and_by_stout_bodies() {
    for measures in [[0.75, 0.6, 0.82], [1.4, 1.28, 1.42]] {
        let body = form(measures);
        for sample in samples_for(&body) {
            let report = sewn_on(&sample, &body, 0.02);
            let good = report.good.clone().unwrap();
            let why = (sample.name, &report.why, &good.because);
            assert!(report.converged && good.ok, "{measures:?}: {why:?}");
            let sizes = ["fit/too_small", "fit/too_large"];
            assert!(
                sizes.iter().all(|code| !has_warning(&report, code)),
                "{why:?}"
            );
        }
    }
}

/// Two sizes of 4 cm (EN 13402-3).
#[test]
fn a_skirt_two_sizes_too_small_is_told_and_not_worn() {
    let body = DressForm::default();
    let smaller = [body.bust_m, body.waist_m, body.hip_m].map(|girth| girth - 0.08);
    let report = sewn_on(&samples_for(&form(smaller))[SKIRT], &body, 0.03);
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
    let report = sewn_on(skirt, &DressForm::default(), 0.04);
    assert!(
        has_warning(&report, "fit/too_large"),
        "{:?}",
        report.warnings
    );
    assert_ne!(report.support.ok, Some(true));
}

#[test]
fn a_top_of_a_child_is_told() {
    let body = DressForm::default();
    let smaller = [body.bust_m, body.waist_m, body.hip_m].map(|girth| girth - 0.22);
    let report = sewn_on(&samples_for(&form(smaller))[TOP], &body, 0.04);
    assert!(
        has_warning(&report, "fit/too_small"),
        "{:?}",
        report.warnings
    );
}
