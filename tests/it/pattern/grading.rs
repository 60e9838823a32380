//! Sizes made of a sample size by a grade rule table: an example by hand, and real nests, all sizes
//! of which are drawn.

use super::read::warnings;
use seamster::config::Limits;
use seamster::pattern::{GradeTable, ImportOptions, Panel, Pattern, Point2, import};
use seamster_fixtures::dxf::DxfBuilder;
use seamster_fixtures::raw::{self, Block};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

fn table(text: &str) -> GradeTable {
    GradeTable::read(text.as_bytes(), &Limits::default()).expect("a table")
}

fn of_size(file: &[u8], table: Option<&GradeTable>, size: Option<&str>) -> Pattern {
    let options = ImportOptions {
        grading: table.cloned(),
        size: size.map(str::to_owned),
        ..ImportOptions::default()
    };
    import(file, &options, &Limits::default()).expect("a pattern")
}

fn rule(file: DxfBuilder, number: u32, [x, y]: Point2) -> DxfBuilder {
    let file = file.tag(0, "TEXT").tag(8, "2");
    file.tag(10, &x.to_string())
        .tag(20, &y.to_string())
        .tag(1, &format!("# {number}"))
}

/// A front on the fold [mm]: its side is one path of three points, and a line is drawn on it.
fn front() -> Vec<u8> {
    let file = DxfBuilder::metric()
        .text("1", "Sample Size: M")
        .block("FRONT-M")
        .text("1", "Piece Name: FRONT")
        .text("1", "Size: M")
        .run("1", false, &[[0.0, 0.0], [200.0, 0.0]])
        .run("1", false, &[[200.0, 0.0], [210.0, 100.0], [200.0, 400.0]])
        .run("1", false, &[[200.0, 400.0], [0.0, 400.0], [0.0, 0.0]])
        .line("6", [0.0, 0.0], [0.0, 400.0])
        .line("8", [0.0, 200.0], [100.0, 200.0])
        .point("4", [100.0, 0.0]);
    let file = rule(rule(file, 1, [0.0, 0.0]), 2, [200.0, 0.0]);
    rule(rule(file, 3, [200.0, 400.0]), 4, [0.0, 400.0])
        .end_block()
        .bytes()
}

const TABLE: &str = "ANSI/AAMA VERSION: 1.0.0
UNITS: METRIC
NUMBER OF SIZES: 3
SIZE LIST: S M L
SAMPLE SIZE: M
RULE: DELTA 1
    0.0, -8.0    0.0, 0.0    0.0, -10.0
RULE: DELTA 2
  -10.0, -8.0    0.0, 0.0   12.0, -10.0
RULE: DELTA 3
   -6.0,  4.0    0.0, 0.0    8.0,   5.0
RULE: DELTA 4
    0.0,  4.0    0.0, 0.0    0.0,   5.0
END
";

#[test]
fn size_l_is_where_its_rules_say() {
    let (file, table) = (front(), table(TABLE));
    let sample = of_size(&file, Some(&table), None);
    assert_eq!(sample.source.sizes, ["M", "S", "L"]);
    assert_eq!(sample.panels, of_size(&file, None, None).panels);
    let large = of_size(&file, Some(&table), Some("l"));
    assert_eq!(large.source.sample_size.as_deref(), Some("L"));
    let panel = &large.panels[0];
    // The side's middle point lies at hypot(10, 100) of hypot(10, 100) + hypot(10, 300) along it.
    let share = 10_100.0_f64.sqrt() / (10_100.0_f64.sqrt() + 90_100.0_f64.sqrt());
    let middle = [
        210.0 + 12.0 + share * (8.0 - 12.0),
        100.0 - 10.0 + share * (5.0 + 10.0),
    ];
    let half = [
        [0.0, -10.0],
        [212.0, -10.0],
        middle,
        [208.0, 405.0],
        [0.0, 405.0],
    ];
    let doubled: f64 = (0..5)
        .map(|i| (half[i], half[(i + 1) % 5]))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    assert!(panel.unfolded);
    assert!(
        (panel.area_m2 - 1e-6 * doubled).abs() < 1e-12,
        "twice the half"
    );
    let points: Vec<Point2> = panel.edges.iter().flat_map(|e| e.points.clone()).collect();
    for expected in &half[1..4] {
        let is_there =
            |p: &Point2| (1000.0 * p[0] - expected[0]).hypot(1000.0 * p[1] - expected[1]) < 1e-9;
        assert!(points.iter().any(is_there), "{expected:?} of {points:?}");
    }
    // The notch at the middle of the hem stays there: the fold's end moves by 0, the side's by 12.
    let hem: Vec<f64> = panel.notches.iter().map(|n| n.at).collect();
    assert_eq!(hem.len(), 2);
    assert!(
        hem.iter()
            .all(|at| (at - 0.25).abs() < 1e-9 || (at - 0.75).abs() < 1e-9),
        "{hem:?}"
    );
}

