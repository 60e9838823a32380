//! Import of DXF: what a pattern holds of a file that was written here, the real files against the
//! truth that lies beside them, and the hostile ones against what they must give. The data is found
//! by `SEAMSTER_TEST_DATA`.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::job::thread_cpu_s;
use seamster::pattern::{
    Allowance, Edge, ImportOptions, NotchKind, Panel, Pattern, PatternFormat, Units, checked,
    import,
};
use seamster_fixtures::dxf::DxfBuilder;
use serde_json::Value;
use std::path::{Path, PathBuf};

// ---- Files written here ----

fn imported(file: DxfBuilder) -> Pattern {
    imported_with(file, &ImportOptions::default())
}

fn imported_with(file: DxfBuilder, options: &ImportOptions) -> Pattern {
    import(&file.bytes(), options, &Limits::default()).expect("a file that can be read")
}

fn refused(file: DxfBuilder) -> Faults {
    import(&file.bytes(), &ImportOptions::default(), &Limits::default())
        .expect_err("a file that cannot be read")
}

/// A piece of 300 by 400 mm in four runs, its turn points at the corners.
fn rectangle(file: DxfBuilder, name: &str) -> DxfBuilder {
    let corners = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];
    let mut file = file.block(name).text("1", &format!("Piece Name: {name}"));
    for i in 0..4 {
        file = file
            .run("1", false, &[corners[i], corners[(i + 1) % 4]])
            .point("2", corners[i]);
    }
    file
}

/// A closed run.
fn closed(file: DxfBuilder, layer: &str, points: &[[f64; 2]]) -> DxfBuilder {
    file.run(layer, true, points)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-12
}

fn codes(pattern: &Pattern) -> Vec<&str> {
    pattern.warnings.iter().map(|w| w.code.as_str()).collect()
}

#[test]
fn piece_becomes_a_clockwise_panel_in_meters() {
    let file = rectangle(DxfBuilder::metric(), "FRONT")
        .text("1", "Quantity: 1,1")
        .point("80", [100.0, 400.0])
        .point("13", [50.0, 50.0])
        .line("7", [100.0, 100.0], [100.0, 300.0])
        .line("8", [0.0, 200.0], [300.0, 200.0])
        .run(
            "84",
            true,
            &[[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]],
        )
        .run(
            "11",
            true,
            &[
                [200.0, 200.0],
                [250.0, 200.0],
                [250.0, 250.0],
                [200.0, 250.0],
            ],
        );
    let pattern = imported(file);
    assert_eq!(pattern.warnings, []);
    assert_eq!(pattern.source.format, PatternFormat::DxfAstm);
    let panel = &pattern.panels[0];
    assert_eq!((panel.id.as_str(), panel.name.as_str()), ("front", "FRONT"));
    assert!(
        close(panel.area_m2, 0.12 - 0.0025)
            && close(panel.drawn_area_m2, 0.12)
            && close(panel.perimeter_m, 1.4)
    );
    let corners: Vec<_> = panel.corners.iter().map(|c| [c.x, c.y]).collect();
    assert_eq!(corners, [[0.0, 0.0], [0.0, 0.4], [0.3, 0.4], [0.3, 0.0]]);
    assert_eq!(panel.quantity.map(|q| (q.left, q.right)), Some((1, 1)));
    let notch = panel.notches[0];
    assert_eq!((notch.edge, notch.kind), (1, NotchKind::T));
    assert!(close(notch.at, 1.0 / 3.0));
    assert_eq!(panel.drill_holes, [[0.05, 0.05]]);
    assert_eq!(panel.grain.map(|g| g.angle_deg), Some(90.0));
    assert_eq!(panel.internal_lines, [[[0.0, 0.2], [0.3, 0.2]]]);
    assert!(signed_area(&panel.holes[0].edges) > 0.0 && signed_area(&panel.edges) < 0.0);
}

#[test]
fn half_piece_is_unfolded() {
    let file = rectangle(DxfBuilder::metric(), "BACK")
        .line("6", [0.0, 0.0], [0.0, 400.0])
        .point("4", [300.0, 100.0])
        .point("4", [0.0, 400.0]);
    let panel = &imported(file).panels[0];
    assert!(panel.unfolded);
    assert!(close(panel.area_m2, 0.24) && close(panel.drawn_area_m2, 0.12));
    assert_eq!(
        panel.corners.len(),
        4,
        "hem and top run straight over the fold"
    );
    assert_eq!(panel.notches.len(), 3, "the notch on the fold stays single");
}

