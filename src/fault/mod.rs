//! Faults and warnings: what is wrong with an input, where, and how to mend it.

mod nearest;

pub(crate) use nearest::nearest;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// One thing that is wrong with an input and keeps it from being used.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct Fault {
    /// What kind of fault, `area/kind`, for a client to act on: `seam/twisted`.
    pub code: String,
    /// Where: a JSON Pointer into the request, or `line N` of a DXF.
    pub pointer: String,
    /// What is wrong, in a sentence for a person, naming the offending thing.
    pub detail: String,
    /// What to do about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fix: Option<String>,
}

impl Fault {
    /// A fault without a suggested fix.
    pub fn new(code: &str, pointer: impl Into<String>, detail: impl Into<String>) -> Self {
        Self {
            code: code.to_owned(),
            pointer: pointer.into(),
            detail: detail.into(),
            fix: None,
        }
    }

    /// The same fault with what to do about it.
    #[must_use]
    pub fn fix(mut self, fix: impl Into<String>) -> Self {
        self.fix = Some(fix.into());
        self
    }
}

/// Every fault found in one input; never empty when returned as an error.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
#[error("{}", .0.iter().map(|f| format!("{} at {}: {}", f.code, f.pointer, f.detail)).collect::<Vec<_>>().join("\n"))]
pub struct Faults(pub Vec<Fault>);

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Self {
        Self(vec![fault])
    }
}

impl Faults {
    /// `Ok(value)` if nothing was found, else the faults.
    ///
    /// # Errors
    /// The faults, if there is at least one.
    pub fn or<T>(self, value: T) -> Result<T, Self> {
        if self.0.is_empty() {
            Ok(value)
        } else {
            Err(self)
        }
    }

    /// The same faults with `prefix` put before each JSON pointer (`line N` pointers stay as they are).
    #[must_use]
    pub fn under(mut self, prefix: &str) -> Self {
        for fault in &mut self.0 {
            if fault.pointer.is_empty() || fault.pointer.starts_with('/') {
                fault.pointer.insert_str(0, prefix);
            }
        }
        self
    }
}

/// Something a user should know about an input that was accepted all the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Warning {
    /// What kind of warning, `area/kind`.
    pub code: String,
    /// What was noticed, in a sentence for a person.
    pub detail: String,
    /// Where: a JSON Pointer, or `line N` of a DXF.
    pub pointer: String,
}

impl Warning {
    /// A warning with its three parts.
    pub fn new(code: &str, pointer: impl Into<String>, detail: impl Into<String>) -> Self {
        Self {
            code: code.to_owned(),
            detail: detail.into(),
            pointer: pointer.into(),
        }
    }
}
