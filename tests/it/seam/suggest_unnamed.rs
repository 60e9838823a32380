//! Suggested seams of garments whose names tell nothing, or little: what edges are as long as each
//! other, and what the other panels leave open, must tell.

use super::drawn::{are_joined, back_under_yoke, bodice, drawn, middle, suggested, yoke};
use seamster::pattern::Panel;
use seamster::seam::suggest::Suggestion;
use seamster_fixtures::panels::{rectangle, trapezoid};

/// A sleeve of which the cap is as long as the armholes of [`bodice`] together, and so long.
fn sleeve(id: &str, length: f64) -> Panel {
    drawn(
        id,
        &[
            &[[-0.12, -length]],
            &[[-0.16, 0.0], [-0.10, 0.09], [0.0, 0.125], [0.10, 0.09]],
            &[[0.16, 0.0]],
            &[[0.12, -length]],
        ],
    )
}

fn are_all_offers(found: &Suggestion) -> bool {
    found.seams.iter().all(|seam| seam.confidence < 0.5)
}

fn told(found: &Suggestion) -> Vec<&str> {
    found.warnings.iter().map(|w| w.detail.as_str()).collect()
}

/// The outer part beside [`middle`], with an edge as long as that of the middle; its hem begins
/// here.
fn outer_beside(id: &str, hem: f64) -> Panel {
    drawn(
        id,
        &[
            &[[hem, 0.0]],
            &[[-0.02, 0.21], [0.03, 0.23], [0.055, 0.30], [0.055, 0.36]],
            &[[0.055, 0.395]],
            &[[0.12, 0.415], [0.15, 0.2]],
            &[[0.10, 0.0]],
        ],
    )
}

#[test]
fn princess_seams_are_found_where_their_edges_are_as_long_as_each_other() {
    let found = suggested(vec![
        middle("1", 0.08),
        outer_beside("2", 0.0),
        outer_beside("3", -0.04),
        middle("4", 0.03),
    ]);
    are_joined(&found, &[["1", "2"], ["2", "3"], ["3", "4"]]);
    assert_eq!(found.warnings, []);
}

#[test]
fn yoke_is_told_by_the_back_that_it_ends() {
    let panels = vec![bodice("1", 0.10), back_under_yoke("2"), yoke("3")];
    let found = suggested(panels);
    are_joined(&found, &[["1", "3"], ["2", "3"], ["1", "2"]]);
}

#[test]
fn lengths_that_differ_are_no_seam_where_no_name_tells() {
    let skirts = |front: &str, back: &str| {
        suggested(vec![
            trapezoid(front, 0.52, 0.40, 0.60),
            trapezoid(back, 0.52, 0.40, 0.62),
        ])
    };
    let named = skirts("skirt_front", "skirt_back");
    assert!(!named.seams.is_empty() && !are_all_offers(&named));
    let unnamed = skirts("1", "2");
    assert!(are_all_offers(&unnamed), "{unnamed:?}");
}

#[test]
fn second_sleeve_of_the_same_cap_is_another_form_of_the_first() {
    let found = suggested(vec![
        bodice("1", 0.10),
        bodice("2", 0.04),
        sleeve("3", 0.12),
        sleeve("4", 0.45),
    ]);
    are_joined(&found, &[["1", "3"], ["2", "3"]]);
    assert!(
        told(&found)
            .iter()
            .any(|w| w.contains("`4`") && w.contains("another form of `3`")),
        "{:?}",
        told(&found)
    );
}

#[test]
fn cuff_is_no_center_front_where_another_panel_is_the_front() {
    let found = suggested(vec![
        bodice("malmofr", 0.10),
        bodice("malmobk", 0.04),
        sleeve("malmosl", 0.45),
        rectangle("malmocf", 0.22, 0.06),
    ]);
    are_joined(&found, &[["malmocf", "malmosl"]]);
}

#[test]
fn back_of_half_the_width_of_the_front_is_half_a_back() {
    for [front, back] in [["skirt_front", "skirt_back"], ["1", "2"], ["A", "B"]] {
        let half = drawn(
            back,
            &[
                &[[0.0, 0.0]],
                &[[0.08, 0.6]],
                &[[0.24, 0.6]],
                &[[0.24, 0.0]],
            ],
        );
        let found = suggested(vec![trapezoid(front, 0.48, 0.32, 0.60), half]);
        are_joined(&found, &[[back, back], [front.min(back), front.max(back)]]);
    }
}

#[test]
fn hood_beside_a_strip_that_does_not_fit_is_not_sewn_as_one_of_two() {
    let hood = drawn(
        "hood_side",
        &[
            &[[0.0, 0.0]],
            &[[0.0, 0.33], [0.10, 0.36], [0.2, 0.33], [0.24, 0.22]],
            &[[0.20, 0.0]],
        ],
    );
    let strip = rectangle("hood_middle", 0.10, 0.40);
    let found = suggested(vec![
        bodice("front", 0.10),
        bodice("back", 0.04),
        hood,
        strip,
    ]);
    are_joined(&found, &[["back", "front"]]);
    let hoods = found
        .seams
        .iter()
        .filter(|seam| seam.pair.id.starts_with("hood"));
    assert_eq!(hoods.count(), 0);
    assert!(told(&found).iter().any(|w| w.contains("`hood_side`")));
}

#[test]
fn small_part_that_is_sewn_to_itself_alone_is_an_offer() {
    // A band much too long for any opening: its ends could meet, but nothing holds it.
    let found = suggested(vec![
        bodice("front", 0.10),
        bodice("back", 0.04),
        rectangle("neckband", 1.6, 0.04),
    ]);
    are_joined(&found, &[["back", "front"]]);
    let of_band = |panel: &str| panel == "neckband";
    let mut sure = found.seams.iter().filter(|seam| seam.confidence >= 0.5);
    assert!(sure.all(|seam| !seam.panels().any(of_band)), "{found:?}");
}