/// A piece that is put in turned and mirrored moves as it is drawn.
#[test]
fn rules_turn_with_their_pieces() {
    let text = String::from_utf8(front()).expect("ASCII");
    let insert = "0\nINSERT\n8\n1\n2\nFRONT-M\n10\n0\n20\n0\n";
    assert!(text.contains(insert));
    let turned = format!("{insert}41\n-1\n50\n90\n");
    let turned = text.replace(insert, &turned).into_bytes();
    let (upright, table) = (front(), table(TABLE));
    for size in ["S", "M", "L"] {
        let area = |file: &[u8]| of_size(file, Some(&table), Some(size)).panels[0].area_m2;
        assert!((area(&upright) - area(&turned)).abs() < 1e-12, "{size}");
    }
}

#[test]
fn what_does_not_fit_together_is_told() {
    let file = front();
    let refused = |text: &str, size: Option<&str>| {
        let options = ImportOptions {
            grading: Some(table(text)),
            size: size.map(str::to_owned),
            ..ImportOptions::default()
        };
        let faults = import(&file, &options, &Limits::default()).expect_err("refused");
        faults.0[0].code.to_string()
    };
    assert_eq!(refused(TABLE, Some("XL")), "pattern/unknown_size");
    let other = TABLE.replace("DELTA 3", "DELTA 33");
    assert_eq!(refused(&other, Some("L")), "pattern/grade_rule");
    let other = TABLE.replace("M L", "N L").replace("SIZE: M", "SIZE: N");
    assert_eq!(refused(&other, Some("L")), "pattern/grade_table");
    // A rule beside the corner, by more than the rounding of any program, moves nothing.
    let astray = String::from_utf8(front())
        .expect("ASCII")
        .replace("20\n400\n1\n# 3", "20\n400.3\n1\n# 3");
    let pattern = of_size(astray.as_bytes(), Some(&table(TABLE)), Some("L"));
    assert_eq!(warnings(&pattern, "pattern/ungraded"), 1);
    let plain = DxfBuilder::metric()
        .block("P")
        .text("1", "Piece Name: P")
        .run("1", true, &[[0.0, 0.0], [200.0, 0.0], [200.0, 400.0]]);
    let pattern = of_size(&plain.bytes(), Some(&table(TABLE)), Some("L"));
    assert_eq!(warnings(&pattern, "pattern/ungraded"), 1);
}

/// All sizes of a piece, by the name of the size, and that of its sample.
struct Nest<'a> {
    sample: &'a Block,
    sizes: BTreeMap<String, &'a Block>,
}

/// Returns the pieces of a file that are drawn in all sizes, with rules in one of them.
fn nests(drawing: &raw::Drawing) -> BTreeMap<String, Nest<'_>> {
    let has_rules = |block: &Block| block.entities.iter().any(|e| e.text.starts_with("# "));
    let part = |block: &'_ Block| {
        let (name, size) = block.name.rsplit_once(['_', '-'])?;
        Some((name.to_owned(), size.to_owned()))
    };
    let mut nests = BTreeMap::new();
    for sample in drawing.blocks.iter().filter(|block| has_rules(block)) {
        let Some((name, _)) = part(sample) else {
            continue;
        };
        let same = drawing.blocks.iter().filter_map(|block| {
            let (other, size) = part(block)?;
            (other == name && is_alike(block, sample)).then_some((size, block))
        });
        let sizes: BTreeMap<_, _> = same.collect();
        nests.insert(name, Nest { sample, sizes });
    }
    nests
}

fn outline(block: &Block) -> impl Iterator<Item = &Vec<Point2>> {
    let paths = block.entities.iter();
    let paths = paths.filter(|e| e.layer == "1" && e.kind == "POLYLINE");
    paths.map(|path| &path.points)
}

fn is_alike(a: &Block, b: &Block) -> bool {
    outline(a).map(Vec::len).eq(outline(b).map(Vec::len))
}

fn drawn(name: &str, block: &Block) -> DxfBuilder {
    let file = DxfBuilder::metric().block(name);
    let file = file.text("1", &format!("Piece Name: {name}"));
    outline(block).fold(file, |file, path| file.run("1", false, path))
}

