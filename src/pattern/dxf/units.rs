//! Which unit the coordinates are in: what the caller says, else the `Units:` text, else `$INSUNITS`, else millimetres.

use super::Findings;
use super::label::Labels;
use crate::fault::Fault;
use crate::pattern::Units;

impl Units {
    /// Its name: `mm`, `cm`, `m` or `inch`.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Cm => "cm",
            Self::M => "m",
            Self::Inch => "inch",
        }
    }

    /// Its length \[m\].
    pub(crate) fn in_metres(self) -> f64 {
        match self {
            Self::Mm => 0.001,
            Self::Cm => 0.01,
            Self::M => 1.0,
            Self::Inch => 0.0254,
        }
    }
}

/// The unit of a file; statements that are unknown or contradict each other become warnings.
pub(super) fn of(
    asked: Option<Units>,
    labels: &Labels,
    insunits: Option<i32>,
    findings: &mut Findings,
) -> Units {
    if let Some(units) = asked {
        return units;
    }
    let text = labels.with_line("units").and_then(|(value, line)| {
        let units = from_text(value);
        if units.is_none() {
            findings.warn(
                "pattern/units_unknown",
                line,
                format!("the text says \"Units: {value}\", which is not known"),
            );
        }
        units.map(|units| (units, line))
    });
    let header = insunits.filter(|code| *code != 0).and_then(|code| {
        let units = from_insunits(code);
        if units.is_none() {
            findings.warn(
                "pattern/units_unknown",
                1,
                format!("$INSUNITS is {code}, which is not a unit of patterns"),
            );
        }
        units
    });
    match (text, header) {
        (Some((said, line)), Some(other)) if said != other => {
            let (said_name, other_name) = (said.name(), other.name());
            findings.warn(
                "pattern/units_conflict",
                line,
                format!("the text says {said_name} and $INSUNITS says {other_name}; {said_name} was taken (units= overrides)"),
            );
            said
        }
        (Some((said, _)), _) => said,
        (None, Some(units)) => units,
        (None, None) => {
            findings.warn(
                "pattern/units_assumed",
                1,
                "the file does not say its units; mm was taken (units= overrides)",
            );
            Units::Mm
        }
    }
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

/// Sizes between which the longest side of a garment's largest panel lies \[m\]: a baby's cuff to a bridal train.
const PLAUSIBLE: [f64; 2] = [0.12, 4.0];

/// Checks the longest side of the largest panel: outside `hard` limits the import is refused, outside the plausible
/// range it is warned about; both name the unit that would fit. A length of 0 says that there is no panel to measure.
pub(super) fn check(
    units: Units,
    longest_m: f64,
    hard: [f64; 2],
    findings: &mut Findings,
) -> Result<(), Fault> {
    let plausible = |size: f64| (PLAUSIBLE[0]..=PLAUSIBLE[1]).contains(&size);
    if longest_m == 0.0 || plausible(longest_m) {
        return Ok(());
    }
    let drawn = longest_m / units.in_metres();
    let fitting = [Units::Mm, Units::Cm, Units::Inch, Units::M]
        .into_iter()
        .find(|u| plausible(drawn * u.in_metres()));
    let detail = format!(
        "read in {}, the largest panel is {} long",
        units.name(),
        shown(longest_m)
    );
    let fix = match fitting {
        Some(other) => format!(
            "say the units of the file: units={} would make it {}",
            other.name(),
            shown(drawn * other.in_metres())
        ),
        None => {
            "say the units of the file with units=mm|cm|m|inch, or check the drawing".to_owned()
        }
    };
    if (hard[0]..=hard[1]).contains(&longest_m) {
        findings.warn("pattern/units_implausible", 1, format!("{detail}; {fix}"));
        return Ok(());
    }
    Err(Fault::new("pattern/units_implausible", "line 1", detail).fix(fix))
}

fn shown(metres: f64) -> String {
    match metres {
        m if (0.01..1e4).contains(&m) => format!("{m:.3} m"),
        m if (1e-5..0.01).contains(&m) => format!("{:.3} mm", m * 1000.0),
        m => format!("{m:.3e} m"),
    }
}
