//! Cohesion of a suggested set: seams of panels that hang on the rest of the garment by offers only
//! are offers themselves.

use super::suggestion::{MIN_SEWN_CONFIDENCE, SuggestedSeam};
use crate::pattern::{MIRROR, Pattern};
use std::collections::BTreeMap;

/// Confidence that is left to a seam of a part that would fall off.
const APART: f64 = 0.49;

/// Lowers the confidence of seams whose panels would fall off if offers were not sewn: of parts
/// that offers alone join, the largest keeps its seams.
pub(super) fn distrust_parts_apart(pattern: &Pattern, seams: &mut [SuggestedSeam]) {
    let sewn = Components::of(pattern, seams.iter().filter(|seam| !seam.is_offer()));
    let all = Components::of(pattern, seams.iter());
    let mut largest: BTreeMap<usize, (usize, f64)> = BTreeMap::new();
    for (part, area) in sewn.areas(pattern) {
        let best = largest.entry(all.root(part)).or_insert((part, area));
        if area > best.1 {
            *best = (part, area);
        }
    }
    for seam in seams {
        let panel = seam.panels().next().and_then(|id| index_of(pattern, id));
        let Some(panel) = panel.filter(|_| seam.confidence >= MIN_SEWN_CONFIDENCE) else {
            continue;
        };
        if largest.get(&all.root(panel)).map(|best| best.0) != Some(sewn.root(panel)) {
            seam.confidence = APART;
        }
    }
}

/// Returns the index of a panel, that of its source for a mirrored copy.
fn index_of(pattern: &Pattern, id: &str) -> Option<usize> {
    let source = || pattern.panel_index(id.strip_suffix(MIRROR)?);
    pattern.panel_index(id).or_else(source)
}

/// Panels that seams join, as a forest; a mirrored copy belongs to its source.
struct Components(Vec<usize>);

impl Components {
    fn of<'a>(pattern: &Pattern, seams: impl Iterator<Item = &'a SuggestedSeam>) -> Self {
        let mut found = Self((0..pattern.panels.len()).collect());
        for seam in seams {
            let panels: Vec<usize> = seam
                .panels()
                .filter_map(|id| index_of(pattern, id))
                .collect();
            for pair in panels.windows(2) {
                let (a, b) = (found.root(pair[0]), found.root(pair[1]));
                found.0[a.max(b)] = a.min(b);
            }
        }
        found
    }

    fn root(&self, panel: usize) -> usize {
        let mut at = panel;
        while self.0[at] != at {
            at = self.0[at];
        }
        at
    }

    /// Returns the root and the area of every component \[m²\].
    fn areas(&self, pattern: &Pattern) -> BTreeMap<usize, f64> {
        let mut areas = BTreeMap::new();
        for (i, panel) in pattern.panels.iter().enumerate() {
            *areas.entry(self.root(i)).or_insert(0.0) += panel.area_m2.abs();
        }
        areas
    }
}