#[test]
fn sew_line_becomes_the_outline() {
    let sewn = [[10.0, 10.0], [290.0, 10.0], [290.0, 390.0], [10.0, 390.0]];
    for layer in ["14", "8"] {
        let pattern = imported(closed(
            rectangle(DxfBuilder::metric(), "FRONT"),
            layer,
            &sewn,
        ));
        let panel = &pattern.panels[0];
        assert_eq!(pattern.source.allowance, Allowance::SewLine);
        assert!(close(panel.area_m2, 0.28 * 0.38) && close(panel.drawn_area_m2, 0.12));
        assert_eq!(panel.cut_line.len(), 4);
    }
}

#[test]
fn blocks_of_one_name_are_different_pieces() {
    let small = [[0.0, 0.0], [100.0, 0.0], [0.0, 90.0]];
    let file = closed(
        rectangle(DxfBuilder::metric(), "DETAIL").block("DETAIL"),
        "1",
        &small,
    );
    let pattern = imported(file);
    let found: Vec<_> = pattern
        .panels
        .iter()
        .map(|p| (p.id.as_str(), (1e6 * p.area_m2).round()))
        .collect();
    assert_eq!(found, [("detail", 120_000.0), ("detail-2", 4500.0)]);
}

#[test]
fn sample_size_is_imported_unless_another_is_asked_for() {
    let graded = || {
        let mut file = DxfBuilder::metric().text("1", "Sample Size: M");
        for (size, w) in [("S", 280.0), ("M", 300.0), ("L", 320.0)] {
            file = file
                .block(&format!("FRONT_{size}"))
                .text("1", "Piece Name: FRONT")
                .text("1", &format!("SIZE: {size}"));
            file = closed(file, "1", &[[0.0, 0.0], [w, 0.0], [w, 400.0], [0.0, 400.0]]);
        }
        file
    };
    let sample = imported(graded());
    assert_eq!(sample.source.sizes, ["S", "M", "L"]);
    assert_eq!(sample.source.sample_size.as_deref(), Some("M"));
    assert!(sample.panels.len() == 1 && close(sample.panels[0].area_m2, 0.12));
    let large = imported_with(
        graded(),
        &ImportOptions {
            size: Some("l".into()),
            ..ImportOptions::default()
        },
    );
    assert!(close(large.panels[0].area_m2, 0.128));
    let unknown = ImportOptions {
        size: Some("XL".into()),
        ..ImportOptions::default()
    };
    let faults = import(&graded().bytes(), &unknown, &Limits::default()).expect_err("no such size");
    assert_eq!(faults.0[0].code, "pattern/unknown_size");
    assert!(
        faults.0[0]
            .fix
            .as_deref()
            .is_some_and(|fix| fix.contains("S, M, L"))
    );
}

