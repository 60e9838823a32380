//! The table of measures: how each is called and taken, and which values a form can have.

use super::DressForm;
use crate::fault::{AvatarCode, Fault};
use serde::Deserialize;
use std::sync::LazyLock;

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    serde_json::from_str(include_str!("measures.json")).expect("a table that a test has read")
});

/// The measures of a dress form, and the proportions between them that it can have.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    measures: Vec<Measure>,
    proportions: Vec<Proportion>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Measure {
    /// Name of the field in a request.
    field: String,
    /// Name of the measure in ISO 8559-1.
    #[serde(rename = "iso_8559_1")]
    #[cfg_attr(
        not(test),
        expect(dead_code, reason = "the table says it to its readers")
    )]
    iso: String,
    /// Way in which it is taken.
    #[cfg_attr(not(test), expect(dead_code, reason = "the tests measure by it"))]
    rule: Rule,
    /// Least and largest value \[m\].
    range_m: [f64; 2],
    /// Largest difference between the value asked for and that of the surface \[m\].
    #[cfg_attr(not(test), expect(dead_code, reason = "the tests measure by it"))]
    tolerance_m: f64,
    /// Part of the body without which it cannot be taken.
    #[serde(default)]
    part: Option<BodyPart>,
    /// True if it is brought into its proportions where it is derived, not refused.
    #[serde(default)]
    fits_others: bool,
}

/// Way in which a measure is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Rule {
    /// Height above the floor.
    Height,
    /// Hull of a level slice of the torso.
    LevelTape,
    /// Hull of a slice normal to the axis of the limb.
    LimbTape,
    /// Straight between landmarks.
    Straight,
}

/// A part of the body that may be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum BodyPart {
    Arms,
    Legs,
}

/// Bounds of a measure as shares of another one.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Proportion {
    field: String,
    of: String,
    range: [f64; 2],
}

impl DressForm {
    /// Returns the faults of its measures, first of each alone, then of their proportions.
    pub(crate) fn check(&self) -> Vec<Fault> {
        let measures = TABLE.measures.iter();
        let mut faults: Vec<_> = measures.filter_map(|measure| measure.check(self)).collect();
        if faults.is_empty() {
            let proportions = TABLE.proportions.iter();
            faults.extend(proportions.filter_map(|proportion| proportion.check(self)));
        }
        faults
    }
}

/// Returns the nearest value to a derived one that goes with the measures it is a share of.
pub(super) fn clamp(form: &DressForm, field: &str, derived: f64) -> f64 {
    let mut measures = TABLE.measures.iter();
    if !measures.any(|measure| measure.field == field && measure.fits_others) {
        return derived;
    }
    let shares = TABLE
        .proportions
        .iter()
        .filter(|share| share.field == field);
    shares.fold(derived, |value, share| {
        let of = form.value(&share.of);
        value.max(share.range[0] * of).min(share.range[1] * of)
    })
}

impl Measure {
    fn check(&self, form: &DressForm) -> Option<Fault> {
        let pointer = format!("/{}", self.field);
        if let (Some(value), Some(part)) = (form.given(&self.field), self.part)
            && !part.is_in(form)
        {
            let part = part.name();
            let detail = format!("a measure of {value} m of the {part}, and the form has none");
            let fix = format!("give \"limbs\": {{\"{part}\": true}}, or leave the measure out");
            return Some(Fault::new(AvatarCode::Measurement, pointer, detail).fix(fix));
        }
        let value = form.value(&self.field);
        let [least, most] = self.range_m;
        let is_derived = form.given(&self.field).is_none();
        // so written that a NaN is a fault
        if (least..=most).contains(&value) || (is_derived && self.fits_others) {
            return None;
        }
        let detail = format!("{value} m is not the measurement of a person");
        let fix = format!("give meters, {least} to {most} here");
        Some(Fault::new(AvatarCode::Measurement, pointer, detail).fix(fix))
    }
}

impl Proportion {
    fn check(&self, form: &DressForm) -> Option<Fault> {
        let (value, of) = (form.value(&self.field), form.value(&self.of));
        let [least, most] = self.range.map(|share| share * of);
        if (least..=most).contains(&value) {
            return None;
        }
        let [name, base] = [&self.field, &self.of].map(|field| name(field));
        let detail = format!("a {name} of {value} m does not go with a {base} of {of:.3} m");
        let fix = format!("give {least:.3} to {most:.3} m, or change the {base}");
        let pointer = format!("/{}", self.field);
        Some(Fault::new(AvatarCode::Measurement, pointer, detail).fix(fix))
    }
}

impl BodyPart {
    /// Returns true if the form has it, or leaves that open.
    fn is_in(self, form: &DressForm) -> bool {
        form.limbs.is_none_or(|limbs| match self {
            Self::Arms => limbs.arms,
            Self::Legs => limbs.legs,
        })
    }

    fn name(self) -> &'static str {
        match self {
            Self::Arms => "arms",
            Self::Legs => "legs",
        }
    }
}

/// The name of a field for a person.
fn name(field: &str) -> String {
    field.trim_end_matches("_m").replace('_', " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Girths to 3 mm, lengths and widths to 5 mm; each measure once.
    #[test]
    fn the_table_names_every_measure_and_states_its_tolerance() {
        let mut fields: Vec<_> = TABLE
            .measures
            .iter()
            .map(|measure| &measure.field)
            .collect();
        fields.sort_unstable();
        fields.dedup();
        assert_eq!(fields.len(), TABLE.measures.len());
        for measure in &TABLE.measures {
            let is_girth = matches!(measure.rule, Rule::LevelTape | Rule::LimbTape);
            let tolerance = if is_girth { 0.003 } else { 0.005 };
            assert!(
                (measure.tolerance_m - tolerance).abs() < 1e-12,
                "{}",
                measure.field
            );
            assert!(!measure.iso.is_empty() && measure.range_m[0] < measure.range_m[1]);
        }
    }
}
