//! Files written in tests, read or refused.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster_fixtures::dxf::DxfBuilder;

pub(super) fn imported(file: DxfBuilder) -> Pattern {
    imported_with(file, &ImportOptions::default())
}

pub(super) fn imported_with(file: DxfBuilder, options: &ImportOptions) -> Pattern {
    import(&file.bytes(), options, &Limits::default()).expect("a file that can be read")
}

pub(super) fn refused_with(file: DxfBuilder, options: &ImportOptions) -> Faults {
    import(&file.bytes(), options, &Limits::default()).expect_err("a file that cannot be read")
}

/// Number of warnings of a code.
pub(super) fn warnings(pattern: &Pattern, code: &str) -> usize {
    let warnings = pattern.warnings.iter();
    warnings.filter(|warning| warning.code == code).count()
}
