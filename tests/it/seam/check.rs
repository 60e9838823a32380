//! Seams on panels made by hand, whose answers are known without the code.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::pattern::{Direction, Match, OutlineRun, Panel, Pattern, Place, SeamPair, Side};
use seamster::seam::{Face, FaceRequest, Seam, SeamCheck, SeamSet, Stretch, Track, check};
use seamster_fixtures::panels::{
    darted, lens, many, notched, pattern, polygon, rectangle, run, seam, trapezoid,
};
use std::collections::BTreeMap;

const EDGE_LENGTH: f64 = 0.012;

/// Left and right edge of a rectangle, in corner indices and gone upwards.
const LEFT_UP: [usize; 2] = [0, 1];
const RIGHT_UP: [usize; 2] = [3, 2];
const TOP: [usize; 2] = [1, 2];

fn checked(pattern: &Pattern, pairs: &[SeamPair]) -> (SeamCheck, Result<SeamSet, Faults>) {
    checked_with(pattern, pairs, &[])
}

fn checked_with(
    pattern: &Pattern,
    pairs: &[SeamPair],
    faces: &[(&str, FaceRequest)],
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let faces: BTreeMap<_, _> = faces
        .iter()
        .map(|(id, face)| ((*id).to_owned(), *face))
        .collect();
    check(pattern, pairs, &faces, EDGE_LENGTH, &Limits::default())
}

fn sewn(pattern: &Pattern, pairs: &[SeamPair]) -> SeamSet {
    checked(pattern, pairs).1.expect("the seams are right")
}

/// Code and pointer of every fault.
fn faults(pattern: &Pattern, pairs: &[SeamPair]) -> Vec<(String, String)> {
    let faults = checked(pattern, pairs).1.expect_err("a seam is wrong");
    faults
        .0
        .into_iter()
        .map(|fault| (fault.code.to_string(), fault.pointer))
        .collect()
}

fn assert_only_fault(pattern: &Pattern, pairs: &[SeamPair], code: &str, pointer: &str) {
    assert_eq!(
        faults(pattern, pairs),
        [(code.to_owned(), pointer.to_owned())]
    );
}

fn edge(panel: &str, [from, to]: [usize; 2]) -> OutlineRun {
    run(panel, from, to)
}

fn pair(id: &str, a: (&str, [usize; 2]), b: (&str, [usize; 2])) -> SeamPair {
    seam(id, edge(a.0, a.1), edge(b.0, b.1))
}

fn with_direction(run: OutlineRun, direction: Direction) -> OutlineRun {
    OutlineRun {
        direction: Some(direction),
        ..run
    }
}

fn tube() -> Pattern {
    pattern(vec![
        rectangle("front", 0.5, 0.6),
        rectangle("back", 0.5, 0.6),
    ])
}

/// Both panels drawn as seen on their outer side: the front's left edge meets the back's right one.
fn tube_seams_both_face_up() -> [SeamPair; 2] {
    [
        pair("left", ("front", LEFT_UP), ("back", RIGHT_UP)),
        pair("right", ("front", RIGHT_UP), ("back", LEFT_UP)),
    ]
}

/// Both panels drawn as seen from the front: left meets left.
fn tube_seams_in_one_view() -> [SeamPair; 2] {
    [
        pair("left", ("front", LEFT_UP), ("back", LEFT_UP)),
        pair("right", ("front", RIGHT_UP), ("back", RIGHT_UP)),
    ]
}

fn turned(mut pair: SeamPair) -> SeamPair {
    let turn = |run: &OutlineRun| OutlineRun {
        from: run.to,
        to: run.from,
        ..run.clone()
    };
    pair.b = match &pair.b {
        Side::One(run) => Side::One(turn(run)),
        Side::Many(runs) => Side::Many(runs.iter().rev().map(turn).collect()),
    };
    pair
}

#[test]
fn tube_drawn_face_up_has_both_faces_up() {
    let set = sewn(&tube(), &tube_seams_both_face_up());
    assert_eq!(set.faces, [Face::Up, Face::Up]);
}

#[test]
fn tube_drawn_in_one_view_has_its_back_face_down() {
    let (check, set) = checked(&tube(), &tube_seams_in_one_view());
    assert_eq!(set.unwrap().faces, [Face::Up, Face::Down]);
    assert!(check.ok && check.warnings.is_empty() && check.corrected.is_empty());
    assert_eq!(check.faces["front"], Face::Up);
    assert_eq!(check.faces["back"], Face::Down);
}

#[test]
fn front_is_up_wherever_it_stands_in_the_file() {
    let mut one = tube();
    one.panels.reverse();
    let set = sewn(&one, &tube_seams_in_one_view());
    assert_eq!(set.faces, [Face::Down, Face::Up]);
}

#[test]
fn finding_states_lengths_counts_and_directions() {
    let panels = pattern(vec![
        rectangle("front", 0.5, 0.6),
        rectangle("back", 0.5, 0.6),
    ]);
    let (check, _) = checked(&panels, &tube_seams_in_one_view());
    let [left, right] = check.seams.as_slice() else {
        panic!()
    };
    assert_eq!((left.length_a_m, left.length_b_m), (0.6, 0.6));
    assert_eq!(left.stitch_count, 51, "0.6 m in mesh edges of 12 mm");
    assert_eq!((left.ease, left.ease_m), (0.0, 0.0));
    assert_eq!(
        (left.direction_a, left.direction_b),
        (Some(Direction::Cw), Some(Direction::Cw))
    );
    assert_eq!(
        (right.direction_a, right.direction_b),
        (Some(Direction::Ccw), Some(Direction::Ccw))
    );
    assert!(left.ok && !left.reversed && left.warnings.is_empty());
}

