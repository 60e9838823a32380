//! Stiff and extreme cases, those that are small; `make stability` runs all of them.

use seamster_fixtures::stability::{StabilityCase, cases};
use std::collections::BTreeSet;

/// Factor of time over a release build on a core of its own: own code is not optimized as far, and
/// other tests run beside it.
const SLOWER: f64 = 20.0;

#[test]
fn every_case_has_a_name_of_its_own() {
    let names: BTreeSet<String> = cases().into_iter().map(|case| case.name).collect();
    assert_eq!(names.len(), cases().len());
}

/// Asserts that the cases of a group meet the conditions of `stability::check` and their own.
fn come_to_what_is_expected(group: &str) {
    let is_ours = |case: &StabilityCase| case.small && case.name.starts_with(group);
    let ours: Vec<StabilityCase> = cases().into_iter().filter(is_ours).collect();
    assert!(!ours.is_empty());
    let wrong: Vec<String> = ours
        .iter()
        .map(|case| seamster_fixtures::stability::line(case, SLOWER))
        .filter(|line| !line.faults.is_empty())
        .map(|line| format!("{}: {}", line.case, line.faults.join("; ")))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
#[ignore = "a minute in a build that is hardly optimized: make soak"]
fn stiff_cloth() {
    come_to_what_is_expected("stiffness");
}

#[test]
fn unlike_things_side_by_side() {
    come_to_what_is_expected("contrast");
}

#[test]
#[ignore = "a minute in a build that is hardly optimized: make soak"]
fn starts_like_no_garment() {
    come_to_what_is_expected("start");
}

#[test]
fn seams_of_any_stiffness() {
    come_to_what_is_expected("seam");
}

#[test]
#[ignore = "a minute in a build that is hardly optimized: make soak"]
fn motions() {
    come_to_what_is_expected("motion");
}

#[test]
fn weights() {
    come_to_what_is_expected("gravity");
}

#[test]
fn fabrics() {
    come_to_what_is_expected("fabric");
}

#[test]
#[ignore = "a minute in a build that is hardly optimized: make soak"]
fn gales() {
    come_to_what_is_expected("wind");
}

#[test]
fn few_vertices() {
    come_to_what_is_expected("size");
}

#[test]
fn garments() {
    come_to_what_is_expected("garment");
}
