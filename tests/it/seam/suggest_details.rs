//! Suggested seams of what fewer garments have: darts inside a panel and with bent legs, vents,
//! gussets, bands round side panels, panels that are cut twice.

use super::drawn::{are_joined, bodice, drawn, middle, outer, suggested};
use seamster::pattern::{Place, Quantity, Side};
use seamster::seam::suggest::Suggestion;
use seamster_fixtures::panels::{mirrored, rectangle, with_hole};

#[test]
fn outer_and_inner_parts_are_told_by_their_names() {
    let found = suggested(vec![
        middle("front inside", 0.08),
        outer("front outside"),
        outer("back outside"),
        middle("back inside", 0.03),
    ]);
    are_joined(
        &found,
        &[
            ["front inside", "front outside"],
            ["back outside", "front outside"],
            ["back inside", "back outside"],
        ],
    );
}

#[test]
fn a_dart_inside_a_panel_is_sewn() {
    let lens = [[0.15, 0.15], [0.16, 0.22], [0.15, 0.29], [0.14, 0.22]];
    let back = with_hole(bodice("back", 0.04), &lens);
    let found = suggested(vec![bodice("front", 0.10), back]);
    for panel in ["back", "back~mirror"] {
        let id = format!("dart-{panel}-inside-1");
        let seams = found.seams.iter().filter(|s| s.pair.id.starts_with(&id));
        let ends: Vec<[Place; 4]> = seams
            .map(|seam| {
                assert!(seam.confidence >= 0.5);
                let [a, b] = [&seam.pair.a, &seam.pair.b].map(|side| &side.runs()[0]);
                [a.from, a.to, b.from, b.to]
            })
            .collect();
        let corner = |corner| Place::HoleCorner { hole: 0, corner };
        let sides = [[0, 1, 0, 3], [1, 2, 3, 2]].map(|corners| corners.map(corner));
        assert_eq!(ends, sides, "{panel}");
    }
}

/// The same panels are a whole top without it.
#[test]
fn a_gusset_that_fits_nowhere_makes_all_seams_offers() {
    let whole = suggested(vec![bodice("front", 0.10), bodice("back", 0.04)]);
    assert!(whole.seams.iter().all(|seam| seam.confidence >= 0.5));
    let gusset = rectangle("gusset", 0.08, 0.12);
    let found = suggested(vec![bodice("front", 0.10), bodice("back", 0.04), gusset]);
    assert!(!found.seams.is_empty());
    assert!(found.seams.iter().all(|seam| seam.confidence < 0.5));
}

/// A rectangle that is cut once is closed on itself; cut twice, it is the front and the back, with
/// a band round both; three of them are nothing known.
#[test]
fn a_panel_that_is_cut_twice_is_front_and_back() {
    let cut = |quantity: u32| {
        let mut panel = rectangle("skirt", 0.6, 0.6);
        let quantity = Quantity {
            left: quantity,
            right: 0,
        };
        panel.quantity = Some(quantity);
        suggested(vec![panel, rectangle("waistband", 1.2, 0.05)])
    };
    let ids = |found: &Suggestion| -> Vec<String> {
        let sure = found.seams.iter().filter(|seam| seam.confidence >= 0.5);
        sure.map(|seam| seam.pair.id.clone()).collect()
    };
    assert!(ids(&cut(1)).contains(&"skirt-back".to_owned()));
    let twice = cut(2);
    for id in ["skirt-side-left", "skirt-side-right", "waistband"] {
        assert!(ids(&twice).contains(&id.to_owned()), "{id}: {twice:?}");
    }
    are_joined(&twice, &[["skirt", "skirt"], ["skirt", "waistband"]]);
    let side = twice.seams.iter().find(|s| s.pair.id == "skirt-side-left");
    let because = &side.expect("found above").because;
    assert!(because.contains("cut twice"), "{because}");
    assert_eq!(ids(&cut(3)), Vec::<String>::new());
}

/// A rectangle has no place for arms: called a top, it is no front and back.
#[test]
fn a_top_of_two_rectangles_is_not_sewn_shut() {
    let mut panel = rectangle("tunic", 0.6, 0.9);
    panel.quantity = Some(Quantity { left: 2, right: 0 });
    let found = suggested(vec![panel]);
    assert!(
        found.seams.iter().all(|seam| seam.confidence < 0.5),
        "{found:?}"
    );
    let unsewn = found.warnings.iter().any(|w| w.detail.contains("`tunic`"));
    assert!(unsewn, "{found:?}");
}

