//! Import of outlines that lie in others: frames, sizes, allowances, holes and lines.

use super::read::{imported, imported_with, refused_with, warnings};
use seamster::pattern::{ImportOptions, Outlines, Pattern};
use seamster_fixtures::dxf::DxfBuilder;

/// Half width of a skirt at waist and hem, and its length [mm].
const SKIRT: [f64; 3] = [200.0, 260.0, 600.0];

/// A skirt about its middle, so many times as large, moved along x.
fn skirt(scale: f64, x: f64) -> [[f64; 2]; 4] {
    let [waist, hem, length] = SKIRT.map(|c| scale * c);
    let corners = [
        [-waist, length],
        [waist, length],
        [hem, -length],
        [-hem, -length],
    ];
    corners.map(|[u, v]| [x + u, v / 2.0])
}

fn area_m2(scale: f64) -> f64 {
    let [waist, hem, length] = SKIRT.map(|c| scale * c / 1000.0);
    (waist + hem) * length
}

fn rectangle(x: f64, y: f64) -> [[f64; 2]; 4] {
    [[-x, -y], [-x, y], [x, y], [x, -y]]
}

fn areas_are(pattern: &Pattern, expected: &[f64]) {
    let areas: Vec<f64> = pattern.panels.iter().map(|panel| panel.area_m2).collect();
    assert_eq!(areas.len(), expected.len(), "{areas:?}");
    for (area, expected) in areas.iter().zip(expected) {
        assert!((area - expected).abs() < 1e-9, "{areas:?}");
    }
}

fn reading(outlines: Outlines) -> ImportOptions {
    ImportOptions {
        outlines,
        ..ImportOptions::default()
    }
}

/// A drawing of sizes, each on its layer.
fn nest(sizes: &[(&str, f64)]) -> DxfBuilder {
    let drawn = sizes.iter();
    drawn.fold(DxfBuilder::metric(), |file, (layer, scale)| {
        file.run(layer, true, &skirt(*scale, 0.0))
    })
}

#[test]
fn sizes_in_each_other_are_named_by_their_layers() {
    let sizes = [("42", 1.08), ("38", 0.96), ("40", 1.0), ("36", 0.92)];
    for count in 2..=sizes.len() {
        let file = || nest(&sizes[..count]);
        let pattern = imported(file());
        assert_eq!(pattern.source.sizes.len(), count);
        assert_eq!(warnings(&pattern, "pattern/nested_sizes"), 1);
        for (name, scale) in &sizes[..count] {
            let options = ImportOptions {
                size: Some((*name).to_owned()),
                ..ImportOptions::default()
            };
            let pattern = imported_with(file(), &options);
            areas_are(&pattern, &[area_m2(*scale)]);
            assert_eq!(pattern.source.sample_size.as_deref(), Some(*name));
            assert!(pattern.panels[0].cut_line.is_empty());
        }
        let options = ImportOptions {
            size: Some("50".to_owned()),
            ..ImportOptions::default()
        };
        let faults = refused_with(file(), &options);
        assert_eq!(faults.0[0].code, "pattern/unknown_size");
    }
}

#[test]
fn sizes_on_one_layer_are_named_by_texts_or_numbered() {
    let same = [("0", 0.96), ("0", 1.0), ("0", 1.04)];
    assert_eq!(imported(nest(&same)).source.sizes, ["1", "2", "3"]);
    let named = ["L", "S", "M"].iter();
    let named = named.fold(nest(&same), |file, name| file.text("0", name));
    let pattern = imported(named);
    assert_eq!(pattern.source.sizes, ["S", "M", "L"]);
    let in_block = same.iter().fold(
        DxfBuilder::metric()
            .block("FRONT")
            .text("1", "Piece Name: FRONT"),
        |file, (_, scale)| file.run("1", true, &skirt(*scale, 0.0)),
    );
    let pattern = imported(in_block);
    assert_eq!(pattern.source.sizes, ["1", "2", "3"]);
    assert_eq!(pattern.panels[0].name, "FRONT");
}

#[test]
fn notches_belong_to_the_size_that_they_lie_on() {
    let sizes = [("38", 0.96), ("40", 1.0), ("42", 1.04)];
    let file = sizes.iter().fold(nest(&sizes), |file, (_, scale)| {
        file.point("4", [50.0 * scale, 300.0 * scale])
    });
    let pattern = imported(file);
    let notches: Vec<f64> = pattern.panels[0].notches.iter().map(|n| n.at).collect();
    assert_eq!(notches.len(), 1);
    // 250 of 400 mm, in every size.
    assert!((notches[0] - 0.625).abs() < 1e-9, "{notches:?}");
}

