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
    /// How sure it is: 0 is a guess, 1 is certain.
    pub confidence: f64,
    /// Why, in words.
    pub because: String,
}

/// What the rules propose for a pattern.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Suggestion {
    /// Seams that can be sewn together. They may name mirrored copies (`sleeve~mirror`) of panels that are drawn once.
    pub seams: Vec<SuggestedSeam>,
    /// Where panels start, by id, as a garment states it.
    pub panels: BTreeMap<String, SuggestedPanel>,
    /// What a user should know, panels that were not recognised among it.
    pub warnings: Vec<Warning>,
}

/// What the rules propose for a panel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SuggestedPanel {
    /// Where it starts.
    pub placement: Placement,
}