/// Panels of a corset side by side, of which one would be closed on itself.
#[test]
fn seams_that_leave_most_of_the_pattern_out_are_offers() {
    let panel = |id: &str| rectangle(id, 0.06, 0.2);
    let all = ["panel 1b", "panel 2", "panel 3", "panel 4", "panel 5"].map(panel);
    let found = suggested(all.to_vec());
    assert!(
        found.seams.iter().all(|seam| seam.confidence < 0.5),
        "{found:?}"
    );
    let told = found
        .warnings
        .iter()
        .filter(|w| w.detail.contains("its name or its size"));
    assert!(told.count() >= 4, "{found:?}");
}

/// A half of which the file says that one is cut as drawn and one mirrored is sewn twice.
#[test]
fn a_stated_copy_counts_as_sewn() {
    let pair = |id: &str, neck: f64| {
        let mut half = bodice(id, neck);
        half.quantity = Some(Quantity { left: 1, right: 1 });
        let mut copy = mirrored(&half);
        copy.id = format!("{id}~mirror");
        [half, copy]
    };
    let panels = [pair("1", 0.10), pair("2", 0.04)].concat();
    let found = suggested(panels);
    assert!(
        found.seams.iter().any(|seam| seam.confidence >= 0.5),
        "{found:?}"
    );
    let doubted = found
        .warnings
        .iter()
        .any(|w| w.detail.contains("cut several times"));
    assert!(!doubted, "{found:?}");
}

/// A bodice of front, back and a side panel on each side: the band goes round all four.
#[test]
fn a_band_goes_round_the_hems_of_side_panels_too() {
    let found = suggested(vec![
        middle("front", 0.08),
        outer("front side"),
        outer("back side"),
        middle("back", 0.03),
        rectangle("waistband", 2.0 * (0.07 + 0.10 + 0.10 + 0.07), 0.05),
    ]);
    are_joined(
        &found,
        &[
            ["front", "waistband"],
            ["front side", "waistband"],
            ["back side", "waistband"],
            ["back", "waistband"],
        ],
    );
}

/// A dart from the hem, whose legs bend half way up: two edges each.
#[test]
fn legs_of_a_dart_may_bend() {
    let darted = |id: &str, neck: f64| {
        drawn(
            id,
            &[
                &[[0.0, 0.0]],
                &[[0.0, 0.40], [0.04, 0.42], [0.06, 0.47], [0.05, 0.56]],
                &[[0.05, 0.60]],
                &[[0.18, 0.64], [0.19, 0.64 - 0.7 * neck], [0.22, 0.64 - neck]],
                &[[0.26, 0.64 - neck]],
                &[[0.26, 0.0]],
                &[[0.155, 0.0]],
                &[[0.15, 0.12]],
                &[[0.13, 0.28]],
                &[[0.11, 0.12]],
                &[[0.105, 0.0]],
            ],
        )
    };
    let found = suggested(vec![darted("front", 0.10), darted("back", 0.04)]);
    let ends: Vec<[Place; 4]> = found
        .seams
        .iter()
        .filter(|seam| seam.pair.id.starts_with("dart-front-1"))
        .map(|seam| {
            let [a, b] = [&seam.pair.a, &seam.pair.b].map(|side| &side.runs()[0]);
            [a.from, a.to, b.from, b.to]
        })
        .collect();
    let legs = [[6, 7, 10, 9], [7, 8, 9, 8]].map(|corners| corners.map(Place::Corner));
    assert_eq!(ends, legs);
    let centers = found
        .seams
        .iter()
        .filter(|s| s.pair.id.starts_with("centre-"));
    let is_center = |side: &Side| {
        let run = &side.runs()[0];
        [run.from, run.to]
            .iter()
            .all(|end| matches!(end, Place::Corner(4 | 5)))
    };
    assert!(centers.clone().count() == 2);
    assert!(
        centers
            .into_iter()
            .all(|s| is_center(&s.pair.a) && is_center(&s.pair.b))
    );
}