fn ring(panel: &Panel) -> Vec<Point2> {
    let points = panel.edges.iter();
    points.flat_map(|e| e.points[1..].to_vec()).collect()
}

/// Distances of the points of a piece from where its file draws them in a size, those of points
/// with rules and of those between, and how far the latter moved.
#[derive(Default)]
struct Errors {
    ruled: Vec<f64>,
    between: Vec<f64>,
    moved: Vec<f64>,
}

fn compare(name: &str, nest: &Nest<'_>, errors: &mut Errors) {
    let texts = nest.sample.entities.iter();
    let places: Vec<Point2> = texts
        .filter(|e| e.text.starts_with("# "))
        .filter_map(|e| e.points.first().copied())
        .collect();
    let vertices: Vec<Point2> = outline(nest.sample).flatten().copied().collect();
    let vertex = |place: &Point2| vertices.iter().position(|v| v == place);
    let ruled: Vec<usize> = places.iter().filter_map(vertex).collect();
    let mut rul = String::from("UNITS: METRIC\nSIZE LIST: SAMPLE");
    let others: Vec<(&String, Vec<Point2>)> = nest
        .sizes
        .iter()
        .filter(|(_, block)| !std::ptr::eq(**block, nest.sample))
        .map(|(size, block)| (size, outline(block).flatten().copied().collect()))
        .collect();
    for (size, _) in &others {
        write!(rul, " {size}").expect("a String");
    }
    rul.push_str("\nSAMPLE SIZE: SAMPLE\n");
    let mut file = drawn(name, nest.sample);
    for (number, i) in (1..).zip(&ruled) {
        file = rule(file, number, vertices[*i]);
        write!(rul, "RULE: DELTA {number}\n0, 0").expect("a String");
        for (_, points) in &others {
            let delta = [0, 1].map(|k| points[*i][k] - vertices[*i][k]);
            write!(rul, " {}, {}", delta[0], delta[1]).expect("a String");
        }
        rul.push('\n');
    }
    let (file, table) = (file.bytes(), table(&rul));
    let sample = ring(&of_size(&file, Some(&table), None).panels[0]);
    for ((size, points), block) in others.iter().zip(
        nest.sizes
            .iter()
            .filter(|(_, b)| !std::ptr::eq(**b, nest.sample)),
    ) {
        let graded = ring(&of_size(&file, Some(&table), Some(size)).panels[0]);
        if graded.len() != sample.len() {
            continue;
        }
        for (before, after) in sample.iter().zip(&graded) {
            let near =
                |v: &Point2| (v[0] / 1000.0 - before[0]).hypot(v[1] / 1000.0 - before[1]) < 1e-6;
            let Some(i) = vertices.iter().position(near) else {
                continue;
            };
            let way = |p: Point2| (p[0] / 1000.0 - after[0]).hypot(p[1] / 1000.0 - after[1]);
            if ruled.iter().any(|r| vertices[*r] == vertices[i]) {
                errors.ruled.push(way(points[i]));
            } else {
                errors.between.push(way(points[i]));
                let [u, v] = [0, 1].map(|k| points[i][k] - vertices[i][k]);
                errors.moved.push(u.hypot(v) / 1000.0);
            }
        }
        assert_eq!(block.0, *size);
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Every point with a rule lies where the file draws it, to its last digit; a point between two of
/// them, which the rules leave to the program, follows to a tenth of its way in the median.
#[test]
fn real_nests_are_made_of_their_sample_sizes() {
    let Some(data) = std::env::var_os("SEAMSTER_TEST_DATA") else {
        eprintln!("SEAMSTER_TEST_DATA is not set: no real nests are graded");
        return;
    };
    let mut errors = Errors::default();
    let files = fs::read_dir(Path::new(&data).join("dxf")).expect("a folder");
    let mut files: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    files.sort();
    for file in files
        .iter()
        .filter(|file| file.extension().is_some_and(|e| e == "DXF"))
    {
        let bytes = fs::read(file).expect("a file");
        let drawing = raw::read(&bytes);
        for (name, nest) in nests(&drawing) {
            compare(&name, &nest, &mut errors);
        }
    }
    assert!(errors.ruled.len() > 1000 && errors.between.len() > 1000);
    let worst = errors.ruled.iter().copied().fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst} m");
    let (between, moved) = (median(&mut errors.between), median(&mut errors.moved));
    println!(
        "{} points between rules: {between} m of {moved} m",
        errors.between.len()
    );
    assert!(between < 0.1 * moved, "{between} m of {moved} m");
}
