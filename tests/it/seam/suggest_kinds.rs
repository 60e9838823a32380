//! Suggested seams of garments drawn here: princess seams, sleeves of two parts, yokes, bands in
//! halves, other forms of a panel, and sets that leave out what must be sewn.

use super::drawn::{
    are_joined, back_under_yoke, bodice, drawn, middle, outer, suggested, sure, yoke,
};
use seamster::pattern::Place;
use seamster_fixtures::panels::{polygon, rectangle};

#[test]
fn princess_seams_are_sewn_by_codes_grown_together_with_a_style() {
    let found = suggested(vec![
        middle("classicfr", 0.08),
        outer("classicsf"),
        outer("classicsb"),
        middle("classicbk", 0.03),
    ]);
    are_joined(
        &found,
        &[
            ["classicfr", "classicsf"],
            ["classicsb", "classicsf"],
            ["classicbk", "classicsb"],
        ],
    );
    assert!(
        sure(&found)
            .iter()
            .any(|id| id.starts_with("shoulder-left"))
    );
    assert_eq!(found.warnings, []);
}

#[test]
fn side_panels_are_told_by_chinese_names() {
    let found = suggested(vec![
        middle("前片", 0.08),
        outer("前侧片"),
        outer("后侧片"),
        middle("后片", 0.03),
    ]);
    are_joined(
        &found,
        &[["前侧片", "前片"], ["前侧片", "后侧片"], ["后侧片", "后片"]],
    );
}

#[test]
fn back_is_sewn_to_the_yoke_and_the_front_over_the_shoulder() {
    let panels = vec![bodice("front", 0.10), back_under_yoke("back"), yoke("yoke")];
    let found = suggested(panels);
    are_joined(
        &found,
        &[
            ["front", "yoke"],
            ["back", "yoke"],
            ["back", "front"],
            ["yoke", "yoke"],
        ],
    );
    assert_eq!(found.warnings, []);
}

#[test]
fn halves_of_a_waistband_go_round_the_waist_together() {
    let leg = |id: &str, fork: f64| {
        drawn(
            id,
            &[
                &[[0.0, 0.0]],
                &[[0.0, 1.0]],
                &[[0.22, 1.0], [0.22, 0.85], [0.24, 0.80]],
                &[[0.22 + fork, 0.76]],
                &[[0.20, 0.0]],
            ],
        )
    };
    let found = suggested(vec![
        leg("pants_front", 0.08),
        leg("pants_back", 0.12),
        rectangle("waistband_left", 0.46, 0.04),
        rectangle("waistband_right", 0.43, 0.04),
    ]);
    are_joined(
        &found,
        &[
            ["pants_front", "waistband_left"],
            ["pants_front", "waistband_right"],
            ["pants_back", "waistband_left"],
            ["pants_back", "waistband_right"],
        ],
    );
}

#[test]
fn parts_of_a_sleeve_are_sewn_to_each_other_and_into_the_armhole() {
    let upper = drawn(
        "top_sleeve",
        &[
            &[[-0.08, -0.45]],
            &[[-0.11, 0.0], [-0.08, 0.07], [-0.02, 0.10]],
            &[[0.05, 0.09], [0.09, 0.05]],
            &[[0.10, 0.02]],
            &[[0.07, -0.45]],
        ],
    );
    let under = drawn(
        "under_sleeve",
        &[
            &[[-0.05, -0.45]],
            &[[-0.08, 0.0], [-0.02, -0.02], [0.04, -0.01]],
            &[[0.08, 0.02]],
            &[[0.06, -0.45]],
        ],
    );
    let found = suggested(vec![
        bodice("front", 0.10),
        bodice("back", 0.04),
        upper,
        under,
    ]);
    are_joined(
        &found,
        &[
            ["top_sleeve", "under_sleeve"],
            ["front", "top_sleeve"],
            ["back", "top_sleeve"],
        ],
    );
}

#[test]
fn of_several_fronts_one_is_taken_and_the_others_are_told() {
    let found = suggested(vec![
        bodice("front", 0.10),
        bodice("front_pocket", 0.10),
        bodice("front_deep", 0.16),
        bodice("back", 0.04),
    ]);
    are_joined(&found, &[["back", "front"]]);
    let told: Vec<&str> = found.warnings.iter().map(|w| w.detail.as_str()).collect();
    assert!(
        told.iter()
            .any(|w| w.contains("`front_deep`") && w.contains("another form of `front`")),
        "{told:?}"
    );
}