#[test]
fn two_outlines_at_the_distance_of_an_allowance_are_sewn_and_cut() {
    for (x, y) in [(190.0, 290.0), (187.3, 287.3), (190.0, 260.0)] {
        let file = DxfBuilder::metric()
            .run("0", true, &rectangle(200.0, 300.0))
            .run("0", true, &rectangle(x, y));
        let pattern = imported(file);
        areas_are(&pattern, &[4e-6 * x * y]);
        assert_eq!(pattern.panels[0].cut_line.len(), 4);
        assert_eq!(warnings(&pattern, "pattern/outline_inside"), 1);
    }
    let uneven = || {
        let file = DxfBuilder::metric().run("0", true, &skirt(1.0, 0.0));
        file.run("0", true, &skirt(0.961, 0.0))
    };
    assert_eq!(imported(uneven()).source.sizes, ["1", "2"]);
    let pattern = imported_with(uneven(), &reading(Outlines::Allowance));
    areas_are(&pattern, &[area_m2(0.961)]);
    assert!(pattern.source.sizes.is_empty());
    let pattern = imported_with(uneven(), &reading(Outlines::Lines));
    areas_are(&pattern, &[area_m2(1.0)]);
    assert_eq!(pattern.panels[0].internal_lines.len(), 1);
}

#[test]
fn frame_about_the_pieces_is_left_out() {
    for layer in ["0", "FRAME"] {
        let file = || {
            DxfBuilder::metric()
                .run(layer, true, &rectangle(1000.0, 500.0))
                .run("0", true, &skirt(1.0, -400.0))
                .run("0", true, &skirt(1.0, 400.0))
        };
        let pattern = imported(file());
        areas_are(&pattern, &[area_m2(1.0); 2]);
        assert_eq!(warnings(&pattern, "pattern/frame"), 1);
        let pattern = imported_with(file(), &reading(Outlines::Lines));
        areas_are(&pattern, &[2.0]);
        let pattern = imported_with(file(), &reading(Outlines::Holes));
        areas_are(&pattern, &[2.0 - 2.0 * area_m2(1.0)]);
    }
    // A frame in a frame, about a single piece on a layer that says so.
    let file = DxfBuilder::metric()
        .run("Sheet border", true, &rectangle(1000.0, 500.0))
        .run("Sheet border", true, &rectangle(980.0, 480.0))
        .run("0", true, &skirt(1.0, 0.0));
    areas_are(&imported(file), &[area_m2(1.0)]);
}

#[test]
fn rectangle_with_small_outlines_in_it_is_a_piece() {
    let small = |x: f64| rectangle(20.0, 30.0).map(|[u, v]| [u + x, v]);
    let file = |layer: &str| {
        DxfBuilder::metric()
            .run(layer, true, &rectangle(200.0, 300.0))
            .run(layer, true, &small(-100.0))
            .run(layer, true, &small(100.0))
    };
    let pattern = imported(file("0"));
    areas_are(&pattern, &[0.24]);
    assert_eq!(pattern.panels[0].internal_lines.len(), 2);
    assert_eq!(warnings(&pattern, "pattern/outline_inside"), 1);
    // What lies on the layer of cut lines is cut out.
    let pattern = imported(file("1"));
    areas_are(&pattern, &[0.24 - 2.0 * 0.0024]);
    assert_eq!(pattern.panels[0].holes.len(), 2);
    let pattern = imported_with(file("0"), &reading(Outlines::Pieces));
    areas_are(&pattern, &[0.0024, 0.0024]);
}

#[test]
fn sizes_have_their_own_sew_lines_and_holes() {
    let sizes = [0.9, 1.0, 1.1];
    let file = || {
        let file = DxfBuilder::metric()
            .block("FRONT")
            .text("1", "Piece Name: FRONT");
        sizes.iter().fold(file, |file, scale| {
            let [x, y] = [200.0 * scale, 300.0 * scale];
            file.run("1", true, &rectangle(x, y))
                .run("14", true, &rectangle(x - 10.0, y - 10.0))
                .run("11", true, &rectangle(30.0 * scale, 30.0 * scale))
        })
    };
    for (size, scale) in ["1", "2", "3"].iter().zip(sizes) {
        let options = ImportOptions {
            size: Some((*size).to_owned()),
            ..ImportOptions::default()
        };
        let pattern = imported_with(file(), &options);
        let sewn = 4e-6 * (200.0 * scale - 10.0) * (300.0 * scale - 10.0);
        areas_are(&pattern, &[sewn - 4e-6 * 900.0 * scale * scale]);
        assert_eq!(pattern.panels[0].holes.len(), 1);
        assert_eq!(pattern.panels[0].cut_line.len(), 4);
    }
}

