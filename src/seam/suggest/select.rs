//! Selects of the proposed seams a set that can be sewn together, without twist and without
//! overlap.

use super::suggestion::SuggestedSeam;
use crate::config::Limits;
use crate::pattern::{Pattern, SeamPair};
use crate::seam;
use std::collections::BTreeMap;

/// Mesh edge length that stitch counts are stated for while checking \[m\]; nothing depends on it.
const EDGE_LENGTH: f64 = 0.02;

/// Number of times that one seam is left out by itself; then all that are still wrong go.
const MAX_SINGLE_REMOVALS: usize = 30;

/// Returns the seams that can be sewn together. Of those that cannot, the least sure is left out
/// first.
pub(super) fn select_compatible(
    pattern: &Pattern,
    mut seams: Vec<SuggestedSeam>,
    limits: &Limits,
) -> Vec<SuggestedSeam> {
    // Of two that clash the later one is refused: the surest come first, and their order comes back
    // at the end.
    let order: Vec<String> = seams.iter().map(|s| s.pair.id.clone()).collect();
    seams.sort_by(|a, b| b.confidence.total_cmp(&a.confidence));
    seams.truncate(limits.seams);
    let named = seams
        .iter()
        .flat_map(|s| s.pair.a.runs().iter().chain(s.pair.b.runs()));
    let names: Vec<String> = named.map(|run| run.panel.clone()).collect();
    let whole = pattern.with_copies(names.iter().map(String::as_str));
    for round in 0.. {
        let pairs: Vec<SeamPair> = seams.iter().map(|s| s.pair.clone()).collect();
        let (check, _) = seam::check(&whole, &pairs, &BTreeMap::new(), EDGE_LENGTH, limits);
        let wrong: Vec<usize> = (0..seams.len()).filter(|i| !check.seams[*i].ok).collect();
        let least = wrong
            .iter()
            .min_by(|a, b| seams[**a].confidence.total_cmp(&seams[**b].confidence));
        let Some(&least) = least else { break };
        if round < MAX_SINGLE_REMOVALS {
            seams.remove(least);
        } else {
            let mut at = 0..;
            seams.retain(|_| at.next().is_some_and(|i| !wrong.contains(&i)));
        }
    }
    seams.sort_by_key(|s| order.iter().position(|id| *id == s.pair.id));
    seams
}