#[test]
fn from_of_a_meets_from_of_b() {
    let set = sewn(&tube(), &tube_seams_both_face_up());
    let expected = |panel, edge, from, to| Stretch {
        panel,
        track: Track::Outline,
        edge,
        from,
        to,
    };
    assert_eq!(
        set.seams[0].matched,
        [[expected(0, 0, 0.0, 1.0), expected(1, 2, 1.0, 0.0)]]
    );
}

#[test]
fn moebius_strip_is_refused() {
    let [left, right] = tube_seams_both_face_up();
    let pairs = [left, turned(right)];
    let (check, result) = checked(&tube(), &pairs);
    let faults = result.unwrap_err().0;
    assert_eq!(faults.len(), 1);
    assert_eq!(
        (faults[0].code.as_str(), faults[0].pointer.as_str()),
        ("seam/twisted", "/seams/1")
    );
    for name in ["`left`", "`right`", "`front`", "`back`"] {
        assert!(faults[0].detail.contains(name), "{}", faults[0].detail);
    }
    assert!(!check.ok && check.seams[0].ok && !check.seams[1].ok);
}

#[test]
fn moebius_strip_is_sewn_where_a_twist_is_allowed() {
    let [left, right] = tube_seams_both_face_up();
    for allowing in 0..2 {
        let mut pairs = [left.clone(), turned(right.clone())];
        pairs[allowing].allow_twist = true;
        let (check, result) = checked(&tube(), &pairs);
        assert_eq!(result.unwrap().seams.len(), 2);
        assert_eq!(check.seams[allowing].warnings[0].code, "seam/twist_allowed");
    }
}

#[test]
fn twist_allowed_elsewhere_does_not_excuse_a_twist() {
    let panels = pattern(vec![
        rectangle("front", 0.5, 0.6),
        rectangle("back", 0.5, 0.6),
        rectangle("collar", 0.5, 0.1),
    ]);
    let [left, right] = tube_seams_both_face_up();
    let mut neck = pair("neck", ("front", TOP), ("collar", [0, 3]));
    neck.allow_twist = true;
    assert_only_fault(
        &panels,
        &[left, turned(right), neck],
        "seam/twisted",
        "/seams/1",
    );
}

#[test]
fn twisted_seam_is_offered_in_the_other_order_where_heights_agree() {
    let [left, right] = tube_seams_both_face_up();
    for (pairs, wrong) in [
        ([left.clone(), turned(right.clone())], 1),
        ([turned(left.clone()), right.clone()], 0),
    ] {
        let (check, _) = checked(&tube(), &pairs);
        assert!(!check.seams[wrong].ok);
        assert_eq!(
            check.corrected,
            [[left.clone(), right.clone()][wrong].clone()]
        );
    }
}

#[test]
fn twisted_seam_is_offered_on_its_mirror_edge_where_reversing_would_turn_it_upside_down() {
    let panels = pattern(vec![
        rectangle("back", 0.5, 0.6),
        rectangle("side", 0.5, 0.6),
    ]);
    let top = pair("top", ("back", TOP), ("side", [2, 1]));
    let wrong = pair("centre", ("back", LEFT_UP), ("side", LEFT_UP));
    let (check, result) = checked(&panels, &[top.clone(), wrong]);
    assert_eq!(result.unwrap_err().0[0].code, "seam/twisted");
    let mended = pair("centre", ("back", LEFT_UP), ("side", RIGHT_UP));
    assert_eq!(check.corrected, std::slice::from_ref(&mended));
    assert_eq!(sewn(&panels, &[top, mended]).faces, [Face::Up; 2]);
}

#[test]
fn edge_picked_on_the_wrong_side_is_offered_as_its_mirror() {
    let [left, right] = tube_seams_both_face_up();
    let wrong = pair("right", ("front", RIGHT_UP), ("back", RIGHT_UP));
    let pairs = [left, wrong];
    let expected = [("seam/overlap", "/seams/1/b"), ("seam/twisted", "/seams/1")];
    assert_eq!(
        faults(&tube(), &pairs),
        expected.map(|(code, pointer)| (code.to_owned(), pointer.to_owned()))
    );
    assert_eq!(checked(&tube(), &pairs).0.corrected, [right]);
}

#[test]
fn seams_that_end_and_begin_at_nearly_the_same_place_share_it() {
    let panels = pattern(vec![
        rectangle("band", 0.8, 0.1),
        rectangle("front", 0.4, 0.4),
        rectangle("back", 0.4, 0.4),
    ]);
    let along = |from, to| OutlineRun {
        panel: "band".to_owned(),
        from,
        to,
        direction: None,
    };
    let at = |at| Place::OnEdge { edge: 3, at };
    let set = sewn(
        &panels,
        &[
            seam(
                "front",
                along(Place::Corner(3), at(0.5005)),
                edge("front", TOP),
            ),
            seam("back", along(at(0.5), Place::Corner(0)), edge("back", TOP)),
        ],
    );
    assert_eq!(set.seams[0].matched[0][0].to, 0.5005);
    assert_eq!(set.seams[1].matched[0][0].from, 0.5005);
}

