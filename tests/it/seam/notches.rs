//! Points that meet between notches: ease lies where the notches put it.

use seamster::config::Limits;
use seamster::pattern::{Pattern, SeamPair};
use seamster::seam::{SeamCheck, SeamSet, Stretch, check};
use seamster_fixtures::panels::{many, notched, pattern, rectangle, run, seam};
use std::collections::BTreeMap;

fn checked(pattern: &Pattern, pair: &SeamPair) -> (SeamCheck, SeamSet) {
    let pairs = std::slice::from_ref(pair);
    let (found, set) = check(pattern, pairs, &BTreeMap::new(), 0.012, &Limits::default());
    (found, set.expect("the seam is right"))
}

/// Two rectangles sewn along their left edges (edge 0, upwards) with notches at these fractions.
fn sides(lengths: [f64; 2], notches: [&[f64]; 2]) -> Pattern {
    let panel = |i: usize| {
        let panel = rectangle(["a", "b"][i], 0.3, lengths[i]);
        notches[i].iter().fold(panel, |p, &at| notched(p, 0, at))
    };
    pattern(vec![panel(0), panel(1)])
}

fn left_edges() -> SeamPair {
    seam("s", run("a", 0, 1), run("b", 0, 1))
}

/// Ends of each stretch but the last on A and on B.
fn cuts(set: &SeamSet) -> Vec<[f64; 2]> {
    let ends = |pair: &[Stretch; 2]| pair.map(|stretch| stretch.to);
    let matched = &set.seams[0].matched;
    matched[..matched.len() - 1].iter().map(ends).collect()
}

fn assert_cuts(set: &SeamSet, expected: &[[f64; 2]]) {
    let found = cuts(set);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }
}

#[test]
fn points_meet_between_matched_notches() {
    // All of the ease of 10 % lies between the notches: 0.1 + 0.2 + 0.1 m against 0.1 + 0.24 + 0.1
    // m.
    let pattern = sides([0.4, 0.44], [&[0.25, 0.75], &[0.1 / 0.44, 0.34 / 0.44]]);
    let (found, set) = checked(&pattern, &left_edges());
    assert_cuts(&set, &[[0.25, 0.1 / 0.44], [0.75, 0.34 / 0.44]]);
    let told = &found.seams[0].notches;
    let pairs: Vec<_> = told.iter().map(|m| (m.a.notch, m.b.notch)).collect();
    assert_eq!(pairs, [(Some(0), Some(0)), (Some(1), Some(1))]);
    assert!((told[1].a.at_m - 0.3).abs() < 1e-12 && (told[1].b.at_m - 0.34).abs() < 1e-12);
    assert_eq!(
        (told[0].a.panel.as_str(), told[0].b.panel.as_str()),
        ("a", "b")
    );
}

#[test]
fn notches_are_taken_in_the_order_of_the_seam() {
    let pattern = sides([0.4, 0.4], [&[0.3, 0.8], &[0.2, 0.7]]);
    let pair = seam("s", run("a", 0, 1), run("b", 1, 0));
    let (found, set) = checked(&pattern, &pair);
    assert_cuts(&set, &[[0.3, 0.7], [0.8, 0.2]]);
    let told: Vec<_> = found.seams[0].notches.iter().map(|m| m.b.notch).collect();
    assert_eq!(told, [Some(1), Some(0)]);
}

#[test]
fn notches_that_do_not_agree_are_left_alone() {
    let cases: [([f64; 2], [&[f64]; 2]); 4] = [
        // Another number on either side.
        ([0.4, 0.44], [&[0.25, 0.75], &[0.25]]),
        // Without ease the same place is 0.1 off: not made to meet.
        ([0.4, 0.4], [&[0.5], &[0.6]]),
        // An ease of 10 % moves a notch by no more than a tenth of the seam.
        ([0.4, 0.44], [&[0.5], &[0.65]]),
        // At the ends there is nothing to divide.
        ([0.4, 0.4], [&[0.0, 1.0], &[0.001, 1.0]]),
    ];
    for (lengths, notches) in cases {
        let (found, set) = checked(&sides(lengths, notches), &left_edges());
        assert_eq!(set.seams[0].matched.len(), 1, "{notches:?}");
        assert!(found.seams[0].notches.is_empty());
    }
}

