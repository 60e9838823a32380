//! Suggestions for panels that go round the body by a hole: ring skirts, ponchos, round yokes and
//! flounces.

use super::drawn::{bodice, drawn, suggested};
use seamster::config::Limits;
use seamster::pattern::{OutlineRun, Panel, Place, PlacementAnchor, SeamPair, Wrap};
use seamster::seam::check;
use seamster::seam::suggest::Suggestion;
use seamster_fixtures::panels::{disc, mirrored, pattern, rectangle, with_round_hole};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// Radius of a circle that is so long \[m\].
fn radius(length: f64) -> f64 {
    length / TAU
}

/// A ring with a hole that is so long \[m\].
fn ring(id: &str, hole: f64, outer: f64) -> Panel {
    with_round_hole(disc(id, radius(outer)), [0.0; 2], radius(hole))
}

/// A band laid level: edges 1 and 3 are the long ones.
fn band(id: &str, length: f64) -> Panel {
    rectangle(id, length, 0.04)
}

/// Every seam as the panels and tracks of its sides, with their lengths to the millimeter.
fn told(panels: &[Panel], found: &Suggestion) -> BTreeSet<(String, String)> {
    let pairs: Vec<SeamPair> = found.seams.iter().map(|seam| seam.pair.clone()).collect();
    let whole = pattern(panels.to_vec());
    let (check, _) = check(&whole, &pairs, &BTreeMap::new(), 0.02, &Limits::default());
    assert!(check.ok, "{check:?}");
    let sides = pairs.iter().zip(&check.seams).map(|(pair, seam)| {
        let side = |runs: &[OutlineRun], length: f64| {
            let hole = match runs[0].from {
                Place::HoleCorner { .. } | Place::OnHoleEdge { .. } => " hole",
                _ => "",
            };
            format!("{}{hole} {:.0}", runs[0].panel, 1e3 * length)
        };
        let mut sides = [
            side(pair.a.runs(), seam.length_a_m),
            side(pair.b.runs(), seam.length_b_m),
        ];
        sides.sort();
        let [a, b] = sides;
        (a, b)
    });
    sides.collect()
}

fn assert_sewn(panels: Vec<Panel>, expected: &[(&str, &str)]) -> Suggestion {
    let found = suggested(panels.clone());
    let expected: BTreeSet<(String, String)> = expected
        .iter()
        .map(|(a, b)| ((*a).to_owned(), (*b).to_owned()))
        .collect();
    assert_eq!(told(&panels, &found), expected);
    assert!(found.seams.iter().all(|seam| seam.confidence >= 0.5));
    found
}

fn assert_level(found: &Suggestion, panel: &str, at: PlacementAnchor) {
    let placement = &found.panels[panel].placement;
    assert_eq!(
        (placement.at, placement.wrap),
        (Some(at), Some(Wrap::Level))
    );
}

#[test]
fn ring_skirt_is_sewn_to_its_band_by_the_hole() {
    for (skirt, waistband) in [
        ("skirt", "waistband"),
        ("SKIRT", "band"),
        ("1", "2"),
        ("A1", "B2"),
    ] {
        let hole = format!("{skirt} hole 740");
        let [long, end] = [740, 40].map(|length| format!("{waistband} {length}"));
        let panels = vec![ring(skirt, 0.74, 3.25), band(waistband, 0.74)];
        let found = assert_sewn(panels, &[(&hole, &long), (&end, &end)]);
        assert_level(&found, skirt, PlacementAnchor::Waist);
    }
}

#[test]
fn hem_that_is_as_long_as_the_band_is_left_open() {
    // Both loops fit the band in length, the hole as its waist.
    let found = suggested(vec![ring("skirt", 0.74, 0.80), band("waistband", 0.74)]);
    let panels = [ring("skirt", 0.74, 0.80), band("waistband", 0.74)];
    let expected = [
        ("skirt hole 740".to_owned(), "waistband 740".to_owned()),
        ("waistband 40".to_owned(), "waistband 40".to_owned()),
    ];
    assert_eq!(told(&panels, &found), BTreeSet::from(expected));
}

#[test]
fn band_of_two_halves_goes_round_the_hole() {
    let panels = vec![
        ring("skirt", 0.74, 3.25),
        band("waistband front", 0.37),
        band("waistband back", 0.37),
    ];
    let found = suggested(panels.clone());
    let told = told(&panels, &found);
    let ends = (
        "waistband back 40".to_owned(),
        "waistband front 40".to_owned(),
    );
    assert!(told.contains(&ends), "{told:?}");
    for half in ["front", "back"] {
        let to_hole = told.iter().any(|(a, b)| {
            a.starts_with("skirt hole") && b.starts_with(&format!("waistband {half}"))
        });
        assert!(to_hole, "{told:?}");
    }
}

