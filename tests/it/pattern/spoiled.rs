//! Import of files with pieces that cannot be read: the others come in, and it is said.

use super::read::{imported, imported_with, refused_with, warnings};
use seamster::pattern::ImportOptions;
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
    for options in [ImportOptions::default(), strict()] {
        let pattern = imported_with(piece(DxfBuilder::metric(), "P", &crossed), &options);
        assert_eq!(warnings(&pattern, "pattern/loop_cut_off"), 1);
        assert!((pattern.panels[0].area_m2 - 0.12).abs() < 1e-9);
    }
}