#[test]
fn stated_faces_that_seams_contradict_are_to_be_turned() {
    let (check, result) = checked_with(
        &tube(),
        &tube_seams_in_one_view(),
        &[("front", FaceRequest::Up), ("back", FaceRequest::Up)],
    );
    let faults = result.unwrap_err().0;
    assert_eq!(faults[0].code, "seam/twisted");
    let fix = faults[0].fix.as_deref().unwrap();
    assert!(fix.contains("`back`") && fix.contains("`down`"), "{fix}");
    assert!(check.corrected.is_empty());
    let (_, mended) = checked_with(
        &tube(),
        &tube_seams_in_one_view(),
        &[("front", FaceRequest::Up), ("back", FaceRequest::Down)],
    );
    assert_eq!(mended.unwrap().faces, [Face::Up, Face::Down]);
}

/// A tube of six gores, each sewn to the next: all have the same face out.
fn gores() -> (Pattern, Vec<SeamPair>) {
    let name = |i: usize| format!("gore-{}", i % 6);
    let panels = (0..6).map(|i| rectangle(&name(i), 0.2, 0.6)).collect();
    let pairs = (0..6).map(|i| {
        let (a, b) = (name(i), name(i + 1));
        pair(&format!("seam-{i}"), (&a, RIGHT_UP), (&b, LEFT_UP))
    });
    (pattern(panels), pairs.collect())
}

#[test]
fn wrongly_stated_faces_are_one_fault_that_names_the_panels_to_turn() {
    let (panels, pairs) = gores();
    let faces = |down: &[usize]| -> Vec<(String, FaceRequest)> {
        let face = |i| match down.contains(&i) {
            true => FaceRequest::Down,
            false => FaceRequest::Up,
        };
        (0..6).map(|i| (format!("gore-{i}"), face(i))).collect()
    };
    let check_with = |down: &[usize]| {
        let faces = faces(down);
        let faces: Vec<_> = faces
            .iter()
            .map(|(id, face)| (id.as_str(), *face))
            .collect();
        checked_with(&panels, &pairs, &faces).1
    };
    assert!(check_with(&[]).is_ok());
    let faults = check_with(&[1, 4]).unwrap_err().0;
    assert_eq!(faults.len(), 1, "{faults:#?}");
    assert_eq!(
        (faults[0].code.as_str(), faults[0].pointer.as_str()),
        ("seam/twisted", "/panels/gore-1/face")
    );
    let fix = faults[0].fix.as_deref().unwrap();
    assert_eq!(
        fix,
        "set `face` of `gore-1` and `gore-4` to `up`, or to `auto`"
    );
    // Where most are wrong, turning the few makes them agree too.
    let faults = check_with(&[0, 1, 3, 4]).unwrap_err().0;
    assert_eq!(faults.len(), 1);
    let fix = faults[0].fix.as_deref().unwrap();
    assert_eq!(
        fix,
        "set `face` of `gore-2` and `gore-5` to `down`, or to `auto`"
    );
}

#[test]
fn reversed_seam_is_blamed_and_not_the_faces_stated_right() {
    let (panels, pairs) = gores();
    let faces: Vec<String> = (0..6).map(|i| format!("gore-{i}")).collect();
    let faces: Vec<_> = faces
        .iter()
        .map(|id| (id.as_str(), FaceRequest::Up))
        .collect();
    for wrong in 0..6 {
        // As a cycle, and as an open row in which the seam is a bridge.
        for open in [false, true] {
            let mut pairs = pairs.clone();
            pairs[wrong] = turned(pairs[wrong].clone());
            if open {
                pairs.remove((wrong + 3) % 6);
            }
            let (check, result) = checked_with(&panels, &pairs, &faces);
            let faults = result.unwrap_err().0;
            assert_eq!(faults.len(), 1, "{faults:#?}");
            assert_eq!(faults[0].code, "seam/twisted");
            let blamed = check.seams.iter().position(|seam| !seam.ok).unwrap();
            assert_eq!(check.seams[blamed].id, format!("seam-{wrong}"));
        }
    }
}

#[test]
fn stated_face_fixes_the_faces_of_all_it_is_sewn_to() {
    let (_, result) = checked_with(
        &tube(),
        &tube_seams_in_one_view(),
        &[("back", FaceRequest::Up)],
    );
    assert_eq!(result.unwrap().faces, [Face::Down, Face::Up]);
}

#[test]
fn auto_seam_is_reversed_where_parity_says_so() {
    let [left, right] = tube_seams_both_face_up();
    let wrong = SeamPair {
        matching: Match::Auto,
        ..turned(right.clone())
    };
    let (check, result) = checked(&tube(), &[left, wrong]);
    let set = result.unwrap();
    assert_eq!(set.faces, [Face::Up, Face::Up]);
    assert!(check.seams[1].reversed && !check.seams[0].reversed);
    assert_eq!(check.seams[1].warnings[0].code, "seam/reversed");
    assert_eq!(check.seams[1].direction_b, Some(Direction::Cw));
    assert_eq!(
        set.seams[1].matched,
        sewn(&tube(), &tube_seams_both_face_up()).seams[1].matched
    );
}

#[test]
fn auto_seam_that_is_right_stays_as_picked() {
    let pairs = tube_seams_both_face_up().map(|pair| SeamPair {
        matching: Match::Auto,
        ..pair
    });
    let (check, _) = checked(&tube(), &pairs);
    assert!(check.ok && check.seams.iter().all(|seam| !seam.reversed));
}