#[test]
fn notch_moves_as_far_as_the_ease_allows() {
    // With ease e a notch at s may lie from s / (1 + e) to (s + e) / (1 + e) of the longer side.
    let e = 0.25;
    for shift in [0.0, e] {
        let at = (0.5 + shift) / (1.0 + e);
        let (_, set) = checked(&sides([0.4, 0.5], [&[0.5], &[at]]), &left_edges());
        assert_cuts(&set, &[[0.5, at]]);
    }
}

#[test]
fn gathers_lie_between_the_notches_and_spread_evenly_there() {
    // A puff sleeve: plain up to the notches, gathered 2 to 1 between them.
    let mut pair = left_edges();
    pair.gather = true;
    let pattern = sides([0.4, 0.6], [&[0.25, 0.75], &[0.1 / 0.6, 0.5 / 0.6]]);
    let (_, set) = checked(&pattern, &pair);
    assert_cuts(&set, &[[0.25, 0.1 / 0.6], [0.75, 0.5 / 0.6]]);
    let plain = sides([0.4, 0.6], [&[], &[]]);
    let (_, set) = checked(&plain, &pair);
    assert_eq!(set.seams[0].matched.len(), 1, "evenly from end to end");
}

#[test]
fn notch_on_a_sleeve_cap_meets_the_shoulder_seam() {
    // A cap of 0.44 m onto armholes of 0.2 and 0.2 m; its notch leaves 0.23 m to the front, 0.21 m
    // to the back.
    let cap = notched(rectangle("sleeve", 0.44, 0.3), 1, 0.23 / 0.44);
    let pattern = pattern(vec![
        cap,
        rectangle("front", 0.3, 0.2),
        rectangle("back", 0.3, 0.2),
    ]);
    let pair = many(
        "cap",
        vec![run("sleeve", 1, 2)],
        vec![run("front", 3, 2), run("back", 1, 0)],
    );
    let (found, set) = checked(&pattern, &pair);
    assert_cuts(&set, &[[0.23 / 0.44, 0.0]]);
    let told = &found.seams[0].notches[0];
    assert_eq!((told.a.notch, told.b.notch), (Some(0), None));
    assert_eq!(told.b.panel, "back");
}

#[test]
fn stitches_are_counted_between_notches() {
    // 0.1, 0.24 and 0.1 m in mesh edges of 12 mm.
    let pattern = sides([0.4, 0.44], [&[0.25, 0.75], &[0.1 / 0.44, 0.34 / 0.44]]);
    let (found, _) = checked(&pattern, &left_edges());
    assert_eq!(found.seams[0].stitch_count, 9 + 20 + 9 + 1);
}

#[test]
fn auto_seam_is_turned_to_where_notches_meet() {
    // Level edges, of which heights say nothing: a notch at a third from the left on both.
    let third = |id| notched(rectangle(id, 0.3, 0.3), 1, 1.0 / 3.0);
    let pattern = pattern(vec![third("a"), third("b")]);
    let mut wrong = seam("s", run("a", 1, 2), run("b", 2, 1));
    wrong.matching = seamster::pattern::Match::Auto;
    let (found, _) = checked(&pattern, &wrong);
    assert!(found.seams[0].reversed && found.seams[0].notches.len() == 1);
    assert!(found.seams[0].warnings[0].detail.contains("notches"));
    let mut right = seam("s", run("a", 1, 2), run("b", 1, 2));
    right.matching = seamster::pattern::Match::Auto;
    assert!(!checked(&pattern, &right).0.seams[0].reversed);
}
