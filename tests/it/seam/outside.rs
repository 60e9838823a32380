//! The side that is out of parts of which no face is stated.

use seamster::config::Limits;
use seamster::pattern::{Pattern, SeamPair};
use seamster::seam::{Face, SeamCheckInput, check_placed};
use seamster_fixtures::panels::{pattern, rectangle, run, seam};
use std::collections::BTreeMap;

/// The faces of panels that start as `starts` says, and the codes of what is told of them.
fn faces(
    pattern: &Pattern,
    pair: &SeamPair,
    starts: &dyn Fn(usize, Face, [f64; 2]) -> Option<[f64; 3]>,
) -> (Vec<Face>, Vec<String>) {
    let to_check = SeamCheckInput {
        pattern,
        pairs: std::slice::from_ref(pair),
        faces: &BTreeMap::new(),
        edge_length: 0.012,
        limits: &Limits::default(),
    };
    let (check, set) = check_placed(&to_check, starts);
    let told = check.warnings.iter().map(|w| w.code.to_string());
    (set.expect("a right seam").faces, told.collect())
}

/// The right edge of a front as it is drawn is sewn to a sleeve, which starts on one side or the
/// other: only with its drawn side in is the front's right edge on the wearer's right.
#[test]
fn sleeves_tell_which_side_of_a_front_is_out() {
    let pattern = pattern(vec![rectangle("1", 0.5, 0.6), rectangle("2", 0.5, 0.6)]);
    let pair = seam("armhole", run("1", 3, 2), run("2", 0, 1));
    for (side, face) in [(1.0, Face::Up), (-1.0, Face::Down)] {
        let starts = |panel: usize, face: Face, [x, y]: [f64; 2]| {
            let sense = if face == Face::Up { 1.0 } else { -1.0 };
            Some(match panel {
                0 => [sense * (x - 0.25), y, 0.15],
                _ => [side * (0.25 + x), y, 0.0],
            })
        };
        let (found, told) = faces(&pattern, &pair, &starts);
        assert_eq!(found, [face, face], "{side}");
        let is_told = told == ["seam/face_chosen"];
        assert_eq!(is_told, face == Face::Down, "{told:?}");
    }
}

#[test]
fn most_of_the_cloth_is_drawn_from_outside_unless_a_front_is_named() {
    let sewn = |small: &str| {
        let pattern = pattern(vec![rectangle(small, 0.1, 0.6), rectangle("2", 0.5, 0.6)]);
        // The right edges of both, upwards: one of the two is seen from inside.
        let pair = seam("side", run(small, 3, 2), run("2", 3, 2));
        faces(&pattern, &pair, &|_, _, _| None).0
    };
    assert_eq!(sewn("1"), [Face::Down, Face::Up]);
    assert_eq!(sewn("front"), [Face::Up, Face::Down]);
}
