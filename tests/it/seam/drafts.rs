//! Seams of garments that GarmentCode drafted: the true ones are accepted, each reversed one is
//! found.

use seamster::config::Limits;
use seamster::pattern::{Match, Panel, Pattern, SeamPair, Side};
use seamster::seam::{Face, SeamCheck, check};
use seamster_fixtures::drafts::{DraftedGarment, data, garment, turned};
use serde_json::Value;
use std::collections::BTreeMap;

/// A skirt of four panels with darts, and a shirt of eight with sleeves. Each seam lies on a cycle:
/// panels that are sewn together once are so through others too, and a dart joins a panel to
/// itself.
const GARMENTS: [(&str, usize); 2] = [
    ("gc_pencil_skirt__r12_aama", 20),
    ("gc_tshirt__r12_aama", 16),
];

/// Both garments; nothing where there is no data folder.
fn garments(left_out: &str) -> Vec<DraftedGarment> {
    let folder = data(left_out).map(|folder| folder.join("dxf"));
    let garments = folder.iter().flat_map(|folder| {
        GARMENTS.map(|(name, stitches)| {
            let garment = garment(folder, name);
            assert_eq!(garment.pairs.len(), stitches, "{name}");
            garment
        })
    });
    garments.collect()
}

fn checked(pattern: &Pattern, pairs: &[SeamPair]) -> SeamCheck {
    check(pattern, pairs, &BTreeMap::new(), 0.012, &Limits::default()).0
}

/// Face up where the loop of corners runs counter-clockwise as drawn.
fn drawn_face(truth: &Value, panel: &Panel) -> Face {
    let panels = truth["panels"].as_object().expect("panels by name");
    let (_, drawn) = panels
        .iter()
        .find(|(name, _)| name.eq_ignore_ascii_case(&panel.name))
        .expect("the panel is in the truth");
    let edges = drawn["edges"].as_array().expect("a list of edges");
    let figure = |point: &Value, i: usize| point[i].as_f64().expect("a figure");
    let twice_area: f64 = edges
        .iter()
        .map(|edge| {
            let (a, b) = (&edge["a_local_mm"], &edge["b_local_mm"]);
            figure(a, 0) * figure(b, 1) - figure(b, 0) * figure(a, 1)
        })
        .sum();
    if twice_area > 0.0 {
        Face::Up
    } else {
        Face::Down
    }
}

fn with_reversed(pairs: &[SeamPair], wrong: usize) -> Vec<SeamPair> {
    let mut pairs = pairs.to_vec();
    let Side::One(run) = &pairs[wrong].b else {
        panic!("made as single runs")
    };
    pairs[wrong].b = Side::One(turned(run));
    pairs
}

#[test]
fn true_seams_are_accepted_with_the_faces_that_were_drawn() {
    for DraftedGarment {
        pattern,
        pairs,
        truth,
    } in garments("true seams")
    {
        let found = checked(&pattern, &pairs);
        assert!(found.ok, "{:#?}", found.seams);
        for panel in &pattern.panels {
            assert_eq!(
                found.faces[&panel.id],
                drawn_face(&truth, panel),
                "{}",
                panel.id
            );
        }
        assert!(found.warnings.is_empty(), "every panel is sewn to another");
    }
}

#[test]
fn each_seam_with_one_side_reversed_is_refused_blamed_and_put_right() {
    for DraftedGarment { pattern, pairs, .. } in garments("reversed seams") {
        for wrong in 0..pairs.len() {
            let found = checked(&pattern, &with_reversed(&pairs, wrong));
            let faults: Vec<_> = found.seams.iter().flat_map(|seam| &seam.errors).collect();
            assert_eq!(faults.len(), 1, "{wrong}: {faults:#?}");
            assert_eq!(faults[0].code, "seam/twisted");
            assert_eq!(faults[0].pointer, format!("/seams/{wrong}"));
            assert_eq!(found.corrected, [pairs[wrong].clone()], "{wrong}");
        }
    }
}

#[test]
fn auto_puts_every_reversed_seam_right() {
    for DraftedGarment { pattern, pairs, .. } in garments("automatic order") {
        for wrong in 0..pairs.len() {
            let mut reversed = with_reversed(&pairs, wrong);
            reversed[wrong].matching = Match::Auto;
            let found = checked(&pattern, &reversed);
            assert!(found.ok, "{wrong}");
            let changed: Vec<_> = found.seams.iter().map(|seam| seam.reversed).collect();
            let expected: Vec<_> = (0..pairs.len()).map(|i| i == wrong).collect();
            assert_eq!(changed, expected);
        }
    }
}