#[test]
fn auto_seam_between_two_parts_joins_upper_end_to_upper_end() {
    let [left, _] = tube_seams_both_face_up();
    let wrong = SeamPair {
        matching: Match::Auto,
        ..turned(left.clone())
    };
    let (check, result) = checked(&tube(), &[wrong]);
    assert!(check.seams[0].reversed);
    assert_eq!(
        result.unwrap().seams[0].matched,
        sewn(&tube(), &[left]).seams[0].matched
    );
}

#[test]
fn dart_is_sewn_from_its_mouth_to_its_tip() {
    let front = pattern(vec![darted("front", [0.4, 0.6], [0.03, 0.12])]);
    let dart = seam("dart", run("front", 2, 3), run("front", 4, 3));
    let (check, result) = checked(&front, std::slice::from_ref(&dart));
    assert_eq!(result.unwrap().faces, [Face::Up]);
    // sqrt(0.12² + 0.015²) = 0.12093 m in mesh edges of 12 mm: 11 edges, 12 points a side, of which
    // the tip meets itself.
    assert_eq!(check.seams[0].stitch_count, 11);
    assert_only_fault(&front, &[turned(dart.clone())], "seam/twisted", "/seams/0");
    let auto = SeamPair {
        matching: Match::Auto,
        ..turned(dart)
    };
    assert!(checked(&front, &[auto]).0.seams[0].reversed);
}

#[test]
fn strip_closed_to_a_ring_runs_in_opposite_directions() {
    let band = pattern(vec![rectangle("band", 0.7, 0.04)]);
    let ring = pair("back", ("band", LEFT_UP), ("band", RIGHT_UP));
    assert!(checked(&band, std::slice::from_ref(&ring)).0.ok);
    let (check, _) = checked(&band, &[turned(ring.clone())]);
    assert_eq!(check.seams[0].errors[0].code, "seam/twisted");
    assert_eq!(
        check.corrected,
        [ring],
        "reversing makes the lower ends meet"
    );
}

#[test]
fn waistband_of_one_strip_is_sewn_to_front_and_back() {
    let panels = pattern(vec![
        trapezoid("front", 0.6, 0.36, 0.6),
        trapezoid("back", 0.6, 0.36, 0.6),
        rectangle("band", 0.72, 0.04),
    ]);
    let [left, right] = tube_seams_both_face_up();
    let half = |at| Place::OnEdge { edge: 3, at };
    let onto = |id: &str, panel: &str, from: Place, to: Place| {
        let band = OutlineRun {
            panel: "band".to_owned(),
            from,
            to,
            direction: None,
        };
        seam(id, edge(panel, TOP), band)
    };
    // The band's bottom edge runs clockwise from its right end to its left end; a front's top runs
    // left to right.
    let pairs = [
        left,
        right,
        onto("waist-front", "front", half(1.0), half(0.5)),
        onto("waist-back", "back", half(0.5), half(0.0)),
        pair("band", ("band", LEFT_UP), ("band", RIGHT_UP)),
    ];
    let (check, result) = checked(&panels, &pairs);
    let set = result.unwrap();
    assert_eq!(set.faces, [Face::Up; 3]);
    let expected = |from, to| Stretch {
        panel: 2,
        track: Track::Outline,
        edge: 3,
        from,
        to,
    };
    assert_eq!(set.seams[2].matched[0][1], expected(1.0, 0.5));
    assert_eq!(set.seams[3].matched[0][1], expected(0.5, 0.0));
    assert_eq!(check.seams[2].length_b_m, 0.36);
    let whole = many(
        "waist",
        vec![edge("front", TOP), edge("back", TOP)],
        vec![run("band", 0, 3)],
    );
    let set = sewn(
        &panels,
        &[pairs[0].clone(), pairs[1].clone(), whole, pairs[4].clone()],
    );
    assert_eq!(set.seams[2].matched.len(), 2);
    assert_eq!(set.seams[2].matched[0][1], expected(1.0, 0.5));
    assert_eq!(set.seams[2].matched[1][1], expected(0.5, 0.0));
}

#[test]
fn sleeve_cap_is_cut_where_the_armholes_end() {
    // A cap of 0.40 m onto armholes of 0.15 and 0.24 m: the cut falls at 0.15/0.39 of the cap.
    let panels = pattern(vec![
        rectangle("front", 0.3, 0.15),
        rectangle("back", 0.3, 0.24),
        rectangle("sleeve", 0.40, 0.5),
    ]);
    let cap = many(
        "cap",
        vec![edge("sleeve", TOP)],
        vec![edge("front", LEFT_UP), edge("back", LEFT_UP)],
    );
    let (check, result) = checked(&panels, std::slice::from_ref(&cap));
    let set = result.unwrap();
    let [[a0, b0], [a1, b1]] = set.seams[0].matched[..] else {
        panic!("{:?}", set.seams[0])
    };
    assert_eq!(
        [a0.from, a1.to, b0.from, b0.to, b1.from, b1.to],
        [0.0, 1.0, 0.0, 1.0, 0.0, 1.0]
    );
    assert_eq!((b0.panel, b1.panel, a0.to), (0, 1, a1.from));
    assert!((a0.to - 0.15 / 0.39).abs() < 1e-12);
    assert!((check.seams[0].ease - (0.40 / 0.39 - 1.0)).abs() < 1e-12);
    // Both armholes go clockwise and so does the cap: sleeve and armholes have different faces.
    assert_eq!(set.faces, [Face::Up, Face::Up, Face::Down]);
}

