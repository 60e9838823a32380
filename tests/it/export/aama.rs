//! Patterns written as AAMA DXF and imported again: the same panels, in the same bytes each time.

use seamster::config::Limits;
use seamster::export::{PatternFile, pattern_dxf};
use seamster::pattern::{
    Allowance, Grain, ImportOptions, Notch, NotchKind, Panel, Pattern, Point2, Quantity, import,
};
use seamster_fixtures::dxf::DxfBuilder;
use seamster_fixtures::panels::{lens, panel_of, pattern, polygon};
use seamster_fixtures::same::differences;
use seamster_fixtures::truth;
use std::path::{Path, PathBuf};

fn imported(bytes: &[u8]) -> Pattern {
    import(bytes, &ImportOptions::default(), &Limits::default()).expect("a pattern")
}

/// The pattern written and imported again.
fn round_trip(pattern: &Pattern) -> (PatternFile, Pattern) {
    let file = pattern_dxf(pattern);
    let again = imported(file.text.as_bytes());
    (file, again)
}

#[track_caller]
fn assert_same(pattern: &Pattern) -> (PatternFile, Pattern) {
    let (file, again) = round_trip(pattern);
    assert_eq!(differences(pattern, &again), Vec::<String>::new());
    assert_eq!(again.name, pattern.name);
    (file, again)
}

/// The number of entities of a kind on a layer.
fn count(file: &PatternFile, kind: &str, layer: &str) -> usize {
    let entity = format!("  0\r\n{kind}\r\n  8\r\n{layer}\r\n");
    file.text.matches(&entity).count()
}

/// A half front on the fold at x = 0 with a V neck, cut 10 mm outside its sew line, as AAMA draws
/// it \[mm\].
fn half_front() -> DxfBuilder {
    let cut = [
        [0.0, -10.0],
        [160.0, -10.0],
        [170.0, 410.0],
        [60.0, 412.0],
        [0.0, 310.0],
    ];
    let sew = [
        [0.0, 0.0],
        [150.0, 0.0],
        [160.0, 400.0],
        [60.0, 400.0],
        [0.0, 300.0],
    ];
    let dart = [[60.0, 60.0], [70.0, 150.0], [80.0, 60.0]];
    let pocket = [[30.0, 30.0], [50.0, 30.0], [50.0, 45.0], [30.0, 50.0]];
    DxfBuilder::metric()
        .text("1", "Style Name: top")
        .text("1", "Sample Size: M")
        .block("FRONT_M")
        .text("1", "Piece Name: front")
        .text("1", "Size: M")
        .text("1", "Quantity: 1")
        .run("1", true, &cut)
        .run("14", true, &sew)
        .line("6", [0.0, 20.0], [0.0, 250.0])
        .point("2", sew[0])
        .point("2", sew[1])
        .point("2", sew[2])
        .point("2", sew[3])
        .point("2", sew[4])
        .point("4", [100.0, 0.0])
        .point("80", [0.0, 0.0])
        .point("4", [152.5, 100.0])
        .line("7", [80.0, 50.0], [100.0, 350.0])
        .run("8", false, &dart)
        .run("11", true, &pocket)
        .point("13", [70.0, 140.0])
        .point("13", [0.0, 200.0])
}

#[test]
fn half_on_the_fold_is_drawn_as_a_half_and_unfolds_to_the_same() {
    let pattern = imported(&half_front().bytes());
    assert!(pattern.panels[0].unfolded && pattern.panels[0].notches.len() == 5);
    let (file, again) = assert_same(&pattern);
    assert_eq!(file.left_out, Vec::<String>::new());
    for (kind, layer, wanted) in [
        ("POLYLINE", "1", 1),
        ("POLYLINE", "14", 1),
        ("LINE", "6", 1),
        ("LINE", "7", 1),
        ("POLYLINE", "8", 1),
        ("POLYLINE", "11", 1),
        ("POINT", "13", 2),
        ("POINT", "4", 2),
        ("POINT", "80", 1),
    ] {
        assert_eq!(count(&file, kind, layer), wanted, "{kind} on {layer}");
    }
    assert_eq!(again.source.allowance, Allowance::SewLine);
    assert_eq!(again.source.sample_size.as_deref(), Some("M"));
    assert_eq!(again.source.sizes, ["M"]);
    let drawn = |pattern: &Pattern| pattern.panels[0].drawn_area_m2;
    assert!((drawn(&again) - drawn(&pattern)).abs() < 1e-9);
}

