//! Faults and warnings: what is wrong with an input, where, and how to mend it.

mod codes;
mod line;
mod nearest;
mod pointer;
mod quoted_list;

pub use codes::{
    AvatarCode, FabricCode, FaultCode, FileCode, FitCode, GarmentCode, MeshCode, PatternCode,
    PlacementCode, RequestCode, SceneCode, SeamCode, StudyCode, codes_markdown,
};
pub use line::without_controls;
pub(crate) use nearest::nearest;
pub(crate) use pointer::pointer_token;
pub(crate) use quoted_list::quoted_list;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A defect of an input that keeps it from being used.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct Fault {
    /// Kind of the fault, `area/kind`, for a client to act on: `seam/twisted`.
    #[schema(value_type = String)]
    pub code: FaultCode,
    /// Place of the fault: a JSON Pointer into the request, or `line N` of a DXF.
    pub pointer: String,
    /// Sentence for a person, naming the offending thing.
    pub detail: String,
    /// Way to mend it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fix: Option<String>,
}

impl Fault {
    /// Creates a fault without a suggested fix.
    pub fn new(
        code: impl Into<FaultCode>,
        pointer: impl Into<String>,
        detail: impl Into<String>,
    ) -> Self {
        Self {
            code: code.into(),
            pointer: pointer.into(),
            detail: detail.into(),
            fix: None,
        }
    }

    /// Adds the way to mend it.
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
    /// Returns `value` if there is no fault.
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

    /// Puts `prefix` before each JSON pointer (`line N` pointers stay as they are).
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

/// A remark on an input that was accepted all the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Warning {
    /// Kind of the warning, `area/kind`.
    #[schema(value_type = String)]
    pub code: FaultCode,
    /// Sentence for a person on what was noticed.
    pub detail: String,
    /// Place of the warning: a JSON Pointer, or `line N` of a DXF.
    pub pointer: String,
}

impl Warning {
    /// Creates a warning.
    pub fn new(
        code: impl Into<FaultCode>,
        pointer: impl Into<String>,
        detail: impl Into<String>,
    ) -> Self {
        Self {
            code: code.into(),
            detail: detail.into(),
            pointer: pointer.into(),
        }
    }
}
