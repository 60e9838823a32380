//! Import of files with pieces that cannot be read: the others come in, and it is said.

use super::read::{imported, imported_with, refused_with, warnings};
use seamster::pattern::{ImportOptions, Unfold};
use seamster_fixtures::dxf::DxfBuilder;

fn piece(file: DxfBuilder, name: &str, outline: &[[f64; 2]]) -> DxfBuilder {
    let file = file.block(name).text("1", &format!("Piece Name: {name}"));
    file.run("1", true, outline)
}

const GOOD: [[f64; 2]; 4] = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];
const BOW_TIE: [[f64; 2]; 4] = [[0.0, 0.0], [300.0, 400.0], [300.0, 0.0], [0.0, 400.0]];

fn strict() -> ImportOptions {
    ImportOptions {
        strict: true,
        ..ImportOptions::default()
    }
}

#[test]
fn piece_that_crosses_itself_is_left_out_of_a_good_file() {
    let spoiled = [
        BOW_TIE.to_vec(),
        vec![[0.0, 0.0], [300.0, 0.0], [100.0, 0.0]],
    ];
    for outline in spoiled {
        let file = || {
            let file = piece(DxfBuilder::metric(), "FRONT", &GOOD);
            piece(piece(file, "BAD", &outline), "BACK", &GOOD)
        };
        let pattern = imported(file());
        let names: Vec<&str> = pattern.panels.iter().map(|p| &*p.name).collect();
        assert_eq!(names, ["FRONT", "BACK"]);
        assert_eq!(warnings(&pattern, "pattern/piece_left_out"), 1);
        let faults = refused_with(file(), &strict());
        assert_eq!(faults.0.len(), 1);
        assert!(faults.0[0].detail.contains("BAD"));
    }
    let alone = piece(DxfBuilder::metric(), "BAD", &BOW_TIE);
    let faults = refused_with(alone, &ImportOptions::default());
    assert_eq!(faults.0[0].code, "pattern/self_intersecting");
}

#[test]
fn small_loop_is_cut_off() {
    let crossed = [
        [0.0, 0.0],
        [300.0, 0.0],
        [300.0, 403.0],
        [303.0, 400.0],
        [0.0, 400.0],
    ];
    let file = || piece(DxfBuilder::metric(), "P", &crossed);
    let pattern = imported(file());
    assert_eq!(warnings(&pattern, "pattern/loop_cut_off"), 1);
    assert!((pattern.panels[0].area_m2 - 0.12).abs() < 1e-9);
    let faults = refused_with(file(), &strict());
    assert_eq!(faults.0[0].code, "pattern/loop_cut_off");
}

#[test]
fn pieces_that_share_an_edge_are_two() {
    // The second piece has three sides of its own; its first is the first piece's last.
    let left = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];
    let right = [[300.0, 0.0], [500.0, -50.0], [500.0, 400.0], [300.0, 400.0]];
    for turned in [false, true] {
        let mut right = right.to_vec();
        if turned {
            right.reverse();
        }
        for layer in ["0", "1"] {
            let file = DxfBuilder::metric()
                .run(layer, true, &left)
                .run(layer, false, &right);
            let pattern = imported(file);
            let areas: Vec<f64> = pattern.panels.iter().map(|p| p.area_m2).collect();
            assert!((areas[0] - 0.12).abs() < 1e-9, "{areas:?}");
            assert!((areas[1] - 0.085).abs() < 1e-9, "{areas:?}");
            assert_eq!(warnings(&pattern, "pattern/shared_edge"), 1);
        }
    }
    // A dart on the layer of sew lines closes nothing.
    let file = piece(DxfBuilder::metric(), "SKIRT", &left).text("15", "ON FOLD");
    let dart = file.run(
        "14",
        false,
        &[[140.0, 400.0], [150.0, 300.0], [160.0, 400.0]],
    );
    assert!((imported(dart).panels[0].area_m2 - 0.12).abs() < 1e-9);
    // A line across a piece is no piece.
    let file = DxfBuilder::metric().run("0", true, &left);
    let across = file.run("0", false, &[[0.0, 100.0], [150.0, 150.0], [300.0, 100.0]]);
    assert_eq!(imported(across).panels.len(), 1);
}

#[test]
fn sew_line_that_is_open_at_a_straight_edge_is_half_a_piece() {
    let cut = [[0.0, -10.0], [310.0, -10.0], [310.0, 410.0], [0.0, 410.0]];
    let sew = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];
    let whole = || {
        let file = piece(DxfBuilder::metric(), "FRONT", &cut);
        file.run("14", false, &sew)
    };
    let pattern = imported(whole());
    assert_eq!(warnings(&pattern, "pattern/fold_assumed"), 1);
    assert!((pattern.panels[0].area_m2 - 0.12).abs() < 1e-9);
    let file = || whole().text("15", "CUT 1 ON FOLD");
    let pattern = imported(file());
    assert_eq!(warnings(&pattern, "pattern/fold_assumed"), 1);
    assert!((pattern.panels[0].area_m2 - 0.24).abs() < 1e-9);
    assert!(pattern.panels[0].unfolded);
    let options = ImportOptions {
        unfold: Unfold::None,
        ..ImportOptions::default()
    };
    let pattern = imported_with(file(), &options);
    assert!((pattern.panels[0].area_m2 - 0.12).abs() < 1e-9);
}
