//! Results of the suggestion: seams and placements, as a client would state them.

use crate::fault::Warning;
use crate::pattern::{Placement, SeamPair};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// Confidence from which a suggested seam is sewn unasked; one of less is an offer, for the user to
/// take.
pub const MIN_SEWN_CONFIDENCE: f64 = 0.5;

/// A seam that the rules propose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SuggestedSeam {
    /// The seam, as a client would state it.
    #[serde(flatten)]
    pub pair: SeamPair,
    /// Confidence: 0 is a guess, 1 is certain. Below 0.5 the seam is an offer: a garment that
    /// leaves its seams to the service is sewn without it.
    pub confidence: f64,
    /// Reason, in words.
    pub because: String,
}

impl SuggestedSeam {
    /// Returns true if the seam is an offer only, which nobody sews unasked.
    pub fn is_offer(&self) -> bool {
        self.confidence < MIN_SEWN_CONFIDENCE
    }

    /// Returns the panels that it joins, one for each of its runs.
    pub fn panels(&self) -> impl Iterator<Item = &str> {
        let runs = self.pair.a.runs().iter().chain(self.pair.b.runs());
        runs.map(|run| run.panel.as_str())
    }
}

/// Seams and placements proposed for a pattern.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Suggestion {
    /// Seams that can be sewn together, offers among them (of a confidence below 0.5). They may
    /// name mirrored copies (`sleeve~mirror`) of panels that are drawn once.
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
