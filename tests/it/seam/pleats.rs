//! Pleats by seams: cloth folded over on the edge of a band, with layers sewn into it.

use seamster::config::Limits;
use seamster::pattern::{Match, OutlineRun, Panel, Pattern, Place, SeamPair};
use seamster::seam::{Face, SeamCheck, check};
use seamster_fixtures::panels::{pattern, polygon, rectangle, run, seam};
use std::collections::BTreeMap;

/// Width of a half of the band \[m\].
const BAND: f64 = 0.37;
/// Depth of a pleat \[m\].
const DEPTH: f64 = 0.06;

/// One ply: name, stretch of the band and stretch of the skirt, from the left \[m\].
type SeamSide = (&'static str, [f64; 2], [f64; 2]);

/// A skirt of front and back whose front is laid in pleats: the plies that lie over others, by
/// name, are `layered`.
struct Pleated {
    plies: Vec<SeamSide>,
    layered: &'static [&'static str],
    skirt_width: f64,
}

impl Pleated {
    fn pattern(&self) -> Pattern {
        self.pattern_with(rectangle("skirt-front", self.skirt_width, 0.5))
    }

    fn pattern_with(&self, front: Panel) -> Pattern {
        pattern(vec![
            front,
            rectangle("skirt-back", BAND, 0.5),
            rectangle("band-front", BAND, 0.04),
            rectangle("band-back", BAND, 0.04),
        ])
    }

    fn seams(&self) -> Vec<SeamPair> {
        let plies = self.plies.iter();
        let pleats = plies.map(|&(id, band, skirt)| SeamPair {
            layered: self.layered.contains(&id),
            ..seam(
                id,
                on("band-front", 3, band.map(|x| (1.0 - x / BAND).max(0.0))),
                on(
                    "skirt-front",
                    1,
                    skirt.map(|x| (x / self.skirt_width).min(1.0)),
                ),
            )
        });
        pleats.chain(around()).collect()
    }
}

fn on(panel: &str, edge: usize, at: [f64; 2]) -> OutlineRun {
    let [from, to] = at.map(|at| Place::OnEdge { edge, at });
    OutlineRun {
        panel: panel.to_owned(),
        from,
        to,
        direction: None,
    }
}

/// The seams that are no pleats.
fn around() -> [SeamPair; 5] {
    let side = |id: &str, panel: &str, back: [usize; 2], front: [usize; 2]| {
        let [front_id, back_id] = ["front", "back"].map(|half| format!("{panel}-{half}"));
        let front = run(&front_id, front[0], front[1]);
        seam(id, front, run(&back_id, back[0], back[1]))
    };
    [
        seam("back", run("band-back", 0, 3), run("skirt-back", 1, 2)),
        side("s1", "skirt", [0, 1], [3, 2]),
        side("s2", "skirt", [3, 2], [0, 1]),
        side("w1", "band", [0, 1], [3, 2]),
        side("w2", "band", [3, 2], [0, 1]),
    ]
}

/// A knife pleat: one ply out, one back below it, one out below both.
fn knife() -> Pleated {
    let [x, d] = [0.15, DEPTH];
    Pleated {
        plies: vec![
            ("left", [0.0, x], [0.0, x]),
            ("out", [x, x + d], [x, x + d]),
            ("under", [x, x + d], [x + 2.0 * d, x + d]),
            ("back-out", [x, x + d], [x + 2.0 * d, x + 3.0 * d]),
            ("right", [x + d, BAND], [x + 3.0 * d, BAND + 2.0 * d]),
        ],
        layered: &["under", "back-out"],
        skirt_width: BAND + 2.0 * d,
    }
}

/// A box pleat: its middle lies out, over two plies on either side; the same seams are an inverted
/// pleat with the outer plies out.
fn box_pleat(layered: &'static [&'static str]) -> Pleated {
    let [x, d] = [0.185, DEPTH];
    let from = x - d;
    let at = |plies: f64| from + plies * d;
    Pleated {
        plies: vec![
            ("left", [0.0, from], [0.0, from]),
            ("outer-l", [from, x], [from, at(1.0)]),
            ("under-l", [from, x], [at(2.0), at(1.0)]),
            ("middle", [from, x + d], [at(2.0), at(4.0)]),
            ("under-r", [x, x + d], [at(5.0), at(4.0)]),
            ("outer-r", [x, x + d], [at(5.0), at(6.0)]),
            ("right", [x + d, BAND], [at(6.0), BAND + 4.0 * d]),
        ],
        layered,
        skirt_width: BAND + 4.0 * d,
    }
}

const BOX: &[&str] = &["outer-l", "under-l", "under-r", "outer-r"];
const INVERTED: &[&str] = &["under-l", "middle", "under-r"];

fn checked(pattern: &Pattern, pairs: &[SeamPair]) -> SeamCheck {
    let limits = Limits::default();
    check(pattern, pairs, &BTreeMap::new(), 0.02, &limits).0
}