#[test]
fn edge_ends_that_nearly_meet_are_sewn_onto_each_other() {
    let panels = |second: f64| {
        pattern(vec![
            polygon(
                "upper",
                &[[0.0, 0.0], [0.0, 0.3], [0.6, 0.3], [0.6, 0.0], [0.3, 0.0]],
            ),
            polygon(
                "lower",
                &[
                    [0.0, 0.0],
                    [0.0, 0.3],
                    [second, 0.3],
                    [0.6, 0.3],
                    [0.6, 0.0],
                ],
            ),
        ])
    };
    let over_two_edges = seam(
        "yoke",
        with_direction(run("upper", 0, 3), Direction::Ccw),
        with_direction(run("lower", 1, 3), Direction::Cw),
    );
    let near = sewn(&panels(0.304), std::slice::from_ref(&over_two_edges));
    let whole = |panel, edge, from, to| Stretch {
        panel,
        track: Track::Outline,
        edge,
        from,
        to,
    };
    assert_eq!(
        near.seams[0].matched,
        [
            [whole(0, 4, 1.0, 0.0), whole(1, 1, 0.0, 1.0)],
            [whole(0, 3, 1.0, 0.0), whole(1, 2, 0.0, 1.0)],
        ]
    );
    let far = sewn(&panels(0.33), &[over_two_edges]);
    assert_eq!(far.seams[0].matched.len(), 3);
}

#[test]
fn closed_run_goes_all_round() {
    let cuff = pattern(vec![
        polygon("hole", &[[0.0, 0.0], [0.0, 0.1], [0.1, 0.1], [0.1, 0.0]]),
        polygon("patch", &[[0.0, 0.0], [0.0, 0.1], [0.1, 0.1], [0.1, 0.0]]),
    ]);
    let round = |direction| {
        seam(
            "round",
            with_direction(run("hole", 0, 0), Direction::Cw),
            with_direction(run("patch", 0, 0), direction),
        )
    };
    let (check, result) = checked(&cuff, &[round(Direction::Cw)]);
    let set = result.unwrap();
    assert_eq!(set.seams[0].matched.len(), 4);
    assert_eq!(set.faces, [Face::Up, Face::Down]);
    // 9 mesh edges of at most 12 mm on each side of 0.1 m; the last point is the first.
    assert_eq!(check.seams[0].stitch_count, 36);
    assert_eq!(
        sewn(&cuff, &[round(Direction::Ccw)]).faces,
        [Face::Up, Face::Up]
    );
}

#[test]
fn direction_tells_the_two_edges_of_a_lens_apart() {
    let leaves = pattern(vec![lens("a", 0.2, 0.04, 16), lens("b", 0.2, 0.04, 16)]);
    let go = |panel, direction| with_direction(run(panel, 0, 1), direction);
    let set = sewn(
        &leaves,
        &[seam("s", go("a", Direction::Cw), go("b", Direction::Ccw))],
    );
    let [[a, b]] = set.seams[0].matched[..] else {
        panic!()
    };
    assert_eq!((a.edge, a.from, a.to), (0, 0.0, 1.0));
    assert_eq!((b.edge, b.from, b.to), (1, 1.0, 0.0));
    assert_only_fault(
        &leaves,
        &[seam("s", run("a", 0, 1), go("b", Direction::Ccw))],
        "seam/direction_needed",
        "/seams/0/a/direction",
    );
}

#[test]
fn notches_and_fractions_are_places() {
    let panels = pattern(vec![
        notched(notched(rectangle("a", 0.4, 0.4), 0, 0.25), 0, 0.75),
        rectangle("b", 0.4, 0.4),
    ]);
    let notch = |notch| Place::AtNotch { notch };
    let a = OutlineRun {
        panel: "a".to_owned(),
        from: notch(0),
        to: notch(1),
        direction: None,
    };
    let on = |at| Place::OnEdge { edge: 2, at };
    let b = OutlineRun {
        panel: "b".to_owned(),
        from: on(0.75),
        to: on(0.25),
        direction: None,
    };
    let set = sewn(&panels, &[seam("s", a, b)]);
    let [[a, b]] = set.seams[0].matched[..] else {
        panic!()
    };
    assert_eq!([a.from, a.to, b.from, b.to], [0.25, 0.75, 0.75, 0.25]);
    assert_eq!(set.faces, [Face::Up, Face::Up]);
}

#[test]
fn place_within_a_millimeter_of_a_corner_is_the_corner() {
    let panels = pattern(vec![rectangle("a", 0.4, 0.4), rectangle("b", 0.4, 0.4)]);
    let near = Place::OnEdge {
        edge: 0,
        at: 0.9999,
    };
    let a = OutlineRun {
        panel: "a".to_owned(),
        from: Place::Corner(0),
        to: near,
        direction: None,
    };
    let set = sewn(&panels, &[seam("s", a, edge("b", RIGHT_UP))]);
    assert_eq!(set.seams[0].matched[0][0].to, 1.0);
}

#[test]
fn both_halves_of_a_folded_edge_can_be_sewn_together() {
    let sheet = pattern(vec![rectangle("sheet", 0.4, 0.4)]);
    let half = |from, to| OutlineRun {
        panel: "sheet".to_owned(),
        from: Place::OnEdge { edge: 1, at: from },
        to: Place::OnEdge { edge: 1, at: to },
        direction: None,
    };
    assert!(
        checked(&sheet, &[seam("fold", half(0.0, 0.5), half(1.0, 0.5))])
            .0
            .ok
    );
    assert_only_fault(
        &sheet,
        &[seam("fold", half(0.0, 0.6), half(1.0, 0.4))],
        "seam/sewn_to_itself",
        "/seams/0/b",
    );
}

