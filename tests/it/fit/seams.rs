//! Seams of whole garments: as JSON, as a fit prepares them, sewn.

use super::sewn;
use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::fit::{self, Garment, PatternRef, ShippedAssets};
use seamster::pattern::{Face, OutlineRun, Pattern, Place, SeamPair};
use seamster_fixtures::panels::{
    many, pattern, polygon, rectangle, run, seam, with_hole, with_line,
};
use serde_json::{Value, json};

/// A garment without a body, hung up by these corners.
fn garment(pattern: Pattern, pairs: &[SeamPair], more: &Value) -> Garment {
    let mut asked = json!({"seams": pairs, "avatar": null, "simulate": {"edge_length_m": 0.03}});
    let fields = asked.as_object_mut().expect("made as an object");
    fields.extend(more.as_object().expect("an object").clone());
    Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        ..serde_json::from_value(asked).expect("a garment")
    }
}

fn warnings(garment: Garment) -> Vec<(String, String)> {
    let prepared =
        fit::resolve(garment, &ShippedAssets, &Limits::default()).expect("it can be sewn");
    let warnings = prepared.warnings().iter();
    warnings
        .map(|w| (w.code.to_string(), w.pointer.clone()))
        .collect()
}

fn front_and_back() -> Pattern {
    pattern(vec![
        rectangle("front", 0.5, 0.6),
        rectangle("back", 0.5, 0.6),
    ])
}

#[test]
fn places_on_holes_and_lines_are_read_and_others_refused() {
    let with = |place: Value| -> Result<Garment, Faults> {
        let run = json!({"panel": "front", "from": place, "to": 1});
        let seams = json!([{"id": "s", "a": run, "b": {"panel": "back", "from": 0, "to": 1}}]);
        let bytes = serde_json::to_vec(&json!({ "seams": seams })).expect("JSON");
        fit::read_garment(&bytes, &Limits::default()).map_err(Faults::from)
    };
    for right in [
        json!(3),
        json!({"edge": 1, "at": 0.5}),
        json!({"notch": 2}),
        json!({"hole": 0, "corner": 2}),
        json!({"hole": 0, "edge": 1, "at": 0.5}),
        json!({"line": 1, "at": 0.25}),
    ] {
        assert!(with(right.clone()).is_ok(), "{right}");
    }
    for wrong in [
        json!({"hole": 0}),
        json!({"hole": 0, "edge": 1}),
        json!({"hole": 0, "corner": 1, "at": 0.5}),
        json!({"line": 1, "at": 0.25, "edge": 0}),
        json!({"line": -1, "at": 0.25}),
        json!({"line": 1}),
    ] {
        let faults = with(wrong.clone()).expect_err("no place");
        let at = "/seams/0/a/from";
        assert!(
            faults.0.iter().all(|f| f.pointer.starts_with(at)),
            "{faults}"
        );
    }
}

#[test]
fn reversed_bridge_is_warned_of_when_a_fit_is_prepared() {
    // Both panels as seen from their outer side.
    let right = seam("side", run("front", 3, 2), run("back", 0, 1));
    let wrong = seam("side", run("front", 3, 2), run("back", 1, 0));
    let warned = |pair: &SeamPair| {
        let pairs = std::slice::from_ref(pair);
        warnings(garment(front_and_back(), pairs, &json!({})))
    };
    assert_eq!(warned(&right), []);
    let likely = ("seam/likely_reversed".to_owned(), "/seams/0/b".to_owned());
    assert_eq!(warned(&wrong), std::slice::from_ref(&likely));
    // A garment that puts its panels itself is judged by that: the back is shifted up and turned by
    // hand.
    let place = |turn: f64, z: f64| json!({"at": "origin", "offset_m": [0.0, 1.0, z], "rotate_deg": [0.0, 0.0, turn]});
    let panels = |turn: f64| json!({"panels": {"front": {"placement": place(0.0, 0.2)}, "back": {"placement": place(turn, -0.2)}}});
    let placed = |turn| {
        warnings(garment(
            front_and_back(),
            std::slice::from_ref(&right),
            &panels(turn),
        ))
    };
    assert_eq!(placed(0.0), []);
    assert_eq!(placed(180.0), [likely]);
}

