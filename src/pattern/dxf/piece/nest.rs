//! Outlines inside outlines: each is owned by the largest that holds it.

use super::measured::MeasuredChain;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::findings::{DxfFindings, at_line};

/// Removes outlines that are drawn twice in the same place.
pub(super) fn drop_duplicates(
    outlines: Vec<MeasuredChain>,
    findings: &mut DxfFindings,
) -> Vec<MeasuredChain> {
    let mut kept: Vec<MeasuredChain> = Vec::with_capacity(outlines.len());
    for outline in outlines {
        if kept.iter().any(|other| other.is_drawn_over(&outline)) {
            findings.warn(
                PatternCode::DuplicateOutline,
                outline.chain.line,
                "an outline is drawn twice in the same place; it was taken once",
            );
        } else {
            kept.push(outline);
        }
    }
    kept
}

/// Splits outlines into those that lie in no other, and those inside of each, the largest that
/// holds them.
pub(super) fn nest(outlines: Vec<MeasuredChain>) -> (Vec<MeasuredChain>, Vec<Vec<MeasuredChain>>) {
    let mut order: Vec<usize> = (0..outlines.len()).collect();
    order.sort_by(|a, b| outlines[*b].area.total_cmp(&outlines[*a].area));
    let mut outer: Vec<usize> = Vec::new();
    let mut owner = vec![None; outlines.len()];
    for i in order {
        owner[i] = outer
            .iter()
            .find(|o| outlines[i].lies_in(&outlines[**o]))
            .copied();
        if owner[i].is_none() {
            outer.push(i);
        }
    }
    outer.sort_unstable();
    let mut inner = vec![vec![]; outer.len()];
    let mut kept = Vec::new();
    for (outline, owner) in outlines.into_iter().zip(owner) {
        match owner.and_then(|o| outer.binary_search(&o).ok()) {
            Some(at) => inner[at].push(outline),
            None => kept.push(outline),
        }
    }
    (kept, inner)
}

/// Returns the fault for more panels than the limit.
pub(super) fn too_many(count: usize, limit: usize, line: usize) -> Fault {
    Fault::new(
        PatternCode::TooManyPanels,
        at_line(line),
        format!("the file has {count} pieces; at most {limit} are read"),
    )
    .fix("export fewer pieces or sizes")
}

#[cfg(test)]
mod tests {
    use super::super::chain::PathChain;
    use super::*;

    fn rectangle(x: f64, y: f64, w: f64, h: f64) -> MeasuredChain {
        let points = [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
        MeasuredChain::new(PathChain::ring(&points))
    }

    #[test]
    fn outlines_are_owned_by_the_largest_around_them() {
        let (outer, inner) = nest(vec![
            rectangle(0.1, 0.1, 0.1, 0.1),
            rectangle(0.0, 0.0, 0.3, 0.4),
            rectangle(1.0, 0.0, 0.3, 0.4),
            rectangle(0.05, 0.05, 0.2, 0.3),
        ]);
        assert_eq!(
            outer.iter().map(|l| l.bounds[0]).collect::<Vec<_>>(),
            [[0.0, 0.0], [1.0, 0.0]]
        );
        assert_eq!(inner.iter().map(Vec::len).collect::<Vec<_>>(), [2, 0]);
    }
}
