//! Units and sizes that a file does not state or states wrong: what was taken, and what chooses.

use seamster::config::Limits;
use seamster::fault::Warning;
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster_fixtures::dxf::DxfBuilder;

fn read(file: DxfBuilder) -> Pattern {
    import(&file.bytes(), &ImportOptions::default(), &Limits::default()).expect("a pattern")
}

fn warning<'a>(pattern: &'a Pattern, code: &str) -> &'a Warning {
    let found = pattern.warnings.iter().find(|w| w.code == code);
    found.unwrap_or_else(|| panic!("no {code} in {:?}", pattern.warnings))
}

/// A panel that is `height` drawing units high.
fn panel(height: f64) -> DxfBuilder {
    let corners = [
        [0.0, 0.0],
        [0.8 * height, 0.0],
        [0.8 * height, height],
        [0.0, height],
    ];
    DxfBuilder::default().run("0", true, &corners)
}

#[test]
fn every_unit_that_gives_a_garment_is_named_inches_first() {
    for (height, offers) in [
        (
            23.622,
            "units=inch would make it 0.600 m, units=cm would make it 0.236 m",
        ),
        (
            60.0,
            "units=inch would make it 1.524 m, units=cm would make it 0.600 m",
        ),
        (1.5, "units=m would make it 1.500 m"),
        (300.0 / 25.4 / 2.0, "units=inch would make it 0.150 m"),
    ] {
        let pattern = read(panel(height));
        let told = &warning(&pattern, "pattern/units_implausible").detail;
        assert!(told.ends_with(offers), "{told}");
        assert!(
            told.starts_with("read in mm, the largest panel is"),
            "{told}"
        );
    }
}

#[test]
fn sample_size_that_is_no_size_of_the_file_is_told_as_that() {
    let corners = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];
    let sized = |sample: Option<&str>| {
        let mut file = DxfBuilder::metric();
        if let Some(sample) = sample {
            file = file.text("1", &format!("Sample Size: {sample}"));
        }
        for size in ["38", "40", "42"] {
            file = file
                .block(&format!("F{size}"))
                .text("1", "Piece Name: FRONT")
                .text("1", &format!("Size: {size}"))
                .run("1", true, &corners);
        }
        read(file)
    };
    let absent = sized(Some("44"));
    let told = &warning(&absent, "pattern/sample_size").detail;
    assert_eq!(
        told,
        "the sample size of the file is \"44\", which is not among its sizes (38, 40, 42); 38 was taken (size= chooses)"
    );
    assert_eq!(absent.source.sample_size.as_deref(), Some("38"));
    let unstated = sized(None);
    let told = &warning(&unstated, "pattern/sample_size").detail;
    assert!(told.starts_with("the file does not say"), "{told}");
    assert_eq!(sized(Some("40")).warnings, []);
}
