//! Suggested seams of garments drawn here: princess seams, sleeves of two parts, yokes, bands in
//! halves, other forms of a panel, and sets that leave out what must be sewn.

use seamster::config::Limits;
use seamster::pattern::{Panel, Place};
use seamster::seam::suggest::{Suggestion, suggest};
use seamster_fixtures::panels::{panel_of, pattern, polygon, rectangle};
use std::collections::BTreeSet;

type Points = Vec<[f64; 2]>;

/// A panel of edges that are drawn one after another, the last back to the beginning.
fn drawn(id: &str, edges: &[&[[f64; 2]]]) -> Panel {
    let start = |i: usize| edges[i % edges.len()][0];
    let closed = |i: usize| -> Points { [edges[i], &[start(i + 1)]].concat() };
    panel_of(id, &(0..edges.len()).map(closed).collect::<Vec<_>>())
}

/// Half of a bodice, its side on the left; the neck is so deep.
fn bodice(id: &str, neck: f64) -> Panel {
    drawn(
        id,
        &[
            &[[0.0, 0.0]],
            &[[0.0, 0.40], [0.04, 0.42], [0.06, 0.47], [0.05, 0.56]],
            &[[0.05, 0.60]],
            &[[0.18, 0.64], [0.19, 0.64 - 0.7 * neck], [0.22, 0.64 - neck]],
            &[[0.26, 0.64 - neck]],
            &[[0.26, 0.0]],
        ],
    )
}

/// A back that ends under a yoke, its side on the left.
fn back_under_yoke(id: &str) -> Panel {
    drawn(
        id,
        &[
            &[[0.0, 0.0]],
            &[[0.0, 0.40], [0.035, 0.42], [0.05, 0.47]],
            &[[0.05, 0.50]],
            &[[0.26, 0.50]],
            &[[0.26, 0.0]],
        ],
    )
}

/// Half a yoke, its armhole on the left.
fn yoke(id: &str) -> Panel {
    drawn(
        id,
        &[
            &[[0.05, 0.50]],
            &[[0.05, 0.60]],
            &[[0.18, 0.64], [0.20, 0.62], [0.23, 0.61]],
            &[[0.26, 0.61]],
            &[[0.26, 0.50]],
        ],
    )
}

/// The middle of half a front or back with a princess seam up to the shoulder, on its left.
fn middle(id: &str, neck: f64) -> Panel {
    drawn(
        id,
        &[
            &[[0.05, 0.0], [0.02, 0.2]],
            &[[0.0, 0.42]],
            &[[0.045, 0.435], [0.06, 0.435 - 0.7 * neck]],
            &[[0.12, 0.435 - neck]],
            &[[0.12, 0.0]],
        ],
    )
}

/// The part beside it, its side on the left.
fn outer(id: &str) -> Panel {
    drawn(
        id,
        &[
            &[[0.0, 0.0]],
            &[[-0.02, 0.21], [0.03, 0.23], [0.055, 0.30], [0.055, 0.36]],
            &[[0.055, 0.395]],
            &[[0.12, 0.415], [0.13, 0.2]],
            &[[0.10, 0.0]],
        ],
    )
}

fn suggested(panels: Vec<Panel>) -> Suggestion {
    suggest(&pattern(panels), &Limits::default())
}

/// Names of the seams of at least even confidence, without the numbers of their parts.
fn sure(found: &Suggestion) -> BTreeSet<&str> {
    let sure = found.seams.iter().filter(|seam| seam.confidence >= 0.5);
    sure.map(|seam| seam.pair.id.as_str()).collect()
}

/// Pairs of panels that seams of at least even confidence join, mirrored copies as their sources.
fn joined(found: &Suggestion) -> BTreeSet<[String; 2]> {
    let source = |panel: &str| panel.trim_end_matches("~mirror").to_owned();
    let mut all = BTreeSet::new();
    for seam in found.seams.iter().filter(|seam| seam.confidence >= 0.5) {
        for a in seam.pair.a.runs() {
            for b in seam.pair.b.runs() {
                let mut pair = [source(&a.panel), source(&b.panel)];
                pair.sort();
                all.insert(pair);
            }
        }
    }
    all
}

fn are_joined(found: &Suggestion, pairs: &[[&str; 2]]) {
    let joined = joined(found);
    for [a, b] in pairs {
        let pair = [(*a).to_owned(), (*b).to_owned()];
        assert!(joined.contains(&pair), "{a} to {b}: {joined:?}");
    }
}

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
