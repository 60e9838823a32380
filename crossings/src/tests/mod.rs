//! Tests of the whole crate, by the rules and against slow exact arithmetic of another kind.

use crate::{CrossingReport, SearchLimits};

mod bodies;
mod exact;
mod meshes;
mod pairs;
pub(crate) mod random;

/// Everything is looked at and kept.
const ALL: SearchLimits = SearchLimits {
    kept: usize::MAX,
    pairs: usize::MAX,
};

/// Returns true if a report has no fault of any kind.
fn is_clear(report: &CrossingReport) -> bool {
    *report == CrossingReport::default()
}
