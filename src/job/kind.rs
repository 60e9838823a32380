//! The kinds of jobs.

use serde::{Deserialize, Serialize};

/// The kind of a job.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum JobKind {
    /// A garment sewn and draped. Records of before there were studies name no kind.
    #[default]
    Fit,
    /// A garment by many methods, settings and meshes.
    Study,
}

impl JobKind {
    /// All kinds.
    pub const ALL: [Self; 2] = [Self::Fit, Self::Study];

    /// Returns the word for it in codes and in the store.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Fit => "fit",
            Self::Study => "study",
        }
    }
}