#[test]
fn warnings_of_seams_are_in_the_report() {
    let wrong = seam("side", run("front", 3, 2), run("back", 1, 0));
    let pins = json!({"pins": [{"panel": "front", "corner": 1}, {"panel": "front", "corner": 2}],
        "simulate": {"edge_length_m": 0.1, "time_limit_s": 0.0}});
    let outcome = sewn(garment(front_and_back(), &[wrong], &pins));
    let codes: Vec<_> = outcome.report.warnings.iter().map(|w| &w.code).collect();
    assert_eq!(codes, ["seam/likely_reversed"]);
}

#[test]
fn pocket_on_a_line_and_mirrored_sleeves_in_holes_are_sewn_shut() {
    // A tabard: one panel with a hole at either side, a pocket on its front and the same sleeve
    // twice.
    let square = |x: f64| [[x, 0.3], [x + 0.1, 0.3], [x + 0.1, 0.4], [x, 0.4]];
    let front = with_hole(rectangle("front", 0.6, 0.5), &square(0.45));
    let front = with_hole(front, &square(0.05));
    let line = [[0.24, 0.2], [0.24, 0.08], [0.36, 0.08], [0.36, 0.2]];
    let front = with_line(front, &line);
    let sleeve = polygon("sleeve", &[[0.0, 0.0], [0.0, 0.2], [0.4, 0.2], [0.4, 0.0]]);
    let pattern = pattern(vec![front, sleeve, rectangle("pocket", 0.12, 0.12)]);
    let all_round = |hole, way| {
        let place = Place::HoleCorner { hole, corner: 0 };
        OutlineRun {
            panel: "front".to_owned(),
            from: place,
            to: place,
            direction: Some(way),
        }
    };
    use seamster::pattern::Direction::{Ccw, Cw};
    let place = |at| Place::OnLine { line: 0, at };
    let on_line = OutlineRun {
        panel: "front".to_owned(),
        from: place(0.0),
        to: place(1.0),
        direction: None,
    };
    let sides = [[1, 0], [0, 3], [3, 2]].map(|[a, b]| run("pocket", a, b));
    let pairs = [
        seam("armhole-l", run("sleeve", 1, 2), all_round(0, Ccw)),
        seam("under-l", run("sleeve", 0, 1), run("sleeve", 3, 2)),
        seam("armhole-r", run("sleeve~mirror", 1, 2), all_round(1, Cw)),
        seam(
            "under-r",
            run("sleeve~mirror", 0, 1),
            run("sleeve~mirror", 3, 2),
        ),
        many("pocket", sides.to_vec(), vec![on_line]),
    ];
    let place = |x: f64, z: f64| json!({"placement": {"at": "origin", "offset_m": [x, 1.0, z]}});
    let more = json!({
        "pins": [{"panel": "front", "corner": 1}, {"panel": "front", "corner": 2}],
        "panels": {"front": place(0.0, 0.0), "sleeve": place(0.3, -0.05), "pocket": place(0.0, 0.02)},
    });
    let outcome = sewn(garment(pattern, &pairs, &more));
    let report = &outcome.report;
    assert!(report.converged, "{}", report.why);
    assert!(report.seam_gap_max_m < 1e-3, "{}", report.seam_gap_max_m);
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    assert_eq!(outcome.mesh.panels.len(), 4);
}

#[test]
fn faces_of_a_file_yield_to_its_seams_and_those_of_a_garment_do_not() {
    let mut pattern = front_and_back();
    for panel in &mut pattern.panels {
        panel.face = Some(Face::Up);
    }
    // The right edges of both, upwards: one of the two is seen from inside.
    let pairs = [seam("side", run("front", 3, 2), run("back", 3, 2))];
    let told = ("seam/file_faces".to_owned(), "/panels".to_owned());
    let asked = garment(pattern.clone(), &pairs, &json!({}));
    assert!(warnings(asked).contains(&told));
    let faces = json!({"panels": {"front": {"face": "up"}, "back": {"face": "up"}}});
    let asked = garment(pattern, &pairs, &faces);
    let faults = fit::resolve(asked, &ShippedAssets, &Limits::default()).expect_err("a twist");
    assert!(
        faults.0.iter().all(|f| f.code == "seam/twisted"),
        "{faults}"
    );
}
