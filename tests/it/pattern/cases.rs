//! The cases of faults that people reported of tools of this trade, found by `SEAMSTER_TEST_DATA`,
//! against the values that are right.

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Panel, Pattern, import};
use std::fs;
use std::path::PathBuf;

fn case(path: &str) -> Option<PathBuf> {
    let data = std::env::var_os("SEAMSTER_TEST_DATA");
    if data.is_none() {
        eprintln!("SEAMSTER_TEST_DATA is not set: {path} is not read");
    }
    data.map(|data| PathBuf::from(data).join("cases").join(path))
}

fn read_size(path: &str, size: Option<&str>) -> Option<Pattern> {
    let bytes = fs::read(case(path)?).expect("a case");
    let options = ImportOptions {
        size: size.map(str::to_owned),
        ..ImportOptions::default()
    };
    Some(import(&bytes, &options, &Limits::default()).expect("a pattern"))
}

fn read(path: &str) -> Option<Pattern> {
    read_size(path, None)
}

fn has(pattern: &Pattern, code: &str) -> bool {
    pattern.warnings.iter().any(|warning| warning.code == code)
}

fn names(pattern: &Pattern) -> Vec<&str> {
    pattern.panels.iter().map(|panel| &*panel.name).collect()
}

fn areas(pattern: &Pattern) -> Vec<f64> {
    pattern.panels.iter().map(|panel| panel.area_m2).collect()
}

fn assert_areas(path: &str, expected: &[f64], tolerance: f64) {
    let Some(pattern) = read(path) else {
        return;
    };
    let areas = areas(&pattern);
    assert_eq!(areas.len(), expected.len(), "{path}: {areas:?}");
    for (area, expected) in areas.iter().zip(expected) {
        assert!((area - expected).abs() <= tolerance, "{path}: {areas:?}");
    }
}

#[test]
fn nested_sizes() {
    for (file, sizes) in [
        ("nst2", 2),
        ("nst3", 3),
        ("nst3_same", 3),
        ("nst5", 5),
        ("nst_aama", 3),
    ] {
        let path = format!("nested-sizes-as-allowance/{file}.dxf");
        let Some(pattern) = read(&path) else {
            return;
        };
        assert!(has(&pattern, "pattern/nested_sizes"), "{file}");
        assert_eq!(pattern.source.sizes.len(), sizes, "{file}");
        let of_size = |size: &String| read_size(&path, Some(size)).expect("a pattern");
        let each: Vec<f64> = pattern
            .source
            .sizes
            .iter()
            .map(|s| areas(&of_size(s))[0])
            .collect();
        assert!(
            each.windows(2).all(|pair| pair[0] < pair[1]),
            "{file}: {each:?}"
        );
        // Size 40: a trapezium of 400 and 520 by 600 mm.
        let middle = if sizes == 5 { 2 } else { 1 };
        assert!((each[middle] - 0.276).abs() < 1e-9, "{file}: {each:?}");
        assert!(pattern.panels.iter().all(|panel| panel.cut_line.is_empty()));
    }
}

#[test]
fn frames() {
    for file in ["frame_layer", "frame_lw", "frame_poly", "noframe"] {
        assert_areas(&format!("frame-as-piece/{file}.dxf"), &[0.276; 2], 1e-9);
    }
}

#[test]
fn two_folds() {
    for file in ["tf_adj", "tf_adj_rev", "tf_poly"] {
        assert_areas(&format!("two-fold-lines/{file}.dxf"), &[0.48], 1e-9);
    }
    for file in ["tf_one", "tf_same", "tf_par"] {
        assert_areas(&format!("two-fold-lines/{file}.dxf"), &[0.24], 1e-9);
    }
    assert_areas("two-fold-lines/quarter_2fold.dxf", &[1.059_94], 1e-5);
    if let Some(pattern) = read("two-fold-lines/quarter_2fold.dxf") {
        assert_eq!(pattern.panels[0].holes.len(), 1);
    }
    if let Some(pattern) = read("two-fold-lines/tf_par.dxf") {
        assert!(has(&pattern, "pattern/fold_ignored"));
    }
}

#[test]
fn holes_on_the_fold() {
    let files = ["hole-on-fold/hof_rect.dxf", "hole-on-fold/hof_ref.dxf"];
    let [Some(half), Some(whole)] = files.map(read) else {
        return;
    };
    assert_eq!(areas(&half), areas(&whole));
    assert_eq!(half.panels[0].holes.len(), 1);
}

#[test]
fn code_pages() {
    for (file, twin) in [
        ("order_1251", "order_utf8"),
        ("order_uesc", "order_utf8"),
        ("order_sj", "order_sj_utf8"),
    ] {
        let files = [file, twin].map(|file| format!("dwgcodepage/{file}.dxf"));
        let [Some(pattern), Some(twin)] = files.map(|path| read(&path)) else {
            return;
        };
        assert_eq!(names(&pattern), names(&twin), "{file}");
    }
}

#[test]
fn wrapped_pieces() {
    for (file, twin) in [
        ("nest_qty", "flat_qty"),
        ("nested_lr", "flat_lr"),
        ("nested_fold", "flat_fold"),
    ] {
        let files = [file, twin].map(|file| format!("nested-insert-quantity/{file}.dxf"));
        let [Some(pattern), Some(twin)] = files.map(|path| read(&path)) else {
            return;
        };
        assert_eq!(pattern.panels, twin.panels, "{file}");
    }
    if let Some(pattern) = read("nested-insert-quantity/nested_sizes.dxf") {
        assert_eq!(pattern.source.sizes.len(), 2);
    }
}

#[test]
fn corners_of_faceted_curves() {
    for file in ["den_12_0", "den_12_3", "bodice_jit02"] {
        let Some(pattern) = read(&format!("facet-corners/{file}.dxf")) else {
            return;
        };
        let corners = |panel: &Panel| panel.corners.len();
        let counts: Vec<usize> = pattern.panels.iter().map(corners).collect();
        assert_eq!(counts, [8, 8], "{file}");
    }
}

#[test]
fn gaps() {
    for file in ["gap_0.05", "gap_0.2", "gap_0.5"] {
        let Some(pattern) = read(&format!("gap-message/{file}.dxf")) else {
            return;
        };
        assert_eq!(pattern.panels.len(), 1, "{file}");
        assert!(has(&pattern, "pattern/gap_closed"), "{file}");
    }
    let Some(path) = case("gap-message/gap_1.0.dxf") else {
        return;
    };
    let bytes = fs::read(path).expect("a case");
    let faults = import(&bytes, &ImportOptions::default(), &Limits::default());
    let faults = faults.expect_err("an open outline").0;
    assert_eq!(faults.len(), 1);
    assert_eq!(faults[0].detail.matches("1.00 mm").count(), 4, "{faults:?}");
}

#[test]
fn inches_come_first() {
    for file in ["inch_noins", "inch_aama_noins"] {
        let Some(pattern) = read(&format!("inch-hint-cm/{file}.dxf")) else {
            return;
        };
        let mut hints = pattern.warnings.iter();
        let hint = hints.find(|w| w.code == "pattern/units_implausible");
        let hint = &hint.expect("a hint").detail;
        let [inch, cm] = ["units=inch", "units=cm"].map(|unit| hint.find(unit));
        assert!(inch.is_some() && (cm.is_none() || inch < cm), "{hint}");
    }
}
