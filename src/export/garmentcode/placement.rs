//! A placement as rotation and translation: (x, y, 0) is turned, then moved.

use super::numbers::neat;
use crate::pattern::polyline::bounds;
use crate::pattern::rotation_matrix;
use crate::pattern::{Panel, Placement, PlacementAnchor, RotationOrder, Wrap};
use serde_json::{Map, Value, json};

/// Returns the fields of a placement; `None` where it is about a body, or rolls the panel.
pub(super) fn written(
    panel: &Panel,
    placement: &Placement,
    scale: f64,
) -> Option<Map<String, Value>> {
    let is_in_space = placement.at == Some(PlacementAnchor::Origin)
        && placement.up_deg.is_none()
        && !matches!(placement.wrap, Some(Wrap::Cylinder | Wrap::Level));
    if !is_in_space {
        return None;
    }
    let points = panel.edges.iter().flat_map(|edge| &edge.points);
    let [low, high] = bounds(&points.copied().collect::<Vec<_>>());
    let center = [0, 1].map(|k| f64::midpoint(low[k], high[k]));
    // R (v - c) + o = R v + (o - R c).
    let rotation = rotation_matrix(placement.rotate_deg, RotationOrder::Xyz);
    let moved = [0, 1, 2].map(|k| {
        let row = rotation[k];
        placement.offset_m[k] - row[0] * center[0] - row[1] * center[1]
    });
    let mut fields = Map::new();
    let translation = moved.map(|c| neat(c / scale));
    fields.insert("translation".to_owned(), json!(translation));
    fields.insert("rotation".to_owned(), json!(placement.rotate_deg.map(neat)));
    Some(fields)
}
