//! A JSON value with the place it stands at, read piece by piece; what is wrong is noted and reading goes on.

use crate::fault::{Fault, Warning, nearest};
use serde_json::{Map, Value};

/// At most this many faults, and as many warnings, are told of one file.
const MOST: usize = 100;

/// What was noticed in a file.
#[derive(Default)]
pub(super) struct Findings {
    /// What keeps it from being read, each at its JSON Pointer.
    pub(super) faults: Vec<Fault>,
    /// What the user should know.
    pub(super) warnings: Vec<Warning>,
    /// Points of all outlines so far.
    pub(super) points: usize,
    left_out: usize,
}

impl Findings {
    /// Notes a fault.
    pub(super) fn fault(&mut self, fault: Fault) {
        if self.faults.len() < MOST {
            self.faults.push(fault);
        } else {
            self.left_out += 1;
        }
    }

    /// Notes a warning.
    pub(super) fn warn(&mut self, code: &str, pointer: &str, detail: impl Into<String>) {
        if self.warnings.len() < MOST {
            self.warnings.push(Warning::new(code, pointer, detail));
        }
    }

    /// All faults, with how many more there are.
    pub(super) fn into_faults(mut self) -> Vec<Fault> {
        if self.left_out > 0 {
            let detail = format!("and {} more faults", self.left_out);
            self.faults.push(Fault::new("pattern/more", "", detail));
        }
        self.faults
    }
}

/// A value and the place it stands at.
#[derive(Clone)]
pub(super) struct At<'a> {
    /// The value.
    pub(super) value: &'a Value,
    /// Its JSON Pointer.
    pub(super) pointer: String,
}

impl<'a> At<'a> {
    /// The whole document.
    pub(super) fn root(value: &'a Value) -> Self {
        let pointer = String::new();
        Self { value, pointer }
    }

    /// A fault here.
    pub(super) fn wrong(&self, code: &str, detail: impl Into<String>, fix: &str) -> Fault {
        Fault::new(code, self.pointer.clone(), detail).fix(fix)
    }

    fn not(&self, what: &str, findings: &mut Findings) {
        let shown: String = self.value.to_string().chars().take(40).collect();
        let fix = format!("give {what}");
        findings.fault(self.wrong(
            "pattern/field",
            format!("{shown} is not {what}"),
            fix.as_str(),
        ));
    }

    fn below(&self, name: &str, value: &'a Value) -> Self {
        let step = name.replace('~', "~0").replace('/', "~1");
        let pointer = format!("{}/{step}", self.pointer);
        Self { value, pointer }
    }

    /// The fields of an object; every one that is not `known` is a fault.
    pub(super) fn fields(
        &self,
        known: &[&str],
        findings: &mut Findings,
    ) -> Option<&'a Map<String, Value>> {
        let Some(fields) = self.value.as_object() else {
            self.not("an object", findings);
            return None;
        };
        for (name, value) in fields {
            if !known.contains(&name.as_str()) {
                let fix = match nearest(name, known.iter().copied()) {
                    Some(near) => format!("{near} may be meant"),
                    None => format!("leave it out; known here: {}", known.join(", ")),
                };
                let shown: String = name.chars().take(60).collect();
                let detail = format!("{shown:?} is not a field here");
                let at = self.below(name, value);
                findings.fault(at.wrong("pattern/unknown_field", detail, &fix));
            }
        }
        Some(fields)
    }

    /// All entries of an object, in the file's order.
    pub(super) fn entries(&self, findings: &mut Findings) -> Vec<(&'a str, Self)> {
        let Some(fields) = self.value.as_object() else {
            self.not("an object", findings);
            return Vec::new();
        };
        let entry =
            |(name, value): (&'a String, &'a Value)| (name.as_str(), self.below(name, value));
        fields.iter().map(entry).collect()
    }

    /// A field, if it is there.
    pub(super) fn get(&self, name: &str) -> Option<Self> {
        self.value.get(name).map(|value| self.below(name, value))
    }

    /// A field that must be there.
    pub(super) fn need(&self, name: &str, findings: &mut Findings) -> Option<Self> {
        let found = self.get(name);
        if found.is_none() && self.value.is_object() {
            let detail = format!("{name:?} is missing");
            findings.fault(self.wrong("pattern/missing_field", detail, "add it"));
        }
        found
    }

    /// The items of a list of at most `most`.
    pub(super) fn items(&self, most: usize, findings: &mut Findings) -> Option<Vec<Self>> {
        let Some(items) = self.value.as_array() else {
            self.not("a list", findings);
            return None;
        };
        if items.len() > most {
            let detail = format!("{} entries; at most {most} are read", items.len());
            findings.fault(self.wrong("pattern/too_large", detail, "leave some out"));
            return None;
        }
        let item = |(i, value): (usize, &'a Value)| Self {
            value,
            pointer: format!("{}/{i}", self.pointer),
        };
        Some(items.iter().enumerate().map(item).collect())
    }

    /// A number.
    pub(super) fn number(&self, findings: &mut Findings) -> Option<f64> {
        let found = self.value.as_f64().filter(|x| x.is_finite());
        if found.is_none() {
            self.not("a number", findings);
        }
        found
    }

    /// A list of `N` numbers.
    pub(super) fn numbers<const N: usize>(&self, findings: &mut Findings) -> Option<[f64; N]> {
        let items = self.value.as_array().filter(|items| items.len() == N);
        let numbers = items.and_then(|items| items.iter().map(Value::as_f64).collect());
        let found: Option<Vec<f64>> = numbers;
        match found.and_then(|numbers| <[f64; N]>::try_from(numbers).ok()) {
            Some(numbers) if numbers.iter().all(|x| x.is_finite()) => Some(numbers),
            _ => {
                self.not(&format!("a list of {N} numbers"), findings);
                None
            }
        }
    }

    /// A number that counts or points.
    pub(super) fn index(&self, findings: &mut Findings) -> Option<usize> {
        let found = self.value.as_u64().and_then(|n| usize::try_from(n).ok());
        if found.is_none() {
            self.not("a whole number, 0 or more", findings);
        }
        found
    }

    /// true or false, also as 1 or 0.
    pub(super) fn flag(&self, findings: &mut Findings) -> Option<bool> {
        let number = self.value.as_f64();
        let found = self.value.as_bool().or(match number {
            Some(0.0) => Some(false),
            Some(1.0) => Some(true),
            _ => None,
        });
        if found.is_none() {
            self.not("true or false", findings);
        }
        found
    }

    /// A text.
    pub(super) fn text(&self, findings: &mut Findings) -> Option<&'a str> {
        let found = self.value.as_str();
        if found.is_none() {
            self.not("a text", findings);
        }
        found
    }
}
