//! Cohesion of a suggested set: seams of panels that hang on the rest of the garment by offers
//! only, or of a small part that is sewn to nothing but itself, are offers themselves.

use super::suggestion::{MIN_SEWN_CONFIDENCE, SuggestedSeam};
use crate::pattern::{MIRROR, Pattern};
use std::collections::BTreeMap;

/// Share of the area of the largest part up to which a part by itself is no garment.
const SMALL: f64 = 0.25;
/// Confidence that is left to a seam of a part that would fall off.
const APART: f64 = 0.49;

/// Lowers the confidence of seams whose panels would fall off if offers were not sewn: of parts
/// that offers alone join, the largest keeps its seams.
pub(super) fn distrust_parts_apart(pattern: &Pattern, seams: &mut [SuggestedSeam]) {
    let sewn = Components::of(pattern, seams.iter().filter(|seam| !seam.is_offer()));
    let all = Components::of(pattern, seams.iter());
    let parts = sewn.parts(pattern);
    let mut largest: BTreeMap<usize, (usize, f64)> = BTreeMap::new();
    for (root, part) in &parts {
        let best = largest.entry(all.root(*root)).or_insert((*root, part.area));
        if part.area > best.1 {
            *best = (*root, part.area);
        }
    }
    let most = largest.values().map(|best| best.1).fold(0.0, f64::max);
    for seam in seams {
        let panel = seam.panels().next().and_then(|id| index_of(pattern, id));
        let Some(panel) = panel.filter(|_| seam.confidence >= MIN_SEWN_CONFIDENCE) else {
            continue;
        };
        let root = sewn.root(panel);
        let is_largest = largest
            .get(&all.root(panel))
            .is_some_and(|best| best.0 == root);
        let is_alone = parts
            .get(&root)
            .is_some_and(|part| part.area < SMALL * most);
        if !is_largest || is_alone {
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

    /// Returns every component by its root.
    fn parts(&self, pattern: &Pattern) -> BTreeMap<usize, Part> {
        let mut parts: BTreeMap<usize, Part> = BTreeMap::new();
        for (i, panel) in pattern.panels.iter().enumerate() {
            let part = parts.entry(self.root(i)).or_default();
            part.area += panel.area_m2.abs();
        }
        parts
    }
}

/// Panels that are sewn together.
#[derive(Default)]
struct Part {
    /// Area of all of them \[m²\].
    area: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Allowance, Panel, PatternFormat, Source};
    use serde_json::json;

    fn pattern(sizes: &[(&str, [f64; 2])]) -> Pattern {
        let panels = sizes.iter().map(|(id, size)| Panel::rectangle(id, *size));
        Pattern {
            id: None,
            name: "shirt".to_owned(),
            source: Source {
                format: PatternFormat::Dxf,
                units: "mm".to_owned(),
                scale_to_m: 1e-3,
                sample_size: None,
                sizes: vec![],
                allowance: Allowance::Unknown,
            },
            panels: panels.collect(),
            seams: vec![],
            placements: BTreeMap::new(),
            warnings: vec![],
        }
    }

    fn seam(a: &str, b: &str) -> SuggestedSeam {
        let side = |panel: &str| json!({"panel": panel, "from": 0, "to": 1});
        let seam = json!({
            "id": format!("{a}-{b}"), "a": side(a), "b": side(b),
            "confidence": 0.9, "because": "the lengths agree",
        });
        serde_json::from_value(seam).expect("a seam")
    }

    #[test]
    fn collar_on_a_stand_that_is_sewn_to_nothing_is_an_offer() {
        let pattern = pattern(&[
            ("front", [0.5, 0.7]),
            ("back", [0.5, 0.7]),
            ("stand", [0.4, 0.04]),
            ("collar", [0.4, 0.08]),
        ]);
        let mut seams = [seam("front", "back"), seam("stand", "collar")];
        distrust_parts_apart(&pattern, &mut seams);
        assert!(!seams[0].is_offer() && seams[1].is_offer());
        let mut seams = [
            seam("front", "back"),
            seam("stand", "collar"),
            seam("back", "stand"),
        ];
        distrust_parts_apart(&pattern, &mut seams);
        assert!(seams.iter().all(|seam| !seam.is_offer()));
    }
}
