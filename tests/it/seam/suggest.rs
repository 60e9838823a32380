//! Suggested seams: of the samples, whose drafts are known, and of real garments against the truth.

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster::seam::suggest::{Suggestion, suggest};
use seamster_fixtures::truth;
use std::collections::BTreeSet;
use std::path::Path;

fn sample(name: &str) -> Pattern {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("static/samples")
        .join(name);
    let bytes = std::fs::read(path).expect("a sample");
    import(&bytes, &ImportOptions::default(), &Limits::default()).expect("a pattern")
}

fn suggested(pattern: &Pattern) -> Suggestion {
    suggest(pattern, &Limits::default())
}

fn ids(found: &Suggestion) -> BTreeSet<&str> {
    found
        .seams
        .iter()
        .map(|seam| seam.pair.id.as_str())
        .collect()
}

#[test]
fn top_is_sewn_at_shoulders_and_sides() {
    let found = suggested(&sample("top.dxf"));
    let wanted = ["shoulder-left", "shoulder-right", "side-left", "side-right"];
    assert_eq!(ids(&found), wanted.into());
    assert!(
        found
            .seams
            .iter()
            .all(|seam| seam.confidence > 0.5 && !seam.because.is_empty())
    );
    assert_eq!(found.panels.keys().collect::<Vec<_>>(), ["back", "front"]);
    assert_eq!(found.warnings, []);
}

#[test]
fn skirt_gets_its_waistband_and_its_darts() {
    let pattern = sample("skirt.dxf");
    let found = suggested(&pattern);
    for kind in ["skirt-side-left", "skirt-side-right", "waistband"] {
        assert!(
            ids(&found).iter().any(|id| id.starts_with(kind)),
            "{kind}: {:?}",
            ids(&found)
        );
    }
    assert!(found.panels.contains_key("waistband"));
}

#[test]
fn suggestion_does_not_depend_on_how_panels_lie_in_their_drawing() {
    let mut pattern = sample("top.dxf");
    let upright = suggested(&pattern);
    for panel in &mut pattern.panels {
        let turn = |[x, y]: [f64; 2]| [-y, x];
        for corner in &mut panel.corners {
            [corner.x, corner.y] = turn([corner.x, corner.y]);
        }
        for point in panel.edges.iter_mut().flat_map(|edge| &mut edge.points) {
            *point = turn(*point);
        }
        panel.grain = None;
    }
    let turned = suggested(&pattern);
    let pairs = |found: &Suggestion| -> Vec<_> {
        found.seams.iter().map(|seam| seam.pair.clone()).collect()
    };
    assert_eq!(pairs(&upright), pairs(&turned));
    assert_eq!(turned.panels["front"].placement.up_deg, Some(180.0));
}

#[test]
fn pattern_of_no_garment_gets_no_seams_and_is_told_of() {
    let mut pattern = sample("top.dxf");
    pattern.panels.truncate(1);
    let found = suggested(&pattern);
    assert_eq!(found.seams, []);
    assert_eq!(found.warnings.len(), 1);
}

#[test]
fn true_seams_are_suggested() {
    let Some(data) = truth::data() else {
        println!("SEAMSTER_TEST_DATA is not set: 1 test left out (suggestions against true seams)");
        return;
    };
    let table = truth::suggest::table(&data);
    table.print("suggestions");
    assert_eq!(table.wrong(), Vec::<String>::new());
}
