//! The unit of the coordinates: what the caller says, else the `Units:` text, else `$INSUNITS`,
//! else millimeters.

use super::labels::DxfLabels;
use crate::fault::{Fault, PatternCode};
use crate::pattern::Units;
use crate::pattern::dxf::findings::DxfFindings;

/// Returns the unit of a file; statements that are unknown or contradict each other become
/// warnings.
pub(crate) fn determine(
    wanted: Option<Units>,
    labels: &DxfLabels,
    insunits: Option<i32>,
    findings: &mut DxfFindings,
) -> Units {
    if let Some(unit) = wanted {
        return unit;
    }
    let label = unit_of_label(labels, findings);
    let header = unit_of_header(insunits, findings);
    match (label, header) {
        (Some((unit, line)), Some(other)) if unit != other => {
            let (name, other_name) = (unit.name(), other.name());
            let detail = format!(
                "the text says {name} and $INSUNITS says {other_name}; {name} was taken (units= overrides)"
            );
            findings.warn(PatternCode::UnitsConflict, line, detail);
            unit
        }
        (Some((unit, _)), _) | (None, Some(unit)) => unit,
        (None, None) => {
            let detail = "the file does not say its units; mm was taken (units= overrides)";
            findings.warn(PatternCode::UnitsAssumed, 1, detail);
            Units::Mm
        }
    }
}

/// Returns the unit of the `Units:` text, with its line.
fn unit_of_label(labels: &DxfLabels, findings: &mut DxfFindings) -> Option<(Units, usize)> {
    let (value, line) = labels.with_line("units")?;
    let unit = from_text(value);
    if unit.is_none() {
        let detail = format!("the text says \"Units: {value}\", which is not known");
        findings.warn(PatternCode::UnitsUnknown, line, detail);
    }
    Some((unit?, line))
}

/// Returns the unit of `$INSUNITS`; 0 says that there is none.
fn unit_of_header(insunits: Option<i32>, findings: &mut DxfFindings) -> Option<Units> {
    let code = insunits.filter(|code| *code != 0)?;
    let unit = from_insunits(code);
    if unit.is_none() {
        let detail = format!("$INSUNITS is {code}, which is not a unit of patterns");
        findings.warn(PatternCode::UnitsUnknown, 1, detail);
    }
    unit
}

fn from_text(value: &str) -> Option<Units> {
    match value.to_lowercase().trim_end_matches('.') {
        "metric" | "mm" | "millimeter" | "millimeters" | "millimetres" => Some(Units::Mm),
        "cm" | "centimeter" | "centimeters" | "centimetres" => Some(Units::Cm),
        "m" | "meter" | "meters" | "metres" => Some(Units::M),
        "english" | "imperial" | "in" | "inch" | "inches" => Some(Units::Inch),
        _ => None,
    }
}

fn from_insunits(code: i32) -> Option<Units> {
    match code {
        1 => Some(Units::Inch),
        4 => Some(Units::Mm),
        5 => Some(Units::Cm),
        6 => Some(Units::M),
        _ => None,
    }
}

/// Sizes between which the longest side of a garment's largest panel lies \[m\]: a baby's cuff to a
/// bridal train.
const PLAUSIBLE: [f64; 2] = [0.12, 4.0];

/// Checks the longest side of the largest panel, 0 if there is no panel to measure.
///
/// Outside the plausible range a warning, outside the `hard` limits a fault names the unit that
/// would fit.
///
/// # Errors
/// A size outside the `hard` limits.
pub(crate) fn check(
    unit: Units,
    longest_m: f64,
    hard: [f64; 2],
    findings: &mut DxfFindings,
) -> Result<(), Fault> {
    if longest_m == 0.0 || is_plausible(longest_m) {
        return Ok(());
    }
    let drawn = longest_m / unit.in_meters();
    let detail = format!(
        "read in {}, the largest panel is {} long",
        unit.name(),
        formatted(longest_m)
    );
    let fix = fix(drawn);
    if (hard[0]..=hard[1]).contains(&longest_m) {
        findings.warn(PatternCode::UnitsImplausible, 1, format!("{detail}; {fix}"));
        return Ok(());
    }
    Err(Fault::new(PatternCode::UnitsImplausible, "line 1", detail).fix(fix))
}

fn is_plausible(size_m: f64) -> bool {
    (PLAUSIBLE[0]..=PLAUSIBLE[1]).contains(&size_m)
}

/// Returns the advice for a largest panel of a length in drawing units: every unit that makes it
/// the size of a garment. Inches come first: of the units that AAMA and ASTM have, they are the
/// other one.
fn fix(drawn: f64) -> String {
    let units = [Units::Inch, Units::Cm, Units::Mm, Units::M];
    let fitting = units.map(|unit| (unit.name(), drawn * unit.in_meters()));
    let fitting = fitting.iter().filter(|(_, size)| is_plausible(*size));
    let offers: Vec<String> = fitting
        .map(|(name, size)| format!("units={name} would make it {}", formatted(*size)))
        .collect();
    if offers.is_empty() {
        return "say the units of the file with units=mm|cm|m|inch, or check the drawing"
            .to_owned();
    }
    format!("say the units of the file: {}", offers.join(", "))
}

fn formatted(length_m: f64) -> String {
    match length_m {
        m if (0.01..1e4).contains(&m) => format!("{m:.3} m"),
        m if (1e-5..0.01).contains(&m) => format!("{:.3} mm", m * 1000.0),
        m => format!("{m:.3e} m"),
    }
}