#[test]
fn half_drawn_the_other_way_round_keeps_its_numbers() {
    // Anticlockwise and clockwise, its fold up or slanting, the mark on either side.
    let half = [
        [0.0, 0.0],
        [150.0, 0.0],
        [160.0, 400.0],
        [60.0, 400.0],
        [0.0, 300.0],
    ];
    for turn in [0.0_f64, 37.0] {
        let (sin, cos) = turn.to_radians().sin_cos();
        let at = |[x, y]: Point2, side: f64| [cos * side * x - sin * y, sin * side * x + cos * y];
        for side in [1.0, -1.0] {
            for backwards in [false, true] {
                let mut points: Vec<Point2> = half.iter().map(|p| at(*p, side)).collect();
                if backwards {
                    points.reverse();
                }
                let file = DxfBuilder::metric()
                    .block("FRONT")
                    .run("1", true, &points)
                    .line("6", at([0.0, 0.0], side), at([0.0, 300.0], side))
                    .point("4", at([100.0, 0.0], side));
                let pattern = imported(&file.bytes());
                assert!(pattern.panels[0].unfolded);
                let (written, _) = assert_same(&pattern);
                assert_eq!(count(&written, "LINE", "6"), 1, "{turn} {side} {backwards}");
            }
        }
    }
}

#[test]
fn unfolded_panel_that_is_not_its_own_image_is_drawn_whole_and_told() {
    let mut pattern = imported(&half_front().bytes());
    pattern.panels[0].notches.pop();
    let (file, again) = round_trip(&pattern);
    assert_eq!(file.left_out.len(), 1, "{:?}", file.left_out);
    assert!(
        file.text
            .contains("999\r\nNot in this file: 1 panel on the fold")
    );
    assert_eq!(differences(&pattern, &again), ["front: unfolded"]);
}

/// A curve from `a` to `b` that bulges by `rise` \[m\].
fn curve(a: Point2, b: Point2, rise: f64) -> Vec<Point2> {
    let e = [b[0] - a[0], b[1] - a[1]];
    let at = |i: u32| {
        let t = f64::from(i) / 24.0;
        let h = rise * 4.0 * t * (1.0 - t);
        [a[0] + t * e[0] - h * e[1], a[1] + t * e[1] + h * e[0]]
    };
    (0..=24).map(at).collect()
}

/// A sleeve with a smooth cap that is parted by a corner without a turn, a notch of every shape,
/// lines that meet and a closed one.
fn sleeve() -> Panel {
    let [a, b, c, d] = [[0.0, 0.0], [0.05, 0.4], [0.35, 0.4], [0.4, 0.0]];
    let cap = curve(b, c, 0.3);
    let (left, right) = cap.split_at(12);
    let left = [left, &right[..1]].concat();
    let mut panel = panel_of(
        "sleeve",
        &[vec![a, b], left, right.to_vec(), vec![c, d], vec![d, a]],
    );
    let kinds = [
        NotchKind::V,
        NotchKind::T,
        NotchKind::Castle,
        NotchKind::Check,
        NotchKind::U,
    ];
    let notch = |(index, kind): (usize, &NotchKind)| Notch {
        index,
        edge: index % 5,
        at: 0.31,
        kind: *kind,
        depth_m: (index % 2 == 0).then_some(0.005),
    };
    panel.notches = kinds.iter().enumerate().map(notch).collect();
    panel.grain = Some(Grain { angle_deg: 90.0 });
    panel.drill_holes = vec![[0.2, 0.1], [0.21, 0.12]];
    panel.internal_lines = vec![
        vec![[0.1, 0.1], [0.2, 0.15], [0.3, 0.1]],
        vec![[0.1, 0.2], [0.12, 0.2], [0.12, 0.22], [0.1, 0.2]],
    ];
    panel.quantity = Some(Quantity { left: 1, right: 1 });
    panel
}