#[test]
fn ring_without_anything_to_sew_is_not_sewn_to_itself() {
    for (name, at) in [
        ("skirt", PlacementAnchor::Waist),
        ("poncho", PlacementAnchor::Neck),
    ] {
        let found = suggested(vec![ring(name, 0.64, 3.25)]);
        assert_eq!(found.seams, []);
        assert_level(&found, name, at);
    }
    let square = rectangle("cloth", 1.0, 1.0);
    let found = suggested(vec![with_round_hole(square, [0.5, 0.5], 0.1)]);
    assert_eq!(found.seams, []);
    assert_level(&found, "cloth", PlacementAnchor::Neck);
}

#[test]
fn poncho_is_sewn_to_its_neck_band_or_collar() {
    let square = |id: &str| with_round_hole(rectangle(id, 1.0, 1.0), [0.5, 0.5], radius(0.6));
    for trim in ["neckband", "neck band", "band"] {
        let panels = vec![square("poncho"), band(trim, 0.6)];
        let [long, end] = [600, 40].map(|length| format!("{trim} {length}"));
        let mut seams = [(long.as_str(), "poncho hole 600"), (&end, &end)];
        if trim > "poncho" {
            seams[0] = (seams[0].1, seams[0].0);
        }
        let found = assert_sewn(panels, &seams);
        assert_level(&found, "poncho", PlacementAnchor::Neck);
        assert_eq!(found.panels[trim].placement.at, Some(PlacementAnchor::Neck));
    }
    let panels = vec![square("poncho"), band("collar", 0.58)];
    let found = suggested(panels.clone());
    let collar = ("collar 580".to_owned(), "poncho hole 600".to_owned());
    assert!(told(&panels, &found).contains(&collar));
}

#[test]
fn flounce_goes_round_the_outline_of_a_ring_skirt() {
    let panels = vec![
        ring("skirt", 0.74, 2.0),
        band("waistband", 0.74),
        ring("flounce", 2.0, 3.0),
    ];
    let found = suggested(panels.clone());
    let told = told(&panels, &found);
    assert!(told.contains(&("skirt hole 740".to_owned(), "waistband 740".to_owned())));
    let flounce: Vec<_> = told
        .iter()
        .filter(|(a, _)| a.starts_with("flounce"))
        .collect();
    assert!(!flounce.is_empty());
    for (a, b) in flounce {
        assert!(
            a.starts_with("flounce hole") && b.starts_with("skirt "),
            "{a} {b}"
        );
        assert!(!b.starts_with("skirt hole"), "{b}");
    }
}

#[test]
fn flounce_goes_round_the_hem_of_a_skirt_of_two_panels() {
    let panels = vec![
        rectangle("skirt front", 0.5, 0.5),
        rectangle("skirt back", 0.5, 0.5),
        ring("flounce", 1.0, 2.0),
    ];
    let found = suggested(panels.clone());
    let told = told(&panels, &found);
    for half in ["front", "back"] {
        let hem = told
            .iter()
            .any(|(a, b)| a.starts_with("flounce hole") && b.starts_with(&format!("skirt {half}")));
        assert!(hem, "{told:?}");
    }
    let placement = &found.panels["flounce"].placement;
    assert_eq!(placement.wrap, Some(Wrap::Level));
    assert!((placement.offset_m[1] + 0.5).abs() < 1e-3, "{placement:?}");
}

#[test]
fn ring_skirt_hangs_from_the_hem_of_a_bodice() {
    let halves = |id: &str, neck| {
        let half = bodice(id, neck);
        vec![half.clone(), mirrored(&half)]
    };
    let mut panels = [halves("front", 0.09), halves("back", 0.02)].concat();
    panels.push(ring("skirt", 1.04, 3.4));
    let found = suggested(panels.clone());
    let told = told(&panels, &found);
    let hem = told.iter().filter(|(_, b)| b.starts_with("skirt hole"));
    let to: BTreeSet<&str> = hem
        .map(|(a, _)| a.split(['~', ' ']).next().unwrap())
        .collect();
    assert_eq!(to, BTreeSet::from(["back", "front"]), "{told:?}");
    let placement = &found.panels["skirt"].placement;
    assert_eq!(placement.at, Some(PlacementAnchor::TorsoFront));
    assert!((placement.offset_m[1] + 0.64).abs() < 1e-3, "{placement:?}");
    let own = told
        .iter()
        .any(|(a, b)| a.starts_with("skirt") && b.starts_with("skirt"));
    assert!(!own, "{told:?}");
}

