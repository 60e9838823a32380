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