#[test]
fn units_are_overridden_by_the_caller() {
    let options = ImportOptions {
        units: Some(Units::Inch),
        ..ImportOptions::default()
    };
    let tenth = closed(
        DxfBuilder::metric().block("CUFF"),
        "1",
        &[[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [0.0, 4.0]],
    );
    let pattern = imported_with(tenth, &options);
    assert!(close(pattern.panels[0].area_m2, 40.0 * 0.0254 * 0.0254));
    assert_eq!(
        (pattern.source.units.as_str(), pattern.source.scale_to_m),
        ("inch", 0.0254)
    );
}

#[test]
fn centimeters_that_are_said_to_be_millimeters_are_warned_about() {
    let file = closed(
        DxfBuilder::metric().block("FRONT"),
        "1",
        &[[0.0, 0.0], [30.0, 0.0], [30.0, 40.0], [0.0, 40.0]],
    );
    let pattern = imported(file);
    let warning = pattern
        .warnings
        .iter()
        .find(|w| w.code == "pattern/units_implausible")
        .expect("a warning");
    assert!(warning.detail.contains("units=cm"), "{}", warning.detail);
}

#[test]
fn order_of_runs_does_not_matter() {
    let corners = [[0.0, 0.0], [300.0, 0.0], [310.0, 400.0], [0.0, 390.0]];
    let run = |file: DxfBuilder, i: usize, back: bool| {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        file.run("1", false, &if back { [b, a] } else { [a, b] })
    };
    let area = |order: [(usize, bool); 4]| {
        let file = order
            .into_iter()
            .fold(DxfBuilder::metric().block("FRONT"), |file, (i, back)| {
                run(file, i, back)
            });
        imported(file).panels[0].area_m2
    };
    let in_order = area([(0, false), (1, false), (2, false), (3, false)]);
    assert!(close(
        area([(2, true), (0, false), (3, true), (1, false)]),
        in_order
    ));
}

#[test]
fn all_open_outlines_are_named_at_once() {
    let file = DxfBuilder::metric()
        .block("FRONT")
        .run("1", false, &[[0.0, 0.0], [300.0, 0.0], [300.0, 400.0]])
        .block("BACK")
        .run("1", false, &[[0.0, 0.0], [300.0, 0.0], [300.0, 500.0]]);
    let faults = refused(file);
    let open: Vec<_> = faults
        .0
        .iter()
        .filter(|f| f.code == "pattern/open_outline")
        .collect();
    assert_eq!(open.len(), 2, "{faults}");
    assert!(
        open[0].detail.contains("FRONT") && open[0].detail.contains("500.00 mm"),
        "{}",
        open[0].detail
    );
    assert!(
        open.iter()
            .all(|f| f.pointer.starts_with("line ") && f.fix.is_some())
    );
}

#[test]
fn what_is_left_out_is_said() {
    let file = rectangle(DxfBuilder::metric(), "FRONT")
        .tag(0, "HATCH")
        .tag(8, "1")
        .tag(0, "HATCH")
        .tag(8, "1");
    let pattern = imported(file);
    assert_eq!(codes(&pattern), ["pattern/entity_ignored"]);
    assert!(pattern.warnings[0].detail.contains("2 of HATCH"));
}

#[test]
fn depth_of_a_notch_is_its_z_or_its_length() {
    let file = rectangle(DxfBuilder::metric(), "FRONT")
        .tag(0, "POINT")
        .tag(8, "4")
        .tag(10, "100")
        .tag(20, "0")
        .tag(30, "-4")
        .line("81", [300.0, 50.0], [293.0, 50.0]);
    let pattern = imported(file);
    assert_eq!(pattern.warnings, []);
    let depths: Vec<_> = pattern.panels[0]
        .notches
        .iter()
        .map(|n| n.depth_m)
        .collect();
    assert_eq!(depths.len(), 2);
    for (found, wanted) in depths.into_iter().zip([0.004, 0.007]) {
        assert!(close(found.expect("a depth"), wanted), "{found:?}");
    }
}

#[test]
fn notch_drawn_on_cut_and_sew_line_is_one() {
    let sewn = [[10.0, 10.0], [290.0, 10.0], [290.0, 390.0], [10.0, 390.0]];
    let file = closed(rectangle(DxfBuilder::metric(), "FRONT"), "14", &sewn)
        .point("4", [100.0, 0.0])
        .point("4", [100.0, 10.0])
        .point("4", [300.0, 200.0])
        .point("4", [150.0, 200.0]);
    let pattern = imported(file);
    assert_eq!(codes(&pattern), ["pattern/notch_ignored"]);
    assert_eq!(pattern.panels[0].notches.len(), 2);
}

#[test]
fn texts_beside_a_bent_piece_are_its_own() {
    let bent = |file: DxfBuilder, x: f64, name: &str| {
        let points = [
            [0.0, 0.0],
            [300.0, 0.0],
            [300.0, 50.0],
            [50.0, 50.0],
            [50.0, 300.0],
            [0.0, 300.0],
        ];
        let file = file.run("CUT", true, &points.map(|p| [p[0] + x, p[1]]));
        let text = |file: DxfBuilder, y: &str, value: &str| {
            file.tag(0, "TEXT")
                .tag(8, "TEXT")
                .tag(10, &(x + 150.0).to_string())
                .tag(20, y)
                .tag(1, value)
        };
        text(text(file, "180", "Cut 1 pair"), "150", name)
    };
    let pattern = imported(bent(
        bent(DxfBuilder::metric(), 0.0, "front"),
        400.0,
        "back",
    ));
    assert_eq!(pattern.warnings, []);
    let found: Vec<_> = pattern
        .panels
        .iter()
        .filter(|p| p.copy_of.is_none())
        .map(|p| (p.id.as_str(), p.quantity.map(|q| (q.left, q.right))))
        .collect();
    assert_eq!(found, [("front", Some((1, 1))), ("back", Some((1, 1)))]);
}

#[test]
fn spline_through_fit_points_is_read() {
    let knots = [[0.0, 400.0], [150.0, 450.0], [300.0, 400.0]];
    let file = DxfBuilder::metric()
        .run(
            "CUT",
            false,
            &[[0.0, 400.0], [0.0, 0.0], [300.0, 0.0], [300.0, 400.0]],
        )
        .tag(0, "SPLINE")
        .tag(8, "CUT")
        .tag(71, "3");
    let file = knots.iter().fold(file, |file, p| {
        file.tag(11, &p[0].to_string()).tag(21, &p[1].to_string())
    });
    let panel = &imported(file).panels[0];
    // By hand: without tangents and with equal chords each half rises as 50 (3 t - t^3) / 2 mm, on
    // average 5/8 of 50.
    let cap = 0.300 * 0.050 * 5.0 / 8.0;
    assert!(
        (panel.area_m2 - 0.12 - cap).abs() < 1e-5,
        "{}",
        panel.area_m2
    );
}

#[test]
fn line_that_lies_in_no_piece_is_said() {
    let file = rectangle(DxfBuilder::metric(), "FRONT").end_block();
    let square = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]];
    let file = closed(file, "CUT", &square).line("INTERNAL", [500.0, 0.0], [600.0, 0.0]);
    let pattern = imported(file);
    assert_eq!(pattern.panels.len(), 2);
    assert_eq!(codes(&pattern), ["pattern/entity_ignored"]);
    assert!(pattern.warnings[0].detail.starts_with("1 of line outside"));
}