#[test]
fn round_yoke_fills_the_neck_and_has_a_band_in_its_hole() {
    // Front and back end at a wide neck, an arc of half of the yoke's outline.
    let body = |id: &str| {
        let arc = |from: f64, to: f64| -> Vec<[f64; 2]> {
            let point = |i: i32| {
                let at = from + (to - from) * f64::from(i) / 24.0;
                let (sin, cos) = at.to_radians().sin_cos();
                [0.15 * cos, 0.65 - 0.15 * sin]
            };
            (0..24).map(point).collect()
        };
        drawn(
            id,
            &[
                &[[-0.26, 0.0]],
                &[[-0.26, 0.40], [-0.23, 0.43], [-0.22, 0.50]],
                &[[-0.22, 0.62]],
                &arc(180.0, 0.0),
                &[[0.15, 0.65]],
                &[[0.22, 0.62], [0.22, 0.50], [0.23, 0.43]],
                &[[0.26, 0.40]],
                &[[0.26, 0.0]],
            ],
        )
    };
    let panels = vec![
        body("front"),
        body("back"),
        ring("yoke", 0.56, TAU * 0.15),
        band("neckband", 0.54),
    ];
    let found = suggested(panels.clone());
    let told = told(&panels, &found);
    assert!(
        told.contains(&("neckband 540".to_owned(), "yoke hole 560".to_owned())),
        "{told:?}"
    );
    for half in ["front", "back"] {
        let outline = told
            .iter()
            .any(|(a, b)| a.starts_with(half) && b.starts_with("yoke 4"));
        assert!(outline, "{told:?}");
    }
}

#[test]
fn small_holes_are_no_openings() {
    let keyhole = |id: &str| with_round_hole(rectangle(id, 0.5, 0.6), [0.25, 0.5], 0.03);
    let found = suggested(vec![keyhole("skirt front"), keyhole("skirt back")]);
    let told = told(&[keyhole("skirt front"), keyhole("skirt back")], &found);
    assert!(
        told.iter()
            .all(|(a, b)| !a.contains("hole") && !b.contains("hole"))
    );
    assert_eq!(told.len(), 1, "two sides alike: {told:?}");
}

/// A sector of a ring, its waist up: edges are the waist, the right side, the hem and the left one.
fn sector(id: &str, degrees: f64, [waist, hem]: [f64; 2]) -> Panel {
    let at = |radius: f64, i: i32| {
        let angle = (-90.0 + degrees * (f64::from(i) / 48.0 - 0.5)).to_radians();
        [radius * angle.cos(), radius * angle.sin()]
    };
    let arc = |radius: f64| (0..48).map(move |i| at(radius, i)).collect::<Vec<_>>();
    let back = |radius: f64| {
        (1..=48)
            .rev()
            .map(move |i| at(radius, i))
            .collect::<Vec<_>>()
    };
    let end = |radius: f64, i: i32| vec![at(radius, i)];
    let sides = [arc(waist), end(waist, 48), back(hem), end(hem, 0)];
    let edges: Vec<&[[f64; 2]]> = sides.iter().map(Vec::as_slice).collect();
    drawn(id, &edges)
}

#[test]
fn sectors_of_a_ring_make_a_skirt() {
    let radii = [radius(0.74), radius(0.74) + 0.5];
    for names in [
        &["skirt front", "skirt back"][..],
        &["skirt 1", "skirt 2"],
        &["skirt 1", "skirt 2", "skirt 3", "skirt 4"],
    ] {
        let degrees = if names.len() == 2 { 180.0 } else { 90.0 };
        let sectors = names.iter().map(|name| sector(name, degrees, radii));
        let panels: Vec<Panel> = sectors.chain([band("waistband", 0.74)]).collect();
        let found = suggested(panels.clone());
        let seams = || found.seams.iter().map(|seam| seam.pair.clone());
        let at_waist = |pair: &SeamPair| pair.b.runs()[0].panel == "waistband";
        let sides = seams().filter(|pair| !at_waist(pair)).count();
        let waist: BTreeSet<String> = seams()
            .filter(at_waist)
            .flat_map(|pair| pair.a.runs().to_vec())
            .map(|run| run.panel)
            .filter(|panel| panel != "waistband")
            .collect();
        assert_eq!(
            (sides, waist.len()),
            (names.len(), names.len()),
            "{:?}",
            told(&panels, &found)
        );
        assert!(found.seams.iter().all(|seam| seam.confidence >= 0.5));
    }
}