/// The codes of warnings and errors of a seam of 1 m with this ease.
fn ease_codes(ease: f64, gather: bool) -> (Vec<String>, Vec<String>) {
    let panels = pattern(vec![
        rectangle("a", 0.4, 1.0),
        rectangle("b", 0.4, 1.0 + ease),
    ]);
    let pair = SeamPair {
        gather,
        ..pair("s", ("a", LEFT_UP), ("b", RIGHT_UP))
    };
    let (check, _) = checked(&panels, &[pair]);
    let finding = &check.seams[0];
    assert!((finding.ease - ease).abs() < 1e-9 && (finding.ease_m - ease).abs() < 1e-9);
    let much = |detail: &str| {
        if detail.contains("much") {
            "much"
        } else {
            "noted"
        }
        .to_owned()
    };
    (
        finding.warnings.iter().map(|w| much(&w.detail)).collect(),
        finding.errors.iter().map(|e| e.code.to_string()).collect(),
    )
}

#[test]
fn ease_is_noted_warned_of_and_refused_at_its_bounds() {
    let none: Vec<String> = vec![];
    let one = |word: &str| vec![word.to_owned()];
    assert_eq!(ease_codes(0.0009, false), (none.clone(), none.clone()));
    assert_eq!(ease_codes(0.0011, false), (one("noted"), none.clone()));
    assert_eq!(ease_codes(0.1499, false), (one("noted"), none.clone()));
    assert_eq!(ease_codes(0.1501, false), (one("much"), none.clone()));
    assert_eq!(ease_codes(0.2999, false), (one("much"), none.clone()));
    assert_eq!(
        ease_codes(0.3001, false),
        (none.clone(), one("seam/ease_too_large"))
    );
    assert_eq!(ease_codes(0.3001, true), (one("noted"), none));
}

#[test]
fn unknown_names_come_with_the_nearest_one() {
    let panels = tube();
    let pairs = [pair("s", ("fornt", LEFT_UP), ("back", RIGHT_UP))];
    assert_only_fault(&panels, &pairs, "seam/unknown_panel", "/seams/0/a/panel");
    let (check, _) = checked(&panels, &pairs);
    assert_eq!(
        check.seams[0].errors[0].fix.as_deref(),
        Some("did you mean `front`?")
    );
}

#[test]
fn faults_that_leave_no_doubt_come_with_the_corrected_seam() {
    let [right, other] = tube_seams_in_one_view();
    let mut wrong = right.clone();
    let Side::One(run) = &mut wrong.a else {
        panic!()
    };
    run.panel = "fronnt".to_owned();
    let Side::One(run) = &mut wrong.b else {
        panic!()
    };
    run.direction = Some(Direction::Ccw);
    let (check, result) = checked(&tube(), &[wrong, other]);
    let codes: Vec<_> = result
        .unwrap_err()
        .0
        .into_iter()
        .map(|f| f.code.to_string())
        .collect();
    assert_eq!(codes, ["seam/unknown_panel", "seam/direction_contradicts"]);
    assert_eq!(check.corrected, std::slice::from_ref(&right));
    // Not where a second fault is left that nothing can be guessed for.
    let mut worse = right;
    let Side::One(run) = &mut worse.a else {
        panic!()
    };
    run.panel = "fronnt".to_owned();
    run.to = Place::Corner(9);
    assert!(checked(&tube(), &[worse]).0.corrected.is_empty());
}

#[test]
fn places_that_are_not_there_are_refused() {
    let panels = tube();
    let at = |place| {
        let b = OutlineRun {
            panel: "back".to_owned(),
            from: place,
            to: Place::Corner(2),
            direction: None,
        };
        many(
            "s",
            vec![edge("front", LEFT_UP)],
            vec![edge("back", TOP), b],
        )
    };
    let cases = [
        (Place::Corner(4), "seam/unknown_corner"),
        (Place::Corner(usize::MAX), "seam/unknown_corner"),
        (Place::OnEdge { edge: 4, at: 0.5 }, "seam/unknown_edge"),
        (Place::AtNotch { notch: 0 }, "seam/unknown_notch"),
        (Place::OnEdge { edge: 2, at: 1.01 }, "seam/bad_fraction"),
        (
            Place::OnEdge {
                edge: 2,
                at: f64::NAN,
            },
            "seam/bad_fraction",
        ),
        (
            Place::OnEdge {
                edge: 2,
                at: f64::NEG_INFINITY,
            },
            "seam/bad_fraction",
        ),
    ];
    for (place, code) in cases {
        assert_only_fault(&panels, &[at(place)], code, "/seams/0/b/1/from");
    }
}

#[test]
fn direction_must_be_given_where_it_is_not_plain_and_agree_where_it_is() {
    let panels = tube();
    let b = edge("back", RIGHT_UP);
    let case = |a: OutlineRun| [seam("s", a, b.clone())];
    assert_only_fault(
        &panels,
        &case(run("front", 0, 2)),
        "seam/direction_needed",
        "/seams/0/a/direction",
    );
    assert_only_fault(
        &panels,
        &case(run("front", 1, 1)),
        "seam/direction_needed",
        "/seams/0/a/direction",
    );
    let wrong = with_direction(run("front", 0, 1), Direction::Ccw);
    assert_only_fault(
        &panels,
        &case(wrong),
        "seam/direction_contradicts",
        "/seams/0/a/direction",
    );
    assert!(
        checked(
            &panels,
            &case(with_direction(run("front", 0, 1), Direction::Cw))
        )
        .0
        .ok
    );
}