#[test]
fn seams_are_offers_where_the_names_need_what_is_not_sewn() {
    let whole = suggested(vec![bodice("front", 0.10), bodice("back", 0.04)]);
    assert!(whole.seams.iter().all(|seam| seam.confidence >= 0.5));
    // A sleeve whose outline is none.
    let lame = polygon("sleeve", &[[0.0, 0.0], [0.1, 0.4], [0.2, 0.0]]);
    let found = suggested(vec![bodice("front", 0.10), bodice("back", 0.04), lame]);
    assert!(!found.seams.is_empty());
    assert!(found.seams.iter().all(|seam| seam.confidence < 0.5));
    let last = &found.warnings.last().expect("a reason").detail;
    assert!(
        last.contains("`sleeve`") && last.contains("offers"),
        "{last}"
    );
}

#[test]
fn offers_count_as_open_edges() {
    let sure = suggested(vec![bodice("front", 0.10), bodice("back", 0.04)]);
    assert_eq!(sure.warnings, []);
    let mut short = bodice("back", 0.04);
    let shoulder = &mut short.edges[2];
    shoulder.length_m *= 1.25;
    let found = suggested(vec![bodice("front", 0.10), short]);
    let shoulder = found.seams.iter().find(|s| s.pair.id == "shoulder-left");
    assert!(shoulder.is_some_and(|seam| seam.confidence < 0.5));
    // The side alone would be sure, but the shoulder stays open.
    assert!(found.seams.iter().all(|seam| seam.confidence < 0.5));
    assert!(
        found
            .warnings
            .iter()
            .any(|w| w.detail.contains("shoulder open")),
        "{:?}",
        found.warnings
    );
}

#[test]
fn half_a_hood_meets_the_middle_of_a_back_that_lies_on_both_sides() {
    let back = drawn(
        "back",
        &[
            &[[-0.26, 0.0]],
            &[[-0.26, 0.40], [-0.22, 0.42], [-0.20, 0.47], [-0.21, 0.56]],
            &[[-0.21, 0.60]],
            &[[-0.08, 0.64], [-0.04, 0.61], [0.04, 0.61]],
            &[[0.08, 0.64]],
            &[[0.21, 0.60], [0.21, 0.56], [0.20, 0.47], [0.22, 0.42]],
            &[[0.26, 0.40]],
            &[[0.26, 0.0]],
        ],
    );
    let hood = drawn(
        "hood",
        &[
            &[[0.0, 0.0]],
            &[[0.0, 0.33], [0.10, 0.36], [0.2, 0.33], [0.24, 0.22]],
            &[[0.20, 0.0]],
        ],
    );
    let found = suggested(vec![bodice("front", 0.10), back, hood]);
    are_joined(
        &found,
        &[["front", "hood"], ["back", "hood"], ["hood", "hood"]],
    );
    let within = found.seams.iter().any(|seam| {
        let runs = seam.pair.a.runs().iter().chain(seam.pair.b.runs());
        runs.flat_map(|run| [run.from, run.to])
            .any(|place| matches!(place, Place::OnEdge { .. }))
    });
    assert!(within, "the middle of the back's neck is no corner");
}

#[test]
fn strip_of_a_hood_lies_between_its_halves() {
    let hood = drawn(
        "hood_side",
        &[
            &[[0.0, 0.0]],
            &[[0.0, 0.33], [0.10, 0.36], [0.2, 0.33], [0.24, 0.22]],
            &[[0.20, 0.0]],
        ],
    );
    let long = hood.edges[1].length_m;
    let found = suggested(vec![
        bodice("front", 0.10),
        bodice("back", 0.04),
        hood,
        rectangle("hood_middle", long, 0.08),
    ]);
    are_joined(
        &found,
        &[
            ["hood_middle", "hood_side"],
            ["front", "hood_side"],
            ["back", "hood_middle"],
        ],
    );
}

#[test]
fn ends_of_a_collar_stay_free() {
    let collar = |name: &str| {
        drawn(
            name,
            &[
                &[[0.0, 0.0]],
                &[[-0.02, 0.06], [0.22, 0.065]],
                &[[0.46, 0.06]],
                &[[0.44, 0.0], [0.22, 0.005]],
            ],
        )
    };
    let found = suggested(vec![
        bodice("front", 0.10),
        bodice("back", 0.04),
        collar("collar"),
    ]);
    are_joined(&found, &[["collar", "front"], ["back", "collar"]]);
    assert!(!sure(&found).contains("neckband-ends"));
}