/// Codes of all that is said, with the seams that it is said of; ease apart, which rounding leaves.
fn said(found: &SeamCheck) -> Vec<(String, String)> {
    let of_seam = found.seams.iter().flat_map(|seam| {
        let faults = seam.errors.iter().map(|fault| fault.code.to_string());
        let warnings = seam.warnings.iter().map(|warning| warning.code.to_string());
        faults.chain(warnings).map(|code| (seam.id.clone(), code))
    });
    of_seam.collect()
}

fn assert_silent(found: &SeamCheck) {
    assert_eq!(said(found), []);
    assert!(found.ok && found.corrected.is_empty(), "{found:?}");
    assert!(found.faces.values().all(|face| *face == Face::Up));
}

fn change(pairs: &mut [SeamPair], id: &str, change: impl Fn(&mut SeamPair)) {
    let pair = pairs.iter_mut().find(|pair| pair.id == id);
    change(pair.expect("a seam of this name"));
}

fn reverse(pair: &mut SeamPair) {
    let mut run = pair.b.runs()[0].clone();
    std::mem::swap(&mut run.from, &mut run.to);
    *pair = SeamPair {
        layered: pair.layered,
        ..seam(&pair.id, pair.a.runs()[0].clone(), run)
    };
}

#[test]
fn pleats_of_each_kind_are_sewn_without_a_word() {
    for pleated in [knife(), box_pleat(BOX), box_pleat(INVERTED)] {
        assert_silent(&checked(&pleated.pattern(), &pleated.seams()));
    }
}

#[test]
fn order_and_sides_of_the_list_change_nothing() {
    let pleated = knife();
    let mut pairs = pleated.seams();
    pairs.reverse();
    for pair in &mut pairs {
        std::mem::swap(&mut pair.a, &mut pair.b);
    }
    assert_silent(&checked(&pleated.pattern(), &pairs));
}

#[test]
fn first_ply_may_be_sewn_with_what_is_beside_it() {
    let mut pleated = knife();
    pleated.plies[0].1[1] += DEPTH;
    pleated.plies[0].2[1] += DEPTH;
    pleated.plies.remove(1);
    assert_silent(&checked(&pleated.pattern(), &pleated.seams()));
}

#[test]
fn whichever_plies_are_layered_the_fold_is_one() {
    for layered in [
        &["out", "back-out"][..],
        &["out", "under"],
        &["out", "under", "back-out"],
    ] {
        let pleated = Pleated { layered, ..knife() };
        assert_silent(&checked(&pleated.pattern(), &pleated.seams()));
    }
}

#[test]
fn band_of_nothing_but_pleats_is_no_twist() {
    let count = 6;
    let depth = BAND / f64::from(count);
    let names = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"];
    let mut plies = vec![];
    for pleat in 0..count {
        let at = f64::from(pleat);
        let [band, skirt] = [at * depth, 3.0 * at * depth];
        let base = [band, band + depth];
        let cloth = |from: f64, to: f64| [skirt + from * depth, skirt + to * depth];
        let name = |ply: usize| names[usize::try_from(pleat).unwrap() * 2 + ply];
        plies.push(("out", base, cloth(0.0, 1.0)));
        plies.push((name(0), base, cloth(2.0, 1.0)));
        plies.push((name(1), base, cloth(2.0, 3.0)));
    }
    let pleated = Pleated {
        plies,
        layered: &["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"],
        skirt_width: 3.0 * BAND,
    };
    let mut pairs = pleated.seams();
    for (number, pair) in pairs.iter_mut().enumerate() {
        pair.id = format!("{}-{number}", pair.id);
    }
    assert_silent(&checked(&pleated.pattern(), &pairs));
}

#[test]
fn fold_lines_may_be_corners_of_the_outline() {
    let pleated = knife();
    let width = pleated.skirt_width;
    let [x, d, top] = [0.15, DEPTH, 0.5];
    let corners = [
        [0.0, 0.0],
        [0.0, top],
        [x + d, top],
        [x + 2.0 * d, top],
        [width, top],
        [width, 0.0],
    ];
    let mut pairs = pleated.seams();
    let run = |edge, at| on("skirt-front", edge, at);
    let left = x / (x + d);
    let rest = d / (width - x - 2.0 * d);
    let sides = [
        ("left", run(1, [0.0, left])),
        ("out", run(1, [left, 1.0])),
        ("under", run(2, [1.0, 0.0])),
        ("back-out", run(3, [0.0, rest])),
        ("right", run(3, [rest, 1.0])),
    ];
    for (id, side) in sides {
        change(&mut pairs, id, |pair| {
            *pair = SeamPair {
                layered: pair.layered,
                ..seam(id, pair.a.runs()[0].clone(), side.clone())
            };
        });
    }
    let back = |panel: &str, from, to| seamster_fixtures::panels::run(panel, from, to);
    change(&mut pairs, "s1", |pair| {
        *pair = seam("s1", back("skirt-front", 5, 4), back("skirt-back", 0, 1));
    });
    let pattern = pleated.pattern_with(polygon("skirt-front", &corners));
    assert_silent(&checked(&pattern, &pairs));
}

#[test]
fn allowed_twist_of_a_fold_is_not_told_of() {
    let pleated = knife();
    let mut pairs = pleated.seams();
    change(&mut pairs, "under", |pair| pair.allow_twist = true);
    assert_silent(&checked(&pleated.pattern(), &pairs));
}

