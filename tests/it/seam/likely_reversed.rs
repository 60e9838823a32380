//! Seams whose order no face can tell are judged by where their panels start.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::pattern::{Match, Pattern, SeamPair, Side};
use seamster::seam::{Face, FaceRequest, SeamCheck, SeamCheckInput, SeamSet, check_placed};
use seamster_fixtures::panels::{mirrored, pattern, polygon, rectangle, run, seam};
use std::collections::BTreeMap;

const WIDTH: f64 = 0.5;
const HEIGHT: f64 = 0.6;

/// Front and back hung 0.15 m before and behind the body; a panel whose face is down is seen from
/// its other side. Strangers to the body start nowhere.
fn starts(pattern: &Pattern) -> impl Fn(usize, Face, [f64; 2]) -> Option<[f64; 3]> {
    let depths: Vec<Option<f64>> = pattern
        .panels
        .iter()
        .map(|panel| match panel.id.as_str() {
            "front" => Some(0.15),
            "back" => Some(-0.15),
            _ => None,
        })
        .collect();
    move |panel, face, [x, y]| {
        let z = depths[panel]?;
        // Seen from its outer side, what is behind the body is turned about the upright axis.
        let sense = if face == Face::Up { 1.0 } else { -1.0 } * z.signum();
        Some([sense * (x - WIDTH / 2.0), y, z])
    }
}

fn checked(
    pattern: &Pattern,
    pairs: &[SeamPair],
    faces: &[(&str, FaceRequest)],
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let faces = faces
        .iter()
        .map(|(id, face)| ((*id).to_owned(), *face))
        .collect::<BTreeMap<_, _>>();
    let to_check = SeamCheckInput {
        pattern,
        pairs,
        faces: &faces,
        edge_length: 0.012,
        limits: &Limits::default(),
    };
    check_placed(&to_check, &starts(pattern))
}

fn tube() -> Pattern {
    pattern(vec![
        rectangle("front", WIDTH, HEIGHT),
        rectangle("back", WIDTH, HEIGHT),
    ])
}

fn turned(pair: &SeamPair) -> SeamPair {
    let Side::One(b) = &pair.b else {
        panic!("made as a single run")
    };
    let mut b = b.clone();
    (b.from, b.to) = (b.to, b.from);
    SeamPair {
        b: Side::One(b),
        ..pair.clone()
    }
}

/// Both ways of drawing the side seam of a T-shirt: both panels as seen from their outer side, and
/// both in one view.
fn side_seams() -> [SeamPair; 2] {
    [
        seam("side", run("front", 3, 2), run("back", 0, 1)),
        seam("side", run("front", 3, 2), run("back", 3, 2)),
    ]
}

fn codes(check: &SeamCheck) -> Vec<&str> {
    let warnings = check.seams.iter().flat_map(|seam| &seam.warnings);
    warnings.map(|warning| warning.code.as_str()).collect()
}

#[test]
fn right_bridge_is_left_alone_however_its_panels_are_drawn() {
    for (pair, back) in side_seams().into_iter().zip([Face::Up, Face::Down]) {
        let (check, set) = checked(&tube(), std::slice::from_ref(&pair), &[]);
        assert_eq!(codes(&check), [""; 0], "{pair:?}");
        assert!(check.corrected.is_empty());
        assert_eq!(set.expect("right").faces, [Face::Up, back]);
    }
}

#[test]
fn reversed_bridge_is_warned_of_with_both_figures_and_the_corrected_seam() {
    for pair in side_seams() {
        let (check, set) = checked(&tube(), &[turned(&pair)], &[]);
        assert!(check.ok && set.is_ok(), "it is a warning");
        assert_eq!(codes(&check), ["seam/likely_reversed"]);
        assert_eq!(check.seams[0].warnings[0].pointer, "/seams/0/b");
        assert_eq!(check.corrected, [pair]);
        // In the right order all chords are 0.3 m. Reversed, the back's other side is out, so that
        // its edge starts on the other side of the body, 0.5 m off, and upside down: 0.6 m (2s - 1)
        // for s from 0 to 1 in 17 points.
        let upright = (0..17)
            .map(|k| (0.6 * (f64::from(k) / 8.0 - 1.0)).powi(2))
            .sum::<f64>()
            / 17.0;
        let reversed = (0.3_f64.powi(2) + 0.5_f64.powi(2) + upright).sqrt() * 1e3;
        let told = &check.seams[0].warnings[0].detail;
        assert!(
            told.contains(&format!("start {reversed:.0} mm apart")),
            "{told}"
        );
        assert!(told.contains("in the other order 300 mm"), "{told}");
    }
}

#[test]
fn auto_bridge_is_turned_by_where_panels_start() {
    let pattern = tube();
    for pair in side_seams() {
        for (asked, reversed) in [(pair.clone(), false), (turned(&pair), true)] {
            let auto = SeamPair {
                matching: Match::Auto,
                ..asked
            };
            let (check, set) = checked(&pattern, &[auto], &[]);
            assert_eq!(check.seams[0].reversed, reversed);
            let (_, right) = checked(&pattern, std::slice::from_ref(&pair), &[]);
            assert_eq!(set.expect("right"), right.expect("right"));
        }
    }
}