#[test]
fn entity_at_an_absurd_distance_is_left_out_and_said() {
    let far = rectangle(DxfBuilder::metric(), "FRONT").line("8", [10.0, 10.0], [20.0, 1e23]);
    let pattern = imported(far);
    assert!(close(pattern.panels[0].area_m2, 0.12));
    assert!(pattern.panels[0].internal_lines.is_empty());
    assert!(
        codes(&pattern).contains(&"pattern/entity_ignored"),
        "{:?}",
        pattern.warnings
    );
}

#[test]
fn records_that_ran_into_one_are_refused() {
    let file = rectangle(DxfBuilder::metric(), "FRONT")
        .point("4", [100.0, 0.0])
        .tag(9, "POINT")
        .tag(8, "4")
        .tag(10, "200")
        .tag(20, "0");
    let faults = refused(file);
    assert_eq!(faults.0[0].code, "pattern/malformed_entity");
}

#[test]
fn samples_that_ship_are_read_without_a_warning() {
    for (name, panels) in [
        (
            "skirt",
            ["skirt-front", "skirt-back", "waistband"].as_slice(),
        ),
        ("top", &["front", "back"]),
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("static/samples")
            .join(format!("{name}.dxf"));
        let pattern = read(&path).unwrap_or_else(|faults| panic!("{name}: {faults}"));
        assert_eq!(
            pattern
                .panels
                .iter()
                .map(|p| p.id.as_str())
                .collect::<Vec<_>>(),
            panels
        );
        assert_eq!(pattern.warnings, [], "{name}");
    }
}

// ---- Patterns as JSON ----

#[test]
fn pattern_survives_json_and_is_measured_anew() {
    let pattern = imported(rectangle(DxfBuilder::metric(), "FRONT"));
    let mut sent = pattern.clone();
    sent.panels[0].area_m2 = 7.0;
    sent.panels[0].edges[2].length_m = -1.0;
    let json = serde_json::to_string(&sent).expect("JSON");
    let back = checked(
        serde_json::from_str(&json).expect("a Pattern"),
        &Limits::default(),
    );
    assert_eq!(back.expect("a right pattern"), pattern);
}