#[test]
fn overlapping_seams_are_refused_unless_layered() {
    let panels = pattern(vec![
        rectangle("front", 0.5, 0.6),
        rectangle("back", 0.5, 0.6),
        rectangle("facing", 0.1, 0.6),
    ]);
    let first = pair("side", ("front", LEFT_UP), ("back", RIGHT_UP));
    let second = pair("facing", ("facing", RIGHT_UP), ("front", LEFT_UP));
    assert_only_fault(
        &panels,
        &[first.clone(), second.clone()],
        "seam/overlap",
        "/seams/1/b",
    );
    let layered = SeamPair {
        layered: true,
        ..second
    };
    assert!(checked(&panels, &[first, layered]).0.ok);
}

#[test]
fn side_that_goes_twice_over_an_edge_is_refused_even_if_layered() {
    let twice = many(
        "s",
        vec![edge("front", LEFT_UP), edge("front", LEFT_UP)],
        vec![edge("back", RIGHT_UP), run("back", 2, 1)],
    );
    let layered = SeamPair {
        layered: true,
        ..twice
    };
    assert_only_fault(&tube(), &[layered], "seam/overlap", "/seams/0/a/1");
}

#[test]
fn edge_sewn_to_itself_is_refused() {
    let same = pair("s", ("front", LEFT_UP), ("front", LEFT_UP));
    let codes = faults(&tube(), &[same]);
    assert!(
        codes.contains(&("seam/sewn_to_itself".to_owned(), "/seams/0/b".to_owned())),
        "{codes:?}"
    );
}

#[test]
fn panel_sewn_to_nothing_is_warned_of() {
    let mut panels = tube();
    panels.panels.push(rectangle("pocket", 0.1, 0.1));
    let (check, _) = checked(&panels, &tube_seams_in_one_view());
    assert!(check.ok);
    assert_eq!(check.warnings.len(), 1);
    assert_eq!(check.warnings[0].code, "seam/loose_panel");
    assert!(check.warnings[0].detail.contains("`pocket`"));
    assert_eq!(check.faces["pocket"], Face::Up);
}

#[test]
fn more_seams_than_the_limit_are_refused() {
    let limits = Limits {
        seams: 2,
        ..Limits::default()
    };
    let pairs: Vec<_> = (0..3)
        .map(|i| pair(&format!("s{i}"), ("front", LEFT_UP), ("back", RIGHT_UP)))
        .collect();
    let (check, result) = check(&tube(), &pairs, &BTreeMap::new(), EDGE_LENGTH, &limits);
    let faults = result.unwrap_err().0;
    assert_eq!(
        (
            faults.len(),
            faults[0].code.as_str(),
            faults[0].pointer.as_str()
        ),
        (1, "seam/too_many", "/seams")
    );
    assert_eq!((check.ok, check.seams.len()), (false, 3));
}

#[test]
fn all_faults_of_a_bad_set_come_at_once() {
    let panels = pattern(vec![
        rectangle("front", 0.5, 0.6),
        rectangle("back", 0.5, 0.6),
        rectangle("tiny", 0.5, 0.3),
    ]);
    let [left, right] = tube_seams_both_face_up();
    let pairs = [
        left,
        turned(right),
        many("empty", vec![], vec![run("back", 9, 2)]),
        pair("left", ("front", TOP), ("sleeve", TOP)),
        pair("uneven", ("front", [3, 0]), ("tiny", LEFT_UP)),
    ];
    let expected = [
        ("seam/twisted", "/seams/1"),
        ("seam/empty_side", "/seams/2/a"),
        ("seam/unknown_corner", "/seams/2/b/from"),
        ("seam/duplicate_id", "/seams/3/id"),
        ("seam/unknown_panel", "/seams/3/b/panel"),
        ("seam/ease_too_large", "/seams/4"),
    ];
    let expected = expected.map(|(code, pointer)| (code.to_owned(), pointer.to_owned()));
    assert_eq!(faults(&panels, &pairs), expected);
    let (check, result) = checked(&panels, &pairs);
    assert!(
        result
            .unwrap_err()
            .0
            .iter()
            .all(|fault| fault.fix.is_some())
    );
    assert_eq!(
        check.seams.iter().map(|seam| seam.ok).collect::<Vec<_>>(),
        [true, false, false, false, false]
    );
}

#[test]
fn run_without_length_is_refused() {
    let mut panels = tube();
    panels.panels[0].edges[0].length_m = 0.0;
    assert_only_fault(
        &panels,
        &tube_seams_both_face_up()[..1],
        "seam/zero_length",
        "/seams/0/a",
    );
}

