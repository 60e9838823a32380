//! Results of the suggestion: seams and placements, as a client would state them.

use crate::fault::Warning;
use crate::pattern::{Placement, SeamPair};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// A seam that the rules propose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SuggestedSeam {
    /// The seam, as a client would state it.
    #[serde(flatten)]
    pub pair: SeamPair,
    /// Confidence: 0 is a guess, 1 is certain.
    pub confidence: f64,
    /// Reason, in words.
    pub because: String,
}

/// Seams and placements proposed for a pattern.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Suggestion {
    /// Seams that can be sewn together. They may name mirrored copies (`sleeve~mirror`) of panels
    /// that are drawn once.
    pub seams: Vec<SuggestedSeam>,
    /// Proposals by id of the panel, as a garment states them.
    pub panels: BTreeMap<String, SuggestedPanel>,
    /// Warnings, of panels that were not recognized among others.
    pub warnings: Vec<Warning>,
}

/// Proposal for one panel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SuggestedPanel {
    /// Its start placement.
    pub placement: Placement,
}