#[test]
fn piece_that_states_its_size_is_not_taken_apart() {
    let file = ["S", "M"].iter().fold(DxfBuilder::metric(), |file, size| {
        file.block(&format!("FRONT-{size}"))
            .text("1", "Piece Name: FRONT")
            .text("1", &format!("Size: {size}"))
            .run("1", true, &skirt(1.0, 0.0))
            .run("1", true, &skirt(0.961, 0.0))
    });
    let pattern = imported(file.text("1", "Sample Size: M"));
    assert_eq!(pattern.source.sizes, ["S", "M"]);
    areas_are(&pattern, &[area_m2(0.961)]);
}

#[test]
fn layers_with_numbers_are_no_sizes_of_an_allowance() {
    let file = DxfBuilder::metric()
        .run("20", true, &rectangle(200.0, 300.0))
        .run("0", true, &rectangle(190.0, 290.0));
    let pattern = imported(file);
    assert!(pattern.source.sizes.is_empty());
    areas_are(&pattern, &[4e-6 * 190.0 * 290.0]);
}

#[test]
fn apron_with_windows_is_no_frame() {
    let window = |x: f64| rectangle(80.0, 80.0).map(|[u, v]| [u + x, v]);
    let file = DxfBuilder::metric()
        .block("APRON")
        .text("1", "Piece Name: APRON");
    let file = file
        .run("1", true, &rectangle(300.0, 250.0))
        .run("1", true, &window(-150.0))
        .run("1", true, &window(150.0));
    let pattern = imported(file);
    areas_are(&pattern, &[0.3 - 2.0 * 0.0256]);
}

#[test]
fn title_block_goes_with_the_frame() {
    let title = [
        [800.0, -500.0],
        [1000.0, -500.0],
        [1000.0, -400.0],
        [800.0, -400.0],
    ];
    let file = DxfBuilder::metric()
        .run("0", true, &rectangle(1000.0, 500.0))
        .run("0", true, &title)
        .run("0", true, &skirt(1.0, -400.0))
        .run("0", true, &skirt(1.0, 300.0));
    areas_are(&imported(file), &[area_m2(1.0); 2]);
}

#[test]
fn piece_without_the_size_is_told() {
    let file = DxfBuilder::metric();
    let file = [("FRONT", &["S", "M", "L"][..]), ("CUFF", &["S", "M"][..])]
        .iter()
        .fold(file, |file, (name, sizes)| {
            sizes.iter().fold(file, |file, size| {
                file.block(&format!("{name}-{size}"))
                    .text("1", &format!("Piece Name: {name}"))
                    .text("1", &format!("Size: {size}"))
                    .run("1", true, &skirt(1.0, 0.0))
            })
        });
    let options = ImportOptions {
        size: Some("L".to_owned()),
        ..ImportOptions::default()
    };
    let pattern = imported_with(file, &options);
    assert_eq!(pattern.panels.len(), 1);
    assert_eq!(warnings(&pattern, "pattern/size_missing"), 1);
}

/// Sizes about a common point: the hems and sides of larger ones lie outside, their tops inside.
#[test]
fn sizes_that_stick_out_of_each_other_are_a_nest() {
    let size = |x: f64, top: f64, length: f64| {
        [
            [0.0, top],
            [x, top],
            [x + 40.0, top - length],
            [0.0, top - length],
        ]
    };
    let file = || {
        DxfBuilder::metric()
            .run("0", true, &size(200.0, 0.0, 600.0))
            .run("0", true, &size(210.0, -3.0, 612.0))
            .run("0", true, &size(220.0, -6.0, 624.0))
    };
    let pattern = imported(file());
    assert_eq!(pattern.source.sizes, ["1", "2", "3"]);
    areas_are(&pattern, &[0.22 * 0.6]);
    // Two panels beside each other are none.
    let beside = size(200.0, 0.0, 600.0).map(|[x, y]| [x + 240.0, y]);
    let two = DxfBuilder::metric()
        .run("0", true, &size(200.0, 0.0, 600.0))
        .run("0", true, &beside);
    assert_eq!(imported(two).panels.len(), 2);
}
