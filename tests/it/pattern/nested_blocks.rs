//! Pieces put together by wrapper blocks, at any depth: the same panels as those of the same file
//! whose pieces the model space inserts.

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster_fixtures::dxf::DxfBuilder;

const FRONT: [[f64; 2]; 4] = [
    [-185.0, 0.0],
    [185.0, 0.0],
    [245.0, -550.0],
    [-245.0, -550.0],
];
const SLEEVE: [[f64; 2]; 4] = [[0.0, 0.0], [120.0, 0.0], [120.0, 150.0], [30.0, 150.0]];
const HALF: [[f64; 2]; 4] = [[0.0, 0.0], [200.0, 0.0], [200.0, -600.0], [0.0, -600.0]];

/// A block with an outline on a layer and its texts, without an INSERT.
fn piece(
    file: DxfBuilder,
    name: &str,
    layer: &str,
    outline: &[[f64; 2]],
    texts: &[&str],
) -> DxfBuilder {
    let file = file.definition(name).run(layer, true, outline);
    texts.iter().fold(file, |file, text| file.text("1", text))
}

fn read(file: DxfBuilder, size: Option<&str>) -> Pattern {
    let options = ImportOptions {
        name: Some("style".into()),
        size: size.map(str::to_owned),
        ..ImportOptions::default()
    };
    import(&file.bytes(), &options, &Limits::default()).expect("a pattern")
}

/// A front, a pair of sleeves and a half back on the fold, in blocks.
fn shirt(layer: &str) -> DxfBuilder {
    let file = piece(
        DxfBuilder::metric(),
        "B1",
        layer,
        &FRONT,
        &["Piece Name: FRONT", "Quantity: 1"],
    );
    let texts = ["Piece Name: SLEEVE", "Quantity: 1,1"];
    let file = piece(file, "B2", layer, &SLEEVE, &texts);
    piece(
        file,
        "B3",
        layer,
        &HALF,
        &["Piece Name: BACK", "Quantity: 1"],
    )
    .line("6", [0.0, 0.0], [0.0, -600.0])
    .point("4", [200.0, -300.0])
    .line("7", [100.0, -100.0], [100.0, -500.0])
}

const PLACES: [(&str, [f64; 2]); 3] = [
    ("B1", [0.0, 0.0]),
    ("B2", [500.0, 40.0]),
    ("B3", [900.0, 0.0]),
];

fn with_inserts(file: DxfBuilder) -> DxfBuilder {
    let inserts = PLACES.iter();
    inserts.fold(file, |file, (name, at)| file.insert(name, *at))
}

#[test]
fn pieces_in_wrappers_are_those_of_the_flat_file() {
    for layer in ["1", "0"] {
        let flat = read(with_inserts(shirt(layer).end_block()), None);
        assert_eq!(flat.panels.len(), 4, "the pair has a mirrored copy");
        for depth in 1..=3 {
            let mut file = with_inserts(shirt(layer).definition("STYLE"));
            let mut top = "STYLE".to_owned();
            for level in 1..depth {
                let name = format!("LEVEL{level}");
                file = file.definition(&name).insert(&top, [10.0, 20.0]);
                top = name;
            }
            let nested = read(file.end_block().insert(&top, [-700.0, 3.0]), None);
            assert_eq!(nested.panels, flat.panels, "layer {layer}, depth {depth}");
            assert_eq!(nested.warnings, flat.warnings);
        }
    }
}

#[test]
fn wrapper_of_one_piece_keeps_its_name_and_the_texts_of_both() {
    let file = piece(DxfBuilder::metric(), "SLEEVE", "1", &SLEEVE, &[]);
    let file = file
        .definition("W")
        .insert("SLEEVE", [100.0, 0.0])
        .text("1", "Quantity: 1,1")
        .end_block()
        .insert("W", [0.0, 0.0]);
    let panels = read(file, None).panels;
    assert_eq!((panels.len(), panels[0].name.as_str()), (2, "SLEEVE"));
}

#[test]
fn mirrored_inserts_and_wrappers_mirror_their_pieces() {
    let mirrored = |file: DxfBuilder, name: &str| file.insert(name, [0.0, 0.0]).tag(41, "-1");
    let flat = shirt("1").end_block().insert("B2", [0.0, 0.0]);
    let flat = read(mirrored(flat, "B2"), None);
    let inside = shirt("1").definition("S").insert("B2", [0.0, 0.0]);
    let inside = mirrored(inside, "B2").end_block().insert("S", [5.0, 5.0]);
    assert_eq!(read(inside, None).panels, flat.panels);
    let outside = shirt("1").definition("S").insert("B2", [7.0, 0.0]);
    let outside = outside.end_block().insert("S", [0.0, 0.0]);
    assert_eq!(read(mirrored(outside, "S"), None).panels, flat.panels);
}