#[test]
fn corners_curves_notches_lines_and_quantities_come_back() {
    let mut written = pattern(vec![sleeve(), lens("gusset", 0.2, 0.03, 40)]);
    written.source.allowance = Allowance::Unknown;
    written.name = "袖 & ^ sleeve".to_owned();
    written.panels[1].name = "Ärmelkeil 前片".to_owned();
    written.panels[1].id = "ärmelkeil-前片".to_owned();
    let whole = written.with_copies(["sleeve~mirror"]).into_owned();
    let mut copy = whole.panels[2].clone();
    copy.quantity = None;
    let (file, again) = round_trip(&whole);
    assert!(file.text.is_ascii());
    let mut wanted = whole.clone();
    wanted.panels[2] = copy;
    assert_eq!(differences(&wanted, &again), Vec::<String>::new());
    assert_eq!(again.name, written.name);
    assert_eq!(again.panels[2].copy_of.as_deref(), Some("sleeve"));
    assert_eq!(file, pattern_dxf(&whole.clone()), "the same bytes");
}

#[test]
fn outline_that_is_a_sew_line_is_told_and_one_of_which_nothing_is_known_is_not() {
    for (allowance, read) in [
        (Allowance::None, Allowance::SewLine),
        (Allowance::SewLine, Allowance::SewLine),
        (Allowance::Unknown, Allowance::Unknown),
    ] {
        let mut pattern = pattern(vec![polygon(
            "front",
            &[[0.0, 0.0], [0.1, 0.4], [0.3, 0.0]],
        )]);
        pattern.source.allowance = allowance;
        let (_, again) = assert_same(&pattern);
        assert_eq!(again.source.allowance, read);
        assert!(again.panels[0].cut_line.is_empty());
    }
}

#[test]
fn what_dxf_cannot_say_is_told_in_the_file() {
    let mut pattern = pattern(vec![sleeve()]);
    pattern.source.sizes = ["S", "M", "L"].map(str::to_owned).to_vec();
    pattern.source.sample_size = Some("M".to_owned());
    pattern.panels[0].label = Some("arm".to_owned());
    pattern.panels[0].notches[0].kind = NotchKind::Slit;
    pattern.panels[0].quantity = Some(Quantity {
        left: 500,
        right: 0,
    });
    let (file, again) = round_trip(&pattern);
    let comments = file.text.matches("999\r\nNot in this file: ").count();
    assert_eq!(
        (file.left_out.len(), comments),
        (4, 4),
        "{:?}",
        file.left_out
    );
    for part in ["S, L", "1 label or", "1 notch is a slit", "more than 100"] {
        assert!(
            file.left_out.iter().any(|said| said.contains(part)),
            "{part}"
        );
    }
    assert_eq!(again.source.sizes, ["M"]);
}

/// The real files, in the order of their names.
fn files(data: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(data.join("dxf")).expect("a folder of files");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let is_dxf = |p: &PathBuf| p.extension().is_some_and(|e| e.eq_ignore_ascii_case("dxf"));
    let mut paths: Vec<PathBuf> = paths.filter(is_dxf).collect();
    paths.sort();
    paths
}

/// The pattern without what DXF cannot say: slits, and cut lines beside a part of an outline, which
/// are lines on the cloth in the file.
fn sayable(pattern: &Pattern, again: &Pattern) -> Pattern {
    let mut sayable = pattern.clone();
    for (panel, again) in sayable.panels.iter_mut().zip(&again.panels) {
        if again.cut_line.is_empty() && !panel.cut_line.is_empty() {
            assert!(again.internal_lines.len() > panel.internal_lines.len());
            panel.cut_line.clear();
            panel.internal_lines.clone_from(&again.internal_lines);
        }
    }
    for notch in sayable
        .panels
        .iter_mut()
        .flat_map(|panel| &mut panel.notches)
    {
        if notch.kind == NotchKind::Slit {
            notch.kind = NotchKind::V;
        }
    }
    sayable
}

#[test]
fn real_files_come_back_the_same() {
    let Some(data) = truth::data() else {
        println!("left out: round trips of 48 real files (SEAMSTER_TEST_DATA is unset)");
        return;
    };
    let mut wrong = Vec::new();
    let mut count = 0;
    for path in files(&data) {
        let name = path
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let pattern = imported(&std::fs::read(&path).expect("a file that can be read"));
        let (file, again) = round_trip(&pattern);
        println!(
            "{name:45} {:3} panels; not in the file: {:?}",
            pattern.panels.len(),
            file.left_out
        );
        let mut found = differences(&sayable(&pattern, &again), &again);
        if (again.name.as_str(), &again.source.sample_size)
            != (pattern.name.as_str(), &pattern.source.sample_size)
        {
            found.push("name or size".to_owned());
        }
        wrong.extend(found.iter().map(|what| format!("{name}: {what}")));
        count += 1;
    }
    assert_eq!(count, 48);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