#[test]
fn all_faults_of_a_pattern_come_at_once_with_pointers() {
    let file = rectangle(rectangle(rectangle(DxfBuilder::metric(), "A"), "B"), "C");
    let mut pattern = imported(file);
    pattern.panels[0].corners[3].x += 0.1;
    pattern.panels[1].id = "a".into();
    pattern.panels[1].edges[0].to = 2;
    let c = &mut pattern.panels[2];
    let swapped = [c.corners[2], c.corners[3]];
    (c.corners[2].x, c.corners[3].x) = (swapped[1].x - 0.4, swapped[0].x + 0.4);
    let corners = c.corners.clone();
    for (i, edge) in c.edges.iter_mut().enumerate() {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        edge.points = vec![[a.x, a.y], [b.x, b.y]];
    }
    let faults = checked(pattern, &Limits::default()).expect_err("three faults");
    let found: Vec<_> = faults
        .0
        .iter()
        .map(|f| (f.code.as_str(), f.pointer.as_str()))
        .collect();
    assert!(
        found.contains(&("pattern/duplicate_id", "/panels/1/id")),
        "{found:?}"
    );
    assert!(
        found.contains(&("pattern/open_outline", "/panels/0/edges/2/points")),
        "{found:?}"
    );
    assert!(
        found.contains(&("pattern/edge", "/panels/1/edges/0")),
        "{found:?}"
    );
    assert!(
        found.contains(&("pattern/self_intersecting", "/panels/2/edges")),
        "{found:?}"
    );
}

#[test]
fn anticlockwise_pattern_is_refused() {
    let mut pattern = imported(rectangle(DxfBuilder::metric(), "A"));
    let panel = &mut pattern.panels[0];
    for corner in &mut panel.corners {
        corner.x = -corner.x;
    }
    for point in panel.edges.iter_mut().flat_map(|e| &mut e.points) {
        point[0] = -point[0];
    }
    let faults = checked(pattern, &Limits::default()).expect_err("anticlockwise");
    assert_eq!(faults.0[0].code, "pattern/orientation");
}

// ---- Real files ----

/// The data folder; `None` where the variable is unset, with a line saying what was left out.
fn data(left_out: &str) -> Option<PathBuf> {
    let found = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from);
    if found.is_none() {
        println!("left out: {left_out} (SEAMSTER_TEST_DATA is unset)");
    }
    found
}

fn json(path: &Path) -> Value {
    let bytes = std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_slice(&bytes).expect("valid JSON")
}

fn read(path: &Path) -> Result<Pattern, Faults> {
    let bytes = std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    import(&bytes, &ImportOptions::default(), &Limits::default())
}

fn files(manifest: &Value) -> impl Iterator<Item = (&str, &Value)> {
    let files = manifest["files"].as_array().expect("a list of files");
    files
        .iter()
        .map(|entry| (entry["file"].as_str().expect("a file name"), entry))
}

/// Count and areas [mm2] of the panels that a file has in truth: those of the sample size, else
/// all.
fn truth(entry: &Value) -> (usize, Vec<f64>) {
    let graded = !entry["pieces_in_sample_size"].is_null();
    let count = entry["pieces_in_sample_size"]
        .as_u64()
        .or(entry["piece_count"].as_u64())
        .expect("a count");
    let pieces = entry["pieces"].as_array().expect("a list of pieces");
    let kept = pieces
        .iter()
        .filter(|p| !graded || p["size"] == entry["sample_size"]);
    let mut areas: Vec<f64> = kept
        .filter_map(|p| p["outline"]["area_mm2"].as_f64().or(p["area_mm2"].as_f64()))
        .collect();
    areas.sort_by(f64::total_cmp);
    (usize::try_from(count).expect("a small count"), areas)
}

