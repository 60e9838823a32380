//! The placement of panels in a specification: (x, y, 0) is turned, then moved.

use super::conventions::Conventions;
use super::findings::SpecFindings;
use super::node::JsonNode;
use super::panel::DrawnPanel;
use super::rotation::{angles_xyz, matrix};
use crate::fault::PatternCode;
use crate::pattern::point::FARTHEST;
use crate::pattern::polyline::bounds;
use crate::pattern::{Placement, PlacementAnchor, RotationOrder, Wrap};

/// Reads the placement of a panel; `None` where nothing is stated.
pub(super) fn read(
    node: &JsonNode<'_>,
    drawn: Option<&DrawnPanel>,
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) -> Option<Placement> {
    let translation = node.get("translation");
    let rotation = node.get("rotation");
    if translation.is_none() && rotation.is_none() {
        return None;
    }
    let zero = Some([0.0; 3]);
    let moved = translation.map_or(zero, |t| read_numbers(&t, conventions.scale, findings));
    let angles = rotation.map_or(zero, |r| read_numbers(&r, 1.0, findings));
    let (moved, angles, drawn) = (moved?, angles?, drawn?);
    let order = conventions.rotation_order;
    let rotation = matrix(angles, order);
    let points = drawn.panel.edges.iter().flat_map(|edge| &edge.points);
    let [low, high] = bounds(&points.copied().collect::<Vec<_>>());
    let mut center = [0, 1].map(|k| 0.5 * (low[k] + high[k]));
    let mut offset = moved;
    if conventions.about_mean {
        for k in 0..2 {
            center[k] -= drawn.mean[k];
            offset[k] += drawn.mean[k];
        }
    }
    // R v + t = R (v - c) + (R c + t).
    for (k, row) in rotation.iter().enumerate() {
        offset[k] += row[0] * center[0] + row[1] * center[1];
    }
    if offset.iter().any(|c| c.abs() > FARTHEST) {
        let detail = "the panel is placed beyond 10 km";
        findings.fault(node.fault(PatternCode::NotFinite, detail, "correct its translation"));
        return None;
    }
    let rotate_deg = match order {
        RotationOrder::Xyz => angles,
        RotationOrder::Zyx => angles_xyz(rotation),
    };
    Some(Placement {
        up_deg: None,
        at: Some(PlacementAnchor::Origin),
        offset_m: offset.map(|c| c + 0.0),
        rotate_deg: rotate_deg.map(|angle| angle + 0.0),
        wrap: Some(Wrap::Flat),
    })
}

/// Reads three numbers times `scale`.
fn read_numbers(node: &JsonNode<'_>, scale: f64, findings: &mut SpecFindings) -> Option<[f64; 3]> {
    let numbers = node.numbers::<3>(findings)?.map(|x| x * scale);
    if numbers.iter().all(|x| x.abs() <= FARTHEST) {
        return Some(numbers);
    }
    let detail = "a number is beyond 10 km or 10000 degrees";
    findings.fault(node.fault(PatternCode::NotFinite, detail, "correct it"));
    None
}
