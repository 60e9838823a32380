//! A JSON value with its place in the document, read step by step; what is wrong is noted and
//! conventions goes on.

use super::findings::SpecFindings;
use crate::fault::{Fault, PatternCode, nearest, pointer_token};
use serde_json::{Map, Value};

/// A value with its place in the document.
#[derive(Clone)]
pub(super) struct JsonNode<'a> {
    /// The value.
    pub(super) value: &'a Value,
    /// Its JSON Pointer.
    pub(super) pointer: String,
}

impl<'a> JsonNode<'a> {
    /// Returns the whole document.
    pub(super) fn root(value: &'a Value) -> Self {
        let pointer = String::new();
        Self { value, pointer }
    }

    /// Returns a fault at this place.
    pub(super) fn fault(&self, code: PatternCode, detail: impl Into<String>, fix: &str) -> Fault {
        Fault::new(code, self.pointer.clone(), detail).fix(fix)
    }

    /// Adds the fault that this is not `what`.
    fn refuse(&self, what: &str, findings: &mut SpecFindings) {
        let shown: String = self.value.to_string().chars().take(40).collect();
        let fix = format!("give {what}");
        findings.fault(self.fault(
            PatternCode::Field,
            format!("{shown} is not {what}"),
            fix.as_str(),
        ));
    }

    /// Returns the value of a field.
    fn child(&self, name: &str, value: &'a Value) -> Self {
        let step = pointer_token(name);
        let pointer = format!("{}/{step}", self.pointer);
        Self { value, pointer }
    }

    /// Returns the fields of an object; every one that is not `known` is a fault.
    pub(super) fn fields(
        &self,
        known: &[&str],
        findings: &mut SpecFindings,
    ) -> Option<&'a Map<String, Value>> {
        let Some(fields) = self.value.as_object() else {
            self.refuse("an object", findings);
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
                let child = self.child(name, value);
                findings.fault(child.fault(PatternCode::UnknownField, detail, &fix));
            }
        }
        Some(fields)
    }

    /// Returns all entries of an object, in the file's order.
    pub(super) fn entries(&self, findings: &mut SpecFindings) -> Vec<(&'a str, Self)> {
        let Some(fields) = self.value.as_object() else {
            self.refuse("an object", findings);
            return Vec::new();
        };
        let entry =
            |(name, value): (&'a String, &'a Value)| (name.as_str(), self.child(name, value));
        fields.iter().map(entry).collect()
    }

    /// Returns a field, if it is there.
    pub(super) fn get(&self, name: &str) -> Option<Self> {
        self.value.get(name).map(|value| self.child(name, value))
    }

    /// Returns a field that must be there.
    pub(super) fn require(&self, name: &str, findings: &mut SpecFindings) -> Option<Self> {
        let found = self.get(name);
        if found.is_none() && self.value.is_object() {
            let detail = format!("{name:?} is missing");
            findings.fault(self.fault(PatternCode::MissingField, detail, "add it"));
        }
        found
    }

    /// Returns the items of a list of at most `most`.
    pub(super) fn items(&self, most: usize, findings: &mut SpecFindings) -> Option<Vec<Self>> {
        let Some(items) = self.value.as_array() else {
            self.refuse("a list", findings);
            return None;
        };
        if items.len() > most {
            let detail = format!("{} entries; at most {most} are read", items.len());
            findings.fault(self.fault(PatternCode::TooLarge, detail, "leave some out"));
            return None;
        }
        let item = |(i, value): (usize, &'a Value)| Self {
            value,
            pointer: format!("{}/{i}", self.pointer),
        };
        Some(items.iter().enumerate().map(item).collect())
    }

    /// Reads a number.
    pub(super) fn number(&self, findings: &mut SpecFindings) -> Option<f64> {
        let found = self.value.as_f64().filter(|x| x.is_finite());
        if found.is_none() {
            self.refuse("a number", findings);
        }
        found
    }

    /// Reads a list of `N` numbers.
    pub(super) fn numbers<const N: usize>(&self, findings: &mut SpecFindings) -> Option<[f64; N]> {
        let items = self.value.as_array().filter(|items| items.len() == N);
        let numbers = items.and_then(|items| items.iter().map(Value::as_f64).collect());
        let found: Option<Vec<f64>> = numbers;
        match found.and_then(|numbers| <[f64; N]>::try_from(numbers).ok()) {
            Some(numbers) if numbers.iter().all(|x| x.is_finite()) => Some(numbers),
            _ => {
                self.refuse(&format!("a list of {N} numbers"), findings);
                None
            }
        }
    }

    /// Reads a number that counts or points.
    pub(super) fn index(&self, findings: &mut SpecFindings) -> Option<usize> {
        let found = self.value.as_u64().and_then(|n| usize::try_from(n).ok());
        if found.is_none() {
            self.refuse("a whole number, 0 or more", findings);
        }
        found
    }

    /// Reads true or false, also as 1 or 0.
    pub(super) fn flag(&self, findings: &mut SpecFindings) -> Option<bool> {
        let number = self.value.as_f64();
        let found = self.value.as_bool().or(match number {
            Some(0.0) => Some(false),
            Some(1.0) => Some(true),
            _ => None,
        });
        if found.is_none() {
            self.refuse("true or false", findings);
        }
        found
    }

    /// Reads a text.
    pub(super) fn text(&self, findings: &mut SpecFindings) -> Option<&'a str> {
        let found = self.value.as_str();
        if found.is_none() {
            self.refuse("a text", findings);
        }
        found
    }
}
