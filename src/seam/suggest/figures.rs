//! Figures of the suggestion, read from `figures.json`, which tells where they come from.

use super::align::AlignmentWeights;
use super::assignment::AssignmentWeights;
use super::edge_templates::PanelTemplate;
use super::labels::PanelKind;
use super::penalties::PenaltyWeights;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Templates of every kind and weights of every step.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Figures {
    #[serde(rename = "about")]
    _about: Vec<String>,
    #[serde(rename = "provenance")]
    _provenance: Vec<String>,
    templates: BTreeMap<String, PanelTemplate>,
    kinds: BTreeMap<PanelKind, Vec<String>>,
    companions: BTreeMap<PanelKind, Vec<String>>,
    pub(super) recognition: RecognitionLimits,
    pub(super) alignment: AlignmentWeights,
    pub(super) penalties: PenaltyWeights,
    pub(super) assignment: AssignmentWeights,
}

/// Limits for a panel that no name tells.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RecognitionLimits {
    /// Largest mean misfit of a role.
    pub(super) max_unnamed_cost: f64,
    /// The same for kinds that are seldom met.
    pub(super) max_rare_cost: f64,
    /// Smallest side of the square of its area \[m\].
    pub(super) min_unnamed_size_m: f64,
}

impl Figures {
    /// Reads the file that is part of the program.
    pub(super) fn embedded() -> Self {
        serde_json::from_str(include_str!("figures.json"))
            .expect("the embedded figures are valid, as their test shows")
    }

    /// Returns the templates of a bodice that is sewn to panels of a kind.
    pub(super) fn beside(&self, kind: PanelKind) -> impl Iterator<Item = &PanelTemplate> {
        let names = self.companions.get(&kind).into_iter().flatten();
        names.filter_map(|name| self.templates.get(name))
    }

    /// Returns the templates of a kind, in the order in which they are tried.
    pub(super) fn templates(&self, kind: PanelKind) -> impl Iterator<Item = &PanelTemplate> {
        let names = self.kinds.get(&kind).into_iter().flatten();
        names.filter_map(|name| self.templates.get(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_template_named_is_there_and_used() {
        let figures = Figures::embedded();
        let lists = figures.kinds.values().chain(figures.companions.values());
        let named: Vec<&String> = lists.flatten().collect();
        assert!(
            named
                .iter()
                .all(|name| figures.templates.contains_key(*name))
        );
        assert!(figures.templates.keys().all(|name| named.contains(&name)));
    }
}
