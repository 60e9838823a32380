//! Patterns written as GarmentCode specifications and imported again: the same panels, stitches and
//! placements; what the format has no place for is told.

use seamster::config::Limits;
use seamster::export::pattern_specification;
use seamster::pattern::{
    Face, Grain, ImportOptions, Match, Pattern, Placement, PlacementAnchor, Point2, import,
};
use seamster_fixtures::panels::{lens, pattern, rectangle, run, seam};
use seamster_fixtures::same::{SAME, differences};
use seamster_fixtures::truth;
use serde_json::{Value, json};

fn imported(bytes: &[u8], name: &str) -> Pattern {
    let options = ImportOptions {
        name: Some(name.to_owned()),
        ..ImportOptions::default()
    };
    import(bytes, &options, &Limits::default()).expect("a pattern")
}

/// The pattern written and imported again, under its own name.
fn round_trip(pattern: &Pattern) -> (Vec<String>, Pattern) {
    let file = pattern_specification(pattern);
    let again = imported(file.text.as_bytes(), &pattern.name);
    (file.left_out, again)
}

/// Places differ by less than 1e-6 m and degrees.
fn is_placed_alike(a: &Placement, b: &Placement) -> bool {
    let numbers = |p: &Placement| [p.offset_m, p.rotate_deg].concat();
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME;
    (a.at, a.wrap, a.up_deg) == (b.at, b.wrap, b.up_deg)
        && numbers(a).iter().zip(&numbers(b)).all(is_near)
}

/// Differences of all that a specification says.
fn all_differences(a: &Pattern, b: &Pattern) -> Vec<String> {
    let mut found = differences(a, b);
    let placed = a.placements.iter().zip(&b.placements);
    let are_placed_alike = a.placements.len() == b.placements.len() && { placed }
        .all(|(a, b)| a.0 == b.0 && is_placed_alike(a.1, b.1));
    let facts = [
        ("seams", a.seams == b.seams),
        ("placements", are_placed_alike),
        ("source", a.source == b.source),
        ("warnings", b.warnings.is_empty()),
    ];
    let wrong = facts.iter().filter(|(_, is_same)| !is_same);
    found.extend(wrong.map(|(what, _)| (*what).to_owned()));
    found
}

#[test]
fn specifications_come_back_the_same() {
    let Some(data) = truth::data() else {
        println!("left out: round trips of 5 specifications (SEAMSTER_TEST_DATA is unset)");
        return;
    };
    let mut count = 0;
    let mut wrong = Vec::new();
    for entry in std::fs::read_dir(data.join("dxf")).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let Some(name) = name.strip_suffix("_specification") else {
            continue;
        };
        let pattern = imported(&std::fs::read(&path).expect("a file"), name);
        let (left_out, again) = round_trip(&pattern);
        let found = left_out
            .into_iter()
            .chain(all_differences(&pattern, &again));
        wrong.extend(found.map(|what| format!("{name}: {what}")));
        count += 1;
    }
    assert_eq!(count, 5);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Two panels with a curve of every kind, drawn one way and the other, stitched both ways.
fn drafted() -> Value {
    let third = 1.0 / 3.0;
    let panel = |turn: f64, clockwise: bool| {
        let vertices = if clockwise {
            json!([[3, 1], [3, 31], [33, 31], [33, 1]])
        } else {
            json!([[3, 1], [33, 1], [33, 31], [3, 31]])
        };
        json!({
            "translation": [1, 120, -25], "rotation": [20, turn, 45], "label": "body",
            "vertices": vertices,
            "edges": [
                {"endpoints": [0, 1], "curvature": {"type": "quadratic", "params": [[0.4, 0.2]]}, "label": "hem"},
                {"endpoints": [1, 2], "curvature": {"type": "cubic", "params": [[third, 0.2], [0.8, -0.1]]}},
                {"endpoints": [2, 3], "curvature": {"type": "circle", "params": [20, 0, 0]}},
                {"endpoints": [3, 0]}
            ]
        })
    };
    let edge = |panel: &str, edge: usize| json!({"panel": panel, "edge": edge});
    json!({
        "pattern": {
            "panels": {"Front": panel(-70.0, false), "back": panel(110.0, true)},
            "stitches": [
                [edge("Front", 3), edge("back", 3)],
                [edge("Front", 0), edge("back", 0), "right_wrong"],
                [edge("back", 1), edge("Front", 1)],
            ]
        },
        "properties": {"curvature_coords": "relative", "normalized_edge_loops": true, "units_in_meter": 100}
    })
}

#[test]
fn curves_faces_labels_stitches_and_placements_come_back() {
    let file = serde_json::to_vec(&drafted()).expect("JSON");
    let pattern = imported(&file, "draft");
    let faces: Vec<_> = pattern.panels.iter().map(|panel| panel.face).collect();
    assert_eq!(faces, [Some(Face::Up), Some(Face::Down)]);
    let (left_out, again) = round_trip(&pattern);
    assert_eq!(left_out, Vec::<String>::new());
    assert_eq!(all_differences(&pattern, &again), Vec::<String>::new());
    let written: Value = serde_json::from_str(&pattern_specification(&pattern).text).expect("JSON");
    let panels = &written["pattern"]["panels"];
    for (i, kind) in ["quadratic", "cubic", "circle"].iter().enumerate() {
        assert_eq!(panels["Front"]["edges"][i]["curvature"]["type"], **kind);
    }
    let control = &panels["Front"]["edges"][0]["curvature"]["params"][0];
    let near = |found: &Value, wanted: f64| {
        assert!(
            (found.as_f64().expect("a number") - wanted).abs() < 1e-8,
            "{found} {wanted}"
        );
    };
    near(&control[0], 0.4);
    near(&control[1], 0.2);
    assert_eq!(written["pattern"]["stitches"][1][2], "right_wrong");
    assert_eq!(written["pattern"]["panel_order"], json!(["Front", "back"]));
}