#[test]
fn plies_of_no_order_are_laid_to_a_fold() {
    let pleated = knife();
    for turned in [false, true] {
        let mut pairs = pleated.seams();
        for id in ["under", "back-out"] {
            change(&mut pairs, id, |pair| {
                if turned {
                    reverse(pair);
                }
                pair.matching = Match::Auto;
            });
        }
        let found = checked(&pleated.pattern(), &pairs);
        assert!(found.ok);
        let plies = found.seams.iter().filter(|seam| seam.id != "right");
        assert!(plies.filter(|seam| seam.reversed).count() == 2 * usize::from(turned));
        let codes: Vec<_> = said(&found).into_iter().map(|(_, code)| code).collect();
        assert_eq!(codes, vec!["seam/reversed"; 2 * usize::from(turned)]);
    }
}

#[test]
fn ply_that_welds_the_ends_of_its_stretch_is_warned_of() {
    let pleated = knife();
    let mut pairs = pleated.seams();
    change(&mut pairs, "under", reverse);
    let found = checked(&pleated.pattern(), &pairs);
    let expected = [("under".to_owned(), "seam/points_welded".to_owned())];
    assert_eq!(said(&found), expected);
    let detail = &found.seams[2].warnings[0].detail;
    assert!(detail.contains("60 mm apart"), "{detail}");
    let [corrected] = found.corrected.as_slice() else {
        panic!("{found:?}")
    };
    pairs[2] = corrected.clone();
    assert_silent(&checked(&pleated.pattern(), &pairs));
}

#[test]
fn ply_of_a_box_pleat_that_welds_is_warned_of() {
    for layered in [BOX, INVERTED] {
        let pleated = box_pleat(layered);
        let mut pairs = pleated.seams();
        change(&mut pairs, "under-r", reverse);
        let found = checked(&pleated.pattern(), &pairs);
        assert!(found.ok);
        let expected = [("under-r".to_owned(), "seam/points_welded".to_owned())];
        assert_eq!(said(&found), expected);
        for corrected in &found.corrected {
            change(&mut pairs, &corrected.id, |pair| *pair = corrected.clone());
        }
        assert_silent(&checked(&pleated.pattern(), &pairs));
    }
}

/// The halves of a cuff's edge change places on the hem, whose ends so become one point; not where
/// hem and cuff are rings anyway.
#[test]
fn halves_that_change_places_are_warned_of_unless_they_close_a_ring() {
    let panels = pattern(vec![
        rectangle("front", 0.4, 0.6),
        rectangle("cuff", 0.4, 0.1),
    ]);
    for edge in [1, 3] {
        let half = |id: &str, cuff: [f64; 2], hem: [f64; 2]| {
            let hem = hem.map(|x| 1.0 - x);
            seam(id, on("cuff", edge, cuff), on("front", 3, hem))
        };
        let mut pairs = vec![
            half("l", [0.0, 0.5], [0.5, 1.0]),
            half("r", [0.5, 1.0], [0.0, 0.5]),
        ];
        let found = checked(&panels, &pairs);
        let warnings: Vec<_> = found.seams.iter().flat_map(|seam| &seam.warnings).collect();
        let [warning] = warnings.as_slice() else {
            panic!("{found:?}")
        };
        assert_eq!(warning.code, "seam/points_welded");
        assert!(
            warning.detail.contains("400 mm apart"),
            "{}",
            warning.detail
        );
        pairs.push(seam("under", run("front", 0, 1), run("front", 3, 2)));
        pairs.push(seam("cuff", run("cuff", 0, 1), run("cuff", 3, 2)));
        assert_silent(&checked(&panels, &pairs));
    }
}

#[test]
fn reversed_seams_of_a_pleated_skirt_are_still_refused() {
    let pleated = knife();
    for id in ["left", "right", "out", "back-out", "back", "s1", "w2"] {
        let mut pairs = pleated.seams();
        change(&mut pairs, id, reverse);
        let found = checked(&pleated.pattern(), &pairs);
        let twisted = said(&found)
            .into_iter()
            .any(|(_, code)| code == "seam/twisted");
        assert!(twisted && !found.ok, "{id}");
    }
}

#[test]
fn layered_seam_of_another_edge_must_not_twist() {
    // A tape of which both long edges are sewn to one stretch of the band lies flat if they run
    // opposite ways; run alike it would be twisted.
    let panels = pattern(vec![
        rectangle("band", 0.4, 0.04),
        rectangle("tape", 0.4, 0.02),
    ]);
    let mut pairs = vec![
        seam("low", run("band", 0, 3), run("tape", 0, 3)),
        SeamPair {
            layered: true,
            ..seam("high", run("band", 0, 3), run("tape", 1, 2))
        },
    ];
    let found = checked(&panels, &pairs);
    assert_eq!(
        said(&found),
        [("high".to_owned(), "seam/twisted".to_owned())]
    );
    change(&mut pairs, "high", reverse);
    assert!(checked(&panels, &pairs).ok);
}