#[test]
fn absurd_requests_are_answered_without_a_panic() {
    let limits = Limits::default();
    let closed = with_direction(run("front", 0, 0), Direction::Cw);
    let long = many("long", vec![closed.clone(); 60_000], vec![closed; 60_000]);
    let (check_long, _) = check(&tube(), &[long], &BTreeMap::new(), EDGE_LENGTH, &limits);
    assert!(
        check_long.seams[0]
            .errors
            .iter()
            .any(|fault| fault.code == "seam/too_long")
    );
    for edge_length in [f64::NAN, 0.0, -1.0, f64::INFINITY, 1e-300] {
        let (check, _) = check(
            &tube(),
            &tube_seams_in_one_view(),
            &BTreeMap::new(),
            edge_length,
            &limits,
        );
        assert!(check.ok && check.seams[0].stitch_count <= 301);
    }
    let (check, _) = checked(&pattern(vec![]), &tube_seams_in_one_view());
    assert_eq!(check.seams[0].errors.len(), 2);
    let crowd = pattern(
        (0..500)
            .map(|i| rectangle(&format!("p{i}"), 0.4, 0.4))
            .collect(),
    );
    let mut random = Lcg64(3);
    let pairs: Vec<_> = (0..2_000)
        .map(|i| {
            let mut any = || {
                let from = random.below(4);
                run(
                    &format!("p{}", random.below(500)),
                    from,
                    (from + 1 + 2 * random.below(2)) % 4,
                )
            };
            let (a, b) = (any(), any());
            SeamPair {
                layered: true,
                ..seam(&format!("s{i}"), a, b)
            }
        })
        .collect();
    assert!(!checked(&crowd, &pairs).0.ok);
    let bare = pattern(vec![Panel {
        corners: vec![],
        edges: vec![],
        ..rectangle("front", 1.0, 1.0)
    }]);
    assert!(!checked(&bare, &tube_seams_in_one_view()).0.ok);
}

/// A small linear congruential generator (Knuth, MMIX), so that each case repeats.
struct Lcg64(u64);

impl Lcg64 {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).expect("31 bits") % bound
    }

    fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }
}

/// Up to six seams between edges of four rectangles, each edge used once, some of them `auto`.
fn random_seams(random: &mut Lcg64) -> Vec<SeamPair> {
    let names = ["front", "back", "left", "right"];
    let mut edges: Vec<(usize, usize)> = (0..16).map(|i| (i / 4, i % 4)).collect();
    random.shuffle(&mut edges);
    let count = 2 + random.below(5);
    let mut way = |(panel, edge): (usize, usize)| {
        let ends = [edge, (edge + 1) % 4];
        let turn = random.below(2);
        run(names[panel], ends[turn], ends[1 - turn])
    };
    let mut pairs: Vec<_> = edges
        .chunks(2)
        .take(count)
        .enumerate()
        .map(|(i, ends)| seam(&format!("s{i}"), way(ends[0]), way(ends[1])))
        .collect();
    for pair in &mut pairs {
        if random.below(3) == 0 {
            pair.matching = Match::Auto;
        }
        pair.allow_twist = random.below(8) == 0;
    }
    pairs
}

/// Returns true if each seam runs as the faces found demand: the definition of a two-sided surface,
/// apart from how it is computed.
fn is_two_sided(seams: &[Seam], faces: &[Face], allowed: &[bool]) -> bool {
    seams.iter().zip(allowed).all(|(seam, allowed)| {
        *allowed
            || seam.matched.iter().all(|[a, b]| {
                let opposite = (a.to > a.from) != (b.to > b.from);
                opposite == (faces[a.panel] == faces[b.panel])
            })
    })
}

#[test]
fn order_of_seams_and_sides_changes_neither_verdict_nor_faces() {
    let panels = pattern(
        ["front", "back", "left", "right"]
            .map(|id| rectangle(id, 0.4, 0.4))
            .to_vec(),
    );
    let mut random = Lcg64(7);
    let mut accepted = 0;
    for case in 0..400 {
        let pairs = random_seams(&mut random);
        let (first, result) = checked(&panels, &pairs);
        if let Ok(set) = result {
            accepted += 1;
            let allowed: Vec<bool> = pairs.iter().map(|pair| pair.allow_twist).collect();
            assert!(
                is_two_sided(&set.seams, &set.faces, &allowed),
                "case {case}"
            );
        }
        let mut other = pairs.clone();
        random.shuffle(&mut other);
        for pair in &mut other {
            if random.below(2) == 0 {
                std::mem::swap(&mut pair.a, &mut pair.b);
            }
        }
        let (second, _) = checked(&panels, &other);
        assert_eq!(
            (first.ok, first.faces),
            (second.ok, second.faces),
            "case {case}"
        );
    }
    assert!(
        (100..390).contains(&accepted),
        "the cases must cover both verdicts: {accepted}"
    );
}

#[test]
fn refused_sets_have_no_coloring_at_all() {
    let panels = pattern(
        ["front", "back", "left", "right"]
            .map(|id| rectangle(id, 0.4, 0.4))
            .to_vec(),
    );
    let mut random = Lcg64(11);
    for case in 0..200 {
        let mut pairs = random_seams(&mut random);
        pairs
            .iter_mut()
            .for_each(|pair| pair.matching = Match::AsPicked);
        let runs = |pair: &SeamPair| [pair.a.runs()[0].clone(), pair.b.runs()[0].clone()];
        let colorable = (0..16_usize).any(|colors| {
            pairs.iter().filter(|pair| !pair.allow_twist).all(|pair| {
                let [a, b] = runs(pair).map(|run| {
                    let panel = panels.panel_index(&run.panel).unwrap();
                    let (Place::Corner(from), Place::Corner(to)) = (run.from, run.to) else {
                        panic!()
                    };
                    (colors >> panel & 1, to == (from + 1) % 4)
                });
                (a.1 != b.1) == (a.0 == b.0)
            })
        });
        assert_eq!(checked(&panels, &pairs).0.ok, colorable, "case {case}");
    }
}