#[test]
fn curves_of_other_files_are_followed_within_a_twentieth_of_a_millimeter() {
    let mut panel = lens("gusset", 0.2, 0.03, 40);
    panel.grain = Some(Grain { angle_deg: 90.0 });
    let pattern = pattern(vec![panel, rectangle("band", 0.3, 0.05)]);
    let (left_out, again) = round_trip(&pattern);
    assert!(
        left_out.iter().any(|said| said == "1 grain line"),
        "{left_out:?}"
    );
    for (a, b) in pattern.panels.iter().zip(&again.panels) {
        assert_eq!((&a.id, a.edges.len()), (&b.id, b.edges.len()));
        assert!((a.perimeter_m - b.perimeter_m).abs() < 1e-4);
        assert!((a.area_m2 - b.area_m2).abs() < 5e-5 * a.perimeter_m);
        for (edge, again) in a.edges.iter().zip(&b.edges) {
            for points in [&edge.points, &again.points].map(|points| points.windows(2)) {
                for ends in points {
                    for at in [ends[0], middle(ends[0], ends[1])] {
                        let off =
                            distance_from(at, &edge.points).max(distance_from(at, &again.points));
                        assert!(off < 5e-5, "{off}");
                    }
                }
            }
        }
    }
}

fn middle(a: Point2, b: Point2) -> Point2 {
    [0, 1].map(|k| f64::midpoint(a[k], b[k]))
}

/// Returns the distance of a point from a polyline \[m\].
fn distance_from(p: Point2, line: &[Point2]) -> f64 {
    let of_chord = |ends: &[Point2]| {
        let way = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
        let off = [p[0] - ends[0][0], p[1] - ends[0][1]];
        let t = (way[0] * off[0] + way[1] * off[1]) / (way[0] * way[0] + way[1] * way[1]);
        let t = t.clamp(0.0, 1.0);
        (off[0] - t * way[0]).hypot(off[1] - t * way[1])
    };
    line.windows(2).map(of_chord).fold(f64::INFINITY, f64::min)
}

#[test]
fn gathers_that_the_lengths_do_not_say_are_told() {
    let mut pattern = pattern(vec![rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4)]);
    pattern.seams = vec![seam("stitch-0", run("a", 0, 1), run("b", 3, 2))];
    assert_eq!(round_trip(&pattern).0, Vec::<String>::new());
    pattern.seams[0].gather = true;
    let (left_out, again) = round_trip(&pattern);
    assert!(left_out.len() == 1 && left_out[0].starts_with("1 seam is gathered"));
    assert!(!again.seams[0].gather);
}

#[test]
fn what_is_no_stitch_and_what_stands_about_a_body_is_told() {
    let mut pattern = pattern(vec![rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4)]);
    let mut auto = seam("auto", run("a", 0, 1), run("b", 3, 2));
    auto.matching = Match::Auto;
    pattern.seams = vec![
        seam("side", run("a", 0, 1), run("b", 3, 2)),
        seam("two edges", run("a", 0, 2), run("b", 3, 2)),
        auto,
    ];
    let torso = Placement {
        at: Some(PlacementAnchor::TorsoFront),
        ..Placement::default()
    };
    pattern.placements.insert("a".to_owned(), torso);
    let (left_out, again) = round_trip(&pattern);
    assert_eq!(left_out.len(), 3, "{left_out:?}");
    assert_eq!(left_out[2], "1 id of a seam: stitches are numbered");
    assert!(left_out[0].starts_with("2 seams") && left_out[1].starts_with("1 placement is"));
    assert_eq!((again.seams.len(), again.placements.len()), (1, 0));
    let runs =
        |seam: &seamster::pattern::SeamPair| [seam.a.runs()[0].clone(), seam.b.runs()[0].clone()];
    let [a, b] = runs(&again.seams[0]);
    let ends = |run: &seamster::pattern::OutlineRun| (run.from, run.to);
    let [first, second] = runs(&pattern.seams[0]);
    let forth = [ends(&a), ends(&b)] == [ends(&first), ends(&second)];
    let turned = [(a.to, a.from), (b.to, b.from)] == [ends(&first), ends(&second)];
    assert!(forth || turned, "{a:?} {b:?}");
}

#[test]
fn panels_of_one_name_and_mirrored_copies_are_told_apart() {
    let mut twins = pattern(vec![rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4)]);
    for panel in &mut twins.panels {
        panel.name = "Detail".to_owned();
    }
    let (left_out, again) = round_trip(&twins);
    assert!(left_out.iter().any(|said| said.contains("other names")));
    assert_eq!(again.panels[1].id, "b");
    let whole = pattern(vec![rectangle("sleeve", 0.3, 0.4)]);
    let whole = whole.with_copies(["sleeve~mirror"]).into_owned();
    let (left_out, again) = round_trip(&whole);
    assert!(left_out.iter().any(|said| said.contains("mirrored cop")));
    assert_eq!(again.panels[1].id, "sleeve_mirror");
}