/// Two sizes of a front, in blocks.
fn sizes() -> DxfBuilder {
    let file = piece(
        DxfBuilder::metric(),
        "F38",
        "1",
        &FRONT.map(|p| p.map(|c| 0.96 * c)),
        &["Piece Name: FRONT", "Size: 38"],
    );
    piece(file, "F40", "1", &FRONT, &["Piece Name: FRONT", "Size: 40"])
}

#[test]
fn sizes_in_a_wrapper_are_offered() {
    let flat = sizes()
        .end_block()
        .insert("F38", [0.0; 2])
        .insert("F40", [0.0; 2]);
    let nested = sizes()
        .definition("STYLE")
        .insert("F38", [0.0; 2])
        .insert("F40", [0.0; 2]);
    let nested = nested.end_block().insert("STYLE", [0.0; 2]);
    let [flat, nested] = [flat, nested].map(|file| file.text("1", "Sample Size: 40").bytes());
    for size in [None, Some("38"), Some("40")] {
        let options = ImportOptions {
            size: size.map(str::to_owned),
            ..ImportOptions::default()
        };
        let [flat, nested] = [&flat, &nested]
            .map(|bytes| import(bytes, &options, &Limits::default()).expect("a pattern"));
        assert_eq!(nested.panels, flat.panels);
        assert_eq!(nested.source, flat.source);
        assert_eq!(nested.source.sizes, ["38", "40"]);
        assert_eq!(
            nested.source.sample_size.as_deref(),
            Some(size.unwrap_or("40"))
        );
    }
}

#[test]
fn wrapper_states_the_size_of_its_pieces_and_facts_of_the_file() {
    let file = piece(
        DxfBuilder::default(),
        "A",
        "1",
        &FRONT,
        &["Piece Name: FRONT"],
    );
    let file = piece(file, "B", "1", &SLEEVE, &["Piece Name: SLEEVE"]);
    let file = file
        .definition("S38")
        .insert("A", [0.0, 0.0])
        .insert("B", [500.0, 0.0])
        .text("1", "Size: 38")
        .text("1", "Style Name: SHIRT")
        .text("1", "Units: METRIC")
        .end_block()
        .insert("S38", [0.0, 0.0]);
    let pattern = read(file, None);
    assert_eq!((pattern.name.as_str(), pattern.panels.len()), ("SHIRT", 2));
    assert_eq!(pattern.source.sizes, ["38"]);
    assert_eq!(pattern.warnings, []);
}

#[test]
fn wrapper_that_nothing_inserts_is_taken_and_told() {
    let pattern = read(with_inserts(shirt("1").definition("STYLE")), None);
    assert_eq!(pattern.panels.len(), 4);
    assert_eq!(pattern.warnings[0].code, "pattern/block_not_inserted");
}

#[test]
fn piece_that_is_put_together_of_blocks_stays_one() {
    let file = DxfBuilder::metric()
        .definition("OUTLINE")
        .run("1", true, &FRONT)
        .definition("SEW")
        .run("14", true, &FRONT.map(|p| [0.9 * p[0], -20.0 + 0.9 * p[1]]))
        .definition("MARK")
        .point("13", [0.0, 0.0])
        .definition("FRONT")
        .insert("OUTLINE", [0.0, 0.0])
        .insert("SEW", [0.0, 0.0])
        .insert("MARK", [0.0, -100.0])
        .end_block()
        .insert("FRONT", [0.0, 0.0]);
    let pattern = read(file, None);
    let [panel] = &pattern.panels[..] else {
        panic!("{} panels", pattern.panels.len());
    };
    assert_eq!((panel.name.as_str(), panel.drill_holes.len()), ("FRONT", 1));
    assert!(!panel.cut_line.is_empty());
}

#[test]
fn what_lies_in_a_piece_of_a_wrapper_goes_to_it() {
    let file = with_inserts(shirt("1").definition("STYLE"))
        .point("13", [560.0, 100.0])
        .line("8", [40.0, -100.0], [90.0, -100.0])
        .run(
            "0",
            true,
            &[
                [-400.0, -700.0],
                [1300.0, -700.0],
                [1300.0, 400.0],
                [-400.0, 400.0],
            ],
        )
        .end_block()
        .insert("STYLE", [50.0, 0.0]);
    let pattern = read(file, None);
    let panel = |id: &str| pattern.panels.iter().find(|p| p.id == id).expect("a panel");
    assert_eq!(panel("sleeve").drill_holes.len(), 1);
    let [x, y] = panel("sleeve").drill_holes[0];
    assert!((x - 0.06).abs() < 1e-12 && (y - 0.06).abs() < 1e-12);
    assert_eq!(panel("front").internal_lines.len(), 1);
    assert_eq!(pattern.panels.len(), 4, "the frame is none");
}