/// Differences between a pattern and the truth; empty where there are none.
fn difference(pattern: &Pattern, entry: &Value) -> String {
    let (count, areas) = truth(entry);
    // The truth counts pieces before their mirrored copies.
    let drawn = pattern.panels.iter().filter(|p| p.copy_of.is_none());
    let mut found: Vec<f64> = drawn.map(|p| 1e6 * p.drawn_area_m2).collect();
    if found.len() != count || areas.len() != count {
        return format!(
            "{} panels, {count} expected with {} areas",
            found.len(),
            areas.len()
        );
    }
    found.sort_by(f64::total_cmp);
    let worst = found
        .iter()
        .zip(&areas)
        .map(|(a, b)| (a / b - 1.0).abs())
        .fold(0.0, f64::max);
    if worst > 1e-3 {
        format!("areas differ by up to {:.2} %", 100.0 * worst)
    } else {
        String::new()
    }
}

#[test]
fn real_files_have_their_panels_and_areas() {
    let Some(data) = data("48 real files") else {
        return;
    };
    let folder = data.join("dxf");
    let manifest = json(&folder.join("manifest.json"));
    let mut wrong = Vec::new();
    for (name, entry) in files(&manifest) {
        let result = match read(&folder.join(name)) {
            Ok(pattern) => difference(&pattern, entry),
            Err(faults) => faults.to_string(),
        };
        println!(
            "{name:50} {}",
            if result.is_empty() {
                "as in truth"
            } else {
                &result
            }
        );
        if !result.is_empty() {
            wrong.push(format!("{name}: {result}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn point_mm(value: &Value) -> [f64; 2] {
    [0, 1].map(|k| value[k].as_f64().expect("a coordinate"))
}

fn distance_mm(a: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    (a[0] - 1000.0 * x).hypot(a[1] - 1000.0 * y)
}

/// By how much a curve is longer than the chords it was written as: a chord of length l over which
/// the curve turns by t lacks l t^2 / 24. The turn of a chord is taken from its ends, twice as
/// large for chords of unequal turn [mm].
fn lost_to_chords(edge: &Edge) -> f64 {
    let way = |w: &[[f64; 2]]| [w[1][0] - w[0][0], w[1][1] - w[0][1]];
    let ways: Vec<[f64; 2]> = edge.points.windows(2).map(way).collect();
    let turn = |a: [f64; 2], b: [f64; 2]| {
        (a[0] * b[1] - a[1] * b[0])
            .atan2(a[0] * b[0] + a[1] * b[1])
            .abs()
    };
    let lost = |w: &[[f64; 2]]| {
        f64::midpoint(w[0][0].hypot(w[0][1]), w[1][0].hypot(w[1][1])) * turn(w[0], w[1]).powi(2)
            / 24.0
    };
    2.0 * 1000.0 * ways.windows(2).map(lost).sum::<f64>()
}

#[test]
fn edges_of_garmentcode_panels_are_those_that_were_drawn() {
    let Some(data) = data("gc_*__r12_aama") else {
        return;
    };
    for name in ["gc_pencil_skirt__r12_aama", "gc_tshirt__r12_aama"] {
        let seams = json(&data.join("dxf").join(format!("{name}.seams.json")));
        let pattern = read(&data.join("dxf").join(format!("{name}.dxf"))).expect("a pattern");
        let panels = seams["panels"].as_object().expect("panels");
        assert_eq!(pattern.panels.len(), panels.len());
        for (id, truth) in panels {
            let panel = pattern
                .panels
                .iter()
                .find(|p| p.id == *id)
                .unwrap_or_else(|| panic!("{name}: no {id}"));
            let drawn = truth["edges"].as_array().expect("a list of edges");
            assert_eq!(panel.edges.len(), drawn.len(), "{name} {id}");
            for (i, truth) in drawn.iter().enumerate() {
                let ends = [
                    point_mm(&truth["a_local_mm"]),
                    point_mm(&truth["b_local_mm"]),
                ];
                let joins = |from: [f64; 2], to: [f64; 2]| {
                    distance_mm(ends[0], from) < 0.1 && distance_mm(ends[1], to) < 0.1
                };
                let found = panel.edges.iter().find(|e| {
                    let (from, to) = (e.points[0], e.points[e.points.len() - 1]);
                    joins(from, to) || joins(to, from)
                });
                let edge = found.unwrap_or_else(|| panic!("{name} {id}: edge {i} is missing"));
                let short = truth["length_mm"].as_f64().expect("a length") - 1000.0 * edge.length_m;
                assert!(
                    short > -0.1 && short < 0.1 + lost_to_chords(edge),
                    "{name} {id}: edge {i} is {short:.3} mm short"
                );
            }
        }
    }
}

#[test]
fn real_panels_are_simple_clockwise_and_closed() {
    let Some(data) = data("checks of 48 real files") else {
        return;
    };
    let folder = data.join("dxf");
    let manifest = json(&folder.join("manifest.json"));
    for (name, _) in files(&manifest) {
        let pattern = read(&folder.join(name)).unwrap_or_else(|faults| panic!("{name}: {faults}"));
        let again = checked(pattern.clone(), &Limits::default())
            .unwrap_or_else(|faults| panic!("{name}: {faults}"));
        for (panel, again) in pattern.panels.iter().zip(&again.panels) {
            assert!(
                (panel.area_m2 - again.area_m2).abs() < 1e-9,
                "{name} {}",
                panel.id
            );
        }
        assert!(pattern.warnings.len() < 20, "{name}: {:?}", codes(&pattern));
    }
}

fn signed_area(edges: &[Edge]) -> f64 {
    let points: Vec<[f64; 2]> = edges
        .iter()
        .flat_map(|e| e.points[1..].iter().copied())
        .collect();
    let next = points.iter().cycle().skip(1);
    points
        .iter()
        .zip(next)
        .map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0]))
        .sum()
}

// ---- Hostile files ----

/// Outcome that a hostile file must have.
enum Expected {
    /// A refusal with this code.
    Refused(&'static str),
    /// Panels of these areas [mm2], and a warning with this code (none asked for where empty).
    Read(&'static [f64], &'static str),
}

const RECTANGLE: &[f64] = &[120_000.0];

fn expected(file: &str) -> Expected {
    use Expected::{Read, Refused};
    match file.trim_end_matches(".dxf") {
        "empty" | "only_whitespace" | "png_renamed" | "dwg_renamed" | "zip_renamed"
        | "html_error_page" | "utf16_bom" => Refused("pattern/not_dxf"),
        "random_junk_64k" | "nul_bytes_inside" => Refused("pattern/nul_byte"),
        "trunc_real_0" | "trunc_real_1" | "trunc_real_2" | "trunc_real_3" | "trunc_mid_vertex"
        | "trunc_lw_real" | "binary_trunc" => Refused("pattern/truncated"),
        "header_only" | "no_entities_section_body" | "text_only" | "points_only" => {
            Refused("pattern/no_outline")
        }
        "open_outline_gap50" | "lines_gap_corner" => Refused("pattern/open_outline"),
        "self_intersect_bowtie" | "self_touch_point" => Refused("pattern/self_intersecting"),
        "zero_area_sliver" | "two_vertex_poly" | "one_vertex_poly" => Refused("pattern/no_area"),
        "nan_coord" | "inf_coord" | "overflow_1e999" | "pi_shuffle_bulge_inf" => {
            Refused("pattern/not_finite")
        }
        "text_in_number" | "comma_decimal" => Refused("pattern/bad_number"),
        "bad_group_code" => Refused("pattern/group_code"),
        "huge_1e300"
        | "tiny_1e-12"
        | "unit_claim_metric_but_metres"
        | "unit_insunits6_mm_coords"
        | "real_steamtrousers_aama_2000_1"
        | "real_steamtrousers_flat_r10_1" => Refused("pattern/units_implausible"),
        "recursive_block_self" | "recursive_block_pair" | "deep_nesting_3000" => {
            Refused("pattern/nesting")
        }
        "billion_laughs_blocks" | "minsert_array_1e8" | "vertices_200k" => {
            Refused("pattern/too_large")
        }
        "claim_2G_spline" | "spline_bad_knots" => Refused("pattern/malformed_entity"),
        "one_line_1MB_text" => Refused("pattern/line_too_long"),
        "many_tiny_pieces_5000" => Refused("pattern/too_many_panels"),
        "arc_negative_radius" => Refused("pattern/negative_radius"),
        "binary_junk" | "binary_valentina_real" => Refused("pattern/binary"),
        "no_eof_marker" => Read(RECTANGLE, "pattern/no_eof"),
        "open_outline_gap_0p2" => Read(RECTANGLE, "pattern/gap_closed"),
        "far_offset_1e9" => Read(RECTANGLE, "pattern/moved"),
        "unit_conflict_text_english_insunits_mm" => Read(&[77_419_200.0], "pattern/units_conflict"),
        "unit_insunits_999" => Read(RECTANGLE, "pattern/units_unknown"),
        "two_overlapping_pieces" | "ccw_and_cw" => Read(&[120_000.0, 120_000.0], ""),
        "identical_pieces_same_place" => Read(RECTANGLE, "pattern/duplicate_outline"),
        "nested_seam_and_cut" => Read(&[106_400.0], ""),
        "outline_with_hole" => Read(&[110_000.0], ""),
        "same_block_name_twice" => Read(&[120_000.0, 4500.0], ""),
        "insert_missing_block" => Read(RECTANGLE, "pattern/missing_block"),
        "block_never_inserted" => Read(RECTANGLE, "pattern/block_not_inserted"),
        "claim_10M_vertices" => Read(RECTANGLE, "pattern/vertex_count"),
        "arc_zero_radius" => Read(&[60_000.0], "pattern/zero_radius"),
        "circle_piece" => Read(&[31_415.9], ""),
        "unknown_entity" => Read(RECTANGLE, "pattern/entity_ignored"),
        "poly_without_seqend" => Read(RECTANGLE, "pattern/no_seqend"),
        "endsec_missing" => Read(RECTANGLE, "pattern/no_endsec"),
        "odd_line_count" => Read(RECTANGLE, "pattern/dangling_line"),
        "z_nonzero" => Read(RECTANGLE, "pattern/not_flat"),
        "zero_length_edges"
        | "dup_closing_vertex"
        | "utf8_bom"
        | "gbk_names"
        | "invalid_utf8_in_r2007"
        | "html_in_name"
        | "path_in_name"
        | "mac_cr_only"
        | "lowercase_keywords"
        | "unknown_group_250"
        | "comments_999"
        | "extrusion_negative_z" => Read(RECTANGLE, ""),
        other => panic!("{other} is new in the folder: say here what it must give"),
    }
}

/// Difference from the outcome that a hostile file must have; empty where there is none.
fn misbehavior(found: &Result<Pattern, Faults>, expected: &Expected) -> String {
    match (found, expected) {
        (Err(faults), Expected::Refused(code)) => {
            let right = faults.0.iter().any(|f| f.code == *code);
            let clear = faults
                .0
                .iter()
                .all(|f| f.pointer.starts_with("line ") && f.fix.is_some());
            if right && clear {
                String::new()
            } else {
                format!("refused otherwise than as {code}: {faults:?}")
            }
        }
        (Ok(pattern), Expected::Read(areas, code)) => {
            let fits =
                |(panel, area): (&Panel, &f64)| (1e6 * panel.area_m2 / area - 1.0).abs() < 1e-4;
            let right =
                pattern.panels.len() == areas.len() && pattern.panels.iter().zip(*areas).all(fits);
            let warned = code.is_empty() || codes(pattern).contains(code);
            if right && warned {
                String::new()
            } else {
                format!("{:?} with {:?}", areas, codes(pattern))
            }
        }
        (Ok(_), Expected::Refused(code)) => format!("read, not refused as {code}"),
        (Err(faults), Expected::Read(..)) => format!("refused: {faults}"),
    }
}

#[test]
fn hostile_files_give_what_they_must_in_time() {
    let Some(data) = data("77 hostile files") else {
        return;
    };
    let folder = data.join("dxf-bad");
    let manifest = json(&folder.join("manifest.json"));
    let mut wrong = Vec::new();
    for (name, _) in files(&manifest) {
        let start = thread_cpu_s();
        let mut result = misbehavior(&read(&folder.join(name)), &expected(name));
        if thread_cpu_s() - start > 2.0 {
            result += " took more than 2 s";
        }
        println!(
            "{name:45} {}",
            if result.is_empty() {
                "as expected"
            } else {
                &result
            }
        );
        if !result.is_empty() {
            wrong.push(format!("{name}: {result}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