#[test]
fn level_bridge_between_shoulders_is_judged_too() {
    // The right half of the front's top onto that of the back: level, so that heights say nothing.
    let half = |id: &str| {
        polygon(
            id,
            &[
                [0.0, 0.0],
                [0.0, HEIGHT],
                [0.1, HEIGHT],
                [0.2, HEIGHT - 0.1],
                [0.3, HEIGHT - 0.1],
                [0.4, HEIGHT],
                [WIDTH, HEIGHT],
                [WIDTH, 0.0],
            ],
        )
    };
    let pattern = pattern(vec![half("front"), half("back")]);
    // Both face up: what is on the right of the front is on the left of the back.
    let pair = seam("shoulder", run("front", 5, 6), run("back", 2, 1));
    let (check, _) = checked(&pattern, std::slice::from_ref(&pair), &[]);
    assert_eq!(codes(&check), [""; 0]);
    let (check, _) = checked(&pattern, &[turned(&pair)], &[]);
    assert_eq!(codes(&check), ["seam/likely_reversed"]);
    assert_eq!(check.corrected, std::slice::from_ref(&pair));
    let auto = SeamPair {
        matching: Match::Auto,
        ..turned(&pair)
    };
    let (check, _) = checked(&pattern, &[auto], &[]);
    assert!(check.seams[0].reversed);
    assert_eq!(codes(&check), ["seam/reversed"]);
    assert_eq!(check.faces["back"], Face::Up);
}

#[test]
fn auto_seams_that_only_each_other_decide_are_turned_together() {
    // Both shoulders picked reversed go together by parity: with the back turned over.
    let pattern = pattern(vec![
        rectangle("front", WIDTH, HEIGHT),
        rectangle("back", WIDTH, HEIGHT),
    ]);
    let part = |panel: &str, from: f64, to: f64| {
        let at = |at| seamster::pattern::Place::OnEdge { edge: 1, at };
        seamster::pattern::OutlineRun {
            from: at(from),
            to: at(to),
            ..run(panel, 1, 2)
        }
    };
    let auto = |id, [a, b]: [f64; 2], [c, d]: [f64; 2]| SeamPair {
        matching: Match::Auto,
        ..seam(id, part("front", a, b), part("back", c, d))
    };
    let wrong = [
        auto("left", [0.1, 0.3], [0.7, 0.9]),
        auto("right", [0.7, 0.9], [0.1, 0.3]),
    ];
    let (check, set) = checked(&pattern, &wrong, &[]);
    assert!(check.seams.iter().all(|seam| seam.reversed));
    assert_eq!(set.expect("right").faces, [Face::Up, Face::Up]);
    // Without places nothing says so.
    let (check, _) = seamster::seam::check(
        &pattern,
        &wrong,
        &BTreeMap::new(),
        0.012,
        &Limits::default(),
    );
    assert!(check.ok && check.seams.iter().all(|seam| !seam.reversed));
}

#[test]
fn seams_that_faces_decide_are_not_judged_by_places() {
    let [pair, _] = side_seams();
    let stated = [("front", FaceRequest::Up), ("back", FaceRequest::Up)];
    let (check, set) = checked(&tube(), std::slice::from_ref(&pair), &stated);
    assert!(codes(&check).is_empty() && set.is_ok());
    let (check, _) = checked(&tube(), &[turned(&pair)], &stated);
    assert_eq!(check.seams[0].errors[0].code, "seam/twisted");
    assert!(codes(&check).is_empty());
    // On a cycle, a reversed seam is a twist.
    let cycle = [
        pair.clone(),
        seam("other", run("front", 0, 1), run("back", 3, 2)),
    ];
    let (check, set) = checked(&tube(), &cycle, &[]);
    assert!(codes(&check).is_empty() && set.is_ok());
    let (check, _) = checked(&tube(), &[turned(&pair), cycle[1].clone()], &[]);
    assert_eq!(
        check.seams.iter().flat_map(|s| &s.errors).count(),
        1,
        "{:#?}",
        check.seams
    );
    assert!(codes(&check).is_empty());
}

#[test]
fn panels_that_start_nowhere_are_not_judged() {
    let pattern = pattern(vec![
        rectangle("front", WIDTH, HEIGHT),
        rectangle("stranger", WIDTH, HEIGHT),
    ]);
    for pair in [
        seam("side", run("front", 3, 2), run("stranger", 0, 1)),
        seam("side", run("front", 3, 2), run("stranger", 1, 0)),
    ] {
        let (check, set) = checked(&pattern, &[pair], &[]);
        assert!(codes(&check).is_empty() && set.is_ok());
    }
}

#[test]
fn mirrored_copy_is_judged_as_it_lies() {
    // A front cut in two halves, the right one a mirrored copy, sewn along the center: drawn x = 0
    // for both.
    let half = rectangle("front", WIDTH / 2.0, HEIGHT);
    let copy = mirrored(&half);
    let pattern = pattern(vec![half, copy]);
    let place = |_: usize, face: Face, [x, y]: [f64; 2]| {
        let sense = if face == Face::Up { 1.0 } else { -1.0 };
        Some([sense * x, y, 0.15])
    };
    let faces = BTreeMap::new();
    let check = |pair: &SeamPair| {
        let to_check = SeamCheckInput {
            pattern: &pattern,
            pairs: std::slice::from_ref(pair),
            faces: &faces,
            edge_length: 0.012,
            limits: &Limits::default(),
        };
        check_placed(&to_check, &place)
    };
    let pair = seam("centre", run("front", 0, 1), run("front~mirror", 0, 1));
    let (found, set) = check(&pair);
    assert!(codes(&found).is_empty());
    assert_eq!(set.expect("right").faces, [Face::Up, Face::Up]);
    let (found, _) = check(&turned(&pair));
    assert_eq!(codes(&found), ["seam/likely_reversed"]);
}
